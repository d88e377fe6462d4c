"""What the decision looks at: vehicle, road and obstacles, at the instant at which a command begins to act."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.corridor import gaps
from swerve.control.forecast import Forecast
from swerve.control.hierarchical.manoeuvre import Manoeuvre
from swerve.control.path import travelled
from swerve.conventions import GRAVITY, PSI, VX, VY, R, X, Y
from swerve.world import Footprint, Road

Array = NDArray[np.float64]

SLOWEST = 1.0  # [m/s] below, a curvature is not measured
STEP = 0.03  # [s] between two instants at which a contact is looked for
SLACK = 1.0  # [s] looked beyond the time that a stop or a lane change takes


@dataclass(frozen=True, eq=False)
class Scene:
    """The scene of one step.

    Attributes:
        state: (6,) of the vehicle.
        time: of that state, on the controller's clock [s].
        footprint: what must not touch anything.
        friction: mu [1].
        braking: share of full braking that the vehicle's inputs reach [1].
        road: whose edges count.
        forecasts: of the obstacles.
    """

    state: Array
    time: float
    footprint: Footprint
    friction: float
    braking: float
    road: Road
    forecasts: tuple[Forecast, ...]

    @property
    def grip(self) -> float:
        """The acceleration mu g [m/s^2]."""
        return self.friction * GRAVITY

    @property
    def deceleration(self) -> float:
        """Of full braking [m/s^2]."""
        return self.braking * self.grip

    @property
    def speed(self) -> float:
        """Over ground [m/s]."""
        return float(np.hypot(self.state[VX], self.state[VY]))

    def on_path(self, last: Manoeuvre | None) -> Array:
        """y, y' and y'' (3,) of the vehicle's motion [m, 1, 1/m]; y'' is that of the path it is on, if there is one."""
        course = self.state[PSI] + np.arctan2(self.state[VY], max(self.state[VX], SLOWEST))
        slope = np.tan(np.clip(course, -1.0, 1.0))
        if last is not None:
            bend = float(last.lateral.at(self.state[X])[2])
        else:
            bend = float(self.state[R] / max(self.speed, SLOWEST) * (1 + slope**2) ** 1.5)
        return np.array([self.state[Y], slope, bend])

    def is_clear(self, manoeuvre: Manoeuvre, horizon: float, margin: float) -> bool:
        """Whether a manoeuvre touches nothing within a horizon [s] and stays on the road."""
        return bool(self.gaps([manoeuvre], horizon, margin)[0] > margin)

    def gaps(self, manoeuvres: Sequence[Manoeuvre], horizon: float, reach: float) -> Array:
        """Smallest clearance (n,) [m] of each manoeuvre within a horizon [s]: 0 off the road, inf beyond `reach`."""
        times = np.arange(0.0, horizon + STEP, STEP)
        poses = np.concatenate([self._poses(each, times) for each in manoeuvres])
        found = np.where(self.road.is_inside(self.footprint, poses), np.inf, 0.0)
        absolute = np.tile(self.time + times, len(manoeuvres))
        for each in self.forecasts:
            found = np.minimum(found, gaps(self.footprint, poses, each, absolute, reach))
        return np.asarray(found.reshape(len(manoeuvres), -1).min(axis=1))

    def _poses(self, manoeuvre: Manoeuvre, times: Array) -> Array:
        """Poses (n, 3) at times (n,) from now on [s]."""
        rate = manoeuvre.rate if manoeuvre.speed < self.speed else -manoeuvre.rate
        lengths = travelled(self.speed, rate, times, manoeuvre.speed)
        return manoeuvre.path(float(self.state[X]), float(lengths[-1])).at(lengths)
