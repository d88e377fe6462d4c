"""Whoever stays behind an obstacle keeps a gap to it, for comfort; its price is low, and to miss it is no fault."""

from dataclasses import dataclass

import numpy as np

from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.limits.limit import Penalty, Rows
from swerve.control.unified.limits.obstacle import ObstacleLimit
from swerve.control.unified.prediction import Trajectory


@dataclass(frozen=True)
class StoppingGap:
    """The gap to one obstacle.

    Attributes:
        limit: for that obstacle.
        gap: that is kept besides its margin [m].
        penalty: of what is missing of it.
    """

    limit: ObstacleLimit
    gap: float
    penalty: Penalty

    @property
    def name(self) -> str:
        """As `Plan.active` says it."""
        return f"gap to {self.limit.name}"

    def violation(self, trajectory: Trajectory) -> float:
        """Largest distance by which the gap is missed, at most all of it [m]."""
        return min(self.gap, max(0.0, self.gap + self.limit.missing(trajectory)))

    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """Those of the obstacle, further away by the gap."""
        matrix, lower, upper = self.limit.rows(trajectory, sensitivities)
        return Rows(matrix, np.asarray(lower + self.gap), upper)
