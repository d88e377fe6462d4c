"""The emergency brake: stops in the distance of the closed form, and leaves alone what is no threat."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.control import Controller, Fallback
from swerve.control.brake.memory import Memory
from swerve.conventions import GRAVITY
from swerve.scenario import load
from swerve.scenario.loader import parse
from swerve.simulate import Outcome, Run, run
from swerve.simulate.assemble import controller_named
from swerve.world import Ellipse, Obstacle, Steady
from tests.control.unified.situations import RUNNING, broken_measurements, seen

AT = 'obstacles.0.position=["{} m", "0 m"]'
STOP = 20**2 / (2 * 0.95 * 0.85 * GRAVITY)  # [m] from 20 m/s with |Fx| <= 0.95 mu Fz
CAR = """
name = "car"
duration = "3 s"
road = {{ friction = 0.85 }}
ego = {{ position = ["0 m", "0 m"], speed = "72 km/h", footprint = "rectangle" }}
goal = {{ speed = "72 km/h", lateral_offset = "0 m" }}
obstacles = [{{ position = ["{x} m", "{y} m"], velocity = ["{vx} m/s", "{vy} m/s"], size = ["4.5 m", "1.8 m"] }}]
"""


@cache
def controller(*overrides: str) -> Controller[Memory]:
    """The emergency brake in the paper's scenario."""
    return controller_named("brake", load("paper", overrides), "planar")


def beside_a_car(x: float, y: float, vx: float, vy: float = 0.0) -> Run:
    """A run of 3 s from 20 m/s near another car."""
    return run(parse(CAR.format(x=x, y=y, vx=vx, vy=vy).encode(), "car"), "brake", "planar")


def braked(done: Run) -> bool:
    """Whether a wheel ever braked noticeably."""
    return bool((done.log.steps.stack("Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr") < -50).any())


def test_it_stops_within_the_closed_form() -> None:
    """From the first step it brakes as hard as the friction allows: 1 % more room than v^2 / 2a is enough."""
    enough = run(load("paper", [AT.format(1.01 * STOP + 2)]), "brake", "planar").result
    assert enough.outcome is Outcome.AVOIDED
    assert enough.speed.final < 0.1
    assert enough.decision == "brake"
    too_near = run(load("paper", [AT.format(0.99 * STOP + 2)]), "brake", "planar").result
    assert too_near.outcome is Outcome.COLLIDED


def test_it_holds_the_standstill() -> None:
    """Once it stands it stays, with the brakes on."""
    done = run(load("paper", [AT.format(40), "duration=7 s"]), "brake", "planar")
    x, n = done.log.motion["X"], 1000
    assert done.result.outcome is Outcome.AVOIDED
    assert x[-1] - x[-n] < 0.05
    assert (done.log.steps.stack("Fx_fl", "Fx_rl")[-5:] < 0).all()


@pytest.mark.parametrize(
    ("x", "y", "vx"),
    [(15.0, 3.5, 15.0), (60.0, 3.5, -20.0), (30.0, -2.9, 0.0), (30.0, 3.5, 0.0), (20.0, 0.0, 20.0), (25.0, 0.0, 30.0)],
    ids=["next lane", "oncoming in its lane", "parked on the shoulder", "parked left", "as fast", "faster"],
)
def test_no_false_alarm(x: float, y: float, vx: float) -> None:
    """What stays off the path, or does not come nearer, is no reason to brake or steer."""
    done = beside_a_car(x, y, vx)
    assert not braked(done)
    assert np.abs(done.log.steps["delta"]).max() < 1e-6
    assert done.result.decision == "none"
    assert {plan.name for plan in done.plans} == {"keep"}


def test_a_crossing_car_that_is_gone_in_time_is_no_alarm_and_one_that_is_not_is() -> None:
    """Where both would be at the same time is what counts."""
    assert not braked(beside_a_car(30.0, 2.0, 0.0, 10.0))
    crossing = beside_a_car(38.0, -10.0, 0.0, 5.0)
    assert braked(crossing)
    assert crossing.result.outcome is Outcome.AVOIDED


def test_it_lets_go_behind_a_slower_one() -> None:
    """Behind a car of 10 m/s it brakes down to that and then stays behind; all the time that shapes its plans."""
    done = beside_a_car(25.0, 0.0, 10.0)
    assert braked(done)
    assert done.result.outcome is Outcome.AVOIDED
    assert done.result.speed.final == pytest.approx(10.0, abs=1.0)
    assert done.result.decision == "brake"
    reasons = list(dict.fromkeys(plan.reason for plan in done.plans))
    assert reasons[:2] == ["no contact is near", "a contact is so near that braking can't wait"]
    assert reasons[-1] == "behind what is in front"


def test_it_sees_a_deceleration() -> None:
    """Behind a car as fast as itself it brakes once that was seen to slow down, and not before."""
    subject, forces = controller(), []
    memory = subject.start()
    for k in range(8):
        slower = max(0, k - 1) * 0.4  # 8 m/s^2 from 0.05 s on
        lead = Obstacle(Ellipse((2.0, 1.0)), Steady((4.0 + 20 * 0.05 * k, 0.0), (20.0 - slower, 0.0)))
        command, _, memory = subject.step(seen(0.05 * k, RUNNING + np.array([0, 0, 0, 0, k, 0]), lead), memory)
        forces.append(command.wheel_forces.sum())
    assert forces[0] == forces[1] == 0
    assert forces[-1] < -5000


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e300])
def test_a_broken_measurement_is_a_fallback(value: float) -> None:
    """A number that is none, anywhere, is answered by the last plan and said to be."""
    subject = controller()
    _, plan, memory = subject.step(seen(), subject.start())
    for name, broken in broken_measurements(value).items():
        command, after, _ = subject.step(replace(broken, time=0.05, stamp=0.05), memory)
        assert after.fallback is Fallback.NOT_FINITE, name
        np.testing.assert_array_equal(command.as_input(), plan.inputs[1], err_msg=name)


@settings(deadline=None, max_examples=40)
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
