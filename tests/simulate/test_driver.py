"""A driver in the loop: helped where the scene would be lost, and else left alone."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from swerve.driver import DriverSeries
from swerve.scenario import load
from swerve.simulate import Run, run
from swerve.simulate.assemble import sensor_of

FORCES = ("Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr")
LOST = ("driver-too-late", "driver-into-obstacle")
RIGHT = ("driver-is-right", "driver-lane-keeping-quiet")


@cache
def done(scenario: str, controller: str, plant: str = "planar") -> Run:
    """A run of the library."""
    return run(load(scenario), controller, plant)


def swerving(controller: str, begins: float, plant: str = "planar") -> Run:
    """The scene of `driver-too-late`, whose driver begins to swerve at another time [s]."""
    turns = ((0.0, 0.0), (0.3, 0.03), (0.8, 0.03), (1.1, -0.03), (1.6, -0.03), (1.8, 0.0))
    driver = DriverSeries(steering=tuple((begins + time, angle) for time, angle in turns))
    scenario = load("driver-too-late")
    return run(scenario, controller, plant, sense=replace(sensor_of(scenario), driver=driver).measure)


def assert_the_same_motion(one: Run, other: Run) -> None:
    """Column by column, to the last bit."""
    for name in one.log.motion.columns:
        np.testing.assert_array_equal(one.log.motion[name], other.log.motion[name], err_msg=name)


@pytest.mark.parametrize(
    ("scenario", "plant"), [("driver-too-late", "planar"), ("driver-into-obstacle", "planar"), (LOST[0], "multibody")]
)
def test_a_scene_that_the_driver_loses_is_avoided_with_help(scenario: str, plant: str) -> None:
    """Swerving too late, or into an obstacle, the driver alone collides; with the assistant nothing is touched."""
    assert done(scenario, "driver", plant).result.outcome.value == "collided"
    helped = done(scenario, "unified", plant).result
    assert helped.outcome.value == "avoided"
    assert helped.min_clearance is not None and helped.min_clearance > 0.05
    assert (helped.fallback_steps, helped.solver_failures) == (0, 0)
    assert helped.driver_deviation is not None and helped.driver_deviation > 0.02


@pytest.mark.parametrize("scenario", LOST)
def test_help_comes_late_and_goes_again(scenario: str) -> None:
    """Until about a second before the obstacle the command is the driver's, to the bit; then the plan says of itself
    that it is shaped and by how much; and once the obstacle is passed the steering goes back to the driver's, which it
    is within 0.02 rad at some time before the next half second is over.
    """
    helped = done(scenario, "unified")
    steps, plans = helped.log.steps, helped.plans
    off = np.abs(steps["delta"] - steps["delta_driver"])
    begins = int(np.argmax(off > 1e-3))
    distance = np.interp(steps["time"], helped.log.motion["time"], helped.log.motion["X"])
    assert steps["time"][begins] >= 0.9
    assert off[:begins].max() == 0.0
    assert not any(plan.is_shaped for plan in plans[:begins])
    assert plans[begins].is_shaped
    assert "rad and" in plans[begins].reason
    x, length = helped.scenario.obstacles[0].position[0], helped.scenario.obstacles[0].size[0]  # type: ignore[index]
    passed = int(np.argmax(distance > x + length / 2 + 2.83))  # the rear end too
    assert off[passed : passed + 10].min() < 0.02


@pytest.mark.parametrize("scenario", RIGHT)
def test_a_driver_who_is_right_is_left_alone(scenario: str) -> None:
    """With the assistant the motion is to the bit that of the driver alone, and no plan says that it was shaped."""
    alone, helped = done(scenario, "driver"), done(scenario, "unified")
    assert_the_same_motion(helped, alone)
    assert helped.result.outcome.value == "avoided"
    assert helped.result.driver_deviation == 0.0
    assert helped.result.decision == "none"
    assert not any(plan.is_shaped for plan in helped.plans)


def test_a_driver_who_swerves_in_time_is_left_alone() -> None:
    """Of the same swerve, one that passes the car by 0.4 m is nobody's affair; 0.3 s later it needs help."""
    assert_the_same_motion(swerving("unified", 0.8), swerving("driver", 0.8))
    assert swerving("driver", 1.1).result.outcome.value == "collided"
    late = swerving("unified", 1.1).result
    assert late.outcome.value == "avoided"
    assert late.driver_deviation is not None and late.driver_deviation > 1e-3


def test_a_driver_in_a_car_with_lags_is_left_alone_too() -> None:
    """On the multibody plant, braking for the car in time, steering and forces are the driver's to rounding."""
    helped = done("driver-is-right", "unified", "multibody")
    steps = helped.log.steps
    assert np.abs(steps["delta"] - steps["delta_driver"]).max() < 1e-9
    assert np.abs(steps.stack(*FORCES).sum(axis=1) - steps["force_driver"]).max() < 1e-6
    assert helped.result.outcome.value == "avoided"


def test_a_driver_is_measured_as_late_as_all_else() -> None:
    """With a delay the input that is seen, logged and passed on is the one of then."""
    late = run(load("driver-is-right", ("sensing.delay=20 ms", "duration=1 s")), "driver", "planar").log.steps
    full = 0.95 * 0.85 * 1530 * 9.81
    asked = -0.8 * full * np.clip((np.maximum(late["time"] - 0.02, 0.0) - 0.3) / 0.3, 0.0, 1.0)
    np.testing.assert_allclose(late["force_driver"], asked, atol=1e-9 * full)
    np.testing.assert_allclose(late.stack(*FORCES).sum(axis=1), asked, atol=1e-9 * full)


def test_without_a_driver_there_is_nothing_to_deviate_from() -> None:
    """The log's columns are nan and the result has no deviation; the controller `driver` coasts."""
    coasting = run(load("paper", ("duration=0.5 s",)), "driver", "planar")
    assert coasting.result.driver_deviation is None
    assert coasting.result.to_json()["driver_deviation"] is None
    assert np.isnan(coasting.log.steps.stack("delta_driver", "force_driver")).all()
    assert (coasting.log.steps.stack("delta", *FORCES) == 0.0).all()
