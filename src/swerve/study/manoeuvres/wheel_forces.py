"""How a driver's pedals become wheel forces: cruise control, and brakes in proportion to the loads.

Holding a speed V is the acceleration a of `driver/cruise.py`, shared over the wheels as their loads are:

    Fx_i = Fz_i / sum Fz  m a
"""

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import VX
from swerve.driver.cruise import LARGEST, cruise
from swerve.plant import PlantState
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]


def hold_speed(vehicle: Vehicle, state: PlantState, speed: float, largest: float = LARGEST) -> Array:
    """Wheel forces (4,) [N] that hold a speed [m/s] with no more than an acceleration [m/s^2]."""
    return accelerate(vehicle, state, cruise(float(state.vehicle[VX]), speed, largest))


def accelerate(vehicle: Vehicle, state: PlantState, acceleration: float) -> Array:
    """Wheel forces (4,) [N] for an acceleration [m/s^2], every wheel by the same share of its load."""
    share: Array = state.wheel_loads / max(state.wheel_loads.sum(), 1.0)
    return vehicle.mass * acceleration * share
