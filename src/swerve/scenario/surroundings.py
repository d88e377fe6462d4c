"""The road of a scenario: its friction and its lanes."""

from math import inf
from typing import Self

from pydantic import Field, model_validator

from swerve.scenario.quantities import Coordinate, Friction, Lanes, Size
from swerve.scenario.settings import KeyedError, Settings
from swerve.world import MOST_PATCHES, Patch, Road
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
        lanes_oncoming: how many of those to the left, outermost first, carry oncoming traffic.
        patches: where the friction is another one; the last that holds a wheel counts.
    """

    friction: Friction = Field(examples=["0.85"])
    lane_width: Size | None = None
    lanes_left: Lanes = 1
    lanes_right: Lanes = 0
    lanes_oncoming: Lanes = 0
    patches: tuple[PatchSettings, ...] = ()

    @model_validator(mode="after")
    def _lanes_have_a_width(self) -> Self:
        for key in ("lanes_left", "lanes_right", "lanes_oncoming"):
            if self.lane_width is None and key in self.model_fields_set:
                raise KeyedError(key, 'means nothing without a width; write lane_width = "3.5 m" too')
        if self.lanes_oncoming > self.lanes_left:
            fault = f"{self.lanes_oncoming} of {self.lanes_left} lanes on the left"
            raise KeyedError("lanes_oncoming", f"is {fault}; write at most as many as there are")
        return self

    @model_validator(mode="after")
    def _patches_are_few(self) -> Self:
        if len(self.patches) > MOST_PATCHES:
            raise KeyedError("patches", f"are {len(self.patches)}; write at most {MOST_PATCHES}")
        return self

    def to_world(self) -> Road:
        """The road as geometry."""
        return Road(self.lane_width, self.lanes_left, self.lanes_right, self.lanes_oncoming)

    def to_friction(self) -> FrictionMap:
        """The friction everywhere on the road."""
        return FrictionMap(self.friction, tuple(patch.to_world() for patch in self.patches))
