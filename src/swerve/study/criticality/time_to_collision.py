"""Time to collision: until contact, when the vehicle and the obstacles keep velocity and heading.

Hayward, Near miss determination through use of a scale of danger, Highway Research Record 384 (1972): the time until
two vehicles collide if they go on at their present speeds and on the same path. Here with exact footprints in the
plane. Straight behind an obstacle it is gap / closing speed.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.study.criticality.encounter import contact_along, poses_now
from swerve.study.criticality.scene import Scene, Seen

Array = NDArray[np.float64]

HORIZON: Final = 100.0  # [s] beyond which nobody keeps velocity and heading, so that nothing is met


def time_to_collision(scene: Scene) -> Array:
    """With the first obstacle that is met, (n,) [s]; 0 in contact, inf where none is met."""
    none = np.full(len(scene.times), np.inf)
    return np.asarray(np.minimum.reduce([none, *(time_to(scene, each) for each in scene.obstacles)]))


def time_to(scene: Scene, seen: Seen) -> Array:
    """Until contact with one obstacle, (n,) [s]; 0 in contact, inf where it is not met."""
    now = np.zeros((len(scene.times), 1))
    first, last = contact_along(scene, seen, now, poses_now(scene, 1), scene.velocity - seen.velocity)
    return np.where((last >= 0) & (first <= HORIZON), np.maximum(first, 0.0), np.inf)[:, 0]
