"""A driver who looks at one point ahead: the preview and optimal curvature model.

Guo and Guan, Modelling of driver/vehicle directional control system, Vehicle System Dynamics 22 (1993) 141-184; with
one point ahead it is also MacAdam's optimal preview (1981) for a car that follows its steering at once. In the preview
time T at a lateral acceleration a the car comes to Y + T Y' + a T^2 / 2, which is to be the path's f:

    a = 2 (f(X + T X') - Y - T Y') / T^2,     delta = a (L / vx^2 + K)

with the understeer gradient K of the car that the driver knows. A real driver answers late as well; this one does not.
"""

from math import cos, sin
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import PSI, VX, VY, X, Y
from swerve.vehicle import Vehicle
from swerve.vehicle.steady_state import steering_per_acceleration

Array = NDArray[np.float64]

SLOWEST = 1.0  # [m/s] below, the steering is as at this speed


class Path(Protocol):
    """Where the car is to go."""

    def at(self, x: float) -> float:
        """Y at `x` [m]."""


def preview_steering(vehicle: Vehicle, friction: float, path: Path, preview: float, state: Array) -> float:
    """Road-wheel angle [rad], within the lock.

    Args:
        vehicle: that is driven.
        friction: of the road [1].
        path: that is wanted.
        preview: time T [s].
        state: of the vehicle (6,).
    """
    vx, vy, psi = state[VX], state[VY], state[PSI]
    along, across = vx * cos(psi) - vy * sin(psi), vx * sin(psi) + vy * cos(psi)
    miss = path.at(state[X] + preview * along) - state[Y] - preview * across
    angle = 2 * miss / preview**2 * steering_per_acceleration(vehicle, friction, max(vx, SLOWEST))
    return float(max(-vehicle.steering_limit, min(vehicle.steering_limit, angle)))
