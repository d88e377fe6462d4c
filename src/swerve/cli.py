"""The command line: parse, call, print. What it prints and its exit statuses are what scripts hold on to.

    0  done, whatever the run's outcome        2    wrong input: one message on stderr, nothing written
    1  --require was not met                   130  interrupted

Everything heavy is imported by the command that needs it, so that --help answers at once.
"""

import argparse
import json
import os
import sys
from collections.abc import Iterable, Sequence
from io import StringIO
from pathlib import Path
from typing import Final, NoReturn, TextIO

from swerve import __version__
from swerve.commands import criticality, export, limit, manoeuvres, studies, view
from swerve.errors import InputError, SwerveError, unknown

INTERRUPTED: Final = 130  # 128 + SIGINT, as shells have it
BROKEN_PIPE: Final = 141  # 128 + SIGPIPE
RUN_SHARE: Final = 0.3  # of the time that a run with files takes, what the run itself takes [1]
EXPORT_SHARE: Final = 0.4  # likewise its exports, where there are any [1]
REPRODUCE_SHARE: Final = 0.8  # likewise of a reproduction [1]


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line `argv`, that of the process by default, and return the exit status."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the matrices are small: a second thread only makes them wait
    try:
        status = _command(argv)
        sys.stdout.flush()
        return status
    except SwerveError as error:
        print(f"swerve: error: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("swerve: interrupted", file=sys.stderr)
        return INTERRUPTED
    except OSError as error:  # of the output: a reader that has seen enough, a full disk
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or Python's flush at exit would fail again
        if isinstance(error, BrokenPipeError):
            return BROKEN_PIPE
        print(f"swerve: error: cannot write: {error}", file=sys.stderr)
        return 2


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise InputError(f"{message} (see {self.prog} --help)")


def _command(argv: Sequence[str] | None) -> int:
    try:
        options = _parser().parse_args(argv)
    except SystemExit:  # --help and --version have printed what they are for
        return 0
    status: int = options.call(options)
    return status


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="swerve", description="Emergency manoeuvres: decided, driven and measured.", allow_abbrev=False
    )
    parser.add_argument("--version", action="version", version=f"swerve {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

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
    run.add_argument("--seed", type=_seed, default=0, help="of all that is random [0]")
    run.add_argument("--out", type=Path, metavar="DIR", help="write result, log, scenario and figures there")
    run.add_argument("--export", metavar="FORMAT[,FORMAT]", help="write csv, mcap, mf4, gif, webp or mp4 there, too")
    run.add_argument("--json", action="store_true", help="print the result as one JSON object")
    run.add_argument("--explain", action="store_true", help="say when the decision changed, and why")
    run.add_argument("--quiet", action="store_true", help="print errors alone, and with --json the result")
    run.add_argument("--require", metavar="OUTCOME", help="exit with status 1 at any other outcome")

    scenarios = commands.add_parser("scenarios", help="list the library of scenarios", allow_abbrev=False)
    scenarios.set_defaults(call=_scenarios)
    scenarios.add_argument("--json", action="store_true", help="print the list as JSON")

    fit_tyre = commands.add_parser("fit-tyre", help="fit a tyre to data", allow_abbrev=False)
    fit_tyre.set_defaults(call=_fit_tyre)
    fit_tyre.add_argument("data", type=Path, metavar="DATA", help="tyre data in a .csv or .tir file")
    fit_tyre.add_argument("--json", action="store_true", help="print the fit as one JSON object")
    fit_tyre.add_argument("--out", type=Path, metavar="FILE", help="write the tyre there, for a scenario's ego.tyre")

    reproduce = commands.add_parser("reproduce", help="make the paper's tables and figures", allow_abbrev=False)
    reproduce.set_defaults(call=_reproduce)
    reproduce.add_argument(
        "--out", type=Path, default=Path("swerve-reproduction"), metavar="DIR", help="where to [swerve-reproduction]"
    )
    export.add_command(commands)
    view.add_command(commands)
    manoeuvres.add_commands(commands)
    limit.add_commands(commands)
    criticality.add_command(commands)
    studies.add_commands(commands)
    return parser


def _seed(text: str) -> int:
    if not (text.isascii() and text.isdigit() and len(text) <= 18):
        raise argparse.ArgumentTypeError(f"{text[:40]!r} is no seed; write a whole number from 0, of at most 18 digits")
    return int(text)


def _run(options: argparse.Namespace) -> int:
    from swerve.scenario import load

    scenario = load(options.scenario, options.set)
    from swerve.simulate import CONTROLLERS, DEFAULT_CONTROLLER, DEFAULT_PLANT, PLANTS, Outcome, run

    controller = _checked("controller", options.controller, CONTROLLERS) or DEFAULT_CONTROLLER
    plant = _checked("plant", options.plant, PLANTS) or DEFAULT_PLANT
    required = _checked("outcome", options.require, [outcome.value for outcome in Outcome], option="require")
    from swerve.report import Console, Progress, prepare_output, result_json, run_summary, write_run
    from swerve.report.exports import formats_named, write_exports

    formats = [] if options.export is None else formats_named(options.export, "--export")
    paths: list[Path] = []
    if options.out is not None:
        prepare_output(options.out)
    elif formats:
        raise InputError(f"--export {options.export}: there is no folder to write to; add --out DIR")
    with Progress(StringIO() if options.quiet else sys.stderr) as progress:
        share = 1.0 if options.out is None else RUN_SHARE
        done = run(scenario, controller, plant, options.seed, progress.part(0.0, share))
        if options.out is not None:
            written = 1.0 - EXPORT_SHARE if formats else 1.0
            paths = write_run(done, options.out, progress.part(share, written))
            paths += write_exports(done, formats, options.out, progress.part(written, 1.0)) if formats else []
    if options.json:
        print(result_json(done.result))
    elif not options.quiet:
        print(run_summary(done, Console.of(sys.stdout)))
    notes = sys.stderr if options.json else sys.stdout
    if options.explain:
        from swerve.report.explain import explanation

        print(explanation(done), file=notes)
    if not options.quiet:
        _print_paths(paths, notes)
    outcome = done.result.outcome.value
    if required in (None, outcome):
        return 0
    print(f"swerve: the outcome is {outcome}, required was {required}", file=sys.stderr)
    return 1


def _scenarios(options: argparse.Namespace) -> int:
    from swerve.scenario import FAMILIES, library_names, load

    library = [load(name) for name in library_names()]
    if options.json:
        library += [load(name) for family in FAMILIES for name in family.members]
        print(json.dumps([each.model_dump(include={"name", "description", "source"}) for each in library]))
        return 0
    lines = [(each.name, each.description) for each in library]
    lines += [(family.pattern, f"{family.title}: {family.ranges}") for family in FAMILIES]
    width = max(len(name) for name, _ in lines)
    print("\n".join(f"{name:{width}}  {description}" for name, description in lines))
    return 0


def _fit_tyre(options: argparse.Namespace) -> int:
    from swerve.report.tyre import fitted_tyre, prepare_tyre_file, tyre_json, tyre_table, write_tyre
    from swerve.vehicle.fitting import fit_tyre, read_tyre_data

    data = read_tyre_data(options.data)
    if options.out is not None:
        prepare_tyre_file(options.out)
    fit = fit_tyre(data)
    tyre = fitted_tyre(fit, (options.out or options.data).stem)
    if options.out is not None:
        write_tyre(tyre, options.out)
    print(tyre_json(fit, tyre) if options.json else tyre_table(fit, tyre))
    _print_paths([options.out] if options.out else [], sys.stderr if options.json else sys.stdout)
    return 0


def _reproduce(options: argparse.Namespace) -> int:
    from swerve.report import Progress, ablation_table, prepare_output, write_reproduction
    from swerve.study.reproduce import reproduce

    prepare_output(options.out)
    with Progress(sys.stderr) as progress:
        reproduction = reproduce(progress.part(0.0, REPRODUCE_SHARE))
        paths = write_reproduction(reproduction, options.out, progress.part(REPRODUCE_SHARE, 1.0))
    print(ablation_table(reproduction.ablation))
    _print_paths(paths, sys.stdout)
    return 0


def _checked(kind: str, name: str | None, known: Iterable[str], option: str | None = None) -> str | None:
    """A name that is known, or None where none was given; the option is called as the kind is, unless said."""
    if name is not None and name not in known:
        raise InputError(f"--{option or kind}: {unknown(kind, name, known)}")
    return name


def _print_paths(paths: Iterable[Path], stream: TextIO) -> None:
    for path in paths:
        print(f"wrote {path}", file=stream)
