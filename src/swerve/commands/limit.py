"""`swerve limit`: how close to the limit a scenario is."""

import argparse
import sys
from collections.abc import Sequence
from typing import Any, Final

from swerve.errors import InputError, unknown

MEANS: Final = ("braking", "steering", "both", "individual")  # `study.limit.Means`, which takes long to import


def add_command(commands: Any) -> None:
    """Add it to a parser's `commands`."""
    limit = commands.add_parser(
        "limit", help="smallest distance and friction at which any control could still avoid", allow_abbrev=False
    )
    limit.set_defaults(call=_limit)
    limit.add_argument("scenario", nargs="?", default="paper", metavar="SCENARIO", help="name or TOML file [paper]")
    limit.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="replace a value")
    limit.add_argument("--means", metavar="M,M,...", help=f"of {', '.join(MEANS)} [all]")
    shown = limit.add_mutually_exclusive_group()
    shown.add_argument("--json", action="store_true", help="print the limits as one JSON object")
    shown.add_argument("--map", action="store_true", help="print the distance over speed and friction, as Markdown")


def _limit(options: argparse.Namespace) -> int:
    from swerve.scenario import load

    scenario = load(options.scenario, options.set)
    names = MEANS if options.means is None else _named(options.means)
    if options.map:
        return _map(options.scenario, options.set, names)
    from swerve.report.limit import limits_json, limits_table
    from swerve.report.progress import Progress
    from swerve.study.limit import Means, limits_of

    with Progress(sys.stderr) as progress:
        limits = limits_of(scenario, [Means(name) for name in names], progress)
    print(limits_json(limits) if options.json else limits_table(limits))
    return 0


def _map(scenario: str, overrides: Sequence[str], names: Sequence[str]) -> int:
    from swerve.report.limit import map_markdown
    from swerve.report.progress import Progress
    from swerve.study.limit import Means
    from swerve.study.limit.map import limit_map

    with Progress(sys.stderr) as progress:
        for i, name in enumerate(names):
            part = progress.part(i / len(names), (i + 1) / len(names))
            print(map_markdown(limit_map(scenario, Means(name), overrides, progress=part)))
    return 0


def _named(text: str) -> list[str]:
    """Names in their order, each once; InputError for one that is none."""
    names = list(dict.fromkeys(name.strip() for name in text.split(",")))
    for name in names:
        if name not in MEANS:
            raise InputError(f"--means: {unknown('mean', name, MEANS)}")
    return names
