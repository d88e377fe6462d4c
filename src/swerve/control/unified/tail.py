"""Beyond the horizon: a point mass that goes on swerving to its side.

At 72 km/h the horizon of Table 3 ends after 20 m. A plan that sees no further meets the obstacle's near edge first, slows
down a little to stop short of it, and finds out too late that there was only room to steer. So the path goes on:

    p(tau) = p_N + v_N tau + side (a / 2) tau^2 e_Y,    a = GRIP mu g

It asks of the end of the plan what a friction circle can still mend, and no more; eq. (10) has no part in it.
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
        return cls(np.arange(1, n_samples + 1) * sample_time, GRIP * friction * GRAVITY)

    def poses(self, end: Array, side: Side) -> Array:
        """X, Y, psi (n_tail, 3) that follow the state (6,) at the horizon's end."""
        velocity = _turn(end[PSI]) @ end[[VX, VY]]
        poses = np.empty((len(self.times), 3))
        poses[:, :2] = end[[X, Y]] + self.times[:, np.newaxis] * velocity
        poses[:, 1] += side.value * self.acceleration / 2 * self.times**2
        poses[:, 2] = end[PSI]
        return poses

    def sensitivities(self, end: Array, of_end: Array) -> Array:
        """Their derivatives (n_tail, 3, n), from those of the state at the horizon's end, (6, n)."""
        turn = _turn(end[PSI])
        ahead = turn @ end[[VX, VY]]
        of_velocity = turn @ of_end[[VX, VY]] + np.outer((-ahead[1], ahead[0]), of_end[PSI])
        moved = of_end[[X, Y, PSI]][np.newaxis].repeat(len(self.times), axis=0)
        moved[:, :2] += self.times[:, np.newaxis, np.newaxis] * of_velocity
        return moved


def _turn(angle: float) -> Array:
    """Body axes to world axes."""
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, -sin], [sin, cos]])
