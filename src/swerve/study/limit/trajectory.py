"""What is sought, and a manoeuvre on a grid that may be it."""

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from swerve.study.limit.grid import Grid

Array = NDArray[np.float64]


class Sought(Enum):
    """What is minimised, in the order of the program's variables D, mu, s."""

    DISTANCE = 0
    FRICTION = 1
    VIOLATION = 2


@dataclass(frozen=True, eq=False)
class Trajectory:
    """A guess, or a solution.

    Attributes:
        grid: on which it is.
        states: (N + 1, 6).
        shares: (N, 5) w of `means`.
        distance: D [m].
        friction: mu [1].
        violation: s [m].
        is_solved: whether a solver says that it is a local optimum.
    """

    grid: Grid
    states: Array
    shares: Array
    distance: float
    friction: float
    violation: float = 0.0
    is_solved: bool = False

    def value(self, sought: Sought) -> float:
        """What was minimised."""
        return (self.distance, self.friction, self.violation)[sought.value]
