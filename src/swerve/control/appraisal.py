"""What a predicted motion comes to, by the outlines of vehicle, obstacles and road: how a baseline tells of its plans.

It is told of any motion alike, whatever the controller itself knows, or believes, of obstacles and edges. Half way
through each sample the pose is that of the cubic with the poses and rates of both ends:

    p = (p0 + p1) / 2 + Ts (v0 - v1) / 8
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swerve.control.forecast import Forecast
from swerve.control.plan import Branch, Passing
from swerve.control.settings import Horizon
from swerve.control.unified.lines import ANY, Lines
from swerve.control.unified.scene import passed
from swerve.conventions import POSE, PSI, VX, VY, R
from swerve.world import Footprint, Road

Array = NDArray[np.float64]


class _Meeting(NamedTuple):
    """A motion and one obstacle: the smallest gap [m], on which side, and the first contact's row, None without."""

    gap: float
    passing: Passing
    contact: int | None


class Appraisal:
    """The appraisal of motions over one horizon."""

    def __init__(self, footprint: Footprint, road: Road, margin: float, horizon: Horizon) -> None:
        """For a footprint that is to keep a margin [m] to obstacles; the first time compiles a kernel."""
        self._footprint, self._road, self._margin = footprint, road, margin
        self._lines = Lines(footprint, 2 * horizon.prediction)
        self._step = horizon.sample_time / 2

    def branch(self, name: str, cost: float, states: Array, start: float, forecasts: Sequence[Forecast]) -> Branch:
        """The branch that a motion is.

        Args:
            name: what it does about the obstacles.
            cost: of it [1].
            states: (Np + 1, 6).
            start: when the first of them is, on the controller's clock [s].
            forecasts: of the obstacles.
        """
        rates = _rates(states)
        poses, times = self._halved(states[:, POSE], rates), start + self._step * np.arange(2.0 * len(states) - 1)
        if not np.isfinite(states).all():
            return Branch(name, (Passing.BEHIND,) * len(forecasts), cost, np.inf, np.inf, None, poses)
        met = [self._meeting(poses, times, each) for each in forecasts]
        violation = max((self._margin - each.gap for each in met), default=0.0)
        speeds = [
            float(np.linalg.norm(rates[each.contact // 2, :2] - forecast.velocity_at(times[[each.contact]])[0]))
            for each, forecast in zip(met, forecasts, strict=True)
            if each.contact is not None
        ]
        off_road, passing = self._off_road(poses), tuple(each.passing for each in met)
        return Branch(name, passing, cost, max(0.0, violation), off_road, max(speeds, default=None), poses)

    def _halved(self, poses: Array, rates: Array) -> Array:
        """Poses (2 Np + 1, 3) at every half sample, from those at every sample and their rates."""
        halved = np.empty((2 * len(poses) - 1, 3))
        halved[::2] = poses
        halved[1::2] = (poses[:-1] + poses[1:]) / 2 + self._step / 4 * (rates[:-1] - rates[1:])
        return halved

    def _meeting(self, poses: Array, times: Array, forecast: Forecast) -> _Meeting:
        from_centre = poses.copy()
        from_centre[:, :2] -= forecast.position_at(times)
        normals, gaps, _ = self._lines.between(forecast.shape, forecast.heading, from_centre, ANY)
        nearest = gaps.min(axis=1)
        touching = np.flatnonzero(nearest < 0)
        contact = int(touching[0]) + 1 if len(touching) else None
        return _Meeting(float(nearest.min()), passed(normals[nearest.argmin()], from_centre[0]), contact)

    def _off_road(self, poses: Array) -> float:
        """Largest distance of the footprint beyond an edge [m]."""
        left, right = self._road.left_edge, self._road.right_edge
        if left is None or right is None:
            return 0.0
        leftwards = np.column_stack((np.sin(poses[:, 2]), np.cos(poses[:, 2])))
        over = poses[:, 1] + self._footprint.support(leftwards) - left
        under = right - poses[:, 1] + self._footprint.support(-leftwards)
        return max(0.0, float(over.max()), float(under.max()))


def _rates(states: Array) -> Array:
    """Of the poses: velocity in world axes [m/s] and yaw rate [rad/s], (n, 3)."""
    cos, sin = np.cos(states[:, PSI]), np.sin(states[:, PSI])
    vx, vy = states[:, VX], states[:, VY]
    return np.column_stack((cos * vx - sin * vy, sin * vx + cos * vy, states[:, R]))
