"""`swerve compare`: scenarios by controllers, side by side."""

import argparse
import sys
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from swerve.commands.options import add_seed, checked
from swerve.commands.pool import add_workers, check_workers, pool
from swerve.commands.printing import print_paths
from swerve.commands.quantities import names

if TYPE_CHECKING:
    from swerve.report import Progress
    from swerve.study.comparison import Comparison

CONTROLLERS: Final = ("unified", "nonlinear", "hierarchical", "brake")  # where none is named
RUN_SHARE: Final = 0.6  # of the time that a comparison with files takes, what its runs take [1]


def add_command(commands: Any) -> None:
    """Add it to a parser's `commands`."""
    compare = commands.add_parser("compare", help="scenarios by controllers, side by side", allow_abbrev=False)
    compare.set_defaults(call=_compare)
    compare.add_argument("scenarios", nargs="+", metavar="SCENARIO", help="library name or TOML file")
    compare.add_argument("--controllers", metavar="C,C,...", help=f"who drives [{','.join(CONTROLLERS)}]")
    compare.add_argument("--plant", help="what is driven [multibody]")
    compare.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="replace a value in every scenario"
    )
    add_seed(compare)
    add_workers(compare, "runs")
    compare.add_argument("--out", type=Path, metavar="DIR", help="write table, figures, report and all runs there")
    compare.add_argument("--json", action="store_true", help="print the comparison as one JSON object")
    compare.add_argument("--quiet", action="store_true", help="print errors alone, and with --json the comparison")


def _compare(options: argparse.Namespace) -> int:
    from swerve.scenario import load

    scenarios = [load(each, options.set) for each in options.scenarios]
    from swerve.simulate import CONTROLLERS as KNOWN
    from swerve.simulate import DEFAULT_PLANT, PLANTS

    controllers = (
        CONTROLLERS if options.controllers is None else names("controllers", "controller", options.controllers, KNOWN)
    )
    plant = checked("plant", options.plant, PLANTS) or DEFAULT_PLANT
    check_workers(options.workers)
    from swerve.report import Progress, prepare_output
    from swerve.study.comparison import check, compare

    check(scenarios, plant)
    if options.out is not None:
        prepare_output(options.out)
    with Progress(StringIO() if options.quiet else sys.stderr) as progress:
        share = 1.0 if options.out is None else RUN_SHARE
        with pool(options.workers) as executor:
            found = compare(scenarios, controllers, plant, options.seed, progress.part(0.0, share), executor)
        paths = [] if options.out is None else _written(found, options.out, progress)
    _print(found, paths, options)
    return 0


def _written(found: "Comparison", directory: Path, progress: "Progress") -> list[Path]:
    from swerve.report.comparison import write_comparison

    return write_comparison(found, directory, progress.part(RUN_SHARE, 1.0))


def _print(found: "Comparison", paths: list[Path], options: argparse.Namespace) -> None:
    """What was asked for; with --json the object is alone on its stream."""
    from swerve.report import Console
    from swerve.report.comparison import comparison_json, comparison_table

    if options.json:
        print(comparison_json(found))
    elif not options.quiet:
        print(comparison_table(found, Console.of(sys.stdout)))
    if not options.quiet:
        print_paths(paths, sys.stderr if options.json else sys.stdout)
