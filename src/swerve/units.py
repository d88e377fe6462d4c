"""Quantities at the border: a number in SI, or a number and its unit in a string, such as "72 km/h".

Inside, everything is SI and radians; only scenario files, the command line and reports know other units. The table
of units is closed: a unit that is not listed is an error, and so is a unit of another dimension.
"""

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from swerve.errors import shown


@dataclass(frozen=True)
class Dimension:
    """A kind of quantity: what it is called, how one is written, and its units.

    Attributes:
        noun: its name in a sentence, with the article.
        example: a right way to write one.
        units: factor to SI of every accepted unit; the first is the SI unit, "" for a plain number.
    """

    noun: str
    example: str
    units: Mapping[str, float]

    @property
    def si_unit(self) -> str:
        """The SI unit, "" for a plain number."""
        return next(iter(self.units))


_DEGREE: Final = math.pi / 180  # [rad]

DIMENSIONS: Final[Mapping[str, Dimension]] = {
    "dimensionless": Dimension("a plain number", "85 %", {"": 1.0, "%": 0.01}),
    "time": Dimension("a time", "50 ms", {"s": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0}),
    "length": Dimension("a length", "25 m", {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "km": 1e3, "ft": 0.3048, "in": 0.0254}),
    "speed": Dimension("a speed", "72 km/h", {"m/s": 1.0, "km/h": 1 / 3.6, "mph": 0.44704, "kn": 1852 / 3600}),
    "acceleration": Dimension("an acceleration", "-4 m/s^2", {"m/s^2": 1.0, "g": 9.80665}),
    "angle": Dimension("an angle", "5 deg", {"rad": 1.0, "mrad": 1e-3, "deg": _DEGREE}),
    "angular speed": Dimension("an angular speed", "20 deg/s", {"rad/s": 1.0, "deg/s": _DEGREE}),
    "mass": Dimension("a mass", "1600 kg", {"kg": 1.0, "g": 1e-3, "t": 1e3, "lb": 0.45359237}),
    "force": Dimension("a force", "4 kN", {"N": 1.0, "kN": 1e3}),
    "moment of inertia": Dimension("a moment of inertia", "2315.3 kg m^2", {"kg m^2": 1.0}),
}

_QUANTITY: Final = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([^\d\s.].*)?", re.ASCII | re.DOTALL)
_NOT_FINITE: Final = re.compile(r"[+-]?(nan|inf(inity)?)\b", re.ASCII | re.IGNORECASE)


def to_si(value: object, dimension: str) -> float:
    """The SI value of a quantity.

    Args:
        value: a number in SI, or a string of a number and a unit: "72 km/h", "3.5m", "-4 m/s²".
        dimension: a key of `DIMENSIONS`.

    Returns:
        The value in the SI unit of the dimension, finite.

    Raises:
        ValueError: it is no finite quantity of that dimension; the text says what would be.
    """
    kind = DIMENSIONS[dimension]
    if isinstance(value, str):
        number, factor = _split(value, kind)
    elif isinstance(value, int | float) and not isinstance(value, bool):
        number, factor = value, 1.0
    else:
        raise _refusal(value, f"not {kind.noun}", kind)
    try:
        result = float(number) * factor
    except OverflowError:
        result = math.inf
    if not math.isfinite(result):
        raise _refusal(value, "not finite", kind)
    return result


def _split(text: str, kind: Dimension) -> tuple[float, float]:
    """The number of "72 km/h", and the factor of its unit."""
    match = _QUANTITY.fullmatch(text.strip())
    if match is None:
        raise _refusal(text, "not finite" if _NOT_FINITE.match(text.strip()) else f"not {kind.noun}", kind)
    number, unit = match[1], _spelled(match[2] or "")
    if unit not in kind.units:
        raise _refusal(text, f"not {kind.noun}" if unit else "without a unit", kind)
    return float(number), kind.units[unit]


def _spelled(unit: str) -> str:
    """The unit as the table writes it: "m/s²" and "m/s2" are "m/s^2", "kg*m^2" is "kg m^2", "°" is "deg"."""
    unit = re.sub(r"\s*[*·]\s*|\s+", " ", unit).replace("²", "^2").replace("°", "deg")
    return re.sub(r"(?<=[a-z])2$", "^2", unit)


def _refusal(value: object, fault: str, kind: Dimension) -> ValueError:
    if kind.si_unit:
        units = ", ".join(kind.units)
        cure = f'write a number in {kind.si_unit} or a string such as "{kind.example}" (units: {units})'
    else:
        cure = f'write a number, or a string such as "{kind.example}"'
    return ValueError(f"{shown(value)} is {fault}; {cure}")
