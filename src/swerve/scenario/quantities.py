"""The kinds of value that a scenario's keys take, each with its dimension and its bounds.

Every bound is wide: it keeps out what no vehicle and no test can mean, and what would fill the memory.
"""

from collections.abc import Iterable
from math import pi
from typing import Annotated

from pydantic import BeforeValidator

from swerve.errors import shown, unknown
from swerve.units import DIMENSIONS, to_si


def quantity(dimension: str, low: float, high: float, *, above: bool = False) -> BeforeValidator:
    """A quantity of `dimension`, read by `to_si`, from `low` to `high` in SI; with `above`, not `low` itself."""

    def read(value: object) -> float:
        number = to_si(value, dimension)
        if low <= number <= high and not (above and number == low):
            return number
        unit = DIMENSIONS[dimension].si_unit
        least = f"{'more than' if above else 'at least'} {low:g} {unit}".strip()
        raise ValueError(f"{shown(value)} is out of range; write {least} and at most {high:g} {unit}".strip())

    return BeforeValidator(read)


def count(noun: str, low: int, high: int) -> BeforeValidator:
    """A whole number from `low` to `high` of what `noun` names."""

    def read(value: object) -> int:
        if isinstance(value, int) and not isinstance(value, bool) and low <= value <= high:
            return value
        raise ValueError(f"{shown(value)} is no number of {noun}; write a whole number from {low} to {high}")

    return BeforeValidator(read)


def text(longest: int, *, empty: bool = True) -> BeforeValidator:
    """One line of text, of at most `longest` characters."""

    def read(value: object) -> str:
        if not isinstance(value, str):
            raise ValueError(f"{shown(value)} is not a text; write it between quotes")
        if len(value) > longest or not value.isprintable():
            raise ValueError(f"{shown(value)} is not one line of at most {longest} characters")
        if not (empty or value.strip()):
            raise ValueError(f"{shown(value)} is empty; write a word or two")
        return value

    return BeforeValidator(read)


def choice(kind: str, names: Iterable[str]) -> BeforeValidator:
    """One name of a closed list; `kind` says in a message what they name."""
    known = tuple(names)

    def read(value: object) -> str:
        if isinstance(value, str) and value in known:
            return value
        raise ValueError(unknown(kind, value, known))

    return BeforeValidator(read)


Text = Annotated[str, text(500)]
Name = Annotated[str, text(100, empty=False)]

Friction = Annotated[float, quantity("dimensionless", 0.0, 2.0, above=True)]
Weight = Annotated[float, quantity("dimensionless", 0.0, 1e12)]
Duration = Annotated[float, quantity("time", 0.0, 300.0, above=True)]
SampleTime = Annotated[float, quantity("time", 1e-3, 1.0)]
PlantStep = Annotated[float, quantity("time", 1e-4, 1.0)]
Coordinate = Annotated[float, quantity("length", -1e4, 1e4)]
Offset = Annotated[float, quantity("length", -100.0, 100.0)]
Size = Annotated[float, quantity("length", 0.0, 100.0, above=True)]
Speed = Annotated[float, quantity("speed", 0.0, 150.0)]
Velocity = Annotated[float, quantity("speed", -150.0, 150.0)]
Acceleration = Annotated[float, quantity("acceleration", -100.0, 100.0)]
Instant = Annotated[float, quantity("time", 0.0, 300.0)]
WaypointTime = Annotated[float, quantity("time", -300.0, 300.0)]
Heading = Annotated[float, quantity("angle", -2 * pi, 2 * pi)]
SteeringAngle = Annotated[float, quantity("angle", -pi / 2, pi / 2)]
Pedal = Annotated[float, quantity("dimensionless", -1.0, 1.0)]
Preview = Annotated[float, quantity("time", 0.1, 10.0)]
Lanes = Annotated[int, count("lanes", 0, 10)]
Horizon = Annotated[int, count("samples", 1, 200)]
Tail = Annotated[int, count("samples", 0, 200)]
Angle = Annotated[float, quantity("angle", 0.0, pi, above=True)]
Force = Annotated[float, quantity("force", 0.0, 1e6, above=True)]
Margin = Annotated[float, quantity("length", 0.0, 10.0)]
Share = Annotated[float, quantity("dimensionless", 0.0, 1.0)]
Iterations = Annotated[int, count("iterations", 1, 100)]
Delay = Annotated[float, quantity("time", 0.0, 1.0)]
SpeedDeviation = Annotated[float, quantity("speed", 0.0, 10.0)]
YawRateDeviation = Annotated[float, quantity("angular speed", 0.0, 1.0)]
AngleDeviation = Annotated[float, quantity("angle", 0.0, 1.0)]
LengthDeviation = Annotated[float, quantity("length", 0.0, 10.0)]
ForceDeviation = Annotated[float, quantity("force", 0.0, 1e4)]
