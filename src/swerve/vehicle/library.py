"""The vehicles that scenarios can name."""

from typing import Final

from swerve.vehicle.parameters import D_CLASS_SEDAN, Vehicle

VEHICLES: Final = {vehicle.name: vehicle for vehicle in (D_CLASS_SEDAN,)}


def vehicle_named(name: str) -> Vehicle:
    """The vehicle of this name; KeyError when there is none."""
    return VEHICLES[name]
