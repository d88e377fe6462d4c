"""Threat numbers: required over available acceleration, above 1 where the one manoeuvre alone is too weak.

    BTN = required deceleration / (force_limit mu g)
    STN = smaller of the required lateral accelerations to the left and to the right / (mu sum(D Fz) / m)

Brännström, Coelingh, Sjöberg, IEEE Trans. Intelligent Transportation Systems 11 (2010). A point mass: it turns at once
and knows no road edge.
"""

import numpy as np
from numpy.typing import NDArray

from swerve.study.criticality.manoeuvre import available_deceleration, available_lateral_acceleration
from swerve.study.criticality.scene import Scene

Array = NDArray[np.float64]


def brake_threat_number(scene: Scene, required_deceleration: Array) -> Array:
    """BTN (n,) [1] of a required deceleration (n,) [m/s^2]."""
    return required_deceleration / available_deceleration(scene)


def steer_threat_number(scene: Scene, required_left: Array, required_right: Array) -> Array:
    """STN (n,) [1] of required lateral accelerations (n,) [m/s^2]."""
    return np.minimum(required_left, required_right) / available_lateral_acceleration(scene)
