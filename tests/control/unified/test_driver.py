"""A driver beside the unified controller: the term, what is held, who leads a step, and how it is handed back."""

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from swerve.control import Fallback, Horizon
from swerve.control.actuation import EVERYTHING, Actuation
from swerve.control.driver import DriverActuation
from swerve.control.unified import UnifiedController
from swerve.control.unified.assistance import FORCE, HANDING_BACK, STEERING, Lead
from swerve.control.unified.condensing import Blocking
from swerve.control.unified.deadline import Deadline
from swerve.control.unified.limits import InputBox
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.terms import DriverDeviation
from swerve.control.unified.way import Way
from swerve.scenario import load
from swerve.signals import DriverInput, Measurement, Observation
from swerve.simulate.assemble import controller_named
from swerve.vehicle.parameters import D_CLASS_SEDAN as SEDAN
from swerve.world import Ellipse
from tests.vehicle.motions import STATIC

Array = NDArray[np.float64]

HORIZON = Horizon(20, 15, 0.05)
ONE_BRAKE = Actuation.of(SEDAN, "steer+friction-brakes")
ASKED = np.array([0.02, -800.0, -700.0, -500.0, -400.0])
WEIGHTS = np.array([STEERING] + 4 * [FORCE])
WALL = Observation(Ellipse((2.0, 2.0)), (20.0, 0.0), (0.0, 0.0), 0.0)  # 18 m away: 0.9 s


@cache
def controller(*overrides: str) -> UnifiedController:
    """That of the paper's scenario."""
    made: Any = controller_named("unified", load("paper", overrides), "planar")
    return made


def seen(driver: DriverInput | None, *obstacles: Observation) -> Measurement:
    """Straight ahead at 72 km/h."""
    return Measurement(0.0, 0.0, np.array([20.0, 0, 0, 0, 0, 0]), STATIC, obstacles, driver)


def along(inputs: Array) -> Trajectory:
    """A trajectory of which only the inputs (20, 5) matter."""
    return Trajectory(inputs, np.zeros((21, 6)), np.zeros((41, 3)), np.zeros(20), np.zeros(20), np.zeros((20, 4)))


def random_inputs(seed: int) -> Array:
    """(20, 5)."""
    return np.random.default_rng(seed).normal(0.0, [0.05, 900, 900, 600, 600], (20, 5))


def test_the_term_is_its_sum() -> None:
    """The term sums weighted squares of what each free input is off, sample by sample and input by input."""
    inputs = random_inputs(1)
    by_hand = sum(WEIGHTS[i] * (inputs[j, i] - ASKED[i]) ** 2 for j in range(15) for i in range(5))
    value = DriverDeviation(ASKED, WEIGHTS, Blocking(HORIZON)).value(along(inputs))
    assert value == pytest.approx(by_hand, rel=1e-12)


@pytest.mark.parametrize("actuation", [EVERYTHING, ONE_BRAKE], ids=["all", "one brake demand"])
@settings(max_examples=10)
@given(seed=st.integers(0, 2**32 - 1))
def test_the_model_of_the_term_has_its_differences(actuation: Actuation, seed: int) -> None:
    """Gradient and Hessian along any direction are the first and second central differences of the value."""
    blocking, inputs = Blocking(HORIZON, actuation), random_inputs(seed)
    term = DriverDeviation(ASKED, WEIGHTS, blocking)
    direction, h = np.random.default_rng(seed + 1).normal(size=blocking.n), 1e-2

    def value(step: float) -> float:
        return term.value(along(inputs + blocking.spread(step * direction)))

    model = term.quadratic(along(inputs), None)  # type: ignore[arg-type]  # the inputs alone decide
    assert model.gradient @ direction == pytest.approx((value(h) - value(-h)) / (2 * h), rel=1e-6, abs=1e-6)
    curvature = (value(h) - 2 * value(0.0) + value(-h)) / h**2
    assert direction @ model.hessian @ direction == pytest.approx(curvature, rel=1e-5)


def test_what_is_held_is_no_longer_free() -> None:
    """The box clips the first inputs to what is held, and leaves a program no change of them but the way there."""
    held = np.tile(ASKED, (4, 1))
    box = replace(InputBox.of(SEDAN, 0.85, STATIC, Blocking(HORIZON)), held=held)
    inputs = random_inputs(2)
    np.testing.assert_array_equal(box.clip(inputs)[:4], held)
    np.testing.assert_array_equal(box.clip(inputs)[4:], replace(box, held=held[:0]).clip(inputs)[4:])
    lower, upper = (bound.reshape(15, 5) for bound in box.bounds(along(inputs), np.array([0.08] + 4 * [4e3])))
    np.testing.assert_array_equal(lower[:4], upper[:4])
    np.testing.assert_allclose(inputs[:4] + lower[:4] * [0.1, 1e3, 1e3, 1e3, 1e3], held, atol=1e-9)
    assert (lower[4:] < upper[4:]).all()


def test_a_plan_gives_back_what_was_taken() -> None:
    """What is held is the driver's input and the last deviation from it, which fades with the time constant."""
    formulation, measurement = controller()._formulation, seen(DriverInput(0.01, 0.0))
    deviation, program = np.array([0.05, 0, 0, 0, 0]), formulation.actuators(STATIC, controller().start())
    held = formulation.assistance.held(program, measurement, deviation).box.held
    assert len(held) == 8
    fading = 0.05 * np.exp(-0.05 * np.arange(1, 9) / HANDING_BACK)
    np.testing.assert_allclose(held[:, 0], 0.01 + fading, rtol=1e-12)
    assert (held[:, 1:] == 0.0).all()


def test_a_driver_steers_no_faster_than_the_vehicle() -> None:
    """Steering that is asked for at once is held as fast as the steering can go, so that the program has a solution."""
    limited = controller("ego.parameters.steering_rate_limit='20 deg/s'")
    command, plan, _ = limited.step(seen(DriverInput(0.2, 0.0)), limited.start())
    assert command.steering_angle == pytest.approx(np.radians(20) * 0.05)
    assert plan.solver_failures == 0


@settings(max_examples=10)
@given(angle=st.floats(-0.03, 0.03), share=st.floats(-0.9, 0.3))
def test_on_a_free_road_the_command_is_the_driver_s(angle: float, share: float) -> None:
    """With nothing in reach each input is to the bit what the driver asks for, and no obstacle is said to shape it."""
    driver = DriverInput(angle, share * 0.95 * 0.85 * 1530 * 9.81)
    measurement = seen(driver)
    command, plan, _ = controller().step(measurement, controller().start())
    np.testing.assert_array_equal(command.as_input(), DriverActuation(SEDAN, 0.85, EVERYTHING).inputs(measurement))
    assert command.steering_angle == angle
    assert (plan.is_shaped, plan.side, plan.fallback) == (False, None, None)
    assert plan.reason == "the driver's input, which leaves a way clear"


def test_a_driver_who_leaves_no_way_is_helped_by_the_least() -> None:
    """Where nothing is clear once a driver has gone straight on for a moment, the plan steers or brakes, is clear, and
    deviates less from the driver than the plan that is made without one.
    """
    driver = DriverInput(0.0, 0.0)
    _, helped, _ = controller().step(seen(driver, WALL), controller().start())
    _, alone, _ = controller().step(seen(None, WALL), controller().start())
    assert helped.is_shaped
    assert helped.reason.startswith(Lead.ASSISTANT.value)
    taken = next(branch for branch in helped.branches if branch.name == helped.name)
    assert taken.violation <= 5e-3
    assert np.abs(helped.inputs[0, 0]) > 1e-3

    def deviation(inputs: Array) -> float:
        return float((WEIGHTS * inputs[:15] ** 2).sum())

    assert deviation(helped.inputs) < deviation(alone.inputs)


def test_a_driver_who_holds_the_clear_way_leads() -> None:
    """Where going straight on leaves no way, steering may: the same scene is led by who asks for the right thing."""
    formulation, memory = controller()._formulation, controller().start()
    for angle, is_clear in ((0.0, False), (0.06, True)):
        measurement = seen(DriverInput(angle, 0.0), WALL)
        _, plan, _ = controller().step(measurement, memory)
        assert (plan.reason == "the driver's input, which leaves a way clear") is is_clear
    way = Way((), ())
    scene = formulation.scene(seen(None), memory)
    program = formulation.situation(scene, way, seen(None), memory, Deadline(1.0, None)).program
    assert program.box.held.size == 0


@pytest.mark.parametrize("bad", [np.nan, np.inf, 1e9])
def test_a_broken_driver_is_no_measurement(bad: float) -> None:
    """An input that is not finite, or absurd, ends in the fallback with a finite command, not in an exception."""
    for driver in (DriverInput(bad, 0.0), DriverInput(0.0, bad)):
        command, plan, memory = controller().step(seen(driver, WALL), controller().start())
        assert plan.fallback is Fallback.NOT_FINITE
        assert np.isfinite(command.as_input()).all()
        assert (memory.deviation == 0.0).all()


@settings(max_examples=25)
@given(force=st.floats(-2e4, 2e4), loads=st.lists(st.floats(0.0, 9e3), min_size=4, max_size=4))
def test_pedals_are_shared_over_the_wheels_as_their_loads(force: float, loads: list[float]) -> None:
    """Wheel forces have the ratio of the loads; their sum is the demand, or what the tyres carry where that is less."""
    measurement = replace(seen(DriverInput(0.0, force)), wheel_loads=np.array(loads))
    forces = DriverActuation(SEDAN, 0.85, EVERYTHING).inputs(measurement)[1:]
    total = sum(loads)
    carried = 0.95 * 0.85 * total
    if total >= 1.0:
        assert forces.sum() == pytest.approx(np.clip(force, -carried, carried), rel=1e-9, abs=1e-6)
        np.testing.assert_allclose(forces * total, forces.sum() * np.array(loads), rtol=1e-9, atol=1e-3)
    assert (np.abs(forces) <= 0.95 * 0.85 * np.array(loads) + 1e-9).all()
