"""A quiet driver: keeps a lane by looking one point ahead (`preview.py`), and a speed; sees no obstacle."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import VX
from swerve.driver.cruise import cruise
from swerve.driver.preview import preview_steering
from swerve.signals import DriverInput
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]


@dataclass(frozen=True)
class _Lane:
    """A straight path along X at Y = `lateral_offset` [m]."""

    lateral_offset: float

    def at(self, x: float) -> float:
        """Y at `x` [m]."""
        return self.lateral_offset


@dataclass(frozen=True)
class LaneKeeper:
    """The driver of one vehicle.

    Attributes:
        vehicle: that the driver knows.
        friction: for which the driver knows its understeer [1].
        lateral_offset: of the lane [m].
        speed: that is held [m/s].
        preview: time that the driver looks ahead [s].
    """

    vehicle: Vehicle
    friction: float
    lateral_offset: float
    speed: float
    preview: float

    def __call__(self, time: float, state: Array) -> DriverInput:
        """The input at the vehicle state (6,); the time does not matter."""
        lane = _Lane(self.lateral_offset)
        angle = preview_steering(self.vehicle, self.friction, lane, self.preview, state)
        return DriverInput(angle, self.vehicle.mass * cruise(float(state[VX]), self.speed))
