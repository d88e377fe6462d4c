"""The footprint stays out of an obstacle, passed in one way: eq. (15) as half-planes that nothing cuts between.

    n . (p_j - c_j) - h(n) - h_ego(-n; psi_j) >= margin        for every half sample j, and beyond the horizon

with p the centre of gravity, c the obstacle's expected centre, h and h_ego the support functions of both shapes. The
half-plane lies inside the region that is allowed: a plan that keeps the rows keeps clear. Beyond the margin there is a
gap for comfort, at a low price: of that is made up for what the prediction gets wrong.
"""

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Passing
from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.forecast import Forecast
from swerve.control.unified.limits.limit import Penalty, Rows, nearest
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.separation import Planes, Separation

Array = NDArray[np.float64]

REACH = 4.0  # [m] gaps wider than this are left out of the rows; acceptance sees them all
SAG = 2e-3  # [m] of the margin that curvature may take: whole steps would otherwise be refused for a fraction of a mm


class ObstacleLimit:
    """The limit for one obstacle, as it was seen at the start of the plan, passed in one way."""

    def __init__(
        self,
        index: int,
        forecast: Forecast,
        times: Array,
        separation: Separation,
        passing: Passing,
        margin: float,
        penalty: Penalty,
    ) -> None:
        """Obstacle `index`; times (n_poses,) [s] are those of the trajectory's poses, on the controller's clock."""
        self._name = f"obstacle {index}"
        self._penalty, self._passing, self._margin = penalty, passing, margin
        self._forecast, self._separation, self._times = forecast, separation, times
        self._centres = forecast.position_at(times)
        self._last: tuple[Trajectory, Planes] | None = None

    @property
    def name(self) -> str:
        """As `Plan.active` says it."""
        return self._name

    @property
    def penalty(self) -> Penalty:
        """Price of the largest missing distance."""
        return self._penalty

    def violation(self, trajectory: Trajectory) -> float:
        """Largest distance by which margin and comfort, less what curvature may take, are missed [m]."""
        return max(0.0, self._margin + self._penalty.comfort - SAG - self._planes(trajectory).smallest)

    def is_near(self, trajectory: Trajectory) -> bool:
        """Whether any pose is within reach, so that `rows` are not empty."""
        return self._planes(trajectory).smallest < REACH

    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """A row for each half-plane in reach."""
        planes = self._planes(trajectory)
        near = nearest(planes.gap, REACH)
        direction = np.column_stack([planes.normal[near], planes.turning[near]])
        matrix = (direction[:, np.newaxis] @ sensitivities.poses[planes.pose[near] - 1])[:, 0]
        lower = self._margin + self._penalty.comfort - planes.gap[near]
        return Rows(matrix, lower, np.full(len(near), np.inf))

    def impact(self, trajectory: Trajectory) -> tuple[int, Array] | None:
        """The first pose at which the plan is in contact, and the obstacle's velocity (2,) then; None without one."""
        planes = self._planes(trajectory)
        touching = planes.pose[planes.gap < 0]
        if len(touching) == 0:
            return None
        first = int(touching.min())
        return first, self._forecast.velocity_at(self._times[first : first + 1])[0]

    def _planes(self, trajectory: Trajectory) -> Planes:
        """Half-planes and gaps of a trajectory; those of the last one are kept, since it is asked for them thrice."""
        if self._last is None or self._last[0] is not trajectory:
            from_centre = trajectory.poses.copy()
            from_centre[:, :2] -= self._centres
            shape, heading = self._forecast.shape, self._forecast.heading
            self._last = trajectory, self._separation.planes(shape, heading, from_centre, self._passing)
        return self._last[1]
