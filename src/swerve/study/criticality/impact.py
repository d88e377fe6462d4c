"""Impact speed: that of the first contact when full braking begins at once, relative to the obstacle."""

import numpy as np
from numpy.typing import NDArray

from swerve.study.criticality.encounter import contact_along
from swerve.study.criticality.roll_out import Path
from swerve.study.criticality.scene import Scene

Array = NDArray[np.float64]


def impact_speed(scene: Scene, braking: Path) -> Array:
    """Under full braking from each instant on, (n,) [m/s]; 0 where nothing is met.

    Args:
        scene: n instants.
        braking: where full braking leads (`roll_out` of `full_braking`).
    """
    speed, earliest = np.zeros(len(scene.times)), np.full(len(scene.times), np.inf)
    rows = np.arange(len(scene.times))
    for seen in scene.obstacles:
        first, last = contact_along(scene, seen, braking.elapsed, braking.poses, scene.velocity - seen.velocity)
        touches = (first <= 0) & (last >= 0)
        at = touches.argmax(axis=1)
        relative = np.linalg.norm(braking.velocity[rows, at] - seen.velocity, axis=1)
        is_first = touches.any(axis=1) & (braking.elapsed[rows, at] < earliest)
        speed = np.where(is_first, relative, speed)
        earliest = np.where(is_first, braking.elapsed[rows, at], earliest)
    return speed
