"""The vehicle as pure functions and frozen parameters: tyre, loads, two-track model."""

from swerve.vehicle.library import VEHICLES, vehicle_named
from swerve.vehicle.parameters import Vehicle
from swerve.vehicle.tyre import Tyre
from swerve.vehicle.tyres import TYRES

__all__ = ["TYRES", "VEHICLES", "Tyre", "Vehicle", "vehicle_named"]
