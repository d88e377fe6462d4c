"""Constant velocity, p(t) = p_0 + v t, and constant heading; at rest without a velocity."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swerve.world.motions.motion import Pair, require_finite


@dataclass(frozen=True)
class Steady:
    """A motion that stays as it is.

    Attributes:
        position: at time zero, (x_o, y_o) of eq. (5) [m].
        velocity: in world axes [m/s].
        heading: of the body's x axis from the world's X axis, anticlockwise [rad].

    Raises:
        ValueError: a number that is not finite.
    """

    position: Pair
    velocity: Pair = (0.0, 0.0)
    heading: float = 0.0

    def __post_init__(self) -> None:
        for name, numbers in (("position", self.position), ("velocity", self.velocity), ("heading", (self.heading,))):
            require_finite(name, numbers)

    def position_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Position (..., 2) [m] at times (...) [s]."""
        elapsed = np.asarray(times, dtype=float)[..., np.newaxis]
        position: NDArray[np.float64] = np.asarray(self.position) + elapsed * np.asarray(self.velocity)
        return position

    def velocity_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """The velocity (..., 2) [m/s], the same at all times (...) [s]."""
        return np.full((*np.shape(times), 2), self.velocity, dtype=float)

    def heading_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """The heading (...) [rad], the same at all times (...) [s]."""
        return np.full(np.shape(times), self.heading, dtype=float)
