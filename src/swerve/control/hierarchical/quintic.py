"""A lane change as a polynomial of fifth degree over the road's axis.

    y(x) = c0 + c1 q + ... + c5 q^5,   q = (x - x0) / L

with y, y', y'' given where it starts, y given where it ends and y' = y'' = 0 there; before and behind it goes on
straight. Of all paths between these ends it is the one with the least integral of y'''^2 (Takahashi et al., Intelligent
Vehicles 1989). From a straight start its largest |y''| is 10 / sqrt(3) (y_end - y_0) / L^2.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

PLACES = np.linspace(0.0, 1.0, 31)  # q at which the largest curvature is looked for
SHORTEST = 1.0  # [m] of a polynomial


@dataclass(frozen=True, eq=False)
class Quintic:
    """The polynomial.

    Attributes:
        start: x0 [m].
        length: L [m].
        coefficients: (6,) c0 to c5 [m].
    """

    start: float
    length: float
    coefficients: Array

    @classmethod
    def between(cls, start: float, at_start: Array, length: float, target: float) -> "Quintic":
        """From y, y', y'' (3,) [m, 1, 1/m] at x0 = `start` [m] to y = `target` [m] after `length` [m]."""
        length = max(length, SHORTEST)
        return cls(start, length, _coefficients(at_start, np.array(length), target))

    @property
    def end(self) -> float:
        """Where it ends, x0 + L [m]."""
        return self.start + self.length

    @property
    def target(self) -> float:
        """Where it leads, y at its end [m]."""
        return float(self.coefficients.sum())

    def at(self, x: Array) -> tuple[Array, Array, Array]:
        """y [m], y' [1] and y'' [1/m] at x (n,) [m]."""
        asked = (x - self.start) / self.length
        q = np.minimum(np.maximum(asked, 0.0), 1.0)
        y, slope, bend = _evaluated(self.coefficients, q)
        y, slope, bend = y + slope * (asked - q), slope / self.length, bend / self.length**2
        return y, slope, np.where(asked == q, bend, 0.0)


def sharpest(at_start: Array, lengths: Array, target: float) -> Array:
    """Largest curvature |y''| / (1 + y'^2)^(3/2) (n,) [1/m] of the polynomials of lengths (n,) [m]."""
    _, slope, bend = _evaluated(_coefficients(at_start, lengths, target)[..., np.newaxis], PLACES)
    along = lengths[:, np.newaxis]
    return np.asarray((np.abs(bend / along**2) / (1 + (slope / along) ** 2) ** 1.5).max(axis=1))


def _coefficients(at_start: Array, length: Array, target: float) -> Array:
    """(6, ...) c0 to c5 [m] for lengths (...) [m]."""
    c0, c1, c2 = at_start[0] + 0 * length, at_start[1] * length, at_start[2] * length**2 / 2
    rest, slope, bend = target - c0 - c1 - c2, -c1 - 2 * c2, -2 * c2
    c3, c4 = 10 * rest - 4 * slope + bend / 2, -15 * rest + 7 * slope - bend
    return np.array([c0, c1, c2, c3, c4, 6 * rest - 3 * slope + bend / 2])


def _evaluated(c: Array, q: Array) -> tuple[Array, Array, Array]:
    """y and its first two derivatives by q, by Horner's scheme."""
    y = c[0] + q * (c[1] + q * (c[2] + q * (c[3] + q * (c[4] + q * c[5]))))
    first = c[1] + q * (2 * c[2] + q * (3 * c[3] + q * (4 * c[4] + q * 5 * c[5])))
    return y, first, 2 * c[2] + q * (6 * c[3] + q * (12 * c[4] + q * 20 * c[5]))
