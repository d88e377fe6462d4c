"""Bounds on the inputs themselves, (14): steering lock, wheel forces, and the trust region of the linearisation; and
which inputs there are (control/actuation.py).

A wheel that corners has less to brake with. At Fx = 0 the friction ellipse is flat, dFy/dFx = 0, so a linear model
takes wheel force for free and spends the grip that the turn needs. The force limit therefore leaves room for the
lateral demand lambda = |M(alpha)| / D of the trajectory it is linearised about:

    |Fx| <= share mu Fz sqrt(1 - (RESERVE lambda)^2)
"""

from dataclasses import dataclass, field

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
        held: (n, 5) inputs of the first samples, fewer than Nc, that are settled; none by default.
    """

    largest: Array
    blocking: Blocking
    held: Array = field(default_factory=lambda: np.empty((0, N_INPUTS)))

    @classmethod
    def of(cls, vehicle: Vehicle, friction: float, loads: Array, blocking: Blocking) -> "InputBox":
        """The box of a vehicle on a road of `friction` [1] with wheel loads (4,) [N]."""
        largest = np.empty(N_INPUTS)
        largest[DELTA] = vehicle.steering_limit
        largest[FORCES] = vehicle.force_limit * friction * np.maximum(loads, 0)  # a lifted wheel's may be below zero
        return cls(largest, blocking)

    def bounds(self, trajectory: Trajectory, trust: Array) -> tuple[Array, Array]:
        """Lower and upper bound (n,) of the scaled changes z, within `trust` (5,) [rad, N, N, N, N].

        Where the trajectory breaks a bound by more than `trust`, the bound is approached by `trust`.
        """
        actuation, inputs = self.blocking.actuation, self.blocking.free(trajectory.inputs)
        limit = self.limit(self.blocking.free(trajectory.lateral_demand))
        lower = np.minimum(np.maximum(actuation.lower * limit - inputs, -trust), trust) / INPUT_SCALE
        upper = np.minimum(np.maximum(actuation.upper * limit - inputs, -trust), trust) / INPUT_SCALE
        n = len(self.held)
        lower[:n] = upper[:n] = (self.held - inputs[:n]) / INPUT_SCALE
        lower, upper = actuation.free_bounds(lower, upper)
        return lower.ravel(), upper.ravel()

    def limit(self, lateral_demand: Array) -> Array:
        """Largest magnitudes (n, 5) beside lateral demands (n, 4) [1]."""
        limit = np.tile(self.largest, (len(lateral_demand), 1))
        limit[:, FORCES] *= np.sqrt(1 - (RESERVE * np.minimum(lateral_demand, 1)) ** 2)
        return limit

    def clip(self, inputs: Array) -> Array:
        """The inputs (Np, 5) that there are, within the largest magnitudes; first those that are held."""
        clipped = self.blocking.actuation.within(inputs, self.largest)
        clipped[: len(self.held)] = self.held
        return clipped
