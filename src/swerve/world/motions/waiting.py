"""At rest until an instant and at constant velocity from it on: a pedestrian who steps out."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swerve.world.motions.motion import Pair, require_finite


@dataclass(frozen=True)
class Waiting:
    """A motion that begins of a sudden.

    Attributes:
        position: until it begins [m].
        velocity: from then on, in world axes [m/s].
        heading: of the body's x axis from the world's X axis, anticlockwise, constant [rad].
        moves_at: when it begins [s].

    Raises:
        ValueError: a number that is not finite.
    """

    position: Pair
    velocity: Pair
    heading: float
    moves_at: float

    def __post_init__(self) -> None:
        for name, numbers in (("position", self.position), ("velocity", self.velocity)):
            require_finite(name, numbers)
        require_finite("heading", (self.heading,))
        require_finite("moves_at", (self.moves_at,))

    def position_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Position (..., 2) [m] at times (...) [s]."""
        elapsed = np.maximum(np.asarray(times, dtype=float) - self.moves_at, 0.0)[..., np.newaxis]
        position: NDArray[np.float64] = np.asarray(self.position) + elapsed * np.asarray(self.velocity)
        return position

    def velocity_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Velocity (..., 2) [m/s] at times (...) [s]; at `moves_at` it moves."""
        moves = np.asarray(times, dtype=float)[..., np.newaxis] >= self.moves_at
        return np.where(moves, np.asarray(self.velocity, dtype=float), 0.0)

    def heading_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """The heading (...) [rad], the same at all times (...) [s]."""
        return np.full(np.shape(times), self.heading, dtype=float)
