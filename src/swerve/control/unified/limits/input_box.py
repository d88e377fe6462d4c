"""Bounds on the inputs themselves, (14): steering lock, wheel forces, and the trust region of the linearisation.

A wheel that corners has less to brake with. At Fx = 0 the friction ellipse is flat, dFy/dFx = 0, so a linear model
takes wheel force for free and spends the grip that the turn needs. The force limit therefore leaves room for the
lateral demand lambda = |M(alpha)| / D of the trajectory it is linearised about:

    |Fx| <= share mu Fz sqrt(1 - (RESERVE lambda)^2)
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.condensing import INPUT_SCALE, Blocking
from swerve.control.unified.prediction import Trajectory
from swerve.conventions import DELTA, FORCES, N_INPUTS
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]

RESERVE = 0.95  # [1] at the peak of the lateral force a wheel keeps sqrt(1 - RESERVE^2) = 31 % of its force limit


@dataclass(frozen=True, eq=False)
class InputBox:
    """The bounds for one vehicle and one step.

    Attributes:
        largest: (5,) largest magnitude of each input, whatever the lateral demand [rad, N, N, N, N].
        blocking: of the free inputs.
    """

    largest: Array
    blocking: Blocking

    @classmethod
    def of(cls, vehicle: Vehicle, friction: float, loads: Array, blocking: Blocking) -> "InputBox":
        """The box of a vehicle on a road of `friction` [1] with wheel loads (4,) [N]."""
        largest = np.empty(N_INPUTS)
        largest[DELTA], largest[FORCES] = vehicle.steering_limit, vehicle.force_limit * friction * loads
        return cls(largest, blocking)

    def bounds(self, trajectory: Trajectory, trust: Array) -> tuple[Array, Array]:
        """Lower and upper bound (n,) of the scaled changes z, within `trust` (5,) [rad, N, N, N, N].

        Where the trajectory breaks a bound by more than `trust`, the bound is approached by `trust`.
        """
        inputs = self.blocking.free(trajectory.inputs)
        demand = np.minimum(self.blocking.free(trajectory.lateral_demand), 1)
        limit = np.empty_like(inputs)
        limit[:, DELTA] = self.largest[DELTA]
        limit[:, FORCES] = self.largest[FORCES] * np.sqrt(1 - (RESERVE * demand) ** 2)
        lower = np.minimum(np.maximum(-limit - inputs, -trust), trust) / INPUT_SCALE
        upper = np.minimum(np.maximum(limit - inputs, -trust), trust) / INPUT_SCALE
        return lower.ravel(), upper.ravel()

    def clip(self, u: Array) -> Array:
        """Inputs (..., 5) within the largest magnitudes."""
        return np.asarray(np.minimum(np.maximum(u, -self.largest), self.largest))
