"""A scenario in one cell of the map: at its speed, friction and offset, and with its obstacles at any distance.

The vehicle starts and is to go on at the cell's speed. A run without contact has to last until the obstacle has been
passed or stopped for, and a while longer, so that what was avoided by losing the vehicle does not count. With full
braking from the start, a = mu g, the vehicle comes as far as d after

    t = (v - sqrt(v^2 - 2 a d)) / a,    and for d beyond d_b = v^2 / (2 a) it stops there after  (d - d_b) / v + v / a

when it brakes as late as it can; whatever it does, it is past, there or at rest by about then.
"""

from dataclasses import dataclass
from math import sqrt
from typing import Final

from swerve.conventions import GRAVITY
from swerve.scenario import Scenario
from swerve.scenario.obstacle import ObstacleSettings
from swerve.study.limit.scene import AHEAD, Scene, reach
from swerve.study.map.boundary import Condition
from swerve.study.map.closed_form import braking_distance
from swerve.world import clearance

SETTLING: Final = 2.0  # [s] that a run goes on after its obstacle
INFINITESIMAL: Final = 6  # digits of a distance [m] and a duration [s]


@dataclass(frozen=True, eq=False)
class Cell:
    """One cell.

    Attributes:
        condition: its speed, friction and offset.
        scenario: there, with the obstacles at their own distance.
        scene: the same, as the limit sees it.
    """

    condition: Condition
    scenario: Scenario
    scene: Scene

    @classmethod
    def of(cls, scenario: Scenario, condition: Condition) -> "Cell":
        """The cell of a scenario; InputError where it has no distance, as `study.limit` says."""
        there = scenario.model_copy(
            update={
                "ego": scenario.ego.model_copy(update={"speed": condition.speed}),
                "goal": scenario.goal.model_copy(update={"speed": condition.speed}),
                "road": scenario.road.model_copy(update={"friction": condition.friction}),
                "obstacles": tuple(_moved(each, 0.0, condition.offset) for each in scenario.obstacles),
            }
        )
        return cls(condition, there, Scene.of(there))

    def at(self, distance: float) -> Scenario:
        """The scenario with all obstacles shifted so that the first one ahead is at `distance` [m]."""
        shift = distance - self.scene.distance
        obstacles = tuple(_moved(each, shift, 0.0) for each in self.scenario.obstacles)
        return self.scenario.model_copy(update={"obstacles": obstacles, "duration": self._duration(distance)})

    @property
    def extent(self) -> float:
        """Largest distance between centres [m] at which an obstacle ahead touches the vehicle, nose to tail."""
        own = float(self.scene.footprint.support(AHEAD)[0])
        return own + max(float(reach(each, AHEAD)[1]) for each in self.scene.obstacles)

    def _duration(self, distance: float) -> float:
        """Of a run [s]; no less than the scenario's own where an obstacle moves, as its motion has its times."""
        speed, grip = self.scene.closing, self.condition.friction * GRAVITY
        way, stopping = max(distance - self.extent, 0.0), braking_distance(speed, self.condition.friction)
        near = (speed - sqrt(max(speed**2 - 2 * grip * way, 0.0))) / grip
        needed = near + max(way - stopping, 0.0) / speed + SETTLING
        is_timed = any(not _is_at_rest(each) for each in self.scenario.obstacles)
        return round(max(needed, self.scenario.duration) if is_timed else needed, INFINITESIMAL)


def covers_start(scenario: Scenario) -> bool:
    """Whether an obstacle touches the vehicle at time zero."""
    pose = [(*scenario.ego.position, scenario.ego.heading)]
    footprint = scenario.ego.to_footprint()
    return any(clearance(footprint, pose, each.to_world(), [0.0])[0] <= 0 for each in scenario.obstacles)


def _is_at_rest(obstacle: ObstacleSettings) -> bool:
    return not (any(obstacle.velocity or ()) or obstacle.acceleration or obstacle.waypoints)


def _moved(obstacle: ObstacleSettings, along: float, aside: float) -> ObstacleSettings:
    """An obstacle elsewhere, at the same times."""

    def there(position: tuple[float, float]) -> tuple[float, float]:
        return round(position[0] + along, INFINITESIMAL), round(position[1] + aside, INFINITESIMAL)

    waypoints = tuple(each.model_copy(update={"position": there(each.position)}) for each in obstacle.waypoints)
    position = None if obstacle.position is None else there(obstacle.position)
    return obstacle.model_copy(update={"position": position, "waypoints": waypoints})
