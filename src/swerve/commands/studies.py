"""`swerve study`: one of the studies of how far the controller reaches, run to its end and written to files."""

import argparse
import sys
from collections.abc import Callable
from concurrent.futures import Executor
from pathlib import Path
from typing import Any, Final

from swerve.commands.options import add_seed
from swerve.commands.pool import add_workers, check_workers, pool
from swerve.commands.printing import print_paths
from swerve.errors import InputError, unknown

N_MULTIBODY: Final = 100  # scenes on the multibody plant, which takes longer to run

Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1
Study = Callable[[Path, int, Executor | None, Callable[[float, float], Progress]], list[Path]]


def add_command(commands: Any) -> None:
    """Add it to a parser's `commands`."""
    study = commands.add_parser("study", help="run many scenes, and write a table", allow_abbrev=False)
    study.set_defaults(call=_study)
    study.add_argument("name", metavar="NAME", help=f"one of {', '.join(STUDIES)}")
    add_seed(study)
    add_workers(study, "scenes")
    study.add_argument("--out", type=Path, default=Path("swerve-study"), metavar="DIR", help="where to [swerve-study]")


def _study(options: argparse.Namespace) -> int:
    from swerve.report import Progress, prepare_output

    if options.name not in STUDIES:
        raise InputError(unknown("study", options.name, STUDIES))
    check_workers(options.workers)
    prepare_output(options.out)
    with Progress(sys.stderr) as progress, pool(options.workers) as executor:
        paths = STUDIES[options.name](options.out, options.seed, executor, progress.part)
    print_paths(paths, sys.stdout)
    return 0


def _random_scenes(
    out: Path, seed: int, executor: Executor | None, part: Callable[[float, float], Progress]
) -> list[Path]:
    from swerve.report.random_scenes import write_survey
    from swerve.study.random_scenes import survey

    surveys = [
        survey("planar", seed, part(0.0, 0.8), executor),
        survey("multibody", seed, part(0.8, 1.0), executor, n_scenes=N_MULTIBODY, n_quiet=N_MULTIBODY),
    ]
    return write_survey(surveys, out)


def _fuzz(out: Path, seed: int, executor: Executor | None, part: Callable[[float, float], Progress]) -> list[Path]:
    """One step follows the other, in this process."""
    from swerve.report.fuzz import as_markdown
    from swerve.study.fuzz import fuzz

    return _written(out, "fuzz.md", as_markdown(fuzz(seed, part(0.0, 1.0))))


def _written(directory: Path, name: str, text: str) -> list[Path]:
    from swerve.report.output import filled

    with filled(directory) as place:
        (place / name).write_text(text, encoding="utf-8", newline="\n")
    return [directory / name]


STUDIES: Final[dict[str, Study]] = {"random-scenes": _random_scenes, "fuzz": _fuzz}
