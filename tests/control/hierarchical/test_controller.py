"""The hierarchical controller: stays, brakes or swerves as it should, mirrors, and never raises."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.control import Controller, Fallback, Side
from swerve.control.hierarchical.memory import Memory
from swerve.scenario import load
from swerve.simulate import Outcome, run
from swerve.simulate.assemble import controller_named
from swerve.world import Ellipse, Obstacle, Steady
from tests.control.unified.situations import RUNNING, broken_measurements, seen

AT = 'obstacles.0.position=["{} m", "0 m"]'


@cache
def controller(*overrides: str) -> Controller[Memory]:
    """The hierarchical controller in the paper's scenario."""
    return controller_named("hierarchical", load("paper", overrides), "planar")


def decided(x: float, y: float = 0.0, *overrides: str) -> str:
    """The manoeuvre of the first step, with a disc of 2 m at a place."""
    subject = controller(*overrides)
    _, _, memory = subject.step(seen(0.0, RUNNING, Obstacle(Ellipse((2.0, 2.0)), Steady((x, y)))), subject.start())
    assert memory.manoeuvre is not None
    return memory.manoeuvre.name


@pytest.mark.parametrize(
    ("x", "y", "name"),
    [(150, 0, "keep"), (30, 3.5, "keep"), (38, 0, "brake"), (22, -0.5, "left"), (22, 0.5, "right"), (10, 0, "brake")],
)
def test_it_decides_by_what_is_feasible(x: float, y: float, name: str) -> None:
    """Far or beside: keep; room to stop: brake; too near for that: the shorter way round; too near for all: brake."""
    assert decided(x, y) == name


def test_it_stays_on_the_road() -> None:
    """Where the shorter way round is off the road it takes the other one."""
    assert decided(22, 0.2) == "right"
    assert decided(22, 0.2, "road.lane_width=3.5 m", "road.lanes_left=2") == "left"


@pytest.mark.slow
def test_it_swerves_and_returns() -> None:
    """At 18 m it goes round and is on its way back to the lane's middle at the end."""
    result = run(load("paper", [AT.format(18), "duration=6 s"]), "hierarchical", "planar").result
    assert result.outcome is Outcome.AVOIDED
    assert abs(result.lateral_offset.final) < 0.3
    assert result.decision in ("steer-left", "steer-right")
    assert result.fallback_steps == 0


def test_it_stops_before_a_wall_of_a_kind() -> None:
    """At 40 m it brakes to a stop at a distance and stays in its lane."""
    result = run(load("paper", [AT.format(40), "duration=6 s"]), "hierarchical", "planar").result
    assert result.outcome is Outcome.AVOIDED
    assert result.speed.final < 0.5
    assert result.max_steer < 1e-3
    assert result.decision == "brake"


def test_a_lane_change_is_clear_as_far_as_a_stop_would_take() -> None:
    """Fast on a slippery road, just too near to stop, it goes further aside than an obstacle far ahead is wide."""
    subject = controller("ego.speed=35 m/s", "goal.speed=35 m/s", "road.friction=0.5")
    ahead = Obstacle(Ellipse((2.0, 2.0)), Steady((148.6, 0.0)))
    _, plan, memory = subject.step(seen(0.0, np.array([35.0, 0, 0, 0, 0, 0]), ahead), subject.start())
    assert plan.side is Side.LEFT
    assert memory.manoeuvre is not None
    assert memory.manoeuvre.lateral.target > 2.1


def test_a_mirrored_scene_is_driven_mirrored() -> None:
    """The plan past the mirror image is the mirrored plan."""
    plans = [
        controller().step(seen(0.0, RUNNING, Obstacle(Ellipse((2.0, 2.0)), Steady((20.0, y)))), controller().start())[1]
        for y in (0.5, -0.5)
    ]
    assert (plans[0].side, plans[1].side) == (Side.RIGHT, Side.LEFT)
    assert [(plan.name, plan.branches[0].passing[0].side) for plan in plans] == [
        ("right", Side.RIGHT),
        ("left", Side.LEFT),
    ]
    mirrored = plans[1].inputs[:, [0, 2, 1, 4, 3]] * [-1, 1, 1, 1, 1]
    np.testing.assert_allclose(plans[0].inputs, mirrored, rtol=1e-6, atol=1e-3)


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e300])
def test_a_broken_measurement_is_a_fallback(value: float) -> None:
    """A number that is none, anywhere, is answered by the last plan and said to be."""
    subject = controller()
    _, plan, memory = subject.step(seen(), subject.start())
    for name, broken in broken_measurements(value).items():
        command, after, _ = subject.step(replace(broken, time=0.05, stamp=0.05), memory)
        assert after.fallback is Fallback.NOT_FINITE, name
        np.testing.assert_array_equal(command.as_input(), plan.inputs[1], err_msg=name)


@settings(deadline=None, max_examples=25)
@given(st.integers(0, 2**32 - 1))
def test_junk_never_raises(seed: int) -> None:
    """Whatever finite numbers are measured, the command is finite and within the lock."""
    random = np.random.default_rng(seed)
    subject, memory = controller(), controller().start()
    for k in range(3):
        rows = random.normal(0, 30, (random.integers(1, 4), 4))
        obstacles = [Obstacle(Ellipse((2.0, 1.0)), Steady((x, y), (vx, vy))) for x, y, vx, vy in rows.tolist()]
        state = random.normal(0, 1, 6) * 10.0 ** random.uniform(-2, 4, 6)
        measured = replace(seen(0.05 * k, state, *obstacles), wheel_loads=random.normal(3000, 4000, 4))
        command, _, memory = subject.step(measured, memory)
        assert np.isfinite(command.as_input()).all()
        assert abs(command.steering_angle) <= 0.5 + 1e-9
