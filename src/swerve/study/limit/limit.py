"""How close to the limit a scene is: the smallest distance and friction at which it can still be avoided.

For each means the program of `program` is solved from every start of `guesses`, and from the solutions of the means
that these contain; each result is driven again by `resimulate`, and counts only if it avoids. The best is the limit: an
upper bound of the true one, as local optima are. `point_mass` bounds it from below.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from swerve.scenario import Scenario
from swerve.study.limit import point_mass
from swerve.study.limit.best import Optimum, best
from swerve.study.limit.contact import time_to_collision
from swerve.study.limit.means import Means
from swerve.study.limit.scene import Scene
from swerve.study.limit.trajectory import Sought

Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1


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
