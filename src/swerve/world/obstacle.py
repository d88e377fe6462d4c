"""An obstacle: a shape and how it moves."""

from dataclasses import dataclass

from numpy import float64
from numpy.typing import ArrayLike, NDArray

from swerve.world.motions import Motion
from swerve.world.shapes import Shape


@dataclass(frozen=True)
class Obstacle:
    """A shape that moves.

    Attributes:
        shape: in the obstacle's own body frame.
        motion: of that frame.
    """

    shape: Shape
    motion: Motion

    def position_at(self, times: ArrayLike) -> NDArray[float64]:
        """Position of the shape's origin (..., 2) [m] at times (...) [s]."""
        return self.motion.position_at(times)

    def velocity_at(self, times: ArrayLike) -> NDArray[float64]:
        """Velocity in world axes (..., 2) [m/s] at times (...) [s]."""
        return self.motion.velocity_at(times)

    def heading_at(self, times: ArrayLike) -> NDArray[float64]:
        """Of the shape's x axis from the world's X axis, anticlockwise (...) [rad], at times (...) [s]."""
        return self.motion.heading_at(times)
