"""Which of the five inputs a controller has: a vehicle without drive torque, with one brake demand, or with a failure.

    u = fixed + basis v,    lower <= u / largest <= upper

Each input moves with one column of `basis` at most, so bounds on u are bounds on v, one by one. A single brake demand
(conventional friction brakes) is a column with the wheel loads of a stop at 0.8 g: left and right alike, front to rear
as lr + 0.8 h : lf - 0.8 h, which is ideal there and leaves the front wheels the first to lock in any milder stop; with
h = 0, static loads, always ideal. The wheel that has the least to give then limits all of them.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import DELTA, FORCES, GRAVITY, N_INPUTS, N_WHEELS
from swerve.vehicle import Vehicle
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters

Array = NDArray[np.float64]

# [1] share of a steered swerve that wheel forces alone reach: in steady state ay = v^2 M (1/Cf + 1/Cr) / L^2, for the
# paper's vehicle that brakes on one side at 20 m/s 4 m/s^2; the yaw rate takes twice as long as by steering to be there
VECTORING: Final = 0.4

DESIGN: Final = 0.8 * GRAVITY  # [m/s^2] deceleration for which brakes of a fixed distribution are designed

# [1] share of full braking that a fixed distribution is trusted with: as long as the load has not moved to the front,
# the front wheels limit the demand, with h / L = 0.2 at lr / (lr + 0.8 h) = 0.8 of it
FIXED_DISTRIBUTION: Final = 0.8


class _Mode(NamedTuple):
    """What a mode has: steering; wheel forces "one by one", "together" or none; and whether they may drive."""

    steers: bool
    forces: str | None
    drives: bool


ALL: Final = "all"
MODES: Final = {
    ALL: _Mode(True, "one by one", True),
    "steer-only": _Mode(True, None, False),
    "brakes-only": _Mode(False, "one by one", False),
    "steer+friction-brakes": _Mode(True, "together", False),
    "no-drive": _Mode(True, "one by one", False),
}


@dataclass(frozen=True, eq=False)
class Actuation:
    """The inputs that there are.

    Attributes:
        basis: (5, m) of the inputs by what is free; at most one entry a row, none below zero [1].
        fixed: (5,) value of an input that is not free; 0 for the others [rad, N, N, N, N].
        lower: (5,) smallest input as a share of its largest magnitude: -1, or 0 [1].
        upper: (5,) largest one: 1, or 0 [1].
        braking: share of full braking that is to be had: of the static load that is on wheels which can brake [1].
    """

    basis: Array
    fixed: Array
    lower: Array
    upper: Array
    braking: float

    @classmethod
    def of(
        cls, vehicle: Vehicle, mode: str, failed_wheels: tuple[int, ...] = (), steering_stuck: float | None = None
    ) -> "Actuation":
        """The inputs of a mode, one of MODES, less what has failed.

        Args:
            vehicle: whose loads share out a single brake demand; its `cg_height` is h.
            mode: name of it.
            failed_wheels: indices of wheels without torque.
            steering_stuck: angle at which the steering stays, None where it moves [rad].

        Raises:
            ValueError: nothing is left to command.
        """
        has, parameters = MODES[mode], Parameters.of(vehicle, friction=1.0)
        loads, shares = np.array(wheel_loads(parameters)), np.array(wheel_loads(parameters, ax=-DESIGN))
        works = np.array([has.forces is not None and wheel not in failed_wheels for wheel in range(N_WHEELS)])
        forces = np.diag(works) if has.forces != "together" else (works * shares / shares.mean())[:, np.newaxis]
        basis = np.zeros((N_INPUTS, 1 + forces.shape[1]))
        basis[DELTA, 0], basis[FORCES, 1:] = has.steers and steering_stuck is None, forces
        basis = basis[:, basis.any(axis=0)]
        if basis.size == 0:
            raise ValueError("nothing is left to command")
        fixed = np.zeros(N_INPUTS)
        fixed[DELTA] = steering_stuck or 0.0
        upper = np.ones(N_INPUTS)
        upper[FORCES] = 1.0 if has.drives else 0.0
        reached = FIXED_DISTRIBUTION if has.forces == "together" else 1.0
        return cls(basis, fixed, -np.ones(N_INPUTS), upper, reached * float(works @ loads / loads.sum()))

    @property
    def n_free(self) -> int:
        """m."""
        return int(self.basis.shape[1])

    @property
    def steers(self) -> bool:
        """Whether the steering angle is free."""
        return bool(self.basis[DELTA].any())

    @property
    def turning(self) -> float:
        """How much of a steered swerve is to be had [1]."""
        if self.steers:
            return 1.0
        left, right = (self.basis[wheels].any(axis=0) for wheels in ([1, 3], [2, 4]))
        return VECTORING if (left & ~right).any() and (right & ~left).any() else 0.0

    @cached_property
    def _moved(self) -> tuple[NDArray[np.intp], Array, NDArray[np.intp]]:
        """The inputs that move, column by column; by how much each; and where in this list a column begins."""
        column, moved = np.nonzero(self.basis.T)
        return moved, self.basis[moved, column], np.flatnonzero(np.diff(column, prepend=-1))

    @cached_property
    def _projection(self) -> Array:
        """(5, m) to the nearest v."""
        return np.asarray(self.basis / (self.basis**2).sum(axis=0))

    def free_bounds(self, lower: Array, upper: Array) -> tuple[Array, Array]:
        """Bounds (..., m) on v, or on its changes, by which inputs, or their changes, stay within bounds (..., 5).

        Where that is not possible for all inputs that move together, those that can move least decide.
        """
        moved, by, first = self._moved
        largest = np.minimum.reduceat(upper[..., moved] / by, first, axis=-1)
        smallest = np.maximum.reduceat(lower[..., moved] / by, first, axis=-1)
        return np.minimum(smallest, largest), largest

    def within(self, u: Array, largest: Array) -> Array:
        """The inputs (..., 5) that there are, the nearest to u (..., 5) within magnitudes (5,)."""
        lower, upper = self.lower * largest, self.upper * largest
        bounded = np.minimum(np.maximum(u, lower), upper)
        v = bounded @ self._projection
        smallest, most = self.free_bounds(lower, upper)
        return np.asarray(np.minimum(np.maximum(v, smallest), most) @ self.basis.T + self.fixed)


EVERYTHING: Final = Actuation(np.eye(N_INPUTS), np.zeros(N_INPUTS), -np.ones(N_INPUTS), np.ones(N_INPUTS), 1.0)
