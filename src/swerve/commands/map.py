"""`swerve map`: what is avoidable, over speed, friction, offset and distance."""

import argparse
import os
import sys
from collections.abc import Callable
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from swerve.commands.limit import MEANS
from swerve.commands.options import add_seed, checked
from swerve.commands.pool import pool
from swerve.commands.printing import print_paths
from swerve.commands.quantities import names, quantities, quantity
from swerve.errors import InputError, SwerveError, shown_path

if TYPE_CHECKING:
    from collections.abc import Iterator

    from swerve.simulate import Run
    from swerve.study.map import Condition, Map, MapSettings

SPEEDS: Final = "15,20,25,30,35"  # [m/s]
FRICTIONS: Final = "0.3,0.5,0.85,1.0"
CONTROLLERS: Final = "unified,brake,hierarchical,nonlinear"
LIMITS: Final = "individual,both"
TOLERANCES: Final = (0.001, 10.0)  # [m]
RANGES: Final = {  # by the dimension: smallest and largest value
    "speed": (1.0, 100.0),
    "dimensionless": (0.01, 2.0),
    "length": (-50.0, 50.0),
}
MOST_WORKERS: Final = 256
REPORT_SHARE: Final = 0.02  # of the time [1]
REPLAY_SHARE: Final = 0.15  # of it, with replays [1]


def add_command(commands: Any) -> None:
    """Add it to a parser's `commands`."""
    parser = commands.add_parser("map", help="what is avoidable, over speed, friction and distance", allow_abbrev=False)
    parser.set_defaults(call=_map)
    parser.add_argument("scenario", nargs="?", default="paper", metavar="SCENARIO", help="name or TOML file [paper]")
    parser.add_argument("--controllers", default=CONTROLLERS, metavar="C,C,...", help=f"whose runs [{CONTROLLERS}]")
    parser.add_argument("--plant", help="what is driven [multibody]")
    parser.add_argument("--speeds", default=SPEEDS, metavar="Q,Q,...", help=f'[{SPEEDS}], or as in "72 km/h,30"')
    parser.add_argument("--frictions", default=FRICTIONS, metavar="F,F,...", help=f"of the road [{FRICTIONS}]")
    parser.add_argument("--offsets", default="0", metavar="Q,Q,...", help="of all obstacles, to the left [0]")
    parser.add_argument("--tolerance", default="0.1 m", metavar="Q", help="of a boundary [0.1 m]")
    parser.add_argument("--limit", default=LIMITS, metavar="M,M,...", help=f"of {', '.join(MEANS)}; or none [{LIMITS}]")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="replace a value")
    add_seed(parser)
    parser.add_argument("--workers", type=int, metavar="N", help="processes on this machine [one for each core]")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a dask scheduler that is there, with its workers")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="where to; a map begun there goes on")
    parser.add_argument("--replays", action="store_true", help="write pages to watch the runs at each boundary, too")
    parser.add_argument("--json", action="store_true", help="print the map as one JSON object")


def _map(options: argparse.Namespace) -> int:
    settings = _settings(options)
    n_workers = _n_workers(options)
    from swerve.report import Progress, prepare_output

    prepare_output(options.out)
    with Progress(sys.stderr) as progress:
        share = REPLAY_SHARE if options.replays else REPORT_SHARE
        made, runs = _made(settings, options, n_workers, progress.part(0.0, 1.0 - share))
        replays = _replays(settings, made, n_workers, progress.part(1.0 - share, 1.0)) if options.replays else {}
        paths = [runs, *_written(made, replays, options)]
    _print(made, paths, options.json)
    return 0


def _settings(options: argparse.Namespace) -> "MapSettings":
    """What is asked for, checked."""
    from swerve.scenario import load
    from swerve.simulate import CONTROLLERS, DEFAULT_PLANT, PLANTS
    from swerve.study.map import MapSettings

    plant = checked("plant", options.plant, PLANTS) or DEFAULT_PLANT
    return MapSettings(
        scenario=load(options.scenario, options.set),
        controllers=names("controllers", "controller", options.controllers, CONTROLLERS),
        plant=plant,
        speeds=quantities("speeds", options.speeds, "speed", *RANGES["speed"]),
        frictions=quantities("frictions", options.frictions, "dimensionless", *RANGES["dimensionless"]),
        offsets=quantities("offsets", options.offsets, "length", *RANGES["length"]),
        tolerance=quantity("tolerance", options.tolerance, "length", *TOLERANCES),
        means=() if options.limit == "none" else names("limit", "mean", options.limit, MEANS),
        seed=options.seed,
    )


def _n_workers(options: argparse.Namespace) -> int:
    if options.workers is not None and options.scheduler is not None:
        raise InputError("--workers: the workers are those of --scheduler; leave one of them out")
    n_cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    n_workers: int = n_cores if options.workers is None else options.workers
    if not 1 <= n_workers <= MOST_WORKERS:
        raise InputError(f"--workers: {n_workers} is out of range; write a whole number from 1 to {MOST_WORKERS}")
    return n_workers


def _made(
    settings: "MapSettings", options: argparse.Namespace, n_workers: int, progress: Callable[[float], None]
) -> "tuple[Map, Path]":
    """The map, and the file of its runs; what is stored already is not run again."""
    from swerve.study.map import Store, cells_of, engine, is_complete, map_of, run_missing

    cells = cells_of(settings)
    with Store(options.out, settings) as store, _resumable(options.out, store.records):
        if not is_complete(cells, settings, store):
            with engine(n_workers, options.scheduler) as client:
                run_missing(cells, settings, store, client, progress)
        runs = store.finish()
        return map_of(cells, settings, list(store.records.values())), runs


@contextmanager
def _resumable(directory: Path, records: "dict[str, Any]") -> "Iterator[None]":
    """Tell how to go on where a map is stopped."""
    from swerve.study.map import EngineLostError

    place = shown_path(directory)
    try:
        yield
    except KeyboardInterrupt:
        print(f"swerve: {_kept(records, place)}; the same command goes on from there", file=sys.stderr)
        raise
    except EngineLostError as error:
        raise SwerveError(f"map: {error}; {_kept(records, place)}, the same command goes on from there") from error


def _kept(records: "dict[str, Any]", place: str) -> str:
    return f"{len(records)} results are kept in {place}"


def _replays(
    settings: "MapSettings", made: "Map", n_workers: int, progress: Callable[[float], None]
) -> "dict[Condition, list[Run]]":
    from swerve.study.map import cells_of
    from swerve.study.map.replays import replayed

    with pool(n_workers) as executor:
        return replayed(cells_of(settings), made, executor, progress)


def _written(made: "Map", replays: "dict[Condition, list[Run]]", options: argparse.Namespace) -> list[Path]:
    """The files that are made of it."""
    from swerve.report.map import Source, as_markdown, write_figure, write_map, write_replays
    from swerve.report.output import filled
    from swerve.study.map.written import map_json, write_boundaries

    watched = write_replays(replays, options.out) if replays else []
    with filled(options.out) as place:
        write_boundaries(made, place / "boundaries.parquet")
        (place / "map.json").write_text(map_json(made) + "\n", encoding="utf-8", newline="\n")
        (place / "map.md").write_text(as_markdown(made), encoding="utf-8", newline="\n")
        for name in ("map.png", "map.pdf"):
            write_figure(made, place / name)
        write_map(made, place / "map.html", Source(options.scenario, tuple(options.set)), list(replays))
    written = ("boundaries.parquet", "map.json", "map.md", "map.png", "map.pdf", "map.html")
    return [*(options.out / name for name in written), *watched]


def _print(made: "Map", paths: list[Path], is_json: bool) -> None:
    from swerve.study.map.written import map_json

    if is_json:
        print(map_json(made))
    print_paths(paths, sys.stderr if is_json else sys.stdout)
