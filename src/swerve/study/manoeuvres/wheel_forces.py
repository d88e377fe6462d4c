"""How a driver's pedals become wheel forces: cruise control, and brakes in proportion to the loads.

Holding a speed V is proportional control of the acceleration, shared over the wheels as their loads are:

    Fx_i = Fz_i / sum Fz  m k (V - vx),   |k (V - vx)| <= the largest acceleration

With k = 5 / s drag, rolling resistance and the tyres' own resistance in a turn leave an error of about 0.1 m/s.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import VX
from swerve.plant import PlantState
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]

GAIN: Final = 5.0  # k [1/s]
LARGEST: Final = 3.0  # acceleration of a cruise control [m/s^2]


def hold_speed(vehicle: Vehicle, state: PlantState, speed: float, largest: float = LARGEST) -> Array:
    """Wheel forces (4,) [N] that hold a speed [m/s] with no more than an acceleration [m/s^2]."""
    return accelerate(vehicle, state, float(np.clip(GAIN * (speed - state.vehicle[VX]), -largest, largest)))


def accelerate(vehicle: Vehicle, state: PlantState, acceleration: float) -> Array:
    """Wheel forces (4,) [N] for an acceleration [m/s^2], every wheel by the same share of its load."""
    share: Array = state.wheel_loads / max(state.wheel_loads.sum(), 1.0)
    return vehicle.mass * acceleration * share
