"""Which part of a proposed change is taken: what counts is the roll-out through the nonlinear model.

Step lengths 1, 1/2, 1/4 are tried until one lowers the merit by at least GOOD of what the convex program promised;
failing that, the best of them is taken if it lowers the merit at all.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.program import Score

Array = NDArray[np.float64]

STEP_LENGTHS = (1.0, 0.5, 0.25)
GOOD = 0.25  # [1] share of the promise


@dataclass(frozen=True, eq=False)
class Step:
    """A trajectory, its score, and the step length that led to it (0: nothing better was found)."""

    trajectory: Trajectory
    score: Score
    length: float = 0.0

    @property
    def merit(self) -> float:
        """What is to be lowered [1]."""
        return self.score.merit


def accept(current: Step, change: Array, promise: float, roll_out: Callable[[Array], Step]) -> Step:
    """The best of the tried step lengths, or the current trajectory with length 0.

    Args:
        current: where the change was computed.
        change: (Np, 5) of the inputs.
        promise: by how much the convex program lowers the merit for the whole change [1].
        roll_out: inputs -> trajectory and score.
    """
    best = replace(current, length=0.0)
    for length in STEP_LENGTHS:
        tried = roll_out(current.trajectory.inputs + length * change)
        if tried.merit < best.merit:
            best = replace(tried, length=length)
        if current.merit - best.merit >= GOOD * length * promise:
            return best
    return best
