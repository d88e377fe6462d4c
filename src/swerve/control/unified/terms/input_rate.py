"""Change of the inputs from sample to sample: the second sum of (10).

    sum_{j=0..Nc-1} || u(k+j) - u(k+j-1) ||_R^2,   u(k-1) being the input that acts now
"""

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.condensing import INPUT_SCALE, Blocking, Sensitivities
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.terms.term import Quadratic
from swerve.conventions import N_INPUTS

Array = NDArray[np.float64]


class InputRate:
    """The term for the diagonal of R and the input before the plan."""

    def __init__(self, weights: Array, previous: Array, blocking: Blocking) -> None:
        """R's diagonal (5,) [1/rad^2, 1/N^2 x 4] and the input that acts now (5,)."""
        self._weights, self._previous, self._blocking = weights, previous, blocking
        step = np.eye(blocking.n) - np.eye(blocking.n, k=-N_INPUTS)  # D of dU = D U - (u(k-1), 0, ...)
        R = np.tile(weights * INPUT_SCALE**2, blocking.n_blocks)
        self._hessian = 2 * step.T @ (R[:, np.newaxis] * step)

    def value(self, trajectory: Trajectory) -> float:
        """The sum above [1]."""
        return float(np.sum(self._weights * self._changes(trajectory) ** 2))

    def quadratic(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Quadratic:
        """Its exact model: it is quadratic, with a Hessian that is the same for all trajectories."""
        pulled = 2 * self._weights * INPUT_SCALE * self._changes(trajectory)
        pulled[:-1] -= pulled[1:]  # D' dU
        return Quadratic(self._hessian, pulled.ravel())

    def _changes(self, trajectory: Trajectory) -> Array:
        return np.diff(self._blocking.free(trajectory.inputs), axis=0, prepend=self._previous[np.newaxis])
