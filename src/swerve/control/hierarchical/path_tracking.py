"""The cost of the tracker: distance from the path, angle to it, and deviation from the speed profile.

sum_{i=1..Np} w_y (Y - y(X))^2 + w_psi (psi - atan y'(X))^2 + w_v (vx - v_i)^2
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.hierarchical.quintic import Quintic
from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.terms.term import Quadratic, Term
from swerve.conventions import PSI, VX, X, Y

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PathTracking(Term):
    """The term for one manoeuvre.

    Attributes:
        lateral: the path y(x).
        speeds: (Np,) the speed profile at the end of each sample [m/s].
        weights: (3,) w_y [1/m^2], w_psi [1/rad^2], w_v [s^2/m^2].
    """

    lateral: Quintic
    speeds: Array
    weights: Array

    def value(self, trajectory: Trajectory) -> float:
        """The sum above [1]."""
        return float((self.weights * self._deviations(trajectory) ** 2).sum())

    def quadratic(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Quadratic:
        """Its Gauss-Newton model."""
        states = sensitivities.states
        _, slope, bend = self.lateral.at(trajectory.states[1:, X])
        turning = bend / (1 + slope**2)
        J = np.stack(
            (
                states[:, Y] - slope[:, np.newaxis] * states[:, X],
                states[:, PSI] - turning[:, np.newaxis] * states[:, X],
                states[:, VX],
            ),
            axis=1,
        )
        weighted = 2 * self.weights[:, np.newaxis] * J
        J, weighted = J.reshape(-1, states.shape[2]), weighted.reshape(-1, states.shape[2])
        return Quadratic(weighted.T @ J, weighted.T @ self._deviations(trajectory).ravel())

    def _deviations(self, trajectory: Trajectory) -> Array:
        """(Np, 3) of [m, rad, m/s]."""
        states = trajectory.states[1:]
        y, slope, _ = self.lateral.at(states[:, X])
        return np.column_stack([states[:, Y] - y, states[:, PSI] - np.arctan(slope), states[:, VX] - self.speeds])
