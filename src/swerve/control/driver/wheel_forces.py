"""What a driver's steering wheel and pedals do to a vehicle's five inputs, without anybody's help:

    delta = the driver's,   Fx_i = Fz_i / sum Fz  F,   |Fx_i| <= share mu Fz_i

every wheel by the same share of its load, and no further than its tyre goes: an ideal distribution, and the brakes of
a vehicle whose wheels do not lock.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.actuation import Actuation
from swerve.conventions import DELTA, FORCES, N_INPUTS
from swerve.signals import DriverInput, Measurement
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]

HANDS_OFF = DriverInput(0.0, 0.0)


@dataclass(frozen=True, eq=False)
class DriverActuation:
    """From a driver to a vehicle.

    Attributes:
        vehicle: that is driven.
        friction: mu [1].
        actuation: the inputs that there are.
    """

    vehicle: Vehicle
    friction: float
    actuation: Actuation

    def inputs(self, measurement: Measurement) -> Array:
        """(5,) [rad, N, N, N, N] of what is asked for in a finite measurement: nothing where nobody is at the wheel."""
        driver, standing = measurement.driver or HANDS_OFF, np.maximum(measurement.wheel_loads, 0.0)
        u, largest = np.empty(N_INPUTS), np.empty(N_INPUTS)
        u[DELTA], largest[DELTA] = driver.steering_angle, self.vehicle.steering_limit
        u[FORCES] = driver.force * standing / max(float(standing.sum()), 1.0)
        largest[FORCES] = self.vehicle.force_limit * self.friction * standing
        return self.actuation.within(u, largest)
