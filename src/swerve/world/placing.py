"""Points of a body frame in the world."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def place(points: Array, poses: Array) -> Array:
    """Points (k, 2) of a body frame in the world, at each of the poses (n, 3) of X [m], Y [m], psi [rad]: (n, k, 2)."""
    cos, sin = np.cos(poses[:, 2, np.newaxis]), np.sin(poses[:, 2, np.newaxis])
    x, y = points[:, 0], points[:, 1]
    turned = np.stack([cos * x - sin * y, sin * x + cos * y], axis=-1)
    placed: Array = poses[:, np.newaxis, :2] + turned
    return placed
