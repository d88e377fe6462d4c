"""The full vehicle: a sprung body, four unsprung masses and four wheels, and the actuators that drive them."""

from swerve.vehicle.multibody.actuators import Actuators
from swerve.vehicle.multibody.chassis import Chassis, TyreDynamics
from swerve.vehicle.multibody.library import COMPLETIONS, completion_of

__all__ = ["COMPLETIONS", "Actuators", "Chassis", "TyreDynamics", "completion_of"]
