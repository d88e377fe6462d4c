"""Arrays as lists for a JSON document: rounded for display, with null for what is not finite."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

MILLIMETRE = 3  # decimals of a length [m]
CENTIMETRE = 2
ANGLE = 4  # of an angle [rad]
FORCE = 0  # of a force [N]
SHARE = 3  # of a share [1]
TIME = 5  # of a time [s]


def rounded(values: ArrayLike, decimals: int) -> list[Any]:
    """Values of any shape as nested lists of that shape."""
    return _plain(np.round(np.asarray(values, dtype=float), decimals))


def _plain(values: Any) -> list[Any]:
    if values.ndim > 1:
        return [_plain(each) for each in values]
    listed: list[Any] = values.tolist()
    if np.isfinite(values).all():
        return listed
    return [each if np.isfinite(each) else None for each in listed]
