"""Slip angles stay below the tyre's peak, behind which the gain of a steering angle changes its sign.

    | alpha_front(x_k, u_k) | <= limit,   | alpha_rear(x_k+1) | <= limit

The front slip is largest when an input sets in, the rear one at the end of the sample.
"""

from dataclasses import dataclass

import numpy as np

from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.limits.limit import Penalty, Rows
from swerve.control.unified.prediction import Trajectory

REACH = 0.1  # [rad] a limit further away than this is left out of the rows; acceptance sees it all the same


@dataclass(frozen=True)
class SlipLimit:
    """The limit for both axles.

    Attributes:
        limit: largest slip angle [rad].
        penalty: of what is beyond it [1/rad, 1/rad^2].
    """

    limit: float
    penalty: Penalty

    @property
    def name(self) -> str:
        """As `Plan.active` says it."""
        return "slip"

    def violation(self, trajectory: Trajectory) -> float:
        """Largest slip angle beyond the limit [rad]."""
        largest = max(np.abs(trajectory.front_slip).max(), np.abs(trajectory.rear_slip).max())
        return max(0.0, float(largest) - self.limit)

    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """At most two rows a sample, each with the sides that are in reach."""
        slip = np.concatenate([trajectory.front_slip, trajectory.rear_slip])
        matrix = np.concatenate([sensitivities.front_slip, sensitivities.rear_slip])
        lower, upper = -self.limit - slip, self.limit - slip
        return Rows(matrix, np.where(lower > -REACH, lower, -np.inf), np.where(upper < REACH, upper, np.inf))
