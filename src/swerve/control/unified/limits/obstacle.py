"""The footprint stays out of an obstacle, on one side of it: eq. (15) as half-planes that nothing can cut between.

For every half sample one line separates the footprint from the obstacle; both ends of the half sample are on its
far side, so the straight motion between them is too:

    n_i . (p_j - c_j) - h(n_i) - h_ego(-n_i; psi_j) >= margin        for j = i - 1, i

with p the centre of gravity, c the obstacle's predicted centre, h and h_ego the support functions of both shapes. The
tangent half-plane lies inside the region that is allowed: a plan that keeps the rows keeps clear.
"""

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Side
from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.limits.limit import Penalty, Rows
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.separation import footprint_reach, separating_normals
from swerve.control.unified.tail import Tail
from swerve.world import Footprint, Obstacle

Array = NDArray[np.float64]

REACH = 6.0  # [m] gaps wider than this are left out of the rows; acceptance sees them all


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
        self.penalty = penalty
        self._obstacle, self._footprint, self._side, self._margin = obstacle, footprint, side, margin
        self._tail = tail
        self._centres = obstacle.position_at(np.concatenate([times, times[-1] + tail.times]))

    def violation(self, trajectory: Trajectory) -> float:
        """Largest distance by which the margin is missed [m]."""
        _, at_start, at_end, _ = self._gaps(trajectory)
        return max(0.0, self._margin - float(min(at_start[1:].min(), at_end.min())))

    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """Two rows for each half sample near the obstacle; the pose that is measured can't be moved and has none."""
        normals, at_start, at_end, turning = self._gaps(trajectory)
        ends = np.flatnonzero(at_end < REACH)
        starts = np.flatnonzero(at_start[1:] < REACH) + 1
        half_samples, poses = np.concatenate([ends, starts]), np.concatenate([ends, starts - 1])
        direction = np.column_stack([normals[half_samples], np.concatenate([turning[1][ends], turning[0][starts]])])
        beyond = self._tail.sensitivities(trajectory.states[-1], sensitivities.states[-1])
        of_poses = np.concatenate([sensitivities.poses, beyond])[poses]
        matrix = np.einsum("ij,ijn->in", direction, of_poses)
        gap = np.concatenate([at_end[ends], at_start[starts]])
        return Rows(matrix, self._margin - gap, np.full(len(gap), np.inf))

    def is_near(self, trajectory: Trajectory) -> bool:
        """Whether any pose is within reach, so that `rows` are not empty."""
        _, at_start, at_end, _ = self._gaps(trajectory)
        return bool(min(at_start[1:].min(), at_end.min()) < REACH)

    def _gaps(self, trajectory: Trajectory) -> tuple[Array, Array, Array, tuple[Array, Array]]:
        """Normals (k, 2), gaps at both ends of each of the k half samples (k,) [m], and d gap / d psi at both."""
        beyond = self._tail.poses(trajectory.states[-1], self._side)
        from_centre = np.concatenate([trajectory.poses, beyond])
        from_centre[:, :2] -= self._centres
        start, end = from_centre[:-1], from_centre[1:]
        normals, reach = separating_normals(self._obstacle, self._footprint, (start + end) / 2, self._side)
        reach_start, turning_start = footprint_reach(self._footprint, normals, start[:, 2])
        reach_end, turning_end = footprint_reach(self._footprint, normals, end[:, 2])
        at_start = np.einsum("ij,ij->i", normals, start[:, :2]) - reach - reach_start
        at_end = np.einsum("ij,ij->i", normals, end[:, :2]) - reach - reach_end
        return normals, at_start, at_end, (-turning_start, -turning_end)
