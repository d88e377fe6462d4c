"""The limits, one file each. A new one is a new file and a line where the controller lists its limits."""

from swerve.control.unified.limits.input_box import InputBox
from swerve.control.unified.limits.lane import Lane
from swerve.control.unified.limits.limit import HardLimit, Penalty, Rows, SoftLimit
from swerve.control.unified.limits.obstacle import ObstacleLimit
from swerve.control.unified.limits.road_edge import RoadEdge
from swerve.control.unified.limits.slip import SlipLimit
from swerve.control.unified.limits.steering_rate import SteeringRateLimit

__all__ = [
    "HardLimit",
    "InputBox",
    "Lane",
    "ObstacleLimit",
    "Penalty",
    "RoadEdge",
    "Rows",
    "SlipLimit",
    "SoftLimit",
    "SteeringRateLimit",
]
