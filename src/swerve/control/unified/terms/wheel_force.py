"""The wheel forces themselves. Of four forces the cost (10) sees two combinations, their sum and their moment; what is
left free (opposite forces front and rear, Fig. 9 of the paper) settles at zero.

    w sum_{j=0..Nc-1} sum_wheels Fx(k+j)^2
"""

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.condensing import INPUT_SCALE, Blocking, Sensitivities
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.terms.term import Quadratic
from swerve.conventions import DELTA


class WheelForce:
    """The term for one weight w [1/N^2]."""

    def __init__(self, weight: float, blocking: Blocking) -> None:
        """The same weight for each wheel."""
        self._blocking = blocking
        self._weights = np.full(INPUT_SCALE.size, weight)
        self._weights[DELTA] = 0.0
        E = blocking.embedding()
        self._hessian = E.T @ np.diag(np.tile(2 * self._weights * INPUT_SCALE**2, blocking.n_blocks)) @ E

    def value(self, trajectory: Trajectory) -> float:
        """The sum above [1]."""
        return float(np.sum(self._weights * self._blocking.free(trajectory.inputs) ** 2))

    def quadratic(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Quadratic:
        """Its exact model."""
        gradient: NDArray[np.float64] = 2 * self._weights * INPUT_SCALE * self._blocking.free(trajectory.inputs)
        return Quadratic(self._hessian, (gradient @ self._blocking.actuation.basis).ravel())
