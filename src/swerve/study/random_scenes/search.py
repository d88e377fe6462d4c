"""A dense search for one way through a scene: a one-sided certificate that it can be avoided with something to spare.

Every member of the family is rolled out through the two-track model on a road with the friction divided by SPARE, and
held against the obstacles' true motions, the exact footprint and the road's edges. That one is clear proves that the
scene can be avoided by a vehicle that uses 1 / SPARE of its friction and knows what is to come; that none is proves
nothing.
"""

from dataclasses import dataclass
from functools import cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import POSE
from swerve.scenario import Scenario
from swerve.simulate.outcome import SPIN_SIDESLIP, sideslip, touches
from swerve.study.random_scenes.family import BATCH, Manoeuvre, RollOut, family
from swerve.world import Footprint, Obstacle, Road

Array = NDArray[np.float64]

SPARE: Final = 1.15  # [1] by which the friction is divided: 15 % to spare
COARSE: Final = 10  # every so many steps are looked at first


@dataclass(frozen=True)
class Certificate:
    """A manoeuvre that is clear.

    Attributes:
        manoeuvre: of the family.
        number: how many were tried until it was found.
    """

    manoeuvre: Manoeuvre
    number: int


def certificate(scene: Scenario, spare: float = SPARE) -> Certificate | None:
    """The first member that is clear of all obstacles, stays on the road and does not spin; None when none does."""
    roll_out, members = _roll_out(scene.duration), family()
    vehicle, friction = scene.ego.to_vehicle(), scene.road.friction / spare
    start = np.array([scene.ego.speed, 0.0, 0.0, scene.ego.heading, *scene.ego.position])
    surroundings = _Surroundings.of(scene, roll_out.times)
    for first in range(0, len(members), BATCH):
        states = roll_out(members[first : first + BATCH], start, vehicle, friction)
        for i in np.flatnonzero(surroundings.is_clear(states, COARSE)):
            if surroundings.is_clear(states[i : i + 1], 1)[0]:
                return Certificate(Manoeuvre(*members[first + i].tolist()), first + int(i) + 1)
    return None


@cache
def _roll_out(duration: float) -> RollOut:
    return RollOut(duration)


@dataclass(frozen=True, eq=False)
class _Surroundings:
    """What a motion is held against."""

    footprint: Footprint
    road: Road
    obstacles: tuple[Obstacle, ...]
    times: Array

    @classmethod
    def of(cls, scene: Scenario, times: Array) -> "_Surroundings":
        obstacles = tuple(each.to_world() for each in scene.obstacles)
        return cls(scene.ego.to_footprint(), scene.road.to_world(), obstacles, times)

    def is_clear(self, states: Array, every: int) -> NDArray[np.bool_]:
        """Of each motion (n, len(times), 6) whether it is, at every so-manyth time."""
        shown = states[:, ::every]
        n = len(shown)
        clear: NDArray[np.bool_] = np.asarray(np.isfinite(shown).all(axis=(1, 2)))
        clear &= (np.abs(sideslip(shown.reshape(-1, shown.shape[2]))) < SPIN_SIDESLIP).reshape(n, -1).all(axis=1)
        poses = shown[..., POSE].reshape(-1, 3)
        clear &= self.road.is_inside(self.footprint, poses).reshape(n, -1).all(axis=1)
        for obstacle in self.obstacles:
            left = np.flatnonzero(clear)
            poses = shown[left][..., POSE].reshape(-1, 3)
            hit = touches(obstacle, self.footprint, poses, np.tile(self.times[::every], len(left)))
            clear[left] = ~hit.reshape(len(left), shown.shape[1]).any(axis=1)
        return clear
