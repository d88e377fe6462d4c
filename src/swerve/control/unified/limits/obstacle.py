"""The footprint stays out of an obstacle, passed in one way: eq. (15) as half-planes that nothing cuts between.

    n . (p_j - c_j) - h(n) - h_ego(-n; psi_j) >= margin        for every half sample j, and beyond the horizon

with p the centre of gravity, c the obstacle's expected centre, h and h_ego the support functions of both shapes. The
half-plane lies inside the region that is allowed: a plan that keeps the rows keeps clear. Beyond the margin there is a
gap for comfort, at a low price, that grows with foresight: of it is made up for what the prediction gets wrong.
"""

import numpy as np
from numpy.typing import NDArray

from swerve.control.forecast import Forecast
from swerve.control.plan import Passing
from swerve.control.unified.condensing import Sensitivities
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
        growth: float,
    ) -> None:
        """Obstacle `index`; times (n_poses,) [s] are those of the trajectory's poses, on the controller's clock.

        `growth` is by how much of itself the gap for comfort grows in a second of foresight [1/s].
        """
        self._name = f"obstacle {index}"
        self._penalty, self._passing, self._margin = penalty, passing, margin
        self._forecast, self._separation, self._times = forecast, separation, times
        self._share = 1 / (1 + growth * (times[1:] - times[0]))
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
        """Largest distance by which margin and comfort, less what curvature may take, are missed [m].

        Within the comfort it is a share of the pose's own: all of it is missed where the margin begins.
        """
        spare = self._planes(trajectory).gap - self._margin + SAG
        return max(0.0, self._penalty.comfort - float(np.minimum(spare, self._share * spare).min()))

    def is_near(self, trajectory: Trajectory) -> bool:
        """Whether any pose is within reach, so that `rows` are not empty."""
        return self._smallest(trajectory) < REACH

    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """A row for each half-plane in reach."""
        planes = self._planes(trajectory)
        near = nearest(planes.gap, REACH)
        direction = np.column_stack([planes.normal[near], planes.turning[near]])
        matrix = (direction[:, np.newaxis] @ sensitivities.poses[near])[:, 0]
        spare, share = planes.gap[near] - self._margin, self._share[near]
        share = np.where(spare < 0, 1.0, share)  # what misses the margin itself is priced in full
        lower = self._penalty.comfort - share * spare
        return Rows(share[:, np.newaxis] * matrix, lower, np.full(len(near), np.inf), share, near)

    def impact(self, trajectory: Trajectory) -> tuple[int, Array] | None:
        """The first pose at which the plan is in contact, and the obstacle's velocity (2,) then; None without one."""
        planes = self._planes(trajectory)
        touching = np.flatnonzero(planes.gap < 0)
        if len(touching) == 0:
            return None
        first = int(touching[0]) + 1
        return first, self._forecast.velocity_at(self._times[first : first + 1])[0]

    def _smallest(self, trajectory: Trajectory) -> float:
        return float(self._planes(trajectory).gap.min())

    def _planes(self, trajectory: Trajectory) -> Planes:
        """Half-planes and gaps of a trajectory; those of the last one are kept, since it is asked for them thrice."""
        if self._last is None or self._last[0] is not trajectory:
            from_centre = trajectory.poses.copy()
            from_centre[:, :2] -= self._centres
            shape, heading = self._forecast.shape, self._forecast.heading
            self._last = trajectory, self._separation.planes(shape, heading, from_centre, self._passing)
        return self._last[1]
