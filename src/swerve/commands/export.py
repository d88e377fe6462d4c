"""`swerve export`: a finished run's folder in the formats of other tools."""

import argparse
import sys
from pathlib import Path
from typing import Any, Final

from swerve.commands.printing import print_paths

READ_SHARE: Final = 0.1  # of the time that an export takes, what reading takes [1]


def add_command(commands: Any) -> None:
    """Add it to a parser's `commands`."""
    export = commands.add_parser("export", help="write a finished run in other formats", allow_abbrev=False)
    export.set_defaults(call=_export)
    export.add_argument("directory", type=Path, metavar="DIR", help="that `swerve run --out` filled")
    export.add_argument("--to", required=True, metavar="FORMAT[,FORMAT]", help="csv, mcap, mf4, gif, webp, mp4")
    export.add_argument("--out", type=Path, metavar="DIR", help="write there [the run's folder]")


def _export(options: argparse.Namespace) -> int:
    from swerve.report import Progress, prepare_output
    from swerve.report.exports import formats_named, write_exports
    from swerve.report.exports.folder import read_run_folder

    formats, directory = formats_named(options.to, "--to"), options.out or options.directory
    with Progress(sys.stderr) as progress:
        run = read_run_folder(options.directory)
        prepare_output(directory)
        paths = write_exports(run, formats, directory, progress.part(READ_SHARE, 1.0))
    print_paths(paths, sys.stdout)
    return 0
