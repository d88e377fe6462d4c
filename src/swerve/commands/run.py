"""`swerve run`: one scenario, one controller, one plant."""

import argparse
import sys
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from swerve.commands.options import add_seed, checked
from swerve.commands.printing import print_paths
from swerve.errors import InputError

if TYPE_CHECKING:
    from swerve.report.exports import Format
    from swerve.simulate import Run

RUN_SHARE: Final = 0.3  # of the time that a run with files takes, what the run itself takes [1]
EXPORT_SHARE: Final = 0.4  # likewise its exports, where there are any [1]


def add_command(commands: Any) -> None:
    """Add it to a parser's `commands`."""
    run = commands.add_parser("run", help="run one scenario", allow_abbrev=False)
    run.set_defaults(call=_run)
    run.add_argument(
        "scenario", nargs="?", default="paper", metavar="SCENARIO", help="library name or TOML file [paper]"
    )
    run.add_argument("--controller", help="who drives [unified]")
    run.add_argument("--plant", help="what is driven [multibody]")
    run.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help='replace a value, as in --set "ego.speed=90 km/h"',
    )
    add_seed(run)
    run.add_argument("--out", type=Path, metavar="DIR", help="write result, log, scenario, report and figures there")
    run.add_argument("--export", metavar="FORMAT[,FORMAT]", help="write csv, mcap, mf4, gif, webp or mp4 there, too")
    run.add_argument("--json", action="store_true", help="print the result as one JSON object")
    run.add_argument("--explain", action="store_true", help="say when the decision changed, and why")
    run.add_argument("--quiet", action="store_true", help="print errors alone, and with --json the result")
    run.add_argument("--require", metavar="OUTCOME", help="exit with status 1 at any other outcome")


def _run(options: argparse.Namespace) -> int:
    from swerve.scenario import load

    scenario = load(options.scenario, options.set)
    from swerve.simulate import CONTROLLERS, DEFAULT_CONTROLLER, DEFAULT_PLANT, PLANTS, Outcome, run

    controller = checked("controller", options.controller, CONTROLLERS) or DEFAULT_CONTROLLER
    plant = checked("plant", options.plant, PLANTS) or DEFAULT_PLANT
    required = checked("outcome", options.require, [outcome.value for outcome in Outcome], option="require")
    from swerve.report import Progress, prepare_output

    formats = _formats(options)
    if options.out is not None:
        prepare_output(options.out)
    with Progress(StringIO() if options.quiet else sys.stderr) as progress:
        share = 1.0 if options.out is None else RUN_SHARE
        done = run(scenario, controller, plant, options.seed, progress.part(0.0, share))
        paths = [] if options.out is None else _written(done, formats, options.out, progress)
    _print(done, paths, options)
    outcome = done.result.outcome.value
    if required in (None, outcome):
        return 0
    print(f"swerve: the outcome is {outcome}, required was {required}", file=sys.stderr)
    return 1


def _formats(options: argparse.Namespace) -> "list[Format]":
    from swerve.report.exports import formats_named

    if options.export is None:
        return []
    formats = formats_named(options.export, "--export")
    if options.out is None:
        raise InputError(f"--export {options.export}: there is no folder to write to; add --out DIR")
    return formats


def _written(done: "Run", formats: "list[Format]", directory: Path, progress: Any) -> list[Path]:
    """The files of a run and its exports."""
    from swerve.report import write_run
    from swerve.report.exports import write_exports

    written = 1.0 - EXPORT_SHARE if formats else 1.0
    paths: list[Path] = write_run(done, directory, progress.part(RUN_SHARE, written))
    if formats:
        paths += write_exports(done, formats, directory, progress.part(written, 1.0))
    return paths


def _print(done: "Run", paths: list[Path], options: argparse.Namespace) -> None:
    """What was asked for; with --json the object is alone on its stream."""
    from swerve.report import Console, result_json, run_summary

    if options.json:
        print(result_json(done.result))
    elif not options.quiet:
        print(run_summary(done, Console.of(sys.stdout)))
    notes = sys.stderr if options.json else sys.stdout
    if options.explain:
        from swerve.report.explain import explanation

        print(explanation(done), file=notes)
    if not options.quiet:
        print_paths(paths, notes)
