"""The controllers' settings: Table 3 of the paper, and what each controller adds of its own."""

from typing import Annotated, Final, Literal, Self

from pydantic import Field, model_validator

from swerve.scenario.quantities import (
    Angle,
    Delay,
    Force,
    Horizon,
    Iterations,
    Margin,
    SampleTime,
    Share,
    Tail,
    Weight,
    choice,
)
from swerve.scenario.settings import KeyedError, Settings

Correction = Literal["mass", "drift", "hold-input", "jacobian", "discretisation"]
CORRECTIONS: Final[tuple[Correction, ...]] = ("mass", "drift", "hold-input", "jacobian", "discretisation")


class Weights(Settings):
    """Weights of the cost (10), as numbers in SI; the paper prints no weight on the inputs.

    Attributes:
        speed: on the deviation from the goal's speed [s^2/m^2].
        lateral_speed: on the lateral speed [s^2/m^2].
        lateral_offset: on the deviation from the goal's lateral offset [1/m^2].
        steering_rate: on the change of steering angle in a sample [1/rad^2].
        force_rate: on the change of each wheel force in a sample [1/N^2].
    """

    speed: Weight = 1.0
    lateral_speed: Weight = 1.0
    lateral_offset: Weight = 10.0
    steering_rate: Weight = 1e2
    force_rate: Weight = 1e-6

    @model_validator(mode="after")
    def _ask_for_something(self) -> Self:
        if not self.speed + self.lateral_speed + self.lateral_offset > 0:
            raise KeyedError("lateral_offset", "all weights on the motion are 0; write at least one above 0")
        return self


class AsPrintedSettings(Settings):
    """Settings of the controller `as-printed`.

    Attributes:
        corrections: the misprints that are put right; none of them by default.
    """

    corrections: tuple[Annotated[Correction, choice("correction", CORRECTIONS)], ...] = ()

    @model_validator(mode="after")
    def _name_each_once(self) -> Self:
        for name in self.corrections:
            if self.corrections.count(name) > 1:
                raise KeyedError("corrections", f"names {name} twice; write it once")
        return self


class UnifiedSettings(Settings):
    """Settings of the controller `unified`, beside the horizons and weights.

    Attributes:
        slip_limit: largest |slip angle| of an axle, soft; the tyre's peak is at 0.15 [rad].
        slip_penalty: per radian beyond it [1/rad].
        slip_penalty_quadratic: per square radian beyond it [1/rad^2].
        clearance_margin: between the footprint and an obstacle, soft [m].
        clearance_penalty: per metre of margin that is missed [1/m].
        clearance_penalty_quadratic: per square metre of it [1/m^2].
        passing_gap: besides the margin, to an obstacle that it passes, as far as it costs little [m].
        stopping_gap: besides the margin, to an obstacle that it stays behind [m].
        force_weight: on each wheel force, which settles the forces that the cost does not see [1/N^2].
        trust_steering: largest change of a planned steering angle in an iteration [rad].
        trust_force: largest change of a planned wheel force in an iteration [N].
        iterations: of the convex program in an ordinary step.
        first_iterations: when a way has no plan that keeps clear.
        commitment: another way is taken when it costs less than this share of the present one [1].
        deadline: of a step, as a share of the sample time [1].
    """

    slip_limit: Angle = 0.12
    slip_penalty: Weight = 1e3
    slip_penalty_quadratic: Weight = 1e5
    clearance_margin: Margin = 0.02
    clearance_penalty: Weight = 2e4
    clearance_penalty_quadratic: Weight = 1e5
    passing_gap: Margin = 0.2
    stopping_gap: Margin = 1.0
    force_weight: Weight = 1e-8
    trust_steering: Angle = 0.08
    trust_force: Force = 4e3
    iterations: Iterations = 2
    first_iterations: Iterations = 6
    commitment: Share = 0.5
    deadline: Share = 0.5


class BrakeSettings(Settings):
    """Settings of the controller `brake`.

    Attributes:
        trigger_share: it acts when braking with this share of the largest deceleration comes too late [1].
        trigger_time: it acts when there is contact within this time at the present speed [s].
        margin: between the footprint and an obstacle that counts as contact [m].
    """

    trigger_share: Share = 0.85
    trigger_time: Delay = 0.6
    margin: Margin = 0.2


class HierarchicalSettings(Settings):
    """Settings of the controller `hierarchical`.

    Attributes:
        comfort: share of mu g that keeping the lane, or returning to it, may take [1].
        evasive: share of mu g that a lane change may take, which leaves the tracker the rest [1].
        braking: share of mu g up to which braking goes before a lane change [1].
        margin: between the footprint and an obstacle on a planned path [m].
        slip_limit: largest |slip angle| of an axle in the tracker, soft [rad].
        slip_penalty: per radian beyond it [1/rad].
        slip_penalty_quadratic: per square radian beyond it [1/rad^2].
        lateral_offset: weight on the distance from the path [1/m^2].
        heading: weight on the angle to the path [1/rad^2].
        speed: weight on the deviation from the speed profile [s^2/m^2].
        iterations: of the tracker's quadratic program in a step.
    """

    comfort: Share = 0.3
    evasive: Share = 1.0
    braking: Share = 0.85
    margin: Margin = 0.2
    slip_limit: Angle = 0.12
    slip_penalty: Weight = 1e3
    slip_penalty_quadratic: Weight = 1e5
    lateral_offset: Weight = 100.0
    heading: Weight = 100.0
    speed: Weight = 5.0
    iterations: Iterations = 2


class NonlinearSettings(Settings):
    """Settings of the controller `nonlinear`; its penalties and limits are those of `unified`.

    Attributes:
        tail: how far after the horizon it still has to keep clear, without a cost on where it goes [samples].
        solver: of the nonlinear program.
    """

    tail: Tail = 20
    solver: Annotated[Literal["fatrop", "ipopt"], choice("solver", ("fatrop", "ipopt"))] = "fatrop"


class ControllerSettings(Settings):
    """Horizons, sample time and weights that every controller reads, and a table for each controller's own.

    Attributes:
        prediction_horizon: Np [samples].
        control_horizon: Nc, after which the predicted input stays as it is [samples].
        sample_time: Ts, between two calls of the controller [s].
        weights: of the cost (10).
        as_printed: read by `as-printed` alone.
        unified: read by `unified`, its penalties and limits by `nonlinear` too.
        brake: read by `brake` alone.
        hierarchical: read by `hierarchical` alone.
        nonlinear: read by `nonlinear` alone.
    """

    prediction_horizon: Horizon = 20
    control_horizon: Horizon = 15
    sample_time: SampleTime = 0.05
    weights: Weights = Field(default_factory=Weights)
    as_printed: AsPrintedSettings = Field(default_factory=AsPrintedSettings)
    unified: UnifiedSettings = Field(default_factory=UnifiedSettings)
    brake: BrakeSettings = Field(default_factory=BrakeSettings)
    hierarchical: HierarchicalSettings = Field(default_factory=HierarchicalSettings)
    nonlinear: NonlinearSettings = Field(default_factory=NonlinearSettings)

    @model_validator(mode="after")
    def _control_within_prediction(self) -> Self:
        longest = self.prediction_horizon
        if self.control_horizon > longest:
            fault = f"{self.control_horizon} samples is longer than prediction_horizon, {longest} samples"
            raise KeyedError("control_horizon", f"{fault}; write at most {longest}")
        return self
