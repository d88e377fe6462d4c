"""How far to the side a run went."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def lateral_excursion(lateral: Array, goal: float) -> float:
    """Largest distance of the centre of gravity from the strip between where it began and where it was to go [m].

    Where it begins on the line that it is to hold, this is the largest |Y - y_d|.

    Args:
        lateral: Y (n,) [m].
        goal: y_d [m].
    """
    low, high = sorted((float(lateral[0]), goal))
    return float(np.max([lateral - high, low - lateral]))
