"""A scenario: all that happens around and is asked of the ego vehicle, in SI units and radians."""

from math import ceil
from typing import Self

import tomli_w
from pydantic import Field, model_validator

from swerve.scenario.actuation import ActuationSettings
from swerve.scenario.controller import ControllerSettings
from swerve.scenario.driver import DriverSettings
from swerve.scenario.ego import EgoSettings
from swerve.scenario.obstacle import ObstacleSettings
from swerve.scenario.quantities import Duration, Name, Offset, PlantStep, Speed, Text
from swerve.scenario.sensing import SensingSettings
from swerve.scenario.settings import KeyedError, Settings
from swerve.scenario.surroundings import RoadSettings
from swerve.world import clearance

RATIO_TOLERANCE = 1e-9  # of a ratio of two times that stands for a whole number [1]


class GoalSettings(Settings):
    """What the ego vehicle is to hold.

    Attributes:
        speed: vx_d [m/s].
        lateral_offset: y_d, of the centre of gravity from Y = 0 [m].
    """

    speed: Speed = Field(examples=['"72 km/h"'])
    lateral_offset: Offset = Field(examples=['"0 m"'])


class PlantSettings(Settings):
    """The simulated vehicle's clock.

    Attributes:
        step: of its integrator and of the log [s].
    """

    step: PlantStep = 1e-3


class Scenario(Settings):
    """One scenario file, read and checked.

    Attributes:
        name: how reports call it.
        description: what it is for, one line.
        source: where its numbers come from.
        duration: the run covers at least this; see `n_samples` [s].
        road: friction and lanes.
        ego: the vehicle and its start.
        obstacles: none, or any number.
        goal: what the ego vehicle is to hold.
        controller: horizons, weights and sample time.
        plant: the simulated vehicle's clock.
        sensing: what the controller gets to know, and when.
        actuation: what the vehicle can command, and what of it has failed.
        driver: who sits at the wheel; None for nobody.
    """

    name: Name = Field(examples=['"my-scenario"'])
    description: Text = ""
    source: Text = ""
    duration: Duration = Field(examples=['"5 s"'])
    road: RoadSettings = Field(examples=["{ friction = 0.85 }"])
    ego: EgoSettings = Field(examples=['{ position = ["0 m", "0 m"], speed = "72 km/h", footprint = "point" }'])
    obstacles: tuple[ObstacleSettings, ...] = ()
    goal: GoalSettings = Field(examples=['{ speed = "72 km/h", lateral_offset = "0 m" }'])
    controller: ControllerSettings = Field(default_factory=ControllerSettings)
    plant: PlantSettings = Field(default_factory=PlantSettings)
    sensing: SensingSettings = Field(default_factory=SensingSettings)
    actuation: ActuationSettings = Field(default_factory=ActuationSettings)
    driver: DriverSettings | None = None

    @model_validator(mode="after")
    def _clocks_agree(self) -> Self:
        times = (("controller.sample_time", self.controller.sample_time, 1), ("sensing.delay", self.sensing.delay, 0))
        for key, time, fewest in times:
            ratio = time / self.plant.step
            if round(ratio) < fewest or abs(ratio - round(ratio)) > RATIO_TOLERANCE * ratio:
                nearest = f"{max(fewest, round(ratio)) * self.plant.step:g} s"
                fault = f"{time:g} s is no whole multiple of plant.step, {self.plant.step:g} s"
                raise KeyedError(key, f"{fault}; the nearest is {nearest}")
        return self

    @model_validator(mode="after")
    def _start_is_clear(self) -> Self:
        pose = [(*self.ego.position, self.ego.heading)]
        for index, obstacle in enumerate(self.obstacles):
            if clearance(self.ego.to_footprint(), pose, obstacle.to_world(), [0.0])[0] <= 0:
                x, y = self.ego.position
                fault = f"{obstacle.noun} covers the ego vehicle at its start, ({x:g} m, {y:g} m)"
                key = "waypoints" if obstacle.waypoints else "position"
                raise KeyedError(f"obstacles.{index}.{key}", f"{fault}; move one of them")
        return self

    @model_validator(mode="after")
    def _stuck_within_lock(self) -> Self:
        angle, lock = self.actuation.steering_stuck, self.ego.to_vehicle().steering_limit
        if angle is not None and abs(angle) > lock:
            fault = f"{angle:g} rad is beyond the vehicle's steering lock"
            raise KeyedError("actuation.steering_stuck", f"{fault}; write at most {lock:g} rad to either side")
        return self

    @model_validator(mode="after")
    def _driver_within_lock(self) -> Self:
        lock = self.ego.to_vehicle().steering_limit
        for index, (_, angle) in enumerate(() if self.driver is None else self.driver.steering):
            if abs(angle) > lock:
                fault = f"{angle:g} rad is beyond the vehicle's steering lock"
                raise KeyedError(f"driver.steering.{index}", f"{fault}; write at most {lock:g} rad to either side")
        return self

    @property
    def n_samples(self) -> int:
        """Controller samples in a run: the duration, rounded up to a whole number of sample times."""
        ratio = self.duration / self.controller.sample_time
        return max(1, ceil(ratio * (1 - RATIO_TOLERANCE)))

    @property
    def n_substeps(self) -> int:
        """Plant steps in a controller sample."""
        return round(self.controller.sample_time / self.plant.step)

    def to_toml(self) -> str:
        """The scenario as a TOML document in SI, defaults written out; it loads to an equal scenario."""
        tables = self.model_dump(exclude_none=True)
        if self.road.lane_width is None:
            for lanes in ("lanes_left", "lanes_right", "lanes_oncoming"):
                del tables["road"][lanes]
        return tomli_w.dumps(tables)
