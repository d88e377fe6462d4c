"""Wheel loads to plan wheel forces with: a measured load is as old as the measurement, a command lasts for a sample."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def falling_loads(loads: Array, before: Array | None) -> Array:
    """Loads (4,) [N], those that fall as much lower as they fell since the last sample, `before` (4,) [N]."""
    return loads if before is None else np.clip(2 * loads - before, 0.0, loads)
