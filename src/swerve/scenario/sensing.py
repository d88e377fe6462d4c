"""What the controller gets to know, and when."""

from typing import Annotated, Final, Literal

from pydantic import Field

from swerve.scenario.quantities import (
    AngleDeviation,
    Delay,
    ForceDeviation,
    LengthDeviation,
    SpeedDeviation,
    YawRateDeviation,
    choice,
)
from swerve.scenario.settings import Settings

LOAD_SOURCES: Final = ("plant", "estimated")


class NoiseSettings(Settings):
    """Standard deviations of white noise on the measured channels; 0 is none.

    Attributes:
        speed: of vx [m/s].
        lateral_speed: of vy [m/s].
        yaw_rate: of r [rad/s].
        heading: of psi [rad].
        position: of X and of Y [m].
        wheel_load: of each wheel [N].
        obstacle_position: of each obstacle, along X and along Y [m].
        obstacle_velocity: of each obstacle, along X and along Y [m/s].
    """

    speed: SpeedDeviation = 0.0
    lateral_speed: SpeedDeviation = 0.0
    yaw_rate: YawRateDeviation = 0.0
    heading: AngleDeviation = 0.0
    position: LengthDeviation = 0.0
    wheel_load: ForceDeviation = 0.0
    obstacle_position: LengthDeviation = 0.0
    obstacle_velocity: SpeedDeviation = 0.0


class SensingSettings(Settings):
    """The way from truth to measurement.

    Attributes:
        delay: age of a measurement when the controller gets it; a whole number of plant steps [s].
        wheel_loads: "plant", or "estimated" from the accelerations.
        noise: on the measured channels.
    """

    delay: Delay = 0.0
    wheel_loads: Annotated[Literal["plant", "estimated"], choice("source of wheel loads", LOAD_SOURCES)] = "plant"
    noise: NoiseSettings = Field(default_factory=NoiseSettings)
