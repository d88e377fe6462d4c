"""What completes each vehicle that scenarios can name."""

from typing import Final

from swerve.vehicle.multibody.actuators import Actuators
from swerve.vehicle.multibody.chassis import Chassis
from swerve.vehicle.multibody.commonroad import ACTUATORS, BMW_320I_CHASSIS, FORD_ESCORT_CHASSIS, VW_VANAGON_CHASSIS
from swerve.vehicle.multibody.sedan import D_CLASS_ACTUATORS, D_CLASS_CHASSIS

COMPLETIONS: Final[dict[str, tuple[Chassis, Actuators]]] = {
    "d-class-sedan": (D_CLASS_CHASSIS, D_CLASS_ACTUATORS),
    "ford-escort": (FORD_ESCORT_CHASSIS, ACTUATORS),
    "bmw-320i": (BMW_320I_CHASSIS, ACTUATORS),
    "vw-vanagon": (VW_VANAGON_CHASSIS, ACTUATORS),
}


def completion_of(name: str) -> tuple[Chassis, Actuators]:
    """Chassis and actuators of the vehicle of this name; KeyError when there is none."""
    return COMPLETIONS[name]
