"""How much of each wheel's friction an input takes, by the friction ellipse:

use^2 = (Fx / (mu Fz))^2 + lambda^2 (1 - (Fx / (mu Fz))^2),   lambda = |M(alpha)| / D
"""

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import FORCES

Array = NDArray[np.float64]

LEAST_GRIP = 1.0  # [N] of a wheel that carries nothing


def friction_use(u: Array, lateral_demand: Array, grip: Array) -> Array:
    """Share of each wheel's friction, (4,) [1].

    Args:
        u: (5,) input [rad, N, N, N, N].
        lateral_demand: (4,) lambda of each wheel when it sets in [1].
        grip: (4,) mu Fz [N].
    """
    along = np.minimum(np.abs(u[FORCES]) / np.maximum(grip, LEAST_GRIP), 1.0) ** 2
    use: Array = np.sqrt(along + np.minimum(lateral_demand, 1.0) ** 2 * (1 - along))
    return use
