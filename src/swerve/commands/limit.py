"""`swerve limit`: how close to the limit a scenario is."""

import argparse
import sys
from typing import Any, Final

from swerve.commands.quantities import names

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
    limit.add_argument("--json", action="store_true", help="print the limits as one JSON object")


def _limit(options: argparse.Namespace) -> int:
    from swerve.scenario import load

    scenario = load(options.scenario, options.set)
    means = MEANS if options.means is None else names("means", "mean", options.means, MEANS)
    from swerve.report.limit import limits_json, limits_table
    from swerve.report.progress import Progress
    from swerve.study.limit import Means, limits_of

    with Progress(sys.stderr) as progress:
        limits = limits_of(scenario, [Means(name) for name in means], progress)
    print(limits_json(limits) if options.json else limits_table(limits))
    return 0
