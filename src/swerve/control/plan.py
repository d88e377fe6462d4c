"""What a controller intends, and why: the answer that goes with every command."""

from dataclasses import dataclass, field
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import N_WHEELS

Array = NDArray[np.float64]

KEEP = "keep"  # the name of a plan that no obstacle asks anything of


class Side(Enum):
    """On which side an obstacle is passed; the value is the sign of the lateral axis (ISO 8855: left is positive)."""

    LEFT = 1
    RIGHT = -1


class Passing(Enum):
    """How one obstacle is passed: on its left, on its right, or not at all; the value is the sign of the side."""

    LEFT = 1
    RIGHT = -1
    BEHIND = 0

    @property
    def side(self) -> Side | None:
        """The side, None for staying behind."""
        return None if self is Passing.BEHIND else Side(self.value)


class Fallback(Enum):
    """Why a command is not the optimum of this step; the value is the sentence for a reader."""

    NOT_FINITE = "the measurement has a number that is not finite"
    LATE = "the measurement is too old"
    NO_SOLUTION = "no program of this step was solved"
    DEADLINE = "the step's time was over before a plan was there"


@dataclass(frozen=True, eq=False)
class Branch:
    """One way that was tried in this step.

    Attributes:
        name: what it does about the obstacles in the path, as in "brake" or "left, then right".
        passing: of each obstacle, in the measurement's order.
        cost: of the tracking terms, over the horizon and beyond it [1].
        violation: largest distance by which it misses a margin to an obstacle; 0 is clear [m].
        off_road: largest distance beyond a road edge; 0 is on the road [m].
        impact_speed: relative to the obstacle, at its first contact; None where it is clear [m/s].
        poses: (n, 3) X, Y, psi of the predicted path, horizon and beyond it.
    """

    name: str
    passing: tuple[Passing, ...]
    cost: float
    violation: float
    off_road: float
    impact_speed: float | None
    poses: Array


@dataclass(frozen=True, eq=False)
class Plan:
    """The predicted motion whose first input is the command.

    Attributes:
        time: of the step [s].
        inputs: (Np, 5) [rad, N, N, N, N].
        states: (Np + 1, 6) predicted states from the measured one on; empty (0, 6) where nothing was predicted.
        side: of the branch taken; None for braking, and where no obstacle shaped the plan.
        name: of the branch taken, KEEP where nothing is in the path.
        is_shaped: whether an obstacle shaped the plan.
        branches: all that were tried.
        reason: why this one, a sentence.
        active: the limits that hold this plan, as in "obstacle 0", "slip" or "left edge".
        friction_use: (4,) share of each wheel's friction that the first input takes [1].
        fallback: None for a plan of this step, else why it is not.
        solver_failures: programs of this step that had no answer.
    """

    time: float
    inputs: Array
    states: Array
    side: Side | None = None
    name: str = KEEP
    is_shaped: bool = False
    branches: tuple[Branch, ...] = ()
    reason: str = ""
    active: tuple[str, ...] = ()
    friction_use: Array = field(default_factory=lambda: np.full(N_WHEELS, np.nan))
    fallback: Fallback | None = None
    solver_failures: int = 0
