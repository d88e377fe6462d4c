"""How close to the limit a scene is: the smallest distance and friction at which it can still be avoided.

For each means the program of `program` is solved from every start of `guesses`, and from the solutions of the means
that these contain; each result is driven again by `resimulate`, and counts only if it avoids. The best is the limit: an
upper bound of the true one, as local optima are. `point_mass` bounds it from below.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.scenario import Scenario
from swerve.study.limit import point_mass
from swerve.study.limit.guesses import guess, starts
from swerve.study.limit.means import Means
from swerve.study.limit.resimulate import Drive, resimulate
from swerve.study.limit.scene import Scene
from swerve.study.limit.solve import STRIDE, Sought, Trajectory, solve
from swerve.world import Ellipse, Obstacle, clearance, distance_ratio

Array = NDArray[np.float64]
Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1

MOST_STRIDES: Final = 12
ARRIVED: Final = 0.005  # [1] this much short of a stride, there is nothing more to gain
AGREEING: Final = 0.01  # [1] of the best value, within which a start agrees with it
LONGEST_DRIVE: Final = 60.0  # [s] in which a contact without action is looked for
CLOCK: Final = 1e-3  # [s]


@dataclass(frozen=True, eq=False)
class Optimum:
    """The best of all starts.

    Attributes:
        trajectory: the solution.
        drive: what it came to when driven again.
        n_starts: from how many it was looked for.
        n_agreeing: how many of them came within 1 % of it.
    """

    trajectory: Trajectory
    drive: Drive
    n_starts: int
    n_agreeing: int


@dataclass(frozen=True, eq=False)
class Limit:
    """The limit of a scene for some means.

    Attributes:
        means: what may be used.
        shortest: at the smallest distance; None where no start led to one.
        time_to_collision: from there to contact without action [s]; None where there would be none.
        slipperiest: on the least friction, at the scenario's own distance; None where no start led to one.
    """

    means: Means
    shortest: Optimum | None
    time_to_collision: float | None
    slipperiest: Optimum | None

    @property
    def distance(self) -> float | None:
        """Smallest distance [m] from the centre of gravity to the first obstacle's centre, along X."""
        return None if self.shortest is None else self.shortest.trajectory.distance

    @property
    def friction(self) -> float | None:
        """Smallest friction [1]."""
        return None if self.slipperiest is None else self.slipperiest.trajectory.friction


@dataclass(frozen=True, eq=False)
class Limits:
    """All limits of a scenario.

    Attributes:
        scene: of it.
        limits: one for each means.
        least_distance: below which nothing helps, by `point_mass` [m].
        least_friction: likewise [1].
    """

    scene: Scene
    limits: tuple[Limit, ...]
    least_distance: float
    least_friction: float


def limits_of(
    scenario: Scenario, means: Sequence[Means] = tuple(Means), progress: Progress = lambda share: None
) -> Limits:
    """The limits of a scenario for each of some means; InputError as `limit_of`."""
    scene = Scene.of(scenario)
    found: list[Limit] = []
    for i, each in enumerate(means):
        found.append(_limit(scene, each))
        progress((i + 1) / len(means))
    return Limits(scene, tuple(found), point_mass.smallest_distance(scene), point_mass.smallest_friction(scene))


def limit_of(scenario: Scenario, means: Means) -> Limit:
    """The limit of a scenario with some means: the same one for the same scenario.

    Args:
        scenario: with an obstacle ahead, and one friction.
        means: what may be used.

    Raises:
        InputError: there is no obstacle ahead, or the road has patches.
    """
    return _limit(Scene.of(scenario), means)


def _limit(scene: Scene, means: Means) -> Limit:
    shortest = best(scene, means, Sought.DISTANCE)
    ttc = None if shortest is None else time_to_collision(scene.at(shortest.trajectory.distance))
    return Limit(means, shortest, ttc, best(scene, means, Sought.FRICTION))


@lru_cache(maxsize=16)  # means contain means
def best(scene: Scene, means: Means, sought: Sought) -> Optimum | None:
    """The smallest distance or friction that any start leads to and that avoids when driven again; None without one."""
    contained = [found for each in means.contained if (found := best(scene, each, sought)) is not None]
    guesses = [guess(scene, start, sought) for start in starts(scene, means)]
    avoided = [driven for each in guesses if (driven := descend(scene, means, sought, each)) is not None]
    candidates = avoided + [(each.trajectory, each.drive) for each in contained]
    if not candidates:
        return None
    trajectory, drive = min(candidates, key=lambda pair: pair[0].value(sought))
    most = (1 + AGREEING) * trajectory.value(sought)
    return Optimum(trajectory, drive, len(guesses), sum(each.value(sought) <= most for each, _ in avoided))


def descend(scene: Scene, means: Means, sought: Sought, start: Trajectory) -> tuple[Trajectory, Drive] | None:
    """Solve again and again, each time from the last solution that avoids when driven again; None without one.

    Whatever the solver says of it, that drive is the proof. A solve goes no further than STRIDE, lest it gets lost.
    """
    best_yet = None
    for _ in range(MOST_STRIDES):
        found = solve(scene, means, sought, start)
        drive = resimulate(scene, found)
        if not drive.is_avoided:
            return best_yet
        best_yet = found, drive
        if found.is_solved and found.value(sought) > (STRIDE + ARRIVED) * start.value(sought):
            return best_yet
        start = found
    return best_yet


def least_violation(scene: Scene, means: Means) -> float:
    """How far [m] an obstacle is overlapped at the least, at the scene's own distance; 0 where it can be avoided."""
    guesses = [guess(scene, start, Sought.VIOLATION) for start in starts(scene, means)]
    found = [solve(scene, means, Sought.VIOLATION, each) for each in guesses]
    return min((each.violation for each in found if each.is_solved), default=np.inf)


def time_to_collision(scene: Scene) -> float | None:
    """Time [s] until the vehicle, going straight on, touches an obstacle; None where it never does."""
    times = np.arange(0.0, LONGEST_DRIVE, CLOCK)
    heading = scene.start[3]
    way = scene.speed * times[:, np.newaxis] * np.array([np.cos(heading), np.sin(heading)])
    poses = np.column_stack((scene.start[4:] + way, np.full(len(times), heading)))
    first = [_first_contact(scene, each, poses, times) for each in scene.obstacles]
    return min((time for time in first if time is not None), default=None)


def _first_contact(scene: Scene, obstacle: Obstacle, poses: Array, times: Array) -> float | None:
    if isinstance(obstacle.shape, Ellipse):
        touches = distance_ratio(scene.footprint, poses, obstacle, times) <= 1
    else:
        touches = clearance(scene.footprint, poses, obstacle, times) <= 0
    return float(times[np.argmax(touches)]) if touches.any() else None
