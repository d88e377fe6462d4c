"""How a manoeuvre may end, and how long its grid is for it.

Past the obstacles the vehicle goes straight on; or it stays behind one and is no faster than that. The horizon grows as
the time that a point mass takes:  sqrt(2 w / (mu g))  aside by w,  v / (mu g)  to a standstill.
"""

from dataclasses import dataclass
from enum import Enum
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.study.limit.scene import WALKING, Scene

Array = NDArray[np.float64]

N_INTERVALS: Final = 100
LASTING: Final = 4.0  # [1] times the time to go aside: past the obstacles, and straight again
STOPPING: Final = 1.25  # [1] times the time that a point mass takes to stop


class Ending(Enum):
    """What the manoeuvre comes to."""

    PAST = "past"
    BEHIND = "behind"


@dataclass(frozen=True)
class Grid:
    """Intervals of one length, in each of which the inputs are held.

    Attributes:
        ending: for which it is long enough.
        step: of an interval [s].
        n_intervals: N.
    """

    ending: Ending
    step: float
    n_intervals: int

    @property
    def times(self) -> Array:
        """Of the nodes (N + 1,) [s]."""
        return np.arange(self.n_intervals + 1, dtype=np.float64) * self.step


def grid_for(scene: Scene, ending: Ending) -> Grid:
    """The grid for an ending, at the scene's friction."""
    if ending is Ending.BEHIND:
        duration = STOPPING * max(scene.speed - scene.slowest, WALKING) / scene.grip
    else:
        duration = LASTING * scene.time_aside + scene.at(0.0).time_past
    return Grid(ending, duration / N_INTERVALS, N_INTERVALS)
