"""A scenario as the limit sees it: one vehicle, one friction, and obstacles that are shifted along X alike.

The distance is that of the first obstacle ahead, from the ego vehicle's centre of gravity to its centre, along X. A
shift moves all obstacles by as much, so that what lies between them stays.
"""

from dataclasses import dataclass, replace
from math import inf, sqrt
from typing import Final, Self

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import GRAVITY, PSI, VY, R, X, Y
from swerve.errors import InputError
from swerve.scenario import Scenario
from swerve.study.limit.shifted import shifted
from swerve.vehicle import Vehicle
from swerve.world import Footprint, Obstacle, Road

Array = NDArray[np.float64]

AHEAD: Final = np.array([[1.0, 0.0], [-1.0, 0.0]])
ASIDE: Final = np.array([[0.0, 1.0], [0.0, -1.0]])
FORESEEN: Final = np.arange(0.0, 10.0, 0.1)  # [s] when an obstacle's speed is looked at
STRAYING: Final = 0.1  # [m/s] across the road, which is none
DRIVE: Final = np.arange(0.0, 60.0, 0.01)  # [s] within which an obstacle is met
WALKING: Final = 1.0  # [m/s]


@dataclass(frozen=True, eq=False)
class Scene:
    """What is given of the problem.

    Attributes:
        name: of the scenario.
        vehicle: with its limits.
        footprint: of it.
        start: (6,) state at time zero.
        friction: mu [1].
        road: with edges or without.
        obstacles: as the scenario has them.
        distance: of the first one ahead [m].
    """

    name: str
    vehicle: Vehicle
    footprint: Footprint
    start: Array
    friction: float
    road: Road
    obstacles: tuple[Obstacle, ...]
    distance: float

    @classmethod
    def of(cls, scenario: Scenario) -> Self:
        """The scene in a scenario; InputError for no obstacle ahead, one that crosses, or more than one friction."""
        if scenario.road.patches:
            raise InputError("road.patches: a limit is that of one friction for all wheels; leave the patches out")
        ego = scenario.ego
        start = np.array([ego.speed, 0.0, 0.0, ego.heading, *ego.position])
        obstacles = tuple(each.to_world() for each in scenario.obstacles)
        places = [float(each.position_at(0.0)[0]) - ego.position[0] for each in obstacles]
        ahead = [place for place in places if place > 0]
        if not ahead:
            raise InputError("obstacles: none is ahead; a limit needs one at a larger X than ego.position")
        for i, each in enumerate(obstacles):
            across = float(np.abs(each.velocity_at(FORESEEN)[:, 1]).max())
            if across > STRAYING:
                told = f"moves across the road at {across:.2g} m/s, so that there is no one smallest distance"
                raise InputError(f"obstacles.{i}: {told}; a limit takes obstacles at rest or along X")
        road, friction = scenario.road.to_world(), scenario.road.friction
        return cls(scenario.name, ego.to_vehicle(), ego.to_footprint(), start, friction, road, obstacles, min(ahead))

    @property
    def speed(self) -> float:
        """vx at time zero [m/s]."""
        return float(self.start[0])

    @property
    def slowest(self) -> float:
        """The smallest speed along X that an obstacle comes to, no less than standstill [m/s]."""
        return max(0.0, self._slowest)

    def is_passed(self, obstacle: Obstacle) -> bool:
        """Whether an obstacle is or becomes slower, so that the vehicle comes past it; of any other it keeps clear."""
        return bool(_slowest(obstacle) < self.speed - WALKING)

    @property
    def closing(self) -> float:
        """The largest speed at which an obstacle is neared, no less than walking pace [m/s]."""
        return max(self.speed - self._slowest, WALKING)

    @property
    def time_aside(self) -> float:
        """How long a point mass takes to go aside by `room`, sqrt(2 w / (mu g)) [s]."""
        return sqrt(2 * self.room / self.grip)

    @property
    def is_oncoming(self) -> bool:
        """Whether an obstacle comes towards the vehicle, so that none can stay behind it."""
        return self._slowest < 0

    @property
    def _slowest(self) -> float:
        return min(map(_slowest, self.obstacles))

    @property
    def room(self) -> float:
        """How far aside the widest obstacle makes the vehicle go [m]."""
        own = float(self.footprint.support(ASIDE).max())
        return own + max(float(reach(each, ASIDE).max()) for each in self.obstacles)

    def meeting(self, obstacle: Obstacle, beyond: float = 0.0) -> float:
        """When the vehicle, going straight on, is as far as an obstacle's centre, or some way [m] beyond [s]."""
        reached = self.start[X] + self.speed * DRIVE >= obstacle.position_at(DRIVE)[:, 0] + beyond
        return float(DRIVE[np.argmax(reached)] if reached.any() else DRIVE[-1])

    @property
    def time_past(self) -> float:
        """How long the vehicle takes, going straight on, to pass all obstacles that it passes [s]."""
        own = float(self.footprint.support(AHEAD)[1])
        passed = filter(self.is_passed, self.obstacles)
        return max((self.meeting(each, float(reach(each, AHEAD)[0]) + own) for each in passed), default=0.0)

    def past(self, state: Array, time: float) -> float:
        """How far a vehicle is past the last obstacle that it passes, at a time [s]; inf with none to pass [m]."""
        own = float(state[X] - self.footprint.support(AHEAD)[1])
        passed = filter(self.is_passed, self.obstacles)
        return min((own - each.position_at(time)[0] - reach(each, AHEAD, time)[0] for each in passed), default=inf)

    @property
    def is_symmetric(self) -> bool:
        """Whether it is its own mirror image at the vehicle's line, so that left and right come to the same."""
        line, left, right = self.start[Y], self.road.left_edge, self.road.right_edge
        own = self.footprint.support(ASIDE)
        return (
            not self.start[[VY, R, PSI]].any()
            and (left is None or right is None or left + right == 2 * line)
            and own[0] == own[1]
            and all(_is_along(each, line) for each in self.obstacles)
        )

    @property
    def grip(self) -> float:
        """Largest acceleration of a point mass, mu g [m/s^2]."""
        return self.friction * GRAVITY

    def at(self, distance: float) -> "Scene":
        """The same scene with all obstacles shifted so that the first is at `distance` [m]."""
        shift = distance - self.distance
        return replace(self, obstacles=tuple(shifted(each, shift) for each in self.obstacles), distance=distance)

    def on(self, friction: float) -> "Scene":
        """The same scene on another friction [1]."""
        return replace(self, friction=friction)


def _slowest(obstacle: Obstacle) -> float:
    """The smallest speed along X that an obstacle comes to [m/s]."""
    return float(obstacle.velocity_at(FORESEEN)[:, 0].min())


def _is_along(obstacle: Obstacle, line: float) -> bool:
    """Whether an obstacle is and stays on a line Y [m], lengthwise or crosswise."""
    heading = obstacle.heading_at(FORESEEN)
    return bool((obstacle.position_at(FORESEEN)[:, 1] == line).all() and np.allclose(np.sin(2 * heading), 0, atol=1e-9))


def reach(obstacle: Obstacle, directions: Array, time: float = 0.0) -> Array:
    """How far an obstacle reaches from its centre at a time [s] in each of (n, 2) unit directions of the world [m]."""
    heading = obstacle.heading_at(time)
    cos, sin = np.cos(heading), np.sin(heading)
    return obstacle.shape.support(directions @ np.array([[cos, -sin], [sin, cos]]))
