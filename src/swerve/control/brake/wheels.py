"""How hard each wheel brakes: an ideal slip control, which leaves the tyre what the turn takes of it.

|Fx| <= share mu Fz sqrt(1 - (RESERVE lambda)^2),   lambda = |M(alpha)| / D of its axle
"""

from functools import cache

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import DELTA
from swerve.kernel import Kernel
from swerve.vehicle import Vehicle
from swerve.vehicle.two_track import Parameters, axle_slip_angle, symbols
from swerve.vehicle.tyre import factors, magic_formula

Array = NDArray[np.float64]

RESERVE = 0.95  # [1] at the peak of the lateral force a wheel keeps sqrt(1 - RESERVE^2) = 31 % of its force limit


class BrakingLimits:
    """The largest braking forces of one vehicle on a road of known friction."""

    def __init__(self, vehicle: Vehicle, parameters: Parameters) -> None:
        """Compile, or take from the cache, the kernel; of the vehicle the force limit counts."""
        self._limits = Kernel(_limits())
        self._force_limit, self._parameters = vehicle.force_limit, parameters.as_array()

    def __call__(self, state: Array, u: Array, loads: Array) -> Array:
        """Largest braking force of each wheel (4,) [N].

        Args:
            state: (6,) of the vehicle.
            u: (5,) input, of which the steering angle counts.
            loads: (4,) of the wheels [N].
        """
        (share,) = self._limits(state, u, loads, self._parameters)
        return np.asarray(self._force_limit * share)


@cache
def _limits() -> ca.Function:
    """(state, u, loads, p) -> the largest braking forces, for a force limit of 1."""
    state, u, loads, p = symbols()
    front = axle_slip_angle(state, p.lf, u[DELTA], p)
    rear = axle_slip_angle(state, -p.lr, 0.0, p)
    limits = []
    for i, slip in enumerate((front, front, rear, rear)):
        demand = ca.fmin(1.0, ca.fabs(magic_formula(p, slip, loads[i])) / factors(p, loads[i])[2])
        limits.append(p.mu * loads[i] * ca.sqrt(1 - (RESERVE * demand) ** 2))
    return ca.Function("braking_limits", [state, u, loads, ca.vertcat(*p)], [ca.vertcat(*limits)])
