"""What every motion answers: where, how fast and how turned, at any time, before zero as well."""

import math
from collections.abc import Iterable
from typing import Protocol

from numpy import float64
from numpy.typing import ArrayLike, NDArray

Pair = tuple[float, float]  # along X and along Y


class Motion(Protocol):
    """A motion in the plane; `times` may have any shape (...)."""

    def position_at(self, times: ArrayLike) -> NDArray[float64]:
        """Position of the body's origin (..., 2) [m] at times (...) [s]."""
        ...

    def velocity_at(self, times: ArrayLike) -> NDArray[float64]:
        """Its derivative (..., 2) [m/s] at times (...) [s]; where that jumps, the one from then on."""
        ...

    def heading_at(self, times: ArrayLike) -> NDArray[float64]:
        """Of the body's x axis from the world's X axis, anticlockwise (...) [rad], at times (...) [s]."""
        ...


def require_finite(name: str, numbers: Iterable[float]) -> None:
    """ValueError that starts with `name` unless all numbers are finite."""
    told = tuple(numbers)
    if not all(map(math.isfinite, told)):
        raise ValueError(f"{name} must be finite, got {', '.join(f'{number:g}' for number in told)}")
