"""A line through the values of a parameter over the vertical load: least squares, y = a + b Fz."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

FLAT = 1e-9  # of the mean: a scatter below it is the rounding of values that are all the same [1]


@dataclass(frozen=True)
class Line:
    """A fitted line.

    Attributes:
        at_no_load: a, in the unit of the values.
        per_newton: b, in it over [N].
        r_squared: share of the values' variance that the line explains; 1 for values that are all the same [1].
    """

    at_no_load: float
    per_newton: float
    r_squared: float

    def at(self, load: ArrayLike) -> Array:
        """The line's value at vertical loads [N]."""
        value: Array = self.at_no_load + self.per_newton * np.asarray(load, dtype=float)
        return value


def fit_line(loads: Sequence[float], values: Sequence[float]) -> Line:
    """The least-squares line through `values` at `loads` [N], two different ones at least."""
    x, y = np.asarray(loads, dtype=float), np.asarray(values, dtype=float)
    dx, dy = x - x.mean(), y - y.mean()
    slope = float(dx @ dy / (dx @ dx))
    rest = dy - slope * dx
    is_flat = np.abs(dy).max() <= FLAT * abs(y.mean())
    return Line(float(y.mean() - slope * x.mean()), slope, 1.0 if is_flat else float(1 - rest @ rest / (dy @ dy)))
