"""Roll-outs, scenes, programs and measurements to try the unified controller's parts on."""

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from swerve.control import Goal, Horizon, Latency, Side, Weights
from swerve.control.forecast import Forecast, forecasts
from swerve.control.plan import Passing
from swerve.control.unified import Formulation, UnifiedController, UnifiedSettings
from swerve.control.unified.condensing import Blocking, Sensitivities, condense
from swerve.control.unified.deadline import Deadline
from swerve.control.unified.memory import Memory
from swerve.control.unified.prediction import PredictionModel, Trajectory
from swerve.control.unified.scene import Scene
from swerve.control.unified.situation import Situation
from swerve.control.unified.way import Way
from swerve.scenario import load
from swerve.sensing import Noise, Past, Sensor, Truth
from swerve.signals import Measurement
from swerve.world import Ellipse, Obstacle, Rectangle, Shape, Steady
from tests.vehicle.motions import SEDAN, STATIC

Array = NDArray[np.float64]

HORIZON = Horizon(20, 15, 0.05)
BLOCKING = Blocking(HORIZON)
SIDES = (Side.LEFT, Side.RIGHT)
PASSED = (Passing.LEFT, Passing.RIGHT)
RUNNING = np.array([20.0, 0, 0, 0, 0, 0])
AHEAD = Obstacle(Ellipse((2.0, 2.0)), Steady((25.0, 0.0)))
CAR = Rectangle(4.85, 1.8, (-0.4, 0.0))
BOX_CAR = ("ego.footprint=rectangle",)
LANES = ("road.lane_width=3.5 m", "road.lanes_left=1", "road.lanes_right=0")
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
def formulation(*overrides: str) -> Formulation:
    """The formula for the paper's scenario, with overrides as in a file; a perfect actuator."""
    scenario = load("paper", overrides)
    settings = scenario.controller
    return Formulation(
        vehicle=scenario.ego.to_vehicle(),
        footprint=scenario.ego.to_footprint(),
        road=scenario.road.to_world(),
        friction=scenario.road.friction,
        goal=Goal(**scenario.goal.model_dump()),
        horizon=Horizon(settings.prediction_horizon, settings.control_horizon, settings.sample_time),
        weights=Weights(**settings.weights.model_dump()),
        latency=Latency(scenario.sensing.delay, 0.0, 0.0),
        settings=UnifiedSettings(**settings.unified.model_dump()),
    )


@cache
def controller(*overrides: str) -> UnifiedController:
    """The unified controller of that formula, which counts its work."""
    return UnifiedController(formulation(*overrides))


def seen(time: float = 0.0, state: Array = RUNNING, *obstacles: Obstacle) -> Measurement:
    """What is measured at this time; with no obstacle named, the paper's."""
    return empty(time, state, *(obstacles or (AHEAD,)))


def empty(time: float = 0.0, state: Array = RUNNING, *obstacles: Obstacle) -> Measurement:
    """What is measured at this time, with no obstacle but the named ones."""
    sensor = Sensor(delay=0.0, noise=Noise(), estimates_loads=False, vehicle=SEDAN)
    now = Past(step=1e-3, n_substeps=50, start=Truth(state, STATIC, np.zeros(2)))
    return sensor.measure(time, now, obstacles, np.random.default_rng(0))


def planned(n: int = 1, *overrides: str) -> Memory:
    """The controller's memory after n steps of the paper's scenario, the vehicle following its plans."""
    memory, state = controller(*overrides).start(), RUNNING
    for k in range(n):
        _, plan, memory = controller(*overrides).step(seen(0.05 * k, state), memory)
        state = plan.states[1]
    return memory


def forecast(
    shape: Shape, position: Sequence[float], velocity: Sequence[float] = (0.0, 0.0), **more: float
) -> Forecast:
    """What is expected of an obstacle seen at time zero that keeps its velocity; `heading` may be given."""
    motion = np.array(position, dtype=float), np.array(velocity, dtype=float), np.zeros(2)
    return Forecast(shape, more.get("heading", 0.0), 0.0, *motion)


def scene(
    *obstacles: Obstacle, state: Array = RUNNING, memory: Memory | None = None, of: tuple[str, ...] = ()
) -> Scene:
    """The scene of a step that measures this state and these obstacles, for the overrides `of`."""
    measurement = empty(0.0, state, *obstacles)
    known = memory or controller(*of).start()
    expected = forecasts(0.0, measurement.obstacles, ())
    return formulation(*of).scene(measurement, replace(known, forecasts=expected))


def situation(
    passing: tuple[Passing, ...], *obstacles: Obstacle, state: Array = RUNNING, of: tuple[str, ...] = ()
) -> Situation:
    """The situation of a way that passes these obstacles like that, with ample time."""
    found = scene(*obstacles, state=state, of=of)
    way = Way(passing, tuple(range(len(passing))))
    here = empty(0.0, state, *obstacles)
    return formulation(*of).situation(found, way, here, controller(*of).start(), Deadline(np.inf, None))


def in_the_mirror(obstacle: Obstacle) -> Obstacle:
    """A steady obstacle, left for right."""
    (x, y), (vx, vy) = obstacle.position_at(0.0), obstacle.velocity_at(0.0)
    return Obstacle(obstacle.shape, Steady((x, -y), (vx, -vy), -float(obstacle.heading_at(0.0))))


def other_side(passing: Passing) -> Passing:
    """Left for right; behind stays behind."""
    return Passing(-passing.value)


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
