"""How hard each wheel brakes: an ideal slip control, which leaves the tyre what the turn takes of it.

|Fx| <= share mu Fz sqrt(1 - (RESERVE lambda)^2),   lambda = |M(alpha)| / D of its axle
"""

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import DELTA
from swerve.vehicle import Vehicle
from swerve.vehicle.two_track import Parameters, axle_slip_angle
from swerve.vehicle.tyre import factors, magic_formula

Array = NDArray[np.float64]

RESERVE = 0.95  # [1] at the peak of the lateral force a wheel keeps sqrt(1 - RESERVE^2) = 31 % of its force limit


def braking_limits(vehicle: Vehicle, parameters: Parameters, state: Array, u: Array, loads: Array) -> Array:
    """Largest braking force of each wheel (4,) [N].

    Args:
        vehicle: whose force limit counts.
        parameters: of it, and the road's friction.
        state: (6,) of it.
        u: (5,) input, of which the steering angle counts.
        loads: (4,) of the wheels [N].
    """
    p = parameters
    front = float(axle_slip_angle(state, p.lf, u[DELTA], p))
    rear = float(axle_slip_angle(state, -p.lr, 0.0, p))
    share = np.empty(4)
    for i, slip in enumerate((front, front, rear, rear)):
        demand = min(1.0, abs(magic_formula(p, slip, loads[i])) / factors(p, loads[i])[2])
        share[i] = np.sqrt(1 - (RESERVE * demand) ** 2)
    return np.asarray(vehicle.force_limit * p.mu * loads * share)
