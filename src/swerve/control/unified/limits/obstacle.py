"""The footprint stays out of an obstacle, on one side of it: eq. (15) as half-planes that nothing cuts between.

    n . (p_j - c_j) - h(n) - h_ego(-n; psi_j) >= margin        for every half sample j

with p the centre of gravity, c the obstacle's predicted centre, h and h_ego the support functions of both shapes. The
half-plane lies inside the region that is allowed: a plan that keeps the rows keeps clear.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Side
from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.limits.limit import Penalty, Rows
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.separation import Planes, footprint_reach, separating_planes
from swerve.control.unified.tail import Tail
from swerve.world import Footprint, Obstacle

Array = NDArray[np.float64]

REACH = 4.0  # [m] gaps wider than this are left out of the rows; acceptance sees them all
SAG = 2e-3  # [m] of the margin that curvature may take: whole steps would otherwise be refused for a fraction of a mm


class ObstacleLimit:
    """The limit for one obstacle, as it was seen at the start of the plan, passed on one side."""

    def __init__(
        self,
        obstacle: Obstacle,
        footprint: Footprint,
        side: Side,
        times: Array,
        tail: Tail,
        margin: float,
        penalty: Penalty,
    ) -> None:
        """Times (2 Np + 1,) [s] are those of the trajectory's poses; the obstacle is where it was seen at time 0."""
        self._penalty = penalty
        self._obstacle, self._footprint, self._side, self._margin = obstacle, footprint, side, margin
        self._tail = tail
        self._last: tuple[Trajectory, Gaps] | None = None
        self._centres = obstacle.position_at(np.concatenate([times, times[-1] + tail.times]))

    @property
    def penalty(self) -> Penalty:
        """Price of the largest missing distance."""
        return self._penalty

    def violation(self, trajectory: Trajectory) -> float:
        """Largest distance by which the margin, less what curvature may take, is missed [m]."""
        return max(0.0, self._margin - SAG - float(self._gaps(trajectory).gap.min()))

    def is_near(self, trajectory: Trajectory) -> bool:
        """Whether any pose is within reach, so that `rows` are not empty."""
        return bool(self._gaps(trajectory).gap.min() < REACH)

    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """A row for each half-plane in reach."""
        planes, gap, turning = self._gaps(trajectory)
        near = np.flatnonzero(gap < REACH)
        beyond = self._tail.sensitivities(trajectory.states[-1], sensitivities.states[-1])
        of_poses = np.concatenate([sensitivities.poses, beyond])[planes.pose[near] - 1]
        direction = np.column_stack([planes.normal[near], turning[near]])
        matrix = (direction[:, np.newaxis] @ of_poses)[:, 0]
        return Rows(matrix, self._margin - gap[near], np.full(len(near), np.inf))

    def _gaps(self, trajectory: Trajectory) -> "Gaps":
        """Half-planes and gaps of a trajectory; those of the last one are kept, since it is asked for them thrice."""
        if self._last is None or self._last[0] is not trajectory:
            self._last = trajectory, self._measure(trajectory)
        return self._last[1]

    def _measure(self, trajectory: Trajectory) -> "Gaps":
        beyond = self._tail.poses(trajectory.states[-1], self._side)
        from_centre = np.concatenate([trajectory.poses, beyond])
        from_centre[:, :2] -= self._centres
        planes = separating_planes(self._obstacle, self._footprint, from_centre, self._side)
        poses = from_centre[planes.pose]
        reach, turning = footprint_reach(self._footprint, planes.normal, poses[:, 2])
        gap = (planes.normal * poses[:, :2]).sum(axis=1) - planes.reach - reach
        return Gaps(planes, gap, -turning)


class Gaps(NamedTuple):
    """Half-planes, the gap to each (k,) [m], and its derivative by psi (k,) [m/rad]."""

    planes: Planes
    gap: Array
    turning: Array
