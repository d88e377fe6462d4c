"""The vehicles that scenarios can name."""

from typing import Final

from swerve.vehicle.multibody.commonroad import BMW_320I, FORD_ESCORT, VW_VANAGON
from swerve.vehicle.parameters import D_CLASS_SEDAN, Vehicle

VEHICLES: Final = {vehicle.name: vehicle for vehicle in (D_CLASS_SEDAN, FORD_ESCORT, BMW_320I, VW_VANAGON)}


def vehicle_named(name: str) -> Vehicle:
    """The vehicle of this name; KeyError when there is none."""
    return VEHICLES[name]
