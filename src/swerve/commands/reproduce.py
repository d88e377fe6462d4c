"""`swerve reproduce`: the paper's tables and figures, and the ablation."""

import argparse
import sys
from pathlib import Path
from typing import Any, Final

from swerve.commands.printing import print_paths

REPRODUCE_SHARE: Final = 0.8  # of the time that a reproduction takes, what its runs take [1]


def add_command(commands: Any) -> None:
    """Add it to a parser's `commands`."""
    reproduce = commands.add_parser("reproduce", help="make the paper's tables and figures", allow_abbrev=False)
    reproduce.set_defaults(call=_reproduce)
    reproduce.add_argument(
        "--out", type=Path, default=Path("swerve-reproduction"), metavar="DIR", help="where to [swerve-reproduction]"
    )


def _reproduce(options: argparse.Namespace) -> int:
    from swerve.report import Progress, ablation_table, prepare_output, write_reproduction
    from swerve.study.reproduce import reproduce

    prepare_output(options.out)
    with Progress(sys.stderr) as progress:
        reproduction = reproduce(progress.part(0.0, REPRODUCE_SHARE))
        paths = write_reproduction(reproduction, options.out, progress.part(REPRODUCE_SHARE, 1.0))
    print(ablation_table(reproduction.ablation))
    print_paths(paths, sys.stdout)
    return 0
