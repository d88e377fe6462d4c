"""The best of all starts: each is guessed, solved and driven again, and counts only if that drive avoids."""

from dataclasses import dataclass
from functools import lru_cache
from typing import Final

import numpy as np

from swerve.study.limit.guesses import guess, starts
from swerve.study.limit.means import Means
from swerve.study.limit.resimulate import Drive, resimulate
from swerve.study.limit.scene import Scene
from swerve.study.limit.solve import descend
from swerve.study.limit.trajectory import Sought, Trajectory

AGREEING: Final = 0.01  # [1] of the best value, within which a start agrees with it


@dataclass(frozen=True, eq=False)
class Optimum:
    """The best of all starts.

    Attributes:
        trajectory: the solution.
        drive: what it came to when driven again.
        n_starts: from how many it was looked for, the best of contained means among them.
        n_agreeing: how many of them came within 1 % of it.
    """

    trajectory: Trajectory
    drive: Drive
    n_starts: int
    n_agreeing: int


@lru_cache(maxsize=16)  # means contain means
def best(scene: Scene, means: Means, sought: Sought) -> Optimum | None:
    """The smallest distance or friction that any start leads to and that avoids when driven again; None without one."""
    contained = _best_contained(scene, means, sought)
    guesses = _guesses(scene, means, sought) + [each.trajectory for each in contained]
    found = [_avoided(scene, descend(scene, means, sought, each)) for each in guesses]
    avoided = [each for each in found if each is not None]
    candidates = avoided + [(each.trajectory, each.drive) for each in contained]
    if not candidates:
        return None
    trajectory, drive = min(candidates, key=lambda pair: pair[0].value(sought))
    most = (1 + AGREEING) * trajectory.value(sought)
    return Optimum(trajectory, drive, len(guesses), sum(each.value(sought) <= most for each, _ in avoided))


def _best_contained(scene: Scene, means: Means, sought: Sought) -> list[Optimum]:
    """The best of all means that some contain, if there is one: a start, and never worse than what comes of it."""
    found = [each for each in (best(scene, inner, sought) for inner in means.contained) if each is not None]
    return sorted(found, key=lambda each: each.trajectory.value(sought))[:1]


def _guesses(scene: Scene, means: Means, sought: Sought) -> list[Trajectory]:
    """Those of all starts that differ."""
    found: list[Trajectory] = []
    for each in (guess(scene, start, sought) for start in starts(scene, means)):
        if each is not None and not any(np.array_equal(each.states, other.states) for other in found):
            found.append(each)
    return found


def _avoided(scene: Scene, found: list[Trajectory]) -> tuple[Trajectory, Drive] | None:
    """The last of some solutions that avoids when driven again, whatever the solver says of it; None without one."""
    drives = ((each, resimulate(scene, each)) for each in reversed(found))
    return next(((each, drive) for each, drive in drives if drive.is_avoided), None)


def least_violation(scene: Scene, means: Means) -> float:
    """How far [m] an obstacle is overlapped at the least, at the scene's own distance; 0 where it can be avoided."""
    found = [descend(scene, means, Sought.VIOLATION, each) for each in _guesses(scene, means, Sought.VIOLATION)]
    return min((each[-1].violation for each in found if each), default=np.inf)
