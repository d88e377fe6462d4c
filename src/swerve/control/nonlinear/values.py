"""What goes into a solve and what comes out."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import X, Y
from swerve.signals import ABSURD
from swerve.world import Obstacle

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Question:
    """What changes from solve to solve.

    Attributes:
        state: (6,) measured.
        command: (5,) input that acts now.
        wheel_loads: (4,) [N].
        obstacles: as they are now.
    """

    state: Array
    command: Array
    wheel_loads: Array
    obstacles: tuple[Obstacle, ...]

    @property
    def nearest(self) -> list[int]:
        """Indices of the obstacles, the nearest to the vehicle first, as the program has them."""
        here = self.state[[X, Y]]
        away = [float(np.hypot(*(each.position_at(0.0) - here))) for each in self.obstacles]
        return sorted(range(len(away)), key=away.__getitem__)


@dataclass(frozen=True, eq=False)
class Guess:
    """Where a solver starts: inputs, rolled out.

    Attributes:
        inputs: (Np, 5) [rad, N, N, N, N].
        states: (Np + 1, 6), the measured one first.
        x: all variables, slacks as large as the roll-out needs them.
        violations: (n_obstacles + 1,) the slacks: of the margins [m] and, last, of the slip limit [rad].
        cost: f, violations included [1].
    """

    inputs: Array
    states: Array
    x: Array
    violations: Array
    cost: float

    @property
    def is_sane(self) -> bool:
        """Whether the roll-out is a motion: from one that diverged Fatrop has been seen not to return."""
        return bool((np.abs(self.states) <= ABSURD).all()) and bool(np.isfinite(self.cost))

    @property
    def missed_clearance(self) -> float:
        """Largest distance by which a margin to an obstacle is missed [m]."""
        return float(self.violations[:-1].max(initial=0.0))


@dataclass(frozen=True, eq=False)
class Answer:
    """What a solver found.

    Attributes:
        inputs: (Np, 5) [rad, N, N, N, N].
        states: (Np + 1, 6), the measured one first.
        violations: (n_obstacles + 1,) the slacks: of the margins [m] and, last, of the slip limit [rad].
        cost: f, violations included [1].
        is_solved: whether the solver says that this is a local minimum.
        iterations: of the solver.
        x: all variables.
        rows: g.
        bound_multipliers: of the bounds on x, positive where the upper one acts.
        row_multipliers: likewise of g.
    """

    inputs: Array
    states: Array
    violations: Array
    cost: float
    is_solved: bool
    iterations: int
    x: Array
    rows: Array
    bound_multipliers: Array
    row_multipliers: Array

    @property
    def missed_clearance(self) -> float:
        """Largest distance by which a margin to an obstacle is missed [m]."""
        return float(self.violations[:-1].max(initial=0.0))
