"""Which ways are worth a plan: each is driven by the point mass alone, from the start on, and priced.

tracking cost of the path + price of what it misses of the margin to an obstacle, and of the road
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.settings import Goal, Weights
from swerve.control.unified.lines import Lines
from swerve.control.unified.scene import SHORTEST_LOOK, Scene
from swerve.control.unified.tail import Outlook, Tail
from swerve.control.unified.way import Way
from swerve.conventions import POSE

Array = NDArray[np.float64]

OFF_LANE = 2e4  # [1] price of leaving the lane
OFF_ROAD = 5e3  # [1/m] price of the largest distance off the road


@dataclass(frozen=True)
class Pricing:
    """What a path costs.

    Attributes:
        goal: speed and lateral offset.
        weights: of the cost (10).
        sample_time: Ts, for which the weights are meant [s].
        miss: price of a missed margin to an obstacle [1/m].
    """

    goal: Goal
    weights: Weights
    sample_time: float
    miss: float

    def tracking(self, poses: Array, speeds: Array, durations: Array, window: float) -> float:
        """Tracking terms along poses (n, 3) and speeds (n,) [m/s], for as long as the window goes [s]."""
        lasting = np.clip(window - (np.cumsum(durations) - durations), 0.0, durations) / self.sample_time
        offset = self.weights.lateral_offset * (poses[:, 1] - self.goal.lateral_offset) ** 2
        return float(lasting @ (offset + self.weights.speed * (speeds - self.goal.speed) ** 2))


def price(scene: Scene, way: Way, outlook: Outlook, tail: Tail, lines: Lines, pricing: Pricing) -> float:
    """The price of a way [1]; `lines` are for the pairs of poses of the tail's path, `outlook` begins at the start."""
    beyond, speeds = tail.path(scene.start, outlook)
    poses = np.concatenate([scene.start[np.newaxis, POSE], beyond])
    times = scene.time + np.concatenate([[0.0], outlook.times])
    missed = 0.0
    for forecast, passing in zip(scene.forecasts, way.passing, strict=True):
        from_centre = poses.copy()
        from_centre[:, :2] -= forecast.position_at(times)
        gaps = lines.between(forecast.shape, forecast.heading, from_centre, passing.value)[1]
        missed = max(missed, scene.place.margin - float(gaps.min()))
    lowest, highest = scene.place.room()
    off_road = max(0.0, float(lowest - beyond[:, 1].min()), float(beyond[:, 1].max() - highest))
    off_lane = OFF_LANE if scene.leaves_lane(poses) else 0.0
    tracking = pricing.tracking(beyond, speeds, outlook.durations, SHORTEST_LOOK)
    return tracking + pricing.miss * missed + OFF_ROAD * off_road + off_lane
