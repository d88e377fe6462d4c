"""An obstacle of a scenario: its shape, and one of four motions, which follows from the keys that are written.

position, velocity                      constant velocity, at rest without one
... and acceleration                    constant velocity, then accelerating: a lead car that brakes
... and moves_at                        at rest, then constant velocity: a pedestrian who steps out
waypoints                               through places at times: a cut-in, an oncoming vehicle that overtakes
"""

from itertools import pairwise
from typing import Final, Self

from pydantic import Field, model_validator

from swerve.errors import shown
from swerve.scenario.quantities import (
    Acceleration,
    Coordinate,
    Heading,
    Instant,
    Name,
    Size,
    Speed,
    Velocity,
    WaypointTime,
)
from swerve.scenario.settings import KeyedError, Settings
from swerve.world import Accelerating, AlongWaypoints, Ellipse, Motion, Obstacle, Rectangle, Steady, Waiting

NOT_BESIDE_WAYPOINTS: Final = ("position", "velocity", "acceleration", "accelerates_at", "final_speed", "moves_at")


class WaypointSettings(Settings):
    """Where an obstacle's centre is at a time.

    Attributes:
        time: of the run; may be before its start [s].
        position: (x, y) [m].
    """

    time: WaypointTime = Field(examples=['"0 s"'])
    position: tuple[Coordinate, Coordinate] = Field(examples=['["60 m", "3.5 m"]'])


class ObstacleSettings(Settings):
    """An obstacle: an ellipse or a rectangle, and how it moves.

    Attributes:
        name: how figures and messages call it.
        position: of its centre at time zero (x, y) [m].
        velocity: in world axes (x, y), None at rest [m/s].
        heading: of its own x axis from the world's X axis, anticlockwise; None for 0, or along its way-points [rad].
        acceleration: in world axes (x, y), None without [m/s^2].
        accelerates_at: when it begins, None for at once [s].
        final_speed: along the initial velocity, at which it ends; None for 0 where it brakes, else for no end [m/s].
        moves_at: until then it stands at its position [s].
        waypoints: in place of position and velocity.
        semi_axes: of an ellipse (a, b) along its own x and y [m].
        size: of a rectangle (length, width) along its own x and y [m].
    """

    name: Name | None = None
    position: tuple[Coordinate, Coordinate] | None = None
    velocity: tuple[Velocity, Velocity] | None = None
    heading: Heading | None = None
    acceleration: tuple[Acceleration, Acceleration] | None = None
    accelerates_at: Instant | None = None
    final_speed: Speed | None = None
    moves_at: Instant | None = None
    waypoints: tuple[WaypointSettings, ...] = ()
    semi_axes: tuple[Size, Size] | None = None
    size: tuple[Size, Size] | None = None

    @model_validator(mode="after")
    def _has_one_shape(self) -> Self:
        if self.semi_axes is None and self.size is None:
            raise KeyedError("semi_axes", 'missing; write semi_axes = ["2 m", "2 m"] or size = ["4 m", "1.7 m"]')
        if self.semi_axes is not None and self.size is not None:
            raise KeyedError("size", "is given beside semi_axes; write one of them, a rectangle or an ellipse")
        return self

    @model_validator(mode="after")
    def _has_one_motion(self) -> Self:
        if self.waypoints:
            self._check_waypoints()
        elif self.position is None:
            raise KeyedError("position", 'missing; write one such as position = ["25 m", "0 m"], or waypoints')
        else:
            self._check_changes()
        return self

    def _check_waypoints(self) -> None:
        for key in NOT_BESIDE_WAYPOINTS:
            if getattr(self, key) is not None:
                raise KeyedError(key, "is given beside waypoints, which tell the whole motion; write one of them")
        if len(self.waypoints) < 2:
            raise KeyedError("waypoints", "is a single one; write at least two, or position and velocity")
        for index, (before, after) in enumerate(pairwise(self.waypoints), 1):
            if after.time <= before.time:
                fault = f"{after.time:g} s is not after the one before it, {before.time:g} s"
                raise KeyedError(f"waypoints.{index}.time", f"{fault}; write them in the order of their times")

    def _check_changes(self) -> None:
        for key in ("accelerates_at", "final_speed"):
            if self.acceleration is None and getattr(self, key) is not None:
                cure = 'write acceleration = ["-4 m/s^2", "0 m/s^2"] too'
                raise KeyedError(key, f"means nothing without an acceleration; {cure}")
        if self.moves_at is not None and self.acceleration is not None:
            raise KeyedError("moves_at", "is given beside acceleration; write one of them, or waypoints")
        if self.moves_at is not None and not any(self.velocity or ()):
            raise KeyedError("moves_at", 'means nothing without a velocity; write velocity = ["0 m/s", "1.5 m/s"] too')
        try:
            self._motion()
        except ValueError as error:  # "final_speed of 30 m/s is never reached from ..."
            name, _, fault = str(error).partition(" ")
            raise KeyedError(name, f"{fault}; write another one, or another acceleration") from error

    @property
    def noun(self) -> str:
        """What a sentence calls it."""
        return "the obstacle" if self.name is None else f"the obstacle {shown(self.name)}"

    def to_world(self) -> Obstacle:
        """The obstacle as geometry and motion."""
        shape = Ellipse(self.semi_axes) if self.semi_axes is not None else Rectangle(*(self.size or ()))
        return Obstacle(shape, self._motion())

    def _motion(self) -> Motion:
        if self.position is None:
            times, positions = zip(*((each.time, each.position) for each in self.waypoints), strict=True)
            return AlongWaypoints(times, positions, self.heading)
        start = self.position, self.velocity or (0.0, 0.0), self.heading or 0.0
        if self.acceleration is not None:
            return Accelerating(*start, self.acceleration, self.accelerates_at or 0.0, self.final_speed)
        return Steady(*start) if self.moves_at is None else Waiting(*start, self.moves_at)
