"""Deviation of the inputs from a driver's, who is taken to hold what is asked for now.

sum_{j=0..Nc-1} || u(k+j) - u_driver(k) ||_W^2
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.condensing import INPUT_SCALE, Blocking, Sensitivities
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.terms.term import Quadratic

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class DriverDeviation:
    """The term for one driver's input.

    Attributes:
        asked: (5,) u_driver [rad, N, N, N, N].
        weights: (5,) diagonal of W [1/rad^2, 1/N^2 x 4].
        blocking: of the free inputs.
    """

    asked: Array
    weights: Array
    blocking: Blocking

    def value(self, trajectory: Trajectory) -> float:
        """The sum above [1]."""
        return float((self.weights * self._deviation(trajectory) ** 2).sum())

    def quadratic(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Quadratic:
        """Its exact model: it is quadratic."""
        E = self.blocking.embedding()
        curvature = np.tile(2 * self.weights * INPUT_SCALE**2, self.blocking.n_blocks)
        slope: Array = 2 * self.weights * INPUT_SCALE * self._deviation(trajectory)
        return Quadratic(E.T @ (curvature[:, np.newaxis] * E), (slope @ self.blocking.actuation.basis).ravel())

    def _deviation(self, trajectory: Trajectory) -> Array:
        return np.asarray(self.blocking.free(trajectory.inputs) - self.asked)
