"""Where the search starts: the vehicle driven round the obstacles on either side, braking more or less.

Where the distance or the friction is sought, the first of a geometric sequence at which the driver keeps clear, stays
on the road and ends as the program asks is the guess: it can be driven. A way that never does is no start.
"""

from collections.abc import Iterator
from itertools import product
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import PSI, VX, VY, R, X, Y
from swerve.study.limit.driver import Start, drive, path
from swerve.study.limit.grid import Ending
from swerve.study.limit.means import Means
from swerve.study.limit.program import CREEP, END_SIDESLIP, END_YAW_RATE
from swerve.study.limit.scene import Scene
from swerve.study.limit.trajectory import Sought, Trajectory

Array = NDArray[np.float64]

SHORT, LONG = 0.75, 1.0  # [1] T, times the time that a point mass takes to go aside: the quicker, the less damped
NEAREST: Final = 0.9  # [1] times the distance at which a point mass goes aside: the first that is tried
GROWTH: Final = 1.1  # [1] from one distance that is tried to the next
POSE: Final = [X, Y, PSI]
TRIALS: Final = 20
MOST_SIDES: Final = 2  # obstacles that are passed left and right in turn; the others are on the last one's side


def starts(scene: Scene, means: Means) -> list[Start]:
    """The ways that are tried: those for which the road has room; of two that are mirror images the left one."""
    if means is Means.BRAKING:
        return [] if scene.is_oncoming else [Start(Ending.BEHIND, (), 1.0, SHORT)]
    hows = ((0.0, SHORT), (0.0, LONG)) if means is Means.STEERING else ((0.3, SHORT), (0.7, LONG))
    n = min(sum(map(scene.is_passed, scene.obstacles)), MOST_SIDES)
    ways = [sides for sides in product((1, -1), repeat=n) if not (scene.is_symmetric and sides[:1] == (-1,))]
    tried = [Start(Ending.PAST, sides, *how) for sides, how in product(ways, hows)]
    return [start for start in tried if _is_on_road(scene, start)]


def _is_on_road(scene: Scene, start: Start) -> bool:
    """Whether its path keeps the road's edges."""
    levels = path(scene, start)[1]
    poses = np.column_stack((np.zeros_like(levels), levels, np.zeros_like(levels)))
    return bool(scene.road.is_inside(scene.footprint, poses).all())


def guess(scene: Scene, start: Start, sought: Sought) -> Trajectory | None:
    """The start as driven at the first distance or friction at which that does; None where it does at no such one."""
    if sought is Sought.VIOLATION:
        return drive(scene, start)
    tried = ((at, drive(at, start)) for at in _tried(scene, sought))
    return next((driven for at, driven in tried if driven.violation <= 0 and _is_done(at, start, driven)), None)


def _is_done(scene: Scene, start: Start, driven: Trajectory) -> bool:
    """Whether the road is kept and the end is what the program asks for."""
    end = driven.states[-1]
    is_straight = abs(end[VY]) <= CREEP + END_SIDESLIP * end[VX] and abs(end[R]) <= END_YAW_RATE
    is_past = start.ending is Ending.BEHIND or scene.past(end, driven.grid.times[-1]) >= 0
    return bool(is_straight and is_past and scene.road.is_inside(scene.footprint, driven.states[:, POSE]).all())


def _tried(scene: Scene, sought: Sought) -> Iterator[Scene]:
    """The scene, easier from one to the next."""
    aside = scene.closing * scene.time_aside
    for i in range(TRIALS):
        if sought is Sought.DISTANCE:
            yield scene.at(NEAREST * aside * GROWTH**i)
        else:
            yield scene.on(scene.friction * (NEAREST * aside / scene.distance * GROWTH**i) ** 2)
