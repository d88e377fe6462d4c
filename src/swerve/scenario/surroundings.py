"""What is round the ego vehicle: the road and the obstacles."""

from typing import Self

from pydantic import Field, model_validator

from swerve.scenario.quantities import Coordinate, Friction, Heading, Lanes, Size, Velocity
from swerve.scenario.settings import KeyedError, Settings
from swerve.world import Ellipse, Obstacle, Rectangle, Road


class RoadSettings(Settings):
    """A straight road along X; without a lane width it has no edges.

    Attributes:
        friction: coefficient mu between tyre and road [1].
        lane_width: of every lane; Y = 0 is the middle of the ego vehicle's own [m].
        lanes_left: number of lanes to the left of it.
        lanes_right: number of lanes to the right of it.
    """

    friction: Friction = Field(examples=["0.85"])
    lane_width: Size | None = None
    lanes_left: Lanes = 1
    lanes_right: Lanes = 0

    @model_validator(mode="after")
    def _lanes_have_a_width(self) -> Self:
        for key in ("lanes_left", "lanes_right"):
            if self.lane_width is None and key in self.model_fields_set:
                raise KeyedError(key, 'means nothing without a width; write lane_width = "3.5 m" too')
        return self

    def to_world(self) -> Road:
        """The road as geometry."""
        return Road(self.lane_width, self.lanes_left, self.lanes_right)


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
