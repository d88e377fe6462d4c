"""The controller's step: what it answers to what it measures, and what it does when it can't plan."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from swerve.control import Fallback, Plan, Side
from swerve.control.unified.memory import Memory, shifted
from swerve.qp import Problem, Solution
from swerve.qp.solution import Status
from swerve.scenario import load
from swerve.signals import Command
from swerve.simulate import run
from swerve.world import Ellipse, Obstacle, Steady
from tests.control.unified.situations import (
    AHEAD,
    RUNNING,
    broken_measurements,
    controller,
    planned,
    random_start,
    seen,
)
from tests.vehicle.motions import MIRROR, STATIC, mirrored

NOT_NUMBERS = [np.nan, np.inf, -np.inf]
BRAKING = np.array([0.0, *(-0.95 * 0.85 * STATIC)])
PLACES = list(broken_measurements(np.nan))


def assert_same(one: Any, other: Any) -> None:
    """Two answers of the controller are the same to the last bit."""
    (command, plan, memory), (command_2, plan_2, memory_2) = one, other
    np.testing.assert_array_equal(command.as_input(), command_2.as_input())
    np.testing.assert_array_equal(plan.inputs, plan_2.inputs)
    np.testing.assert_array_equal(plan.states, plan_2.states)
    assert (plan.side, plan.fallback) == (plan_2.side, plan_2.fallback)
    assert memory.committed is memory_2.committed


def failing(monkeypatch: pytest.MonkeyPatch, status: Status = Status.FAILED) -> list[Problem]:
    """From here on the solver has no answer; the problems it was asked."""
    asked: list[Problem] = []

    def no_answer(problem: Problem, *rest: Any, **named: Any) -> Solution:
        asked.append(problem)
        return Solution.without_answer(problem, status, 0, "none")

    monkeypatch.setattr("swerve.control.unified.branch.solve", no_answer)
    return asked


def test_a_plan_is_what_it_says() -> None:
    """The command is the plan's first input, the plan begins at the measured state, and both sides were tried."""
    command, plan, memory = controller().step(seen(), controller().start())
    np.testing.assert_array_equal(command.as_input(), plan.inputs[0])
    np.testing.assert_array_equal(memory.command, plan.inputs[0])
    np.testing.assert_array_equal(plan.states[0], RUNNING)
    assert plan.inputs.shape == (20, 5)
    assert plan.states.shape == (21, 6)
    assert (plan.fallback, plan.solver_failures) == (None, 0)
    assert {branch.side for branch in plan.branches} == set(Side)
    assert memory.plan is plan


def test_equal_sides_go_left_and_nothing_else_is_remembered() -> None:
    """Straight ahead of the obstacle the plan goes left, from the first step in which the obstacle matters."""
    _, plan, memory = controller().step(seen(), controller().start())
    costs = {branch.side: branch.cost for branch in plan.branches}
    assert costs[Side.LEFT] == pytest.approx(costs[Side.RIGHT], rel=1e-6)
    assert plan.side in (None, Side.LEFT)
    assert memory.committed in (None, Side.LEFT)
    assert plan.states[-1, 5] >= 0


def test_the_same_step_gives_the_same_bits() -> None:
    """A step is a function of measurement and memory: asked twice, with other questions between, it answers alike."""
    memory = planned(3)
    state = memory.plan.states[1]
    first = controller().step(seen(0.15, state), memory)
    controller().step(seen(0.15, state * MIRROR), controller().start())
    assert_same(controller().step(seen(0.15, state), memory), first)


def test_a_step_changes_nothing_it_was_given() -> None:
    """Measurement and memory are as they were after a step, so that a run can be resumed from any of them."""
    memory = planned(2)
    kept = {side: inputs.copy() for side, inputs in memory.inputs.items()}
    command, trust = memory.command.copy(), dict(memory.trust)
    measurement = seen(0.1, memory.plan.states[1].copy())
    controller().step(measurement, memory)
    controller().step(replace(measurement, stamp=-1.0), memory)
    assert {side: inputs.tolist() for side, inputs in memory.inputs.items()} == {
        side: inputs.tolist() for side, inputs in kept.items()
    }
    np.testing.assert_array_equal(memory.command, command)
    np.testing.assert_array_equal(measurement.state, memory.plan.states[1])
    assert memory.trust == trust


@pytest.mark.parametrize("lateral", [0.3, -0.8, 1.5])
def test_a_step_in_the_mirror_is_the_mirror_of_the_step(lateral: float) -> None:
    """With obstacle and state mirrored, the command is the mirror image."""
    state = random_start(np.random.default_rng(4))
    here = controller().step(
        seen(0.0, state, Obstacle(Ellipse((2.0, 1.5)), Steady((26.0, lateral), heading=0.3))), controller().start()
    )
    there = controller().step(
        seen(0.0, state * MIRROR, Obstacle(Ellipse((2.0, 1.5)), Steady((26.0, -lateral), heading=-0.3))),
        controller().start(),
    )
    np.testing.assert_allclose(there[0].as_input(), mirrored(here[0].as_input()), rtol=1e-6, atol=1e-6)
    assert here[1].side is None or there[1].side is Side(-here[1].side.value)


@pytest.mark.parametrize(
    "overrides", [(), ("ego.parameters.steering_rate_limit=1 rad/s",), ("controller.control_horizon=5",)]
)
def test_plans_keep_what_they_promise(overrides: tuple[str, ...]) -> None:
    """In every plan of a run the inputs are within their limits, and held after the control horizon."""
    scenario = load("paper", ("duration=1.5 s", *overrides))
    done = run(scenario, plant="planar")
    n_free, rate = scenario.controller.control_horizon, scenario.ego.to_vehicle().steering_rate_limit
    before = 0.0
    for plan in done.plans:
        assert (np.abs(plan.inputs[:, 0]) <= 0.5 + 1e-12).all()
        assert (np.abs(plan.inputs[:, 1:]) <= 0.95 * 0.85 * STATIC + 1e-9).all()
        assert np.abs(np.diff(plan.inputs[:1, 0], prepend=before)).max() <= rate * 0.05 + 1e-9
        np.testing.assert_array_equal(plan.inputs[n_free:], np.tile(plan.inputs[n_free - 1], (20 - n_free, 1)))
        before = plan.inputs[0, 0]


def test_a_side_once_taken_is_kept() -> None:
    """Through the paper's scenario there is one side, from the first step that an obstacle shapes to the last."""
    sides = [plan.side for plan in run(load("paper"), plant="planar").plans if plan.side is not None]
    assert len(sides) > 10
    assert set(sides) == {Side.LEFT}


# What is done when there is no plan


@pytest.mark.parametrize("value", NOT_NUMBERS)
@pytest.mark.parametrize("place", PLACES)
def test_what_is_not_finite_is_not_planned_from(place: str, value: float) -> None:
    """One number that is none, in state, loads or any obstacle: the last plan goes on, and the plan says why."""
    memory = planned()
    broken = replace(broken_measurements(value)[place], time=0.05, stamp=0.05)
    command, plan, after = controller().step(broken, memory)
    assert plan.fallback is Fallback.NOT_FINITE
    np.testing.assert_array_equal(command.as_input(), memory.plan.inputs[1])
    np.testing.assert_array_equal(plan.states, memory.plan.states[1:])
    assert after.plan is memory.plan


@pytest.mark.parametrize("value", NOT_NUMBERS)
def test_a_time_that_is_no_number_is_a_bad_measurement(value: float) -> None:
    """Neither clock may be nan or infinite: how old the measurement is can't be known."""
    for broken in (replace(seen(), stamp=value), replace(seen(), time=value)):
        _, plan, _ = controller().step(broken, planned())
        assert plan.fallback in (Fallback.NOT_FINITE, Fallback.LATE)


@pytest.mark.parametrize(("age", "fallback"), [(0.0, None), (0.02, None), (0.03, Fallback.LATE), (5.0, Fallback.LATE)])
def test_what_is_too_old_is_not_planned_from(age: float, fallback: Fallback | None) -> None:
    """Half a sample is the oldest that a measurement may be."""
    memory = planned()
    _, plan, _ = controller().step(replace(seen(0.05, memory.plan.states[1]), stamp=0.05 - age), memory)
    assert plan.fallback is fallback


@pytest.mark.parametrize("status", [Status.FAILED, Status.INFEASIBLE, Status.ITERATION_LIMIT])
@pytest.mark.parametrize("ahead", [25.0, 12.0, None])
def test_a_solver_that_fails_is_no_exception(
    monkeypatch: pytest.MonkeyPatch, status: Status, ahead: float | None
) -> None:
    """Where no program has an answer the last plan goes on; each program that failed is counted, and no other."""
    memory = planned()
    asked = failing(monkeypatch, status)
    measurement = seen(0.05, memory.plan.states[1], replace(AHEAD, motion=Steady((ahead or 0.0, 0.0))))
    if ahead is None:
        measurement = replace(measurement, obstacles=())
    command, plan, _ = controller().step(measurement, memory)
    assert plan.fallback is Fallback.NO_SOLUTION
    assert plan.solver_failures == len(asked) > 0
    np.testing.assert_array_equal(command.as_input(), memory.plan.inputs[1])


def test_a_solver_that_fails_once_costs_one_iteration(monkeypatch: pytest.MonkeyPatch) -> None:
    """One failure among answers is counted, and the step still has a plan of its own."""
    from swerve.control.unified import branch

    solve, calls = branch.solve, []

    def sometimes(problem: Problem) -> Solution:
        calls.append(problem)
        return Solution.without_answer(problem, Status.FAILED, 0, "none") if len(calls) == 1 else solve(problem)

    monkeypatch.setattr(branch, "solve", sometimes)
    _, plan, _ = controller().step(seen(), controller().start())
    assert plan.fallback is None
    assert plan.solver_failures == 1


def test_without_any_plan_it_brakes_straight() -> None:
    """Blind from the start, it brakes with all the friction that static loads give, wheels straight."""
    command, plan, _ = controller().step(replace(seen(), state=np.full(6, np.nan)), controller().start())
    np.testing.assert_allclose(command.as_input(), BRAKING)
    assert plan.fallback is Fallback.NOT_FINITE
    assert plan.states.shape == (0, 6)


def test_a_plan_is_followed_to_its_end_and_then_it_brakes() -> None:
    """Blind after one plan, it drives that plan's inputs one after the other, then brakes straight."""
    memory = planned()
    last = memory.plan
    blind = replace(seen(), state=np.full(6, np.nan))
    for k in range(1, 25):
        command, plan, memory = controller().step(blind, memory)
        wanted = last.inputs[k] if k < 20 else BRAKING
        np.testing.assert_allclose(command.as_input(), wanted)
        np.testing.assert_array_equal(memory.command, command.as_input())
        assert plan.inputs.shape == (20, 5)
        assert plan.fallback is Fallback.NOT_FINITE


def test_sight_regained_is_a_plan_again() -> None:
    """After blind steps the plans that were moved on are improved again, as if nothing had been."""
    memory = planned(3)
    path = memory.plan.states
    for k in (1, 2):
        _, _, memory = controller().step(replace(seen(), state=np.full(6, np.nan)), memory)
        assert memory.age == k
    np.testing.assert_array_equal(memory.inputs[Side.LEFT], shifted(planned(3).inputs[Side.LEFT], 2))
    _, plan, memory = controller().step(seen(0.25, path[3]), memory)
    assert (plan.fallback, memory.age) == (None, 0)


def test_blind_it_stops_and_stays() -> None:
    """A vehicle whose sensors never work brakes to a standstill and does not begin to drive backwards."""
    from tests.control.unified.test_robustness import blinded

    motion = run(load("paper", ["obstacles=[]"]), plant="planar", sense=blinded(lambda k: True)).log.motion
    assert motion["vx"].min() > -0.5
    assert abs(motion["vx"][-1]) < 0.5


@pytest.mark.parametrize("value", [9e4, 1e6, -1e20, 1e300])
@pytest.mark.parametrize("place", PLACES)
def test_what_no_vehicle_measures_is_no_exception(place: str, value: float) -> None:
    """Numbers that are finite and absurd lead to some command within the limits: no exception, no warning."""
    memory = planned()
    command, plan, _ = controller().step(replace(broken_measurements(value)[place], time=0.05, stamp=0.05), memory)
    assert isinstance(command, Command)
    assert isinstance(plan, Plan)
    assert np.isfinite(command.as_input()).all()
    assert abs(command.steering_angle) <= 0.5


@pytest.mark.parametrize("loads", [np.zeros(4), -STATIC, STATIC * [0, 0, 1, 1], STATIC * 1e-9])
def test_wheels_that_carry_nothing_are_no_exception(loads: np.ndarray) -> None:
    """Lifted wheels, and loads that are nonsense, leave a command within the limits."""
    command, _, _ = controller().step(replace(seen(), wheel_loads=loads), planned())
    assert np.isfinite(command.as_input()).all()


@pytest.mark.parametrize("position", [(0.0, 0.0), (1.0, 0.0), (-1.9, 0.5), (2.0, 0.0)])
def test_an_obstacle_that_is_already_touched_is_no_exception(position: tuple[float, float]) -> None:
    """Inside or on the edge of an obstacle there is a plan that gets out, and no failure of a solver."""
    _, plan, _ = controller().step(seen(0.0, RUNNING, replace(AHEAD, motion=Steady(position))), controller().start())
    assert plan.fallback is None
    assert plan.solver_failures == 0


@pytest.mark.parametrize("state", [np.zeros(6), np.array([0.3, 0, 0, 0, 0, 0]), np.array([-5.0, 0, 0, 0, 0, 0])])
def test_standing_and_rolling_back_can_be_planned_from(state: np.ndarray) -> None:
    """At standstill and backwards there are plans as everywhere."""
    _, plan, _ = controller().step(seen(0.0, state), controller().start())
    assert plan.fallback is None
    assert np.isfinite(plan.states).all()


def test_many_obstacles_are_seen_at_once() -> None:
    """Each obstacle has its limit; with a dozen of them there is a plan that keeps clear of the one that matters."""
    others = [Obstacle(Ellipse((1.0, 1.0)), Steady((60.0 + 10 * k, 8.0))) for k in range(11)]
    memory = controller().start()
    assert isinstance(memory, Memory)
    _, plan, _ = controller().step(seen(0.0, RUNNING, AHEAD, *others), memory)
    _, alone, _ = controller().step(seen(), memory)
    np.testing.assert_allclose(plan.inputs, alone.inputs, atol=1e-3)


def test_without_obstacles_it_drives_on() -> None:
    """On an empty road at the wanted speed nothing is done."""
    command, plan, memory = controller().step(replace(seen(), obstacles=()), controller().start())
    np.testing.assert_allclose(command.as_input() / [1, 1e3, 1e3, 1e3, 1e3], 0.0, atol=1e-9)
    assert (plan.side, memory.committed) == (None, None)
