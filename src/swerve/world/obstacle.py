"""An obstacle: a shape that moves with constant velocity and constant heading."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swerve.world.shapes import Shape


@dataclass(frozen=True)
class Obstacle:
    """A shape, where it is at time zero and how it moves.

    Attributes:
        shape: in the obstacle's own body frame.
        position: of the shape's origin at time zero, (x_o, y_o) of eq. (5) [m].
        velocity: in world axes, constant [m/s].
        heading: of the shape's x axis from the world's X axis, anticlockwise, constant [rad].

    Raises:
        ValueError: a position, velocity or heading that is not finite.
    """

    shape: Shape
    position: tuple[float, float]
    velocity: tuple[float, float] = (0.0, 0.0)
    heading: float = 0.0

    def __post_init__(self) -> None:
        for name, values in (("position", self.position), ("velocity", self.velocity), ("heading", (self.heading,))):
            if not all(map(math.isfinite, values)):
                raise ValueError(f"{name} must be finite, got {getattr(self, name)}")

    def position_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Position of the shape's origin [m], shape (..., 2), at `times` of shape (...) [s]."""
        elapsed = np.asarray(times, dtype=float)[..., np.newaxis]
        position: NDArray[np.float64] = np.asarray(self.position) + elapsed * np.asarray(self.velocity)
        return position
