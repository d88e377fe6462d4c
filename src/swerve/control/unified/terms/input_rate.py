"""Change of the inputs from sample to sample: the second sum of (10).

sum_{j=0..Nc-1} || u(k+j) - u(k+j-1) ||_R^2,   u(k-1) being the input that acts now
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.condensing import INPUT_SCALE, Blocking, Sensitivities
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.terms.term import Quadratic
from swerve.conventions import N_INPUTS

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class InputRate:
    """The term for the diagonal of R and the input before the plan.

    Attributes:
        weights: (5,) diagonal of R [1/rad^2, 1/N^2 x 4].
        blocking: of the free inputs.
        hessian: (n, n), the same for all trajectories.
        previous: (5,) input that acts now.
    """

    weights: Array
    blocking: Blocking
    hessian: Array
    previous: Array

    @classmethod
    def of(cls, weights: Array, blocking: Blocking) -> "InputRate":
        """The term before the first step, when nothing acts."""
        n = N_INPUTS * blocking.n_blocks
        step = np.eye(n) - np.eye(n, k=-N_INPUTS)  # D of dU = D U - (u(k-1), 0, ...)
        R = np.tile(weights * INPUT_SCALE**2, blocking.n_blocks)
        of_all, E = 2 * step.T @ (R[:, np.newaxis] * step), blocking.embedding()
        return cls(weights, blocking, E.T @ of_all @ E, np.zeros(N_INPUTS))

    def after(self, previous: Array) -> "InputRate":
        """The same term for another input (5,) before the plan."""
        return replace(self, previous=previous)

    def value(self, trajectory: Trajectory) -> float:
        """The sum above [1]."""
        return float((self.weights * self._changes(trajectory) ** 2).sum())

    def quadratic(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Quadratic:
        """Its exact model: it is quadratic."""
        pulled = 2 * self.weights * INPUT_SCALE * self._changes(trajectory)
        pulled[:-1] -= pulled[1:]  # D' dU
        return Quadratic(self.hessian, (pulled @ self.blocking.actuation.basis).ravel())

    def _changes(self, trajectory: Trajectory) -> Array:
        inputs = self.blocking.free(trajectory.inputs)
        changes = inputs.copy()
        changes[0] -= self.previous
        changes[1:] -= inputs[:-1]
        return changes
