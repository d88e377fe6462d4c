"""The whole footprint stays on the road: for each pose j, with e_Y the world's lateral axis,

right edge + margin <= Y_j - h_ego(-e_Y; psi_j),    Y_j + h_ego(e_Y; psi_j) <= left edge - margin
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Side
from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.limits.limit import Penalty, Rows, nearest
from swerve.control.unified.prediction import Trajectory
from swerve.world import Footprint, Point

Array = NDArray[np.float64]

REACH = 1.5  # [m] poses further from the edge than this are left out of the rows; acceptance sees them all


@dataclass(frozen=True)
class RoadEdge:
    """The limit for one edge.

    Attributes:
        side: on which the edge is.
        edge: its Y [m].
        footprint: of the ego vehicle.
        margin: to the edge [m].
        penalty: of the largest distance by which it is missed.
    """

    side: Side
    edge: float
    footprint: Footprint
    margin: float
    penalty: Penalty

    @property
    def name(self) -> str:
        """As `Plan.active` says it."""
        return f"{self.side.name.lower()} edge"

    def violation(self, trajectory: Trajectory) -> float:
        """Largest distance by which the margin is missed [m]."""
        return max(0.0, self.margin - float(self._gaps(trajectory)[0].min()))

    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """A row for each pose in reach, but the first, which is measured."""
        gap, turning = self._gaps(trajectory)
        near = nearest(gap, REACH)
        of_poses = sensitivities.poses[near]
        matrix = turning[near, np.newaxis] * of_poses[:, 2] - self.side.value * of_poses[:, 1]
        return Rows(matrix, self.margin - gap[near], np.full(len(near), np.inf), places=near)

    def _gaps(self, trajectory: Trajectory) -> tuple[Array, Array]:
        """Distance of each pose but the first from the edge [m], and its derivative by psi [m/rad]."""
        _, y, psi = trajectory.poses[1:].T
        gap = self.side.value * (self.edge - y)
        if isinstance(self.footprint, Point):
            return gap, np.zeros(len(gap))
        sin, cos = np.sin(psi), np.cos(psi)
        half = np.array([self.footprint.length, self.footprint.width]) / 2
        x = self.footprint.centre[0] + self.side.value * np.sign(sin) * half[0]  # of the corner that is furthest out
        y = self.footprint.centre[1] + self.side.value * np.sign(cos) * half[1]
        reach, turning = sin * x + cos * y, cos * x - sin * y
        return gap - self.side.value * reach, -self.side.value * turning
