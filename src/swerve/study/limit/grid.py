"""How a manoeuvre may end, and how long its grid is for it.

Past the obstacles the vehicle goes straight on; or it stays behind one and is no faster than that. The horizon grows as
the time that a point mass takes:  sqrt(2 w / (mu g))  aside by w,  v / (mu g)  to a standstill.
"""

from dataclasses import dataclass
from enum import Enum
from math import sqrt
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.study.limit.scene import Scene

Array = NDArray[np.float64]

N_INTERVALS: Final = 100
SETTLING: Final = 4.0  # [1] times the time to go aside: past the obstacles, and straight again
NEAREST: Final = 1.3  # [1] times the distance at which a point mass can go aside: where the pass may begin
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
    """

    ending: Ending
    step: float

    @property
    def times(self) -> Array:
        """Of the nodes (N_INTERVALS + 1,) [s]."""
        return np.arange(N_INTERVALS + 1, dtype=np.float64) * self.step


def grid_for(scene: Scene, ending: Ending) -> Grid:
    """The grid for an ending, at the scene's friction."""
    closing, grip = max(scene.speed - scene.slowest, 1.0), scene.grip(scene.friction)
    if ending is Ending.BEHIND:
        return Grid(ending, STOPPING * closing / grip / N_INTERVALS)
    aside = sqrt(2 * scene.room / grip)
    return Grid(ending, ((NEAREST + SETTLING * sqrt(0.5)) * aside + scene.depth / closing) / N_INTERVALS)
