"""First guesses for a plan: the few manoeuvres that a way can begin with, each a steering pulse and its half undone, or
a straight stop. Where the steering is not free, wheel forces of opposite sign left and right take its place.

From a straight guess the obstacle has no left and no right, and a convex program finds a valley, not the lowest one.
Rolled out, these say at once which valley is worth the work.
"""

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.way import Way
from swerve.conventions import DELTA, FORCES, GRAVITY, N_INPUTS
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]

SHARES = (0.12, 0.28, 0.55, 0.75)  # [1] of the steering angle that uses all grip
LENGTHS = (0.2, 0.4, 0.6, 0.8)  # [1] of the horizon that the pulse lasts
UNDONE = 0.5  # [1] of the pulse, in the other direction, for the rest of the horizon
STOPS = (0.4, 0.7, 0.95)  # [1] of the largest wheel forces
TO_THE_LEFT = np.array([-1.0, 1.0, -1.0, 1.0])  # signs of wheel forces whose moment turns to the left
BRAKING = 0.4  # [1] of the largest wheel forces, beside a pulse of a way that stops after a swerve


def seeds(
    vehicle: Vehicle,
    friction: float,
    slip_limit: float,
    speed: float,
    way: Way,
    largest: Array,
    n_samples: int,
    steers: bool = True,
) -> list[Array]:
    """Inputs (Np, 5) of each first guess.

    Args:
        vehicle: that is driven.
        friction: mu [1].
        slip_limit: largest slip angle [rad].
        speed: forward [m/s].
        way: that the plan is for.
        largest: (5,) magnitudes of the inputs [rad, N, N, N, N].
        n_samples: Np.
        steers: whether the steering is free.
    """
    nothing = np.zeros((n_samples, N_INPUTS))
    if way.side is None:
        return [nothing - share * _only(FORCES, largest) for share in STOPS]
    turning = np.zeros(N_INPUTS)
    if steers:
        turning[DELTA] = _largest_angle(vehicle, friction, slip_limit, speed)
    else:
        turning[FORCES] = TO_THE_LEFT * largest[FORCES]
    braking = (BRAKING if way.brakes else 0.0) * _only(FORCES, largest)
    return [
        share * way.side.value * _pulse(n_samples, length)[:, np.newaxis] * turning - braking
        for share in SHARES
        for length in LENGTHS
    ]


def _only(part: slice, inputs: Array) -> Array:
    kept = np.zeros(N_INPUTS)
    kept[part] = inputs[part]
    return kept


def _pulse(n_samples: int, length: float) -> Array:
    return np.where(np.arange(n_samples) < round(length * n_samples), 1.0, -UNDONE)


def _largest_angle(vehicle: Vehicle, friction: float, slip_limit: float, speed: float) -> float:
    """Front slip at its limit and the angle of the tightest steady turn, L mu g / v^2 [rad]."""
    turn = vehicle.wheelbase * friction * GRAVITY / max(speed, 1.0) ** 2
    return min(vehicle.steering_limit, slip_limit + turn)
