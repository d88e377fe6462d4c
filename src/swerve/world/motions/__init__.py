"""How obstacles move: one file for each kind of motion, all of them functions of time alone."""

from swerve.world.motions.accelerating import Accelerating
from swerve.world.motions.along_waypoints import AlongWaypoints
from swerve.world.motions.motion import Motion
from swerve.world.motions.steady import Steady
from swerve.world.motions.waiting import Waiting

__all__ = ["Accelerating", "AlongWaypoints", "Motion", "Steady", "Waiting"]
