"""Tyre data to fit, made by a formula written out here, as points and as CSV."""

from collections.abc import Iterable, Sequence
from math import atan, radians, sin
from pathlib import Path

import numpy as np

from swerve.vehicle.fitting import LoadBlock, TyreData

HERE = Path(__file__).parent
HEADER = "load [N], slip_angle [deg], lateral_force [N]"
DEGREES = [0.5 * i for i in range(-24, 25)]  # -12 to 12 deg


def force(load: float, alpha: float, B: float, C: float, D: float, E: float = 0.0) -> float:
    """Eq. (3) with mu = 1 [N] at a load [N] and slip angle [rad]."""
    x = B * alpha
    return load * D * sin(C * atan(x - E * (x - atan(x))))


def data(loads: Sequence[float], parameters: Sequence[Sequence[float]], degrees: Sequence[float] = DEGREES) -> TyreData:
    """Points at `degrees` of slip for each load [N], with its B, C, D (and E)."""
    alphas = np.radians(degrees)
    blocks = [
        LoadBlock(
            f"load {load:g} N", np.full_like(alphas, load), alphas, np.array([force(load, a, *p) for a in alphas])
        )
        for load, p in zip(loads, parameters, strict=True)
    ]
    return TyreData("made.csv", "made here", tuple(blocks))


def rows(load: float, degrees: Iterable[float] = DEGREES) -> list[str]:
    """Lines of a CSV file at one load [N], with B = 12, C = 1.45 and D = 0.95."""
    return [f"{load!r}, {degree!r}, {force(load, radians(degree), 12.0, 1.45, 0.95)!r}" for degree in degrees]


def table(*blocks: Sequence[str], header: str = HEADER) -> str:
    """The text of a CSV file."""
    return "\n".join([header, *(line for block in blocks for line in block)]) + "\n"


GOOD = table(rows(1500.0), rows(3000.0), rows(6000.0))
