"""The path that the vehicle is about to follow, and where on it the vehicle is while it brakes.

Braking changes when the vehicle is somewhere, not where it goes: s(t) = v t - a t^2 / 2 until it stands, or has the
speed that it is to have.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import PSI, X, Y

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Path:
    """A path by its length; behind its last pose it goes straight on.

    Attributes:
        lengths: (n,) from the start to each pose, not falling [m].
        poses: (n, 3) X [m], Y [m], psi [rad].
    """

    lengths: Array
    poses: Array

    @classmethod
    def through(cls, states: Array) -> "Path":
        """The path through states (n, 6)."""
        steps = np.hypot(np.diff(states[:, X]), np.diff(states[:, Y]))
        return cls(np.append(0.0, np.cumsum(steps)), states[:, [X, Y, PSI]])

    def at(self, s: Array) -> Array:
        """Poses (m, 3) at lengths (m,) [m]."""
        poses = np.column_stack([np.interp(s, self.lengths, column) for column in self.poses.T])
        beyond = np.maximum(0.0, s - self.lengths[-1])
        poses[:, 0] += beyond * np.cos(self.poses[-1, 2])
        poses[:, 1] += beyond * np.sin(self.poses[-1, 2])
        return poses


def travelled(speed: float, deceleration: float, times: Array, end: float = 0.0) -> Array:
    """Lengths s (n,) [m] after times (n,) [s], from `speed` to the speed `end` [m/s] and on with that.

    A negative deceleration [m/s^2] speeds up; with one of 0 the speed stays.
    """
    lasts = max(0.0, (speed - end) / deceleration) if deceleration != 0 else np.inf
    changing = np.minimum(times, lasts)
    return np.asarray(speed * changing - deceleration / 2 * changing**2 + end * (times - changing))
