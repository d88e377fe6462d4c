"""Readings off a motion that several standards share."""

import numpy as np
from numpy.typing import NDArray

from swerve.simulate import Table

Array = NDArray[np.float64]


def first_time(time: Array, is_so: NDArray[np.bool_]) -> float:
    """The first time at which it is so [s]; nan when it never is."""
    return float(time[np.argmax(is_so)]) if is_so.any() else float("nan")


def value_at(motion: Table, name: str, time: float) -> float:
    """A column at a time [s]; nan when the motion was over by then."""
    times = motion["time"]
    return float(np.interp(time, times, motion[name], right=np.nan))


def sideslip(motion: Table) -> Array:
    """atan(vy / vx) (n,) [rad]."""
    angles: Array = np.arctan2(motion["vy"], motion["vx"])
    return angles


def largest(values: Array) -> float:
    """Of the absolute values; nan of none."""
    return float(np.abs(values).max()) if len(values) else float("nan")


def travelled(motion: Table, start: float, end: float) -> float:
    """Length of the path from a time to another [s]: [m]."""
    within = (motion["time"] >= start) & (motion["time"] <= end)
    points = motion.stack("X", "Y")[within]
    return float(np.hypot(*np.diff(points, axis=0).T).sum())
