"""Whoever brakes does so in its lane: the centre of gravity stays within a band along the road.

    lowest <= Y_j <= highest        for every half sample j, and beyond the horizon

Without it a stop would swing to and fro: a path that winds, and tyres that slip sideways, end a little sooner.
"""

from dataclasses import dataclass

import numpy as np

from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.limits.limit import Penalty, Rows, nearest
from swerve.control.unified.prediction import Trajectory

REACH = 0.5  # [m] poses further inside than this are left out of the rows; acceptance sees them all


@dataclass(frozen=True)
class Lane:
    """The limit for one band.

    Attributes:
        lowest: Y [m].
        highest: Y [m].
        penalty: of the largest distance beyond it.
    """

    lowest: float
    highest: float
    penalty: Penalty

    @property
    def name(self) -> str:
        """As `Plan.active` says it."""
        return "lane"

    def violation(self, trajectory: Trajectory) -> float:
        """Largest distance beyond the band [m]."""
        y = trajectory.poses[1:, 1]
        return max(0.0, float(y.max()) - self.highest, self.lowest - float(y.min()))

    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """A row for each pose but the first, with the sides that are in reach."""
        y = trajectory.poses[1:, 1]
        lower, upper = self.lowest - y, self.highest - y
        near = nearest(np.minimum(-lower, upper), REACH)
        lower, upper = lower[near], upper[near]
        return Rows(
            sensitivities.poses[near, 1],
            np.where(lower > -REACH, lower, -np.inf),
            np.where(upper < REACH, upper, np.inf),
            places=near,
        )
