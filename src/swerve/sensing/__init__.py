"""From truth to measurement."""

from swerve.sensing.past import Past, Truth
from swerve.sensing.sensor import Noise, Sensor

__all__ = ["Noise", "Past", "Sensor", "Truth"]
