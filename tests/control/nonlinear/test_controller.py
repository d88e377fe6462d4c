"""The nonlinear controller: drives as it should, mirrored scenes mirrored, and never raises."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from swerve.control import Controller, Fallback, Side
from swerve.control.nonlinear import SOLVERS, NonlinearController, Question
from swerve.control.nonlinear.memory import Memory
from swerve.control.nonlinear.program import NonlinearProgram
from swerve.scenario import load, parse
from swerve.signals import ABSURD
from swerve.simulate import Outcome, run
from swerve.simulate.assemble import controller_named
from swerve.world import Ellipse, Obstacle, Steady
from tests.control.unified.situations import RUNNING, broken_measurements, seen

AT = 'obstacles.0.position=["{} m", "0 m"]'
SLIPPERY = ("ego.speed=25 m/s", "goal.speed=25 m/s", "road.friction=0.5")
RECTANGLES = """
name = "rectangles"
duration = "2.5 s"
road = { friction = 0.85 }
ego = { position = ["0 m", "0 m"], speed = "72 km/h", footprint = "rectangle" }
goal = { speed = "72 km/h", lateral_offset = "0 m" }
obstacles = [
    { position = ["27 m", "0 m"], size = ["4.5 m", "1.8 m"] },
    { position = ["55 m", "5 m"], velocity = ["-10 m/s", "0 m/s"], size = ["4.5 m", "1.8 m"] },
]
"""


@cache
def controller(*overrides: str) -> Controller[Memory]:
    """The nonlinear controller of the paper's scenario."""
    return controller_named("nonlinear", load("paper", overrides), "planar")


@pytest.mark.slow
@pytest.mark.parametrize("distance", [25.0, 15.2])
def test_it_avoids_what_can_be_avoided(distance: float) -> None:
    """It drives round the paper's obstacle, also at 15.2 m, and every program of the way is solved."""
    result = run(load("paper", ["duration=2.5 s", AT.format(distance)]), "nonlinear", "planar").result
    assert result.outcome is Outcome.AVOIDED
    assert result.min_distance_ratio is not None
    assert 1 <= result.min_distance_ratio <= 1.1
    assert (result.solver_failures, result.fallback_steps) == (0, 0)
    assert result.decision in ("steer-left", "brake+steer-left")  # of two sides that are alike the left one


@pytest.mark.slow
def test_an_obstacle_that_comes_into_sight_late_is_avoided() -> None:
    """On a road so slippery that a swerve takes all of the horizon it drives round in time, every program solved."""
    result = run(load("paper", [*SLIPPERY, "duration=2.5 s", AT.format(28.0)]), "nonlinear", "planar").result
    assert result.outcome is Outcome.AVOIDED
    assert (result.solver_failures, result.fallback_steps) == (0, 0)


@pytest.mark.parametrize("distance", [40.0, 26.25, 25.0])
def test_an_obstacle_at_the_end_of_the_horizon_is_planned_for(distance: float) -> None:
    """An obstacle beyond the horizon's end, or just within it, is planned for: both sides are solved and keep clear."""
    subject = controller(*SLIPPERY)
    state = np.array([25.0, 0, 0, 0, 0, 0])
    seen_there = seen(0.0, state, Obstacle(Ellipse((2.0, 2.0)), Steady((distance, 0.0))))
    _, plan, _ = subject.step(seen_there, subject.start())
    assert (plan.fallback, plan.solver_failures) == (None, 0)
    assert [each.impact_speed for each in plan.branches] == [None, None]
    assert np.hypot(plan.states[:, 4] - distance, plan.states[:, 5]).min() >= 2.0


def test_what_is_not_solved_is_still_a_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    """Stopped long before the solution, it says so, and commands a motion that costs less than going straight."""
    monkeypatch.setitem(SOLVERS["fatrop"], "max_iter", 4)
    subject = controller_named("nonlinear", load("paper"), "planar")
    assert isinstance(subject, NonlinearController)
    obstacle = Obstacle(Ellipse((2.0, 2.0)), Steady((17.0, 0.0)))
    measured = seen(0.0, RUNNING, obstacle)
    _, plan, _ = subject.step(measured, subject.start())
    assert (plan.fallback, plan.solver_failures) == (Fallback.NO_SOLUTION, 2)
    assert "quadratic" not in Fallback.NO_SOLUTION.value
    rolled_out = subject.program.model.roll_out(plan.states[0], plan.inputs, measured.wheel_loads)
    np.testing.assert_allclose(rolled_out.states, plan.states)
    question = Question(plan.states[0], np.zeros(5), measured.wheel_loads, (obstacle,))
    straight = subject.program.guess(question, np.zeros_like(plan.inputs))
    assert min(each.cost for each in plan.branches) < 0.5 * straight.cost


@pytest.mark.slow
def test_the_other_solver_drives_round_too() -> None:
    """IPOPT in a loop of its own gets past on as short a way, every program solved."""
    changed = ["duration=1.5 s", 'controller.nonlinear.solver="ipopt"']
    result = run(load("paper", changed), "nonlinear", "planar").result
    assert result.outcome is Outcome.AVOIDED
    assert result.min_distance_ratio is not None
    assert 1 <= result.min_distance_ratio <= 1.1
    assert result.solver_failures == 0


@pytest.mark.slow
def test_rectangles_are_kept_apart() -> None:
    """A rectangular vehicle gets past a parked one and an oncoming one, by the plant's own geometry."""
    result = run(parse(RECTANGLES.encode(), "rectangles"), "nonlinear", "planar").result
    assert result.outcome is Outcome.AVOIDED
    assert result.min_clearance is not None
    assert result.min_clearance > 0


@pytest.mark.parametrize("offset", [0.6, -0.6])
def test_a_mirrored_scene_is_driven_mirrored(offset: float) -> None:
    """An obstacle on the right is passed on the left, and the mirror image on the right by the mirrored inputs."""
    plans = [
        controller().step(seen(0.0, RUNNING, Obstacle(Ellipse((2.0, 2.0)), Steady((18.0, y)))), controller().start())[1]
        for y in (offset, -offset)
    ]
    assert plans[0].side is Side(int(-np.sign(offset)))
    assert plans[1].side is Side(int(np.sign(offset)))
    for plan in plans:
        assert [(each.name, each.passing[0].side) for each in plan.branches] == [
            ("left", Side.LEFT),
            ("right", Side.RIGHT),
        ]
        assert plan.name == min(plan.branches, key=lambda each: each.cost).name
        assert max(each.violation for each in plan.branches) < 0.025  # of a chord of half a sample, 0.5 m
    mirrored = plans[1].inputs[:, [0, 2, 1, 4, 3]] * [-1, 1, 1, 1, 1]
    np.testing.assert_allclose(plans[0].inputs, mirrored, atol=2.0, rtol=1e-3)


def test_a_plan_is_named_after_its_path() -> None:
    """While an obstacle comes into sight, left is where the plan passes on the left, wherever it was begun."""
    scenario = load("paper", [*SLIPPERY, "duration=1 s", AT.format(58.7)])
    plans = [each for each in run(scenario, "nonlinear", "planar").plans if each.side is not None]
    assert len(plans) > 5
    for plan in plans:
        nearest = np.hypot(plan.states[:, 4] - 58.7, plan.states[:, 5]).argmin()
        assert plan.side.value * plan.states[nearest, 5] > 0, plan.time
        assert plan.name == plan.side.name.lower()


@pytest.mark.parametrize(("distance", "n_solved"), [(200.0, 1), (18.0, 2)])
def test_what_nothing_is_in_the_way_of_is_planned_once(
    monkeypatch: pytest.MonkeyPatch, distance: float, n_solved: int
) -> None:
    """One program is solved where no obstacle is near, one for each side in front of one."""
    subject, solved = controller(), []
    solve = NonlinearProgram.solve
    monkeypatch.setattr(NonlinearProgram, "solve", lambda *args: solved.append(args) or solve(*args))
    _, plan, _ = subject.step(
        seen(0.0, RUNNING, Obstacle(Ellipse((2.0, 2.0)), Steady((distance, 0.0)))), subject.start()
    )
    assert len(solved) == n_solved
    assert plan.is_shaped is (n_solved > 1)


@pytest.mark.parametrize("speed", [20.0, 1e5, np.nextafter(ABSURD, 0)])
def test_an_obstacle_out_of_sight_shapes_nothing(speed: float) -> None:
    """Where the sensor sees fewer obstacles than the program has room for, also when the model's motion diverges."""
    subject = controller()
    state = np.array([speed, -0.9 * speed, 30.0, 1.0, 0.0, 0.0])
    _, plan, _ = subject.step(replace(seen(0.0, state), obstacles=()), subject.start())
    assert (plan.is_shaped, plan.side) == (False, None)


def test_the_steering_rate_is_kept() -> None:
    """With a slow actuator no two planned steering angles, nor the first and the last command, are further apart."""
    slow = controller("ego.parameters.steering_rate_limit=0.4 rad/s")
    _, plan, _ = slow.step(seen(0.0, RUNNING, Obstacle(Ellipse((2.0, 2.0)), Steady((17.0, 0.0)))), slow.start())
    steering = np.append(0.0, plan.inputs[:, 0])
    assert np.abs(np.diff(steering)).max() <= 0.4 * 0.05 + 1e-6
    assert np.abs(steering).max() > 0.03


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e300])
def test_a_broken_measurement_is_a_fallback(value: float) -> None:
    """A number that is none, anywhere, is answered by the last plan and said to be."""
    subject = controller()
    _, plan, memory = subject.step(seen(), subject.start())
    for name, broken in broken_measurements(value).items():
        command, after, _ = subject.step(replace(broken, time=0.05, stamp=0.05), memory)
        assert after.fallback is Fallback.NOT_FINITE, name
        np.testing.assert_array_equal(command.as_input(), plan.inputs[1], err_msg=name)


@pytest.mark.slow
@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(st.integers(0, 2**32 - 1))
def test_junk_never_raises(seed: int) -> None:
    """Whatever finite numbers are measured, and however many obstacles, the command is finite and within the lock."""
    random = np.random.default_rng(seed)
    subject = controller()
    obstacles = [
        Obstacle(Ellipse((float(random.uniform(0.1, 5)), 1.0)), Steady((float(x), float(y)), (float(vx), float(vy))))
        for x, y, vx, vy in random.normal(0, 30, (random.integers(0, 4), 4))
    ]
    state = random.normal(0, 1, 6) * 10.0 ** random.uniform(-2, 4, 6)
    measured = seen(0.0, state, *obstacles)
    measured = replace(
        measured, wheel_loads=random.normal(3000, 4000, 4), obstacles=measured.obstacles[: len(obstacles)]
    )
    command, _, _ = subject.step(measured, subject.start())
    assert np.isfinite(command.as_input()).all()
    assert abs(command.steering_angle) <= 0.5 + 1e-6
