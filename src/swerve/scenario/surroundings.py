"""What is round the ego vehicle: the road and the obstacles."""

from math import inf
from typing import Self

from pydantic import Field, model_validator

from swerve.scenario.quantities import Coordinate, Friction, Heading, Lanes, Size, Velocity
from swerve.scenario.settings import KeyedError, Settings
from swerve.world import MOST_PATCHES, Ellipse, Obstacle, Patch, Rectangle, Road
from swerve.world import Friction as FrictionMap


class PatchSettings(Settings):
    """A rectangle of the road on which the friction is another; without an interval it has no bounds that way.

    Attributes:
        x: from and to, along X [m].
        y: from and to, along Y [m].
        friction: coefficient mu on it [1].
    """

    x: tuple[Coordinate, Coordinate] | None = None
    y: tuple[Coordinate, Coordinate] | None = None
    friction: Friction = Field(examples=["0.3"])

    @model_validator(mode="after")
    def _intervals_ascend(self) -> Self:
        for key, interval in (("x", self.x), ("y", self.y)):
            if interval is not None and interval[0] >= interval[1]:
                fault = f"goes from {interval[0]:g} m to {interval[1]:g} m; write the smaller first"
                raise KeyedError(key, fault)
        return self

    def to_world(self) -> Patch:
        """The patch as geometry."""
        everywhere = (-inf, inf)
        return Patch(self.x or everywhere, self.y or everywhere, self.friction)


class RoadSettings(Settings):
    """A straight road along X; without a lane width it has no edges.

    Attributes:
        friction: coefficient mu between tyre and road; the controllers know this one alone [1].
        lane_width: of every lane; Y = 0 is the middle of the ego vehicle's own [m].
        lanes_left: number of lanes to the left of it.
        lanes_right: number of lanes to the right of it.
        patches: where the friction is another one; the last that holds a wheel counts.
    """

    friction: Friction = Field(examples=["0.85"])
    lane_width: Size | None = None
    lanes_left: Lanes = 1
    lanes_right: Lanes = 0
    patches: tuple[PatchSettings, ...] = ()

    @model_validator(mode="after")
    def _lanes_have_a_width(self) -> Self:
        for key in ("lanes_left", "lanes_right"):
            if self.lane_width is None and key in self.model_fields_set:
                raise KeyedError(key, 'means nothing without a width; write lane_width = "3.5 m" too')
        return self

    @model_validator(mode="after")
    def _patches_are_few(self) -> Self:
        if len(self.patches) > MOST_PATCHES:
            raise KeyedError("patches", f"are {len(self.patches)}; write at most {MOST_PATCHES}")
        return self

    def to_world(self) -> Road:
        """The road as geometry."""
        return Road(self.lane_width, self.lanes_left, self.lanes_right)

    def to_friction(self) -> FrictionMap:
        """The friction everywhere on the road."""
        return FrictionMap(self.friction, tuple(patch.to_world() for patch in self.patches))


class ObstacleSettings(Settings):
    """An obstacle that keeps its velocity and heading: an ellipse, or a rectangle.

    Attributes:
        position: of its centre at time zero (x, y) [m].
        velocity: in world axes (x, y) [m/s].
        heading: of its own x axis from the world's X axis, anticlockwise [rad].
        semi_axes: of an ellipse (a, b) along its own x and y [m].
        size: of a rectangle (length, width) along its own x and y [m].
    """

    position: tuple[Coordinate, Coordinate] = Field(examples=['["25 m", "0 m"]'])
    velocity: tuple[Velocity, Velocity] = (0.0, 0.0)
    heading: Heading = 0.0
    semi_axes: tuple[Size, Size] | None = None
    size: tuple[Size, Size] | None = None

    @model_validator(mode="after")
    def _has_one_shape(self) -> Self:
        if self.semi_axes is None and self.size is None:
            raise KeyedError("semi_axes", 'missing; write semi_axes = ["2 m", "2 m"] or size = ["4 m", "1.7 m"]')
        if self.semi_axes is not None and self.size is not None:
            raise KeyedError("size", "is given beside semi_axes; write one of them, a rectangle or an ellipse")
        return self

    def to_world(self) -> Obstacle:
        """The obstacle as geometry and motion."""
        shape = Ellipse(self.semi_axes) if self.semi_axes is not None else Rectangle(*(self.size or ()))
        return Obstacle(shape, self.position, self.velocity, self.heading)
