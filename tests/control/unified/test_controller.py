"""The controller's step: what it answers to what it measures, and what it does when it can't plan."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from swerve.control import Fallback, Plan, Side
from swerve.control.fallback import shifted
from swerve.control.plan import Passing
from swerve.control.unified import UnifiedController
from swerve.control.unified.memory import Memory
from swerve.qp import Problem, Solution
from swerve.qp.solution import Status
from swerve.scenario import load
from swerve.signals import Command, Measurement
from swerve.simulate import run
from swerve.world import Ellipse, Obstacle, Rectangle, Steady, clearance
from tests.control.unified.situations import (
    AHEAD,
    BOX_CAR,
    LANES,
    RUNNING,
    broken_measurements,
    controller,
    empty,
    formulation,
    in_the_mirror,
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
    for name in ("side", "name", "is_shaped", "reason", "active", "fallback", "solver_failures"):
        assert getattr(plan, name) == getattr(plan_2, name)
    for branch, branch_2 in zip(plan.branches, plan_2.branches, strict=True):
        assert (branch.passing, branch.cost, branch.violation) == (branch_2.passing, branch_2.cost, branch_2.violation)
        np.testing.assert_array_equal(branch.poses, branch_2.poses)
    assert memory.committed == memory_2.committed


def frozen(value: Any) -> Any:
    """Everything in a value, deep down, as what can be compared."""
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, dict):
        return {key: frozen(each) for key, each in value.items()}
    if isinstance(value, tuple):
        return [frozen(each) for each in value]
    return frozen(vars(value)) if hasattr(value, "__dict__") and not isinstance(value, type) else repr(value)


def failing(monkeypatch: pytest.MonkeyPatch, status: Status = Status.FAILED) -> list[Problem]:
    """From here on the solver has no answer; the problems it was asked."""
    asked: list[Problem] = []

    def no_answer(problem: Problem, *rest: Any, **named: Any) -> Solution:
        asked.append(problem)
        return Solution.without_answer(problem, status, 0, "none")

    monkeypatch.setattr("swerve.control.unified.improve.solve", no_answer)
    return asked


def test_a_plan_is_what_it_says() -> None:
    """The command is the plan's first input, the plan begins at the measured state, and all ways were tried."""
    command, plan, memory = controller().step(seen(), controller().start())
    np.testing.assert_array_equal(command.as_input(), plan.inputs[0])
    np.testing.assert_array_equal(memory.command, plan.inputs[0])
    np.testing.assert_array_equal(plan.states[0], RUNNING)
    assert plan.inputs.shape == (20, 5)
    assert plan.states.shape == (21, 6)
    assert (plan.fallback, plan.solver_failures) == (None, 0)
    assert [branch.passing for branch in plan.branches] == [(Passing.BEHIND,), (Passing.LEFT,), (Passing.RIGHT,)]
    assert [branch.name for branch in plan.branches] == ["brake", "left", "right"]
    assert memory.plan is plan
    assert memory.count == 1


def test_equal_sides_go_left() -> None:
    """Straight ahead of the obstacle both sides cost the same, and the plan goes left from the first step on."""
    _, plan, memory = controller().step(seen(), controller().start())
    costs = {branch.name: branch.cost for branch in plan.branches}
    assert costs["left"] == pytest.approx(costs["right"], rel=1e-4)
    assert (plan.name, plan.side, plan.is_shaped) == ("left", Side.LEFT, True)
    assert memory.taken == memory.committed == (Passing.LEFT,)
    assert plan.states[-1, 5] > 0


def test_the_papers_scene_is_clear_at_first_sight() -> None:
    """In the very first step there is a plan that keeps its margin, by brute force along horizon and tail."""
    _, plan, _ = controller().step(seen(), controller().start())
    (left,) = (branch for branch in plan.branches if branch.name == "left")
    assert left.violation <= 5e-3
    assert clearance(formulation().place.footprint, left.poses, AHEAD, np.zeros(len(left.poses))).min() > 0


def test_the_same_step_gives_the_same_bits() -> None:
    """A step is a function of measurement and memory: asked twice, with other questions between, it answers alike."""
    memory = planned(3)
    assert memory.plan is not None
    state = memory.plan.states[1]
    first = controller().step(seen(0.15, state), memory)
    controller().step(seen(0.15, state * MIRROR), controller().start())
    assert_same(controller().step(seen(0.15, state), memory), first)


def test_a_step_changes_nothing_it_was_given() -> None:
    """Measurement and memory are as they were after a step, so that a run can be resumed from any of them."""
    memory = planned(2)
    assert memory.plan is not None
    measurement = seen(0.1, memory.plan.states[1].copy())
    known, told = frozen(memory), frozen(measurement)
    controller().step(measurement, memory)
    controller().step(replace(measurement, stamp=-1.0), memory)
    controller().step(replace(measurement, obstacles=()), memory)
    assert frozen(memory) == known
    assert frozen(measurement) == told


MIRRORED = (*BOX_CAR, "road.lane_width=3.5 m", "road.lanes_left=1", "road.lanes_right=1")


@pytest.mark.parametrize("of", [(), MIRRORED])
@pytest.mark.parametrize("lateral", [0.3, -0.8, 1.5])
def test_a_step_in_the_mirror_is_the_mirror_of_the_step(lateral: float, of: tuple[str, ...]) -> None:
    """With obstacle and state mirrored, the command is the mirror image."""
    state = random_start(np.random.default_rng(4))
    obstacle = Obstacle(Ellipse((2.0, 1.5)), Steady((26.0, lateral), heading=0.3))
    here = controller(*of).step(seen(0.0, state, obstacle), controller(*of).start())
    there = controller(*of).step(seen(0.0, state * MIRROR, in_the_mirror(obstacle)), controller(*of).start())
    np.testing.assert_allclose(there[0].as_input(), mirrored(here[0].as_input()), rtol=1e-5, atol=1e-5)
    assert here[1].side is None or there[1].side is Side(-here[1].side.value)
    costs, mirrored_costs = ({b.passing: b.cost for b in plan.branches} for plan in (here[1], there[1]))
    for passing, cost in costs.items():
        flipped = tuple(Passing(-each.value) for each in passing)
        assert mirrored_costs[flipped] == pytest.approx(cost, rel=1e-4)


# What is decided


def follow(measure: Any, n: int, *of: str) -> list[Plan]:
    """The plans of n steps, the vehicle following them; `measure` makes a measurement of time and state."""
    memory, state, plans = controller(*of).start(), RUNNING, []
    for k in range(n):
        _, plan, memory = controller(*of).step(measure(0.05 * k, state), memory)
        state = plan.states[1]
        plans.append(plan)
    return plans


def wall(x: float, lowest: float, highest: float) -> Obstacle:
    """A wall across the road, from one Y to another."""
    return Obstacle(Rectangle(1.0, highest - lowest), Steady((x, (lowest + highest) / 2)))


def test_in_front_of_a_wall_it_stops() -> None:
    """With no way round it brakes in time, straight, and stands before the wall."""
    across = wall(50.0, -30.0, 30.0)
    plans = follow(lambda time, state: seen(time, state, across), 90)
    assert {plan.name for plan in plans if plan.is_shaped} == {"brake"}
    assert all(plan.fallback is None for plan in plans)
    states = np.array([plan.states[0] for plan in plans])
    assert abs(states[-1, 0]) < 0.3
    assert 42.0 < states[-1, 4] < 49.5
    assert np.abs(states[:, 5]).max() < 0.1
    assert (np.diff(states[:, 4]) > -0.01).all()  # it may roll back a little, for a gap of its comfort


@pytest.mark.parametrize(("lowest", "highest", "names"), [(-1.0, 30.0, {"right"}), (-30.0, 1.0, {"left"})])
def test_where_one_side_is_closed_it_takes_the_other(lowest: float, highest: float, names: set[str]) -> None:
    """A wall that leaves room on one side alone, too near to stop, is passed there."""
    plans = follow(lambda time, state: seen(time, state, wall(24.0, lowest, highest)), 12)
    assert {plan.name for plan in plans if plan.is_shaped} == names
    assert max(branch.violation for plan in plans[1:] for branch in plan.branches if branch.name in names) <= 0.02


def test_where_an_edge_closes_the_left_it_goes_right_or_stops() -> None:
    """With its lane the leftmost of the road there is no passing on the left."""
    of = (*BOX_CAR, "road.lane_width=3.5 m", "road.lanes_left=0", "road.lanes_right=1")
    plans = follow(lambda time, state: seen(time, state, AHEAD), 20, *of)
    assert {plan.name for plan in plans if plan.is_shaped} <= {"right", "brake"}
    assert plans[0].name == "right"


def test_where_both_edges_close_it_brakes() -> None:
    """On a single lane there is only the brake."""
    of = (*BOX_CAR, "road.lane_width=3.5 m", "road.lanes_left=0", "road.lanes_right=0")
    plans = follow(lambda time, state: empty(time, state, wall(50.0, -1.5, 1.5)), 20, *of)
    assert {plan.name for plan in plans if plan.is_shaped} == {"brake"}


@pytest.mark.parametrize("of", [(), (*BOX_CAR, *LANES)])
def test_where_nothing_threatens_it_is_the_plan_of_an_empty_road(of: tuple[str, ...]) -> None:
    """A car in the lane beside the next, one that is followed far ahead and one behind change nothing but rounding."""
    car = Rectangle(4.5, 1.8)
    others = [Obstacle(car, Steady((60.0, 0.0), (20.0, 0.0))), Obstacle(car, Steady((-20.0, 0.0), (20.0, 0.0)))]
    others += [Obstacle(car, Steady((90.0, 5.0), (15.0, 0.0)))]
    drifted = RUNNING + np.array([-1.0, 0.05, 0.01, 0.002, 0.0, 0.1])
    for state in (RUNNING, drifted):
        alone = controller(*of).step(empty(0.0, state), controller(*of).start())
        beside = controller(*of).step(empty(0.0, state, *others), controller(*of).start())
        np.testing.assert_allclose(beside[1].inputs, alone[1].inputs, rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(beside[1].states, alone[1].states, rtol=1e-9, atol=1e-9)
        assert beside[1].name == alone[1].name == "keep"
        assert (beside[1].side, beside[1].is_shaped, beside[2].committed) == (None, False, None)


def test_a_slalom_is_a_way() -> None:
    """One after the other, the first half on the right and the second half on the left: left, then right."""
    car = Rectangle(4.5, 1.8)
    two = [Obstacle(car, Steady((28.0, -0.9))), Obstacle(car, Steady((60.0, 0.9)))]
    plans = follow(lambda time, state: seen(time, state, *two), 60)
    assert plans[0].name.startswith("left")
    poses = np.array([plan.states[0][[4, 5, 3]] for plan in plans])
    assert min(clearance(formulation().place.footprint, poses, each, np.zeros(60)).min() for each in two) > 0


def test_a_car_that_brakes_in_front_is_not_hit() -> None:
    """Followed at 25 m, a car that brakes at 6 m/s^2 is not touched, on a road with no way round."""
    of = (*BOX_CAR, "road.lane_width=3.5 m", "road.lanes_left=0", "road.lanes_right=0")

    def lead(time: float) -> tuple[float, float]:
        lasted = min(time, 20.0 / 6.0)
        return 30.0 + 20.0 * lasted - 3.0 * lasted**2, 20.0 - 6.0 * lasted

    def measure(time: float, state: np.ndarray) -> Measurement:
        x, speed = lead(time)
        here = Obstacle(Rectangle(4.5, 1.8), Steady((x - speed * time, 0.0), (speed, 0.0)))
        return seen(time, state, here)

    plans = follow(measure, 100, *of)
    front = formulation(*of).place.footprint.support([[1.0, 0.0]])[0]
    gaps = [lead(0.05 * k)[0] - 2.25 - plan.states[0, 4] - front for k, plan in enumerate(plans)]
    assert min(gaps) > 0.0
    assert plans[-1].states[0, 0] < 1.0


# When time is short


def test_a_clock_that_is_always_over_leaves_a_fallback() -> None:
    """Late from the start, every step is counted as such, follows what there is, and raises nothing."""
    now = iter(range(10**6))
    hurried = UnifiedController(formulation(), clock=lambda: float(next(now)))
    memory = planned(2)
    command, plan, after = hurried.step(seen(0.1, memory.plan.states[1]), memory)
    assert plan.fallback is Fallback.DEADLINE
    np.testing.assert_array_equal(command.as_input(), memory.plan.inputs[1])
    assert after.age == 1
    command, plan, _ = hurried.step(seen(), hurried.start())
    assert plan.fallback is Fallback.DEADLINE
    assert np.isfinite(command.as_input()).all()
    assert (command.wheel_forces < 0).all()


def test_a_clock_that_stands_is_all_the_time_there_is() -> None:
    """With a clock that never moves the plan is that of a step without any deadline."""
    calm = UnifiedController(formulation(), clock=lambda: 0.0)
    ample = controller("controller.unified.deadline=1")
    _, plan, _ = calm.step(seen(), calm.start())
    _, wanted, _ = ample.step(seen(), ample.start())
    assert plan.fallback is None
    assert [b.name for b in plan.branches] == [b.name for b in wanted.branches]


def test_next_to_no_time_is_one_program_a_way() -> None:
    """With an allowance that is used up at once each way still has its one program: a plan, and no fallback."""
    hurried = controller("controller.unified.deadline=1e-6")
    memory, state = hurried.start(), RUNNING
    for k in range(30):
        command, plan, memory = hurried.step(seen(0.05 * k, state), memory)
        assert plan.fallback is None
        assert np.isfinite(command.as_input()).all()
        state = plan.states[1]


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
@pytest.mark.parametrize("ahead", [25.0, 60.0, None])
def test_a_solver_that_fails_is_no_exception(
    monkeypatch: pytest.MonkeyPatch, status: Status, ahead: float | None
) -> None:
    """Where no program has an answer by either solver the last plan goes on, as long as it is clear; each program that
    failed is counted once, and no other.
    """
    memory = planned()
    asked = failing(monkeypatch, status)
    obstacles = () if ahead is None else (replace(AHEAD, motion=Steady((ahead, 0.0))),)
    measurement = empty(0.05, memory.plan.states[1], *obstacles)
    command, plan, _ = controller().step(measurement, memory)
    assert plan.fallback is Fallback.NO_SOLUTION
    assert 2 * plan.solver_failures == len(asked) > 0
    np.testing.assert_array_equal(command.as_input(), memory.plan.inputs[1])


def test_a_plan_that_is_not_clear_any_more_is_not_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where no program has an answer and the last plan now leads into a wall, it brakes with all it has."""
    memory = planned()
    failing(monkeypatch)
    command, plan, after = controller().step(seen(0.05, memory.plan.states[1], wall(45.0, -30.0, 30.0)), memory)
    assert (plan.fallback, plan.name) == (Fallback.NO_SOLUTION, "full braking")
    assert (command.wheel_forces < -0.3 * 0.85 * STATIC).all()
    assert after.plan is plan


def test_a_fallback_is_within_what_the_wheels_carry_now(monkeypatch: pytest.MonkeyPatch) -> None:
    """A plan made at other loads is cut to the friction of the loads that were measured last."""
    across = wall(40.0, -30.0, 30.0)
    _, _, memory = controller().step(seen(0.0, RUNNING, across), controller().start())
    assert memory.plan is not None
    failing(monkeypatch)
    light = STATIC * np.array([0.2, 1.0, 0.3, 1.0])
    measurement = replace(seen(0.05, memory.plan.states[1], across), wheel_loads=light)
    command, plan, _ = controller().step(measurement, memory)
    assert plan.fallback is Fallback.NO_SOLUTION
    assert (np.abs(command.wheel_forces) <= 0.95 * 0.85 * light + 1e-9).all()


def test_a_solver_that_fails_once_costs_one_iteration(monkeypatch: pytest.MonkeyPatch) -> None:
    """One program that both solvers fail at is counted, and the step still has a plan of its own."""
    from swerve.control.unified import improve

    solve, calls = improve.solve, []

    def sometimes(problem: Problem, *rest: Any, **named: Any) -> Solution:
        calls.append(problem)
        if calls[0] is problem:
            return Solution.without_answer(problem, Status.FAILED, 0, "none")
        return solve(problem, *rest, **named)

    monkeypatch.setattr(improve, "solve", sometimes)
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
    """Blind after one plan, it drives that plan's inputs one after the other, then brakes straight, as hard as the
    lateral demand leaves.
    """
    memory = planned()
    last = memory.plan
    blind = replace(seen(), state=np.full(6, np.nan))
    for k in range(1, 25):
        command, plan, memory = controller().step(blind, memory)
        if k < 20:
            np.testing.assert_allclose(command.as_input(), last.inputs[k])
        else:
            assert command.steering_angle == 0
            assert (command.wheel_forces >= BRAKING[1:] - 1e-9).all()
            assert (command.wheel_forces <= 0.3 * BRAKING[1:]).all()
        np.testing.assert_array_equal(memory.command, command.as_input())
        assert plan.inputs.shape == (20, 5)
        assert plan.fallback is Fallback.NOT_FINITE
        assert plan.name == (last.name if k < 20 else "full braking")


def test_sight_regained_is_a_plan_again() -> None:
    """After blind steps the plans that were moved on are improved again, as if nothing had been."""
    memory = planned(3)
    path = memory.plan.states
    for k in (1, 2):
        _, _, memory = controller().step(replace(seen(), state=np.full(6, np.nan)), memory)
        assert memory.age == k
    left = (Passing.LEFT,)
    np.testing.assert_array_equal(memory.inputs[left], shifted(planned(3).inputs[left], 2))
    _, plan, memory = controller().step(seen(0.25, path[3]), memory)
    assert (plan.fallback, memory.age, plan.name) == (None, 0, "left")


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
    """Inside or on the edge of an obstacle there is a plan of some kind, and no failure of a solver."""
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
    """Each obstacle has its limit; with a dozen of them the plan is the one for the obstacle that matters."""
    others = [Obstacle(Ellipse((1.0, 1.0)), Steady((60.0 + 10 * k, 12.0))) for k in range(11)]
    memory = controller().start()
    assert isinstance(memory, Memory)
    _, plan, _ = controller().step(seen(0.0, RUNNING, AHEAD, *others), memory)
    _, alone, _ = controller().step(seen(), memory)
    assert plan.name == alone.name
    np.testing.assert_allclose(plan.inputs / [1, 1e3, 1e3, 1e3, 1e3], alone.inputs / [1, 1e3, 1e3, 1e3, 1e3], atol=1e-3)


@pytest.mark.parametrize("n", [4, 8])
def test_many_obstacles_in_the_path_are_no_exception(n: int) -> None:
    """More obstacles in the path than sides are tried for: a plan, and a handful of branches."""
    crowd = [Obstacle(Ellipse((1.0, 1.0)), Steady((25.0 + 6 * k, 0.4 * (-1) ** k))) for k in range(n)]
    _, plan, _ = controller().step(seen(0.0, RUNNING, *crowd), controller().start())
    assert plan.fallback is None
    assert 2 <= len(plan.branches) <= 4
    assert all(len(branch.passing) == n for branch in plan.branches)


def test_obstacles_come_and_go() -> None:
    """From step to step there may be more of them or fewer, in any order: always a plan of its own."""
    memory, state = controller().start(), RUNNING
    far = Obstacle(Ellipse((1.0, 1.0)), Steady((80.0, 6.0)))
    for k, obstacles in enumerate([(AHEAD,), (AHEAD, far), (far, AHEAD), (), (AHEAD,), (far,)]):
        _, plan, memory = controller().step(empty(0.05 * k, state, *obstacles), memory)
        assert plan.fallback is None
        assert len(memory.forecasts) == len(obstacles)
        state = plan.states[1]


def test_without_obstacles_it_drives_on() -> None:
    """On an empty road at the wanted speed nothing is done."""
    command, plan, memory = controller().step(replace(seen(), obstacles=()), controller().start())
    np.testing.assert_allclose(command.as_input() / [1, 1e3, 1e3, 1e3, 1e3], 0.0, atol=1e-9)
    assert (plan.side, plan.name, plan.is_shaped, memory.committed) == (None, "keep", False, None)
    assert plan.reason == "the only way"
