"""Roll-outs, programs and measurements to try the unified controller's parts on."""

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from swerve.control import Horizon, Side
from swerve.control.unified import UnifiedController
from swerve.control.unified.acceptance import Step
from swerve.control.unified.branch import SidePlan
from swerve.control.unified.condensing import Blocking, Sensitivities, condense
from swerve.control.unified.memory import Memory
from swerve.control.unified.prediction import PredictionModel, Trajectory
from swerve.control.unified.program import Score
from swerve.scenario import load
from swerve.sensing import Noise, Past, Sensor, Truth
from swerve.signals import Measurement
from swerve.simulate.assemble import controller_named
from swerve.world import Ellipse, Obstacle, Steady
from tests.vehicle.motions import SEDAN, STATIC

Array = NDArray[np.float64]

HORIZON = Horizon(20, 15, 0.05)
BLOCKING = Blocking(HORIZON)
SIDES = (Side.LEFT, Side.RIGHT)
RUNNING = np.array([20.0, 0, 0, 0, 0, 0])
AHEAD = Obstacle(Ellipse((2.0, 2.0)), Steady((25.0, 0.0)))
seeds = st.integers(0, 2**32 - 1)


@cache
def model() -> PredictionModel:
    """The prediction of the paper's scenario."""
    return PredictionModel(SEDAN, 0.85, HORIZON)


def random_start(random: np.random.Generator) -> Array:
    """A state within what a swerving vehicle goes through."""
    return random.normal([18, 0, 0, 0, 0, 0], [3, 0.5, 0.3, 0.1, 3, 2])


def random_inputs(random: np.random.Generator, share: float = 1.0) -> Array:
    """A plan (Np, 5) whose last free input is held."""
    free = random.normal(0.0, np.array([0.03, 900, 900, 600, 600]) * share, (BLOCKING.n_blocks, 5))
    return free[BLOCKING.block]


def random_roll_out(seed: int) -> tuple[Trajectory, Sensitivities, np.random.Generator]:
    """A trajectory, its sensitivities, and the generator that made it."""
    random = np.random.default_rng(seed)
    trajectory = model().roll_out(random_start(random), random_inputs(random), STATIC)
    return trajectory, condense(model().linearise(trajectory, STATIC), BLOCKING), random


def along_the_linear_model(trajectory: Trajectory, sensitivities: Sensitivities, z: Array) -> Trajectory:
    """The trajectory after scaled changes z (n,), had the model been linear."""
    poses = trajectory.poses.copy()
    poses[1:] += sensitivities.poses @ z
    return Trajectory(
        trajectory.inputs + BLOCKING.spread(z),
        trajectory.states + np.concatenate([np.zeros((1, 6)), sensitivities.states @ z]),
        poses,
        trajectory.front_slip + sensitivities.front_slip @ z,
        trajectory.rear_slip + sensitivities.rear_slip @ z,
        trajectory.lateral_demand,
    )


@cache
def controller(*overrides: str) -> UnifiedController:
    """The unified controller of the paper's scenario."""
    made: Any = controller_named("unified", load("paper", overrides), "planar")
    return made


def seen(time: float = 0.0, state: Array = RUNNING, *obstacles: Obstacle) -> Measurement:
    """What is measured at this time; with no obstacle named, the paper's."""
    sensor = Sensor(delay=0.0, noise=Noise(), estimates_loads=False, vehicle=SEDAN)
    now = Past(step=1e-3, n_substeps=50, start=Truth(state, STATIC, np.zeros(2)))
    return sensor.measure(time, now, obstacles or (AHEAD,), np.random.default_rng(0))


def planned(n: int = 1) -> Memory:
    """The controller's memory after n steps of the paper's scenario, the vehicle following its plans."""
    memory, state = controller().start(), RUNNING
    for k in range(n):
        _, plan, memory = controller().step(seen(0.05 * k, state), memory)
        state = plan.states[1]
    return memory


def side_plan(side: Side, merit: float, violation: float = 0.0) -> SidePlan:
    """A side's plan with this merit and missed margin [m]; the motion does not matter."""
    nothing = model().roll_out(RUNNING, np.zeros((20, 5)), STATIC)
    return SidePlan(side, Step(nothing, Score(merit, 0.0, ())), violation, True, 1.0, 1, 0)


def with_entry(values: Array, place: int, value: float) -> Array:
    """A copy with one entry replaced."""
    copy = values.copy()
    copy[place] = value
    return copy


def broken_measurements(value: float) -> dict[str, Measurement]:
    """The paper's first measurement with `value` in one place after the other."""
    good = seen()
    only = good.obstacles[0]
    broken = {f"state {i}": replace(good, state=with_entry(good.state, i, value)) for i in range(6)}
    loads = {f"load {i}": replace(good, wheel_loads=with_entry(good.wheel_loads, i, value)) for i in range(4)}
    obstacles = {
        "position x": replace(only, position=(value, 0.0)),
        "position y": replace(only, position=(25.0, value)),
        "velocity x": replace(only, velocity=(value, 0.0)),
        "velocity y": replace(only, velocity=(0.0, value)),
        "heading": replace(only, heading=value),
    }
    seen_wrong = {f"obstacle's {name}": replace(good, obstacles=(only, each)) for name, each in obstacles.items()}
    return broken | loads | seen_wrong
