"""The vehicle on a path, and what it would touch there, and when.

Both vehicle and obstacle are taken where they are at the same time, so that neither what stays beside the path nor what
has left it by then is in the way.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.forecast import Forecast
from swerve.control.path import Path, travelled
from swerve.world import Footprint, Obstacle, Shape, Steady, clearance

Array = NDArray[np.float64]

STEP = 0.02  # [s] between two instants at which a contact is looked for
STEP_OF_PATH = 0.5  # [m] between two places at which it is looked for


@dataclass(frozen=True, eq=False)
class Corridor:
    """The vehicle on its path, from the instant `start` on.

    Attributes:
        footprint: what must not be touched.
        path: that it follows.
        speed: at the start [m/s].
        start: on the controller's clock [s].
        margin: between footprint and obstacle that counts as contact [m].
    """

    footprint: Footprint
    path: Path
    speed: float
    start: float
    margin: float

    def contact(self, forecast: Forecast, deceleration: float, horizon: float, end: float = 0.0) -> float | None:
        """Time to the first contact within a horizon [s], None without one, braking so [m/s^2] to a speed [m/s]."""
        times = np.arange(0.0, horizon, STEP)
        poses = self.path.at(travelled(self.speed, deceleration, times, end))
        touched = self._touches(forecast, poses, self.start + times)
        return float(times[np.argmax(touched)]) if touched.any() else None

    def is_ahead(self, forecast: Forecast, reach: float) -> bool:
        """Whether an obstacle is now on the next `reach` [m] of the path."""
        poses = self.path.at(np.arange(0.0, reach, STEP_OF_PATH))
        return bool(self._touches(forecast, poses, np.full(len(poses), self.start)).any())

    def _touches(self, forecast: Forecast, poses: Array, times: Array) -> NDArray[np.bool_]:
        """Whether the footprint at poses (n, 3) is in contact with an obstacle at times (n,) [s]."""
        return np.asarray(gaps(self.footprint, poses, forecast, times, self.margin) <= self.margin)


def gaps(footprint: Footprint, poses: Array, forecast: Forecast, times: Array, reach: float) -> Array:
    """Clearance (n,) [m] of a footprint at poses (n, 3) from an obstacle at times (n,) [s]; inf well beyond `reach`."""
    seen = poses.copy()
    seen[:, :2] -= forecast.position_at(times)
    near = np.hypot(seen[:, 0], seen[:, 1]) <= _radius(footprint) + _radius(forecast.shape) + reach
    found = np.full(len(poses), np.inf)
    if near.any():
        still = Obstacle(forecast.shape, Steady((0.0, 0.0), heading=forecast.heading))
        found[near] = clearance(footprint, seen[near], still, np.zeros(np.count_nonzero(near)))
    return found


def _radius(shape: Shape) -> float:
    """Of the circle about a shape's origin that holds it [m]."""
    return float(np.hypot(*shape.outline().T).max())
