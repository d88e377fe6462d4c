"""Who drives when the emergency brake does not act: a driver that holds the goal's speed.

Until the brake has acted the driver sees nothing, which is what an emergency brake is for. Then it is awake: behind an
obstacle on its path that is nearer than a time gap it goes no faster than that.
"""

from collections.abc import Sequence

import numpy as np

from swerve.control.corridor import Corridor
from swerve.control.forecast import Forecast

STIFFNESS = 1.0  # [1/s] of the speed controller
MOST = 2.0  # [m/s^2] that it speeds up or slows down with
TIME_GAP = 1.8  # [s] to an obstacle in front
ROOM = 6.0  # [m] to an obstacle in front when both stand


def wanted_acceleration(speed: float, wanted: float) -> float:
    """The acceleration [m/s^2] from a speed to a wanted one [m/s]."""
    return min(max(STIFFNESS * (wanted - speed), -MOST), MOST)


def wanted_speed(goal: float, corridor: Corridor, forecasts: Sequence[Forecast]) -> float:
    """The goal's speed, or that of the slowest obstacle on the path within the time gap, if it is lower [m/s]."""
    reach = ROOM + TIME_GAP * corridor.speed
    along = np.array([np.cos(corridor.path.poses[0, 2]), np.sin(corridor.path.poses[0, 2])])
    now = np.array([corridor.start])
    ahead = [float(each.velocity_at(now)[0] @ along) for each in forecasts if corridor.is_ahead(each, reach)]
    return max(0.0, min([goal, *ahead]))
