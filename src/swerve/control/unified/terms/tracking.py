"""Deviation of one state from its reference, at the end of every sample: the first sum of (10).

w sum_{i=1..Np} (xi_j(k+i) - reference)^2
"""

from dataclasses import dataclass

from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.terms.term import Quadratic


@dataclass(frozen=True)
class Tracking:
    """The term for one state.

    Attributes:
        state: its index in xi.
        reference: the value it is to have [unit of the state].
        weight: w [1 / unit of the state^2].
    """

    state: int
    reference: float
    weight: float

    def value(self, trajectory: Trajectory) -> float:
        """The sum above [1]."""
        deviation = trajectory.states[1:, self.state] - self.reference
        return float(self.weight * (deviation @ deviation))

    def quadratic(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Quadratic:
        """Its Gauss-Newton model."""
        deviation = trajectory.states[1:, self.state] - self.reference
        J = sensitivities.states[:, self.state]
        weighted = 2 * self.weight * J.T
        return Quadratic(weighted @ J, weighted @ deviation)
