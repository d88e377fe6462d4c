"""What a controller intends, and why: the answer that goes with every command."""

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Side(Enum):
    """On which side an obstacle is passed; the value is the sign of the lateral axis (ISO 8855: left is positive)."""

    LEFT = 1
    RIGHT = -1


class Fallback(Enum):
    """Why a command is not the optimum of this step; the value is the sentence for a reader."""

    NOT_FINITE = "the measurement has a number that is not finite"
    LATE = "the measurement is too old"
    NO_SOLUTION = "no quadratic program of this step was solved"


@dataclass(frozen=True, eq=False)
class Branch:
    """One way that was tried in this step.

    Attributes:
        side: on which it passes.
        cost: of the tracking terms and of violations, as in the controller's merit [1].
        violation: largest distance by which it misses a margin to an obstacle [m].
    """

    side: Side
    cost: float
    violation: float


@dataclass(frozen=True, eq=False)
class Plan:
    """The predicted motion whose first input is the command.

    Attributes:
        time: of the step [s].
        inputs: (Np, 5) [rad, N, N, N, N].
        states: (Np + 1, 6) predicted states from the measured one on; empty (0, 6) where nothing was predicted.
        side: of the branch taken, None where no obstacle shaped the plan.
        branches: all that were tried.
        fallback: None for a plan of this step, else why it is not.
        solver_failures: quadratic programs of this step that had no answer.
    """

    time: float
    inputs: Array
    states: Array
    side: Side | None
    branches: tuple[Branch, ...] = ()
    fallback: Fallback | None = None
    solver_failures: int = 0
