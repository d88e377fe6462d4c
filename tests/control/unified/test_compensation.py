"""Where the vehicle will be when a command acts, against a plant that is driven with the same delays."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.control import Latency
from swerve.control.unified.compensation import is_late, n_commands, state_at_effect
from swerve.vehicle.integrate import rk4
from swerve.world import Ellipse, Obstacle, Steady
from tests.control.unified.situations import RUNNING, controller, model, random_start, seeds, seen
from tests.control.unified.test_prediction import ROLLING
from tests.vehicle.motions import STATIC, move

AT_ONCE = Latency(0.0, 0.0, 0.0)


def driven(state: np.ndarray, segments: list[tuple[np.ndarray, float]]) -> np.ndarray:
    """The state after inputs that are held for some time each, in steps of 1 ms."""
    for u, duration in segments:
        n = max(1, round(duration / 1e-3))
        for _ in range(n if duration > 0 else 0):
            state = rk4(lambda xi, u=u: move(xi, u, STATIC, ROLLING).derivative, state, duration / n)
    return state


def commands(random: np.random.Generator, n: int) -> list[np.ndarray]:
    """The commands given so far, the last one first."""
    return [random.normal(0.0, [0.03, 500, 500, 500, 500]) for _ in range(n)]


@given(seeds)
def test_without_delays_it_is_the_state_that_was_measured(seed: int) -> None:
    """A fresh measurement of a vehicle that obeys at once is the start of the plan, to the last bit."""
    random = np.random.default_rng(seed)
    state = random_start(random)
    found = state_at_effect(seen(0.35, state), commands(random, n_commands(AT_ONCE, 0.05)), 0.0, model())
    np.testing.assert_array_equal(found, state)


@settings(max_examples=10)
@given(seeds, st.sampled_from([0.01, 0.03, 0.05, 0.08, 0.12]), st.sampled_from([0.0, 0.02, 0.05, 0.07]))
def test_it_is_where_past_commands_lead(seed: int, sensing: float, actuation: float) -> None:
    """From the measurement's stamp to the command's effect the vehicle follows the commands that were given before."""
    random, latency = np.random.default_rng(seed), Latency(sensing, actuation, 0.0)
    given_before = commands(random, n_commands(latency, 0.05))
    state, now = random_start(random), 1.0
    measurement = replace(seen(now, state), stamp=now - sensing)
    # command j, the last one first, acts from now - (j + 1) Ts + actuation on for one sample
    segments = []
    for j in reversed(range(len(given_before))):
        begins, ends = now + actuation - (j + 1) * 0.05, now + actuation - j * 0.05
        segments.append((given_before[j], max(0.0, ends - max(begins, measurement.stamp))))
    assert sum(duration for _, duration in segments) == pytest.approx(sensing + actuation)
    found = state_at_effect(measurement, given_before, actuation, model())
    np.testing.assert_allclose(found, driven(state, segments), atol=2e-4)


@pytest.mark.parametrize("delay", [0.01, 0.04, 0.06])
def test_an_old_measurement_is_planned_from_like_a_fresh_one(delay: float) -> None:
    """Rolling straight on, a plan from an old measurement is the plan from what is true now, moving obstacles
    included.
    """
    delayed = controller(f"sensing.delay={delay}")
    obstacle = Obstacle(Ellipse((2.0, 2.0)), Steady((14.0, -0.7), velocity=(5.0, 0.3)))
    measured = seen(1.0 - delay, RUNNING, obstacle)
    old = replace(measured, time=1.0)
    now = seen(1.0, RUNNING + np.array([0, 0, 0, 0, 20.0 * delay, 0]), obstacle)
    _, from_old, _ = delayed.step(old, delayed.start())
    _, from_fresh, _ = controller().step(now, controller().start())
    assert from_old.side is from_fresh.side is not None
    np.testing.assert_allclose(from_old.inputs, from_fresh.inputs, rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(from_old.states, from_fresh.states, rtol=1e-6, atol=1e-6)


@given(st.floats(0.0, 0.3), st.floats(0.0, 0.3))
def test_enough_commands_are_remembered(sensing: float, actuation: float) -> None:
    """The commands reach back to the stamp of the oldest measurement that is used."""
    reach = n_commands(Latency(sensing, actuation, 0.0), 0.05) * 0.05
    assert reach >= sensing + actuation + 0.025


@pytest.mark.parametrize(("age", "late"), [(0.08, False), (0.1, False), (0.11, True), (5.0, True), (-1.0, False)])
def test_late_is_older_than_usual(age: float, late: bool) -> None:
    """A measurement is late when it is half a sample older than the known delay explains."""
    measurement = replace(seen(1.0), stamp=1.0 - age)
    assert is_late(measurement, Latency(0.08, 0.2, 0.3), 0.05) is late
