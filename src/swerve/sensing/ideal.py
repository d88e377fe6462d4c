"""Ideal sensing: the truth, at once and without noise."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from swerve.signals import Measurement, Observation
from swerve.world import Obstacle

Array = NDArray[np.float64]


def measure(time: float, vehicle: Array, wheel_loads: Array, obstacles: Sequence[Obstacle]) -> Measurement:
    """What is true at `time` [s].

    Args:
        time: of the controller's step [s].
        vehicle: (6,) vehicle state.
        wheel_loads: (4,) [N].
        obstacles: known from time zero on.
    """
    seen = tuple(
        Observation(obstacle.shape, tuple(obstacle.position_at(time)), obstacle.velocity, obstacle.heading)
        for obstacle in obstacles
    )
    return Measurement(time, time, vehicle, wheel_loads, seen)
