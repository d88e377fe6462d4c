"""Beyond the horizon: a point mass that goes on swerving to its side.

At 72 km/h the horizon of Table 3 ends after 20 m. A plan that sees no further meets the obstacle's near edge first,
slows down a little to stop short of it, and finds out too late that there was only room to steer. So the path goes on:

    p(tau) = p_N + v_N tau + side (a / 2) tau^2 e_Y,    a = GRIP mu g

It asks of the end of the plan what a friction circle can still mend, and no more; the cost (10) does not see it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Side
from swerve.conventions import GRAVITY, PSI, VX, VY, X, Y

Array = NDArray[np.float64]

GRIP = 0.6  # [1] share of mu g; the rest is the time that a yaw rate takes to build up


@dataclass(frozen=True)
class Tail:
    """The path beyond the horizon.

    Attributes:
        times: (n_tail,) tau of its poses, from the horizon's end on [s].
        acceleration: a [m/s^2].
    """

    times: Array
    acceleration: float

    @classmethod
    def of(cls, friction: float, n_samples: int, sample_time: float) -> "Tail":
        """As many samples as the horizon has."""
        return cls(sample_time * np.arange(1.0, n_samples + 1.0), GRIP * friction * GRAVITY)

    def poses(self, end: Array, side: Side) -> Array:
        """X, Y, psi (n_tail, 3) that follow the state (6,) at the horizon's end."""
        forwards, leftwards = _velocity(end)
        poses = np.empty((len(self.times), 3))
        poses[:, 0] = end[X] + self.times * forwards
        poses[:, 1] = end[Y] + self.times * (leftwards + side.value * self.acceleration / 2 * self.times)
        poses[:, 2] = end[PSI]
        return poses

    def sensitivities(self, end: Array, of_end: Array) -> Array:
        """Their derivatives (n_tail, 3, n), from those of the state at the horizon's end, (6, n)."""
        forwards, leftwards = _velocity(end)
        cos, sin = np.cos(end[PSI]), np.sin(end[PSI])
        of_forwards = cos * of_end[VX] - sin * of_end[VY] - leftwards * of_end[PSI]
        of_leftwards = sin * of_end[VX] + cos * of_end[VY] + forwards * of_end[PSI]
        moved = np.empty((len(self.times), 3, of_end.shape[1]))
        moved[:, 0] = of_end[X] + np.outer(self.times, of_forwards)
        moved[:, 1] = of_end[Y] + np.outer(self.times, of_leftwards)
        moved[:, 2] = of_end[PSI]
        return moved


def _velocity(state: Array) -> tuple[float, float]:
    """Velocity along X and Y [m/s]."""
    cos, sin = np.cos(state[PSI]), np.sin(state[PSI])
    return cos * state[VX] - sin * state[VY], sin * state[VX] + cos * state[VY]
