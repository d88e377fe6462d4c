"""Time to react: until the last instant at which any one of the manoeuvres still avoids every obstacle.

    TTR = max(TTB, TTS left, TTS right)

Hillenbrand et al. (2006); Tamke et al. (2011).
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def time_to_react(*times: Array) -> Array:
    """The largest of the times (n,) to a manoeuvre [s]; -inf where none of them helps."""
    return np.asarray(np.maximum.reduce(times))
