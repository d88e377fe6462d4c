"""Required acceleration: the smallest constant one that avoids every obstacle which would be met.

    braking    x(s) = v s - a s^2 / 2 to standstill, along the course, stays behind: x(s) <= x_in(s) for all s
               a = max over s of  2 (v s - x_in) / s^2  while it moves,  v^2 / (2 x_in)  once it stands
    steering   y(s) = a s^2 / 2, across the course, passes: y(s) >= y_out(s) for all s;  a = max over s of 2 y_out / s^2

x_in and y_out are where, moved along or across its course from its place at the instant, and from where it would be
at s, the footprint begins and ceases to touch the obstacle (span.py). Straight behind an obstacle at a gap d this is
(v - w)^2 / (2 d), as in Brännström, Coelingh, Sjöberg, Model-based threat assessment for avoiding arbitrary vehicle
collisions, IEEE Trans. Intelligent Transportation Systems 11 (2010).
"""

from collections.abc import Callable
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import VX
from swerve.study.criticality.encounter import abreast, contact_along, poses_now
from swerve.study.criticality.scene import Scene, Seen
from swerve.study.criticality.time_to_collision import time_to

Array = NDArray[np.float64]
Required = Callable[[Scene, Seen, Array], Array]  # n instants, obstacle, times to collision -> (n,)

LONGEST: Final = 10  # [1] of the time to collision that is looked at
FINENESS: Final = 100  # instants in one time to collision
JUST_AFTER: Final = 1 + 1e-9  # [1] of it, where rounding no longer hides the contact


def required_deceleration(scene: Scene) -> Array:
    """To stay behind every obstacle that would be met, (n,) [m/s^2]; 0 where none is, inf where none is enough."""
    return _largest(scene, _to_stay_behind)


def required_lateral_acceleration(scene: Scene, side: int) -> Array:
    """To pass every obstacle that would be met on a side (1 left, -1 right), (n,) [m/s^2]; 0 where none is."""
    return _largest(scene, lambda part, seen, ttc: _to_pass(part, seen, ttc, side))


def lateral_shift(scene: Scene, seen: Seen, s: Array, side: int) -> Array:
    """How far aside of its path the footprint must be to be clear of an obstacle after s, (n, m) [m]; 0 where it is.

    Args:
        scene: n instants.
        seen: an obstacle of it.
        s: (n, m) times from the instant on [s].
        side: 1 left, -1 right.
    """
    poses = poses_now(scene, s.shape[1])
    poses[..., :2] += s[..., np.newaxis] * scene.velocity[:, np.newaxis]
    first, last = contact_along(scene, seen, s, poses, _across(along_course(scene)))
    return np.maximum(last if side > 0 else -first, 0.0)


def _largest(scene: Scene, required: Required) -> Array:
    """Over the obstacles, of the instants in which they would be met."""
    largest = np.zeros(len(scene.times))
    for i, seen in enumerate(scene.obstacles):
        ttc = time_to(scene, seen)
        largest[ttc == 0] = np.inf
        met = np.isfinite(ttc) & (ttc > 0)
        if met.any():
            part = scene.of_rows(met)
            largest[met] = np.maximum(largest[met], required(part, part.obstacles[i], ttc[met]))
    return largest


def looked_at(scene: Scene, seen: Seen, ttc: Array, across: bool) -> Array:
    """Times (n, m) [s] at which the paths are looked at: a grid, and when the obstacle enters and leaves the way.

    Args:
        scene: n instants.
        seen: an obstacle of it.
        ttc: (n,) time to collision with it, finite and positive [s].
        across: the way is the strip across the path beside the vehicle; or else the strip that the path sweeps.
    """
    forwards = along_course(scene)
    enters, leaves = abreast(scene, seen, forwards if across else _across(forwards))
    edges = np.column_stack((ttc * JUST_AFTER, enters * JUST_AFTER, leaves / JUST_AFTER))
    usable = (edges > 0) & (edges <= LONGEST * ttc[:, np.newaxis])
    edges = np.where(usable, edges, ttc[:, np.newaxis])
    grid = ttc[:, np.newaxis] * (np.arange(1, FINENESS * LONGEST + 1) / FINENESS)
    return np.concatenate((grid, edges), axis=1)


def _to_stay_behind(scene: Scene, seen: Seen, ttc: Array) -> Array:
    s = looked_at(scene, seen, ttc, across=False)
    speed = scene.speed[:, np.newaxis]
    x_in, x_out = contact_along(scene, seen, s, poses_now(scene, s.shape[1]), along_course(scene))
    ahead = x_in > 0
    room = np.where(ahead, x_in, np.inf)
    moving = np.maximum(2 * (speed * s - room) / s**2, 0.0)
    still_moves = moving * s <= speed
    needed = np.where(still_moves, moving, speed**2 / (2 * room))
    over_it = (x_in <= 0) & (x_out >= 0)
    return np.asarray(np.where(over_it, np.inf, needed).max(axis=1))


def _to_pass(scene: Scene, seen: Seen, ttc: Array, side: int) -> Array:
    s = looked_at(scene, seen, ttc, across=True)
    return np.asarray((2 * lateral_shift(scene, seen, s, side) / s**2).max(axis=1))


def _across(vectors: Array) -> Array:
    """Vectors (n, 2), a quarter turned to the left."""
    return np.column_stack((-vectors[:, 1], vectors[:, 0]))


def along_course(scene: Scene) -> Array:
    """Unit vector of the motion, (n, 2); against the course when the vehicle reverses."""
    forwards = np.where(scene.states[:, VX] < 0, -1.0, 1.0)[:, np.newaxis]
    return np.asarray(forwards * np.column_stack((np.cos(scene.course), np.sin(scene.course))))
