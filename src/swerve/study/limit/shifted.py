"""A motion somewhere else along X, at the same times."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swerve.world import Motion, Obstacle


@dataclass(frozen=True)
class Shifted:
    """A motion that is another one, further along X.

    Attributes:
        motion: the other one.
        by: how much further [m].
    """

    motion: Motion
    by: float

    def position_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Position (..., 2) [m] at times (...) [s]."""
        position: NDArray[np.float64] = self.motion.position_at(times) + np.array([self.by, 0.0])
        return position

    def velocity_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Velocity (..., 2) [m/s] at times (...) [s]."""
        return self.motion.velocity_at(times)

    def heading_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Heading (...) [rad] at times (...) [s]."""
        return self.motion.heading_at(times)


def shifted(obstacle: Obstacle, by: float) -> Obstacle:
    """The obstacle further along X, by that much more [m] where it is shifted already."""
    motion = obstacle.motion
    if isinstance(motion, Shifted):
        return replace(obstacle, motion=replace(motion, by=motion.by + by))
    return replace(obstacle, motion=Shifted(motion, by))
