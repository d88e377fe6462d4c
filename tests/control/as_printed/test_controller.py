"""The paper's controller as a whole: what it does, and what it does where its program has no solution."""

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.control import Fallback, Side
from swerve.control.as_printed import AsPrintedController
from swerve.control.as_printed.controller import Memory
from swerve.qp import Problem
from swerve.scenario import CORRECTIONS, load
from swerve.simulate import run
from swerve.simulate.assemble import controller_named
from swerve.world import Ellipse, Obstacle, Rectangle, Steady
from tests.control.unified.situations import AHEAD, RUNNING, broken_measurements, seen
from tests.vehicle.motions import STATIC

ALL = ("mass", "drift", "hold-input", "jacobian", "discretisation")


@cache
def controller(*corrections: str) -> AsPrintedController:
    """The paper's controller with some misprints put right."""
    words = ", ".join(f'"{each}"' for each in corrections)
    scenario = load("paper", [f"controller.as_printed.corrections=[{words}]"])
    made: Any = controller_named("as-printed", scenario, "planar")
    return made


def asked(monkeypatch: pytest.MonkeyPatch, corrections: tuple[str, ...], *step: Any) -> Problem:
    """The quadratic program that a step solves."""
    from swerve.control.as_printed import controller as module

    problems, solve = [], module.solve
    monkeypatch.setattr(module, "solve", lambda problem: problems.append(problem) or solve(problem))
    controller(*corrections).step(*step)
    return problems[0]


def test_every_correction_has_its_switch() -> None:
    """The corrections of the scenario file are the five misprints, no more and no fewer."""
    assert tuple(CORRECTIONS) == ALL


@pytest.mark.parametrize("correction", ALL)
def test_each_switch_changes_the_program(monkeypatch: pytest.MonkeyPatch, correction: str) -> None:
    """At a state where the vehicle turns and brakes, each correction alone makes another program of the step."""
    state, memory = np.array([19.0, 0.5, 0.2, 0.1, 0.0, 0.3]), Memory(np.array([0.03, -400.0, -300.0, -200.0, -100.0]))
    plain = asked(monkeypatch, (), seen(0.0, state), memory)
    corrected = asked(monkeypatch, (correction,), seen(0.0, state), memory)
    differs = [
        name
        for name in ("hessian", "gradient", "rows", "row_lower")
        if not np.array_equal(getattr(plain, name), getattr(corrected, name))
    ]
    changed_by_drift_alone = ["gradient", "row_lower"]
    assert differs == (changed_by_drift_alone if correction == "drift" else differs)
    assert differs


def test_the_obstacle_is_linearised_where_the_vehicle_is(monkeypatch: pytest.MonkeyPatch) -> None:
    """(15): 1 - rho_k on the right, rho_k and its gradient at (X_k, Y_k), for an ellipse with a heading."""
    obstacle = Obstacle(Ellipse((3.0, 1.5)), Steady((20.0, 1.0), heading=0.4))
    state = np.array([20.0, 0, 0, 0, 2.0, -0.5])
    problem = asked(monkeypatch, (), seen(0.0, state, obstacle), Memory(np.zeros(5)))

    def rho(x: float, y: float) -> float:
        dx, dy = x - 20.0, y - 1.0
        along, across = dx * np.cos(0.4) + dy * np.sin(0.4), -dx * np.sin(0.4) + dy * np.cos(0.4)
        return (along / 3.0) ** 2 + (across / 1.5) ** 2

    np.testing.assert_allclose(problem.row_lower[-20:], 1 - rho(2.0, -0.5), rtol=1e-12)
    assert np.isinf(problem.row_upper[-20:]).all()
    p1 = (rho(2.0 + 1e-5, -0.5) - rho(2.0 - 1e-5, -0.5)) / 2e-5
    # of W only the drift-free double integration is left: X~ after two samples from the first wheel force
    moved = 0.05**2 / 1530.0
    np.testing.assert_allclose(problem.rows[-20 + 1, 1] / 1e3, p1 * moved, rtol=1e-6)


def test_a_moving_obstacle_is_met_where_it_will_be(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each sample has the rho of the obstacle's position at that sample."""
    leading = Obstacle(Ellipse((2.0, 2.0)), Steady((25.0, 0.0), velocity=(10.0, 0.0)))
    problem = asked(monkeypatch, (), seen(0.0, RUNNING, leading), Memory(np.zeros(5)))
    distance = 25.0 + 10.0 * 0.05 * np.arange(1, 21)
    np.testing.assert_allclose(problem.row_lower[-20:], 1 - (distance / 2) ** 2, rtol=1e-12)


def test_a_rectangle_is_taken_by_an_ellipse_round_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """The paper knows ellipses alone: a box counts as the ellipse of its proportions through its corners."""
    box = Obstacle(Rectangle(4.0, 2.0), Steady((25.0, 0.0)))
    ellipse = Obstacle(Ellipse((np.sqrt(2) * 2.0, np.sqrt(2) * 1.0)), Steady((25.0, 0.0)))
    first = asked(monkeypatch, (), seen(0.0, RUNNING, box), Memory(np.zeros(5)))
    second = asked(monkeypatch, (), seen(0.0, RUNNING, ellipse), Memory(np.zeros(5)))
    np.testing.assert_allclose(first.row_lower, second.row_lower)
    np.testing.assert_allclose(first.rows, second.rows)


def test_the_command_is_the_first_change() -> None:
    """The receding horizon: the plan's first input is commanded and acts at the next step."""
    command, plan, memory = controller(*ALL).step(
        seen(0.0, RUNNING, replace(AHEAD, motion=Steady((40.0, 0.5)))), Memory(np.zeros(5))
    )
    np.testing.assert_array_equal(command.as_input(), plan.inputs[0])
    np.testing.assert_array_equal(memory.command, plan.inputs[0])
    assert plan.states.shape == (21, 6)
    assert plan.inputs.shape == (20, 5)
    np.testing.assert_array_equal(plan.states[0], RUNNING)
    np.testing.assert_allclose(plan.inputs[15:], np.tile(plan.inputs[14], (5, 1)))


def test_without_holding_the_plan_falls_back() -> None:
    """MISPRINT 4 is in the plan: after Nc the predicted input is the one that acts now."""
    memory = Memory(np.array([0.01, -100.0, -100.0, 0.0, 0.0]))
    _, plan, _ = controller("drift", "jacobian", "mass").step(seen(), memory)
    np.testing.assert_allclose(plan.inputs[15:], np.tile(memory.command, (5, 1)))


@settings(max_examples=25)
@given(st.integers(0, 2**32 - 1), st.sampled_from([(), ("mass",), ALL]))
def test_commands_are_within_the_limits(seed: int, corrections: tuple[str, ...]) -> None:
    """Whatever is measured, a command that the program gave is within lock and share of the friction circle."""
    random = np.random.default_rng(seed)
    state = random.normal([20, 0, 0, 0, 0, 0], [4, 1, 0.5, 0.2, 2, 2])
    memory = Memory(np.array([0.1, 500, -500, 500, -500]) * random.uniform(-1, 1, 5))
    command, plan, _ = controller(*corrections).step(seen(0.0, state), memory)
    if plan.fallback is None:
        assert abs(command.steering_angle) <= 0.5 * (1 + 1e-6)
        assert (np.abs(command.wheel_forces) <= 0.95 * 0.85 * STATIC * (1 + 1e-6)).all()


@pytest.mark.parametrize("corrections", [(), ALL])
def test_without_a_solution_the_command_is_held(corrections: tuple[str, ...]) -> None:
    """On top of an obstacle the hard program is infeasible: the last command stays, and the failure is counted."""
    memory = Memory(np.array([0.02, -300.0, -300.0, -100.0, -100.0]))
    inside = replace(AHEAD, motion=Steady((0.0, 0.0)))
    command, plan, after = controller(*corrections).step(seen(0.0, RUNNING, inside), memory)
    np.testing.assert_array_equal(command.as_input(), memory.command)
    assert (plan.fallback, plan.solver_failures) == (Fallback.NO_SOLUTION, 1)
    assert after is memory
    assert plan.states.shape == (0, 6)
    np.testing.assert_array_equal(plan.inputs, np.tile(memory.command, (20, 1)))


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("place", list(broken_measurements(np.nan)))
def test_what_is_not_finite_holds_the_command(place: str, value: float) -> None:
    """One number that is none, anywhere in the measurement: the last command stays, and the plan says why."""
    memory = Memory(np.array([0.02, -300.0, -300.0, -100.0, -100.0]))
    command, plan, _ = controller().step(broken_measurements(value)[place], memory)
    assert plan.fallback is Fallback.NOT_FINITE
    np.testing.assert_array_equal(command.as_input(), memory.command)


def test_what_is_too_old_holds_the_command() -> None:
    """A measurement older than half a sample is not planned from."""
    command, plan, _ = controller().step(replace(seen(1.0), stamp=0.96), Memory(np.full(5, 0.1)))
    assert plan.fallback is Fallback.LATE
    np.testing.assert_array_equal(command.as_input(), np.full(5, 0.1))


def test_as_printed_it_collides() -> None:
    """In the paper's own scenario the predicted car does not move, so the real one drives straight into the
    obstacle.
    """
    result = run(load("paper"), "as-printed", "planar").result
    assert result.outcome.value == "collided"
    assert result.min_distance_ratio == pytest.approx(0.0, abs=1e-6)
    assert result.impact_speed == pytest.approx(20.0)
    assert result.decision == "none"


def test_with_the_drift_alone_the_hard_program_is_often_infeasible() -> None:
    """The wall of the first-order obstacle stands half way: with the drift put right, many steps have no solution."""
    result = run(load("paper", ['controller.as_printed.corrections=["drift"]']), "as-printed", "planar").result
    assert result.solver_failures == result.fallback_steps >= 20


def test_the_side_is_named_where_an_obstacle_holds_the_plan() -> None:
    """A plan that no obstacle touches has no side; one that an obstacle pushes has the side to which it goes."""
    _, plan, _ = controller(*ALL).step(replace(seen(), obstacles=()), Memory(np.zeros(5)))
    assert plan.side is None
    for lateral, side in ((0.8, Side.RIGHT), (-0.8, Side.LEFT)):
        _, plan, _ = controller(*ALL).step(
            seen(0.0, RUNNING, replace(AHEAD, motion=Steady((38.0, lateral)))), Memory(np.zeros(5))
        )
        assert plan.side is side
