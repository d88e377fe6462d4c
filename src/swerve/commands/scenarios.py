"""`swerve scenarios`: the library, a line each, and its families, a line for all members of one."""

import argparse
import json
from typing import Any


def add_command(commands: Any) -> None:
    """Add it to a parser's `commands`."""
    scenarios = commands.add_parser("scenarios", help="list the library of scenarios", allow_abbrev=False)
    scenarios.set_defaults(call=_scenarios)
    scenarios.add_argument("--json", action="store_true", help="print the list as JSON")


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
