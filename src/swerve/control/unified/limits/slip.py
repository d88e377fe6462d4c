"""Slip angles stay below the tyre's peak, behind which the gain of a steering angle changes its sign.

    | alpha_front(x_k, u_k) | <= limit,   | alpha_rear(x_k+1) | <= limit

The front slip is largest when an input sets in, the rear one at the end of the sample.
"""

from dataclasses import dataclass

import numpy as np

from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.limits.limit import Penalty, Rows
from swerve.control.unified.prediction import Trajectory


@dataclass(frozen=True)
class SlipLimit:
    """The limit for both axles.

    Attributes:
        limit: largest slip angle [rad].
        penalty: of what is beyond it [1/rad, 1/rad^2].
    """

    limit: float
    penalty: Penalty

    def violation(self, trajectory: Trajectory) -> float:
        """Largest slip angle beyond the limit [rad]."""
        largest = max(np.abs(trajectory.front_slip).max(), np.abs(trajectory.rear_slip).max())
        return max(0.0, float(largest) - self.limit)

    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """Two rows a sample."""
        slip = np.concatenate([trajectory.front_slip, trajectory.rear_slip])
        matrix = np.vstack([sensitivities.front_slip, sensitivities.rear_slip])
        return Rows(matrix, -self.limit - slip, self.limit - slip)
