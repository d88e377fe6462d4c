"""First guesses for a plan: the few manoeuvres that a side can begin with, each a steering pulse and its half undone.

From a straight guess the obstacle has no left and no right, and a convex program finds a valley, not the lowest one.
Rolled out, these say at once which valley is worth the work.
"""

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Side
from swerve.conventions import DELTA, GRAVITY, N_INPUTS
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]

SHARES = (0.12, 0.28, 0.55, 0.75)  # [1] of the steering angle that uses all grip
LENGTHS = (0.2, 0.4, 0.6, 0.8)  # [1] of the horizon that the pulse lasts
UNDONE = 0.5  # [1] of the pulse, in the other direction, for the rest of the horizon


def seeds(
    vehicle: Vehicle, friction: float, slip_limit: float, speed: float, side: Side, n_samples: int
) -> list[Array]:
    """Inputs (Np, 5) of each first guess at forward speed [m/s]: no wheel force, a steering pulse towards `side`."""
    guesses = []
    for share in SHARES:
        amplitude = side.value * share * _largest_angle(vehicle, friction, slip_limit, speed)
        for length in LENGTHS:
            inputs = np.zeros((n_samples, N_INPUTS))
            inputs[:, DELTA] = -UNDONE * amplitude
            inputs[: round(length * n_samples), DELTA] = amplitude
            guesses.append(inputs)
    return guesses


def _largest_angle(vehicle: Vehicle, friction: float, slip_limit: float, speed: float) -> float:
    """Front slip at its limit and the angle of the tightest steady turn, L mu g / v^2 [rad]."""
    turn = vehicle.wheelbase * friction * GRAVITY / max(speed, 1.0) ** 2
    return min(vehicle.steering_limit, slip_limit + turn)
