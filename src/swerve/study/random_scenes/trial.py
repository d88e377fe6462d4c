"""One random scene run, and what is held against it."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from swerve.conventions import GRAVITY, INPUTS
from swerve.scenario import Scenario
from swerve.simulate import Outcome, Run, run
from swerve.study.random_scenes.search import Certificate

CONTROLLER: Final = "unified"
ROUNDING: Final = 1e-6  # by which a command may exceed a limit, as a share of it [1]
CALM_STEER: Final = 0.01  # [rad] a larger steering angle is an intervention
CALM_FORCE: Final = 0.05  # likewise of the wheel forces together, as a share of mu m g [1]


@dataclass(frozen=True)
class Trial:
    """A scene that was run.

    Attributes:
        scene: that was run.
        plant: by name.
        certificate: why it can be avoided; None for a quiet scene.
        outcome: of the run.
        decision: of the run.
        min_clearance: between footprint and obstacles [m].
        impact_speed: relative to the obstacle; None without contact [m/s].
        impact_obstacle: its index; None without contact.
        fallbacks: steps that were answered by a fallback.
        is_within_limits: whether every command was finite and within the vehicle's limits.
        largest_steer: commanded; in a quiet scene by how much it differs from that on an empty road [rad].
        largest_force: of all wheels together, likewise, as a share of mu m g [1].
        step_time: median of the controller's step [s].
        wall_time: of the run [s].
    """

    scene: Scenario
    plant: str
    certificate: Certificate | None
    outcome: Outcome
    decision: str
    min_clearance: float
    impact_speed: float | None
    impact_obstacle: int | None
    fallbacks: int
    is_within_limits: bool
    largest_steer: float
    largest_force: float
    step_time: float
    wall_time: float

    @property
    def is_avoided(self) -> bool:
        """Whether it touched nothing and stayed in hand."""
        return self.outcome is Outcome.AVOIDED

    @property
    def intervenes(self) -> bool:
        """Whether anything was done that a quiet scene does not ask for."""
        is_calm = self.largest_steer < CALM_STEER and self.largest_force < CALM_FORCE
        return not (self.decision == "none" and is_calm)

    @property
    def cause(self) -> str:
        """What it failed by: the outcome, and with a collision what the obstacle does."""
        if self.impact_obstacle is None:
            return self.outcome.value
        return f"{self.outcome.value}: {kind_of(self.scene, self.impact_obstacle)}"


def try_scene(scene: Scenario, plant: str, certificate: Certificate | None) -> Trial:
    """Run a scene and measure it; what is done in a quiet one, without a certificate, beside an empty road."""
    done = run(scene, CONTROLLER, plant)
    result, inputs = done.result, done.log.steps.stack(*INPUTS)
    if certificate is None:
        inputs = inputs - run(_emptied(scene), CONTROLLER, plant).log.steps.stack(*INPUTS)
    grip = scene.road.friction * scene.ego.to_vehicle().mass * GRAVITY
    return Trial(
        scene=scene,
        plant=plant,
        certificate=certificate,
        outcome=result.outcome,
        decision=result.decision,
        min_clearance=float("nan") if result.min_clearance is None else result.min_clearance,
        impact_speed=result.impact_speed,
        impact_obstacle=result.impact_obstacle,
        fallbacks=result.fallback_steps,
        is_within_limits=_is_within_limits(done),
        largest_steer=float(np.abs(inputs[:, 0]).max()),
        largest_force=float(np.abs(inputs[:, 1:].sum(axis=1)).max() / grip),
        step_time=result.step_time.median,
        wall_time=result.wall_time,
    )


def _emptied(scene: Scenario) -> Scenario:
    return scene.model_copy(update={"obstacles": ()})


def kind_of(scene: Scenario, index: int) -> str:
    """How an obstacle moves, in a word."""
    obstacle = scene.obstacles[index]
    vx, vy = obstacle.velocity or (0.0, 0.0)
    if obstacle.acceleration is not None:
        return "braking"
    if vy != 0:
        return "crossing"
    return "static" if vx == 0 else "slower" if vx > 0 else "oncoming"


def _is_within_limits(done: Run) -> bool:
    """Whether every command is finite, within the lock, and within the wheels' friction at their loads of then."""
    scene, log = done.scenario, done.log
    vehicle = scene.ego.to_vehicle()
    inputs, n = log.steps.stack(*INPUTS), scene.n_substeps
    loads = log.motion.stack("Fz_fl", "Fz_fr", "Fz_rl", "Fz_rr")[: n * len(inputs) : n]
    largest = vehicle.force_limit * scene.road.friction * loads
    within = np.abs(inputs[:, 1:]) <= largest * (1 + ROUNDING) + ROUNDING
    return bool(np.isfinite(inputs).all() and (np.abs(inputs[:, 0]) <= vehicle.steering_limit).all() and within.all())
