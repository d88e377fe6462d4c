"""`swerve manoeuvres` and `swerve manoeuvre`: the library of open-loop tests, and one of them driven."""

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from swerve.errors import InputError, unknown
from swerve.units import to_si

if TYPE_CHECKING:
    from swerve.study.manoeuvres import Manoeuvre

OPTIONS: Final = {"speed": "speed", "friction": "dimensionless"}  # by the parameter's name: its dimension
RANGES: Final = {"speed": (1.0, 100.0, "m/s"), "friction": (0.01, 2.0, "")}  # within which a test means something


def add_command(commands: Any) -> None:
    """Add both to a parser's `commands`."""
    library = commands.add_parser("manoeuvres", help="list the library of manoeuvres", allow_abbrev=False)
    library.set_defaults(call=_library)
    library.add_argument("--json", action="store_true", help="print the list as JSON")

    one = commands.add_parser("manoeuvre", help="drive one test manoeuvre, without a controller", allow_abbrev=False)
    one.set_defaults(call=_drive)
    one.add_argument("name", metavar="NAME", help="of the manoeuvre, as `swerve manoeuvres` lists them")
    one.add_argument("--plant", help="what is driven [multibody]")
    one.add_argument("--vehicle", default="d-class-sedan", help="whose numbers it has [d-class-sedan]")
    one.add_argument("--speed", metavar="QUANTITY", help='as in --speed "80 km/h" [the standard\'s]')
    one.add_argument("--friction", metavar="QUANTITY", help="of the road [the manoeuvre's]")
    one.add_argument("--out", type=Path, metavar="DIR", help="write result, motion and figure there")
    one.add_argument("--json", action="store_true", help="print the result as one JSON object")


def _library(options: argparse.Namespace) -> int:
    from swerve.report.manoeuvre import library_json, library_table
    from swerve.study.manoeuvres import MANOEUVRES

    show = library_json if options.json else library_table
    print(show(MANOEUVRES.values()))
    return 0


def _drive(options: argparse.Namespace) -> int:
    from swerve.report.manoeuvre import manoeuvre_json, manoeuvre_table, write_manoeuvre
    from swerve.report.output import prepare_output
    from swerve.simulate import DEFAULT_PLANT
    from swerve.study.manoeuvres import manoeuvre_named, run_manoeuvre
    from swerve.study.manoeuvres.run import PLANTS
    from swerve.vehicle import VEHICLES, vehicle_named

    manoeuvre = _changed(manoeuvre_named(options.name), options)
    if options.vehicle not in VEHICLES:
        raise InputError(f"--vehicle: {unknown('vehicle', options.vehicle, VEHICLES)}")
    if options.plant is not None and options.plant not in PLANTS:
        raise InputError(f"--plant: {unknown('plant', options.plant, PLANTS)}")
    if options.out is not None:
        prepare_output(options.out)
    run = run_manoeuvre(manoeuvre, vehicle_named(options.vehicle), options.plant or DEFAULT_PLANT)
    paths = [] if options.out is None else write_manoeuvre(run, options.out)
    print(manoeuvre_json(run) if options.json else manoeuvre_table(run))
    for path in paths:
        print(f"wrote {path}", file=sys.stderr if options.json else sys.stdout)
    return 0


def _changed(manoeuvre: "Manoeuvre", options: argparse.Namespace) -> "Manoeuvre":
    """The manoeuvre with what the options say; InputError for a value that cannot be."""
    changes = {}
    for name, dimension in OPTIONS.items():
        text = getattr(options, name)
        if text is not None:
            changes[name] = _quantity(name, text, dimension)
    try:
        return replace(manoeuvre, **changes)  # type: ignore[type-var]
    except ValueError as error:
        raise InputError(f"{manoeuvre.name}: {error}") from error


def _quantity(name: str, text: str, dimension: str) -> float:
    """A quantity or a plain number in SI, within its range."""
    try:
        value = to_si(_number(text), dimension)
    except ValueError as error:
        raise InputError(f"--{name}: {error}") from error
    low, high, unit = RANGES[name]
    if not low <= value <= high:
        raise InputError(f"--{name}: {value:g} {unit}".rstrip() + f" is not from {low:g} to {high:g} {unit}".rstrip())
    return value


def _number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text
