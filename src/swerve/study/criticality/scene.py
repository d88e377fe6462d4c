"""What a criticality measure looks at: the vehicle, the road and the obstacles at n instants.

What comes after an instant is predicted from it, as from a sensor's picture: an obstacle, and a vehicle that does
nothing, keep velocity and heading. Whatever else an obstacle is about to do is unknown at that instant.
"""

from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import PSI, VX, VY, X, Y
from swerve.scenario import Scenario
from swerve.vehicle import Vehicle
from swerve.vehicle.multibody import completion_of
from swerve.world import Footprint, Obstacle, Road

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Seen:
    """An obstacle as it is seen at n instants.

    Attributes:
        obstacle: that is seen.
        position: (n, 2) [m].
        velocity: (n, 2) [m/s].
        heading: (n,) [rad].
    """

    obstacle: Obstacle
    position: Array
    velocity: Array
    heading: Array

    @classmethod
    def at(cls, obstacle: Obstacle, times: Array) -> Self:
        """The obstacle at times (n,) [s]."""
        return cls(obstacle, obstacle.position_at(times), obstacle.velocity_at(times), obstacle.heading_at(times))

    def of_rows(self, rows: NDArray[np.bool_]) -> Self:
        """At some of the instants alone."""
        return replace(self, position=self.position[rows], velocity=self.velocity[rows], heading=self.heading[rows])


@dataclass(frozen=True, eq=False)
class Scene:
    """n instants, each a row.

    Attributes:
        vehicle: its numbers, with the steering rate that its actuators reach.
        footprint: of it.
        road: with edges or without.
        times: (n,) [s].
        states: (n, 6) [vx vy r psi X Y].
        steering: (n,) road-wheel angle [rad].
        friction: (n,) under the centre of gravity [1].
        obstacles: as they are seen.
    """

    vehicle: Vehicle
    footprint: Footprint
    road: Road
    times: Array
    states: Array
    steering: Array
    friction: Array
    obstacles: tuple[Seen, ...]

    @classmethod
    def of_start(cls, scenario: Scenario, plant: str) -> Self:
        """The first instant of a scenario: one row."""
        ego = scenario.ego
        state = np.array([[ego.speed, 0.0, 0.0, ego.heading, *ego.position]])
        return cls.of_motion(scenario, plant, np.zeros(1), state, np.zeros(1))

    @classmethod
    def of_motion(cls, scenario: Scenario, plant: str, times: Array, states: Array, steering: Array) -> Self:
        """The instants of a motion in a scenario.

        Args:
            scenario: vehicle, road and obstacles.
            plant: name of the one whose actuators steer.
            times: (n,) [s].
            states: (n, 6), finite.
            steering: (n,) road-wheel angle [rad].
        """
        vehicle, road = scenario.ego.to_vehicle(), scenario.road
        if plant == "multibody":
            rate = completion_of(scenario.ego.vehicle)[1].steering_rate_limit
            vehicle = vehicle.with_changes({"steering_rate_limit": min(rate, vehicle.steering_rate_limit)})
        friction = road.to_friction().at(states[:, [X, Y]])
        seen = tuple(Seen.at(each.to_world(), times) for each in scenario.obstacles)
        return cls(vehicle, scenario.ego.to_footprint(), road.to_world(), times, states, steering, friction, seen)

    @property
    def position(self) -> Array:
        """(n, 2) [m]."""
        return self.states[:, [X, Y]]

    @property
    def heading(self) -> Array:
        """(n,) [rad]."""
        return self.states[:, PSI]

    @property
    def velocity(self) -> Array:
        """Over ground, (n, 2) [m/s]."""
        cos, sin = np.cos(self.heading), np.sin(self.heading)
        vx, vy = self.states[:, VX], self.states[:, VY]
        return np.column_stack((vx * cos - vy * sin, vx * sin + vy * cos))

    @property
    def speed(self) -> Array:
        """Over ground, (n,) [m/s]."""
        return np.hypot(self.states[:, VX], self.states[:, VY])

    @property
    def course(self) -> Array:
        """The heading, turned by the sideslip onto the path, (n,) [rad]; a reversing vehicle looks back along it."""
        return self.heading + np.arctan2(self.states[:, VY], np.abs(self.states[:, VX]))

    def of_rows(self, rows: NDArray[np.bool_]) -> Self:
        """Some of the instants alone."""
        return replace(
            self,
            times=self.times[rows],
            states=self.states[rows],
            steering=self.steering[rows],
            friction=self.friction[rows],
            obstacles=tuple(each.of_rows(rows) for each in self.obstacles),
        )
