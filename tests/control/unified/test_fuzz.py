"""The controller at measurements that no run would come to: a seeded part of the study of that name."""

from functools import cache

import numpy as np
import pytest

from swerve.control.plan import Fallback
from swerve.report.fuzz import as_markdown
from swerve.scenario import load
from swerve.study.fuzz import Fault, Fuzz, fuzz, measurement
from swerve.study.fuzz.limits import Held, Limits, static_loads

N_STEPS = 300


@cache
def _fuzz() -> Fuzz:
    return fuzz(0, lambda share: None, N_STEPS)


def test_nothing_goes_wrong() -> None:
    """No step raises, and every command is finite and within the limits."""
    assert _fuzz().faults == ()


def test_every_step_is_answered() -> None:
    """Most by a plan, whatever is measured; the rest by a fallback."""
    answers = _fuzz().answers
    assert sum(answers.values()) == _fuzz().n_steps == N_STEPS
    assert answers["plan"] > N_STEPS / 2
    assert set(answers) <= {"plan", *(each.name.lower() for each in Fallback)}


def test_the_measurements_are_what_no_run_comes_to() -> None:
    """Backwards, in a spin, at rest, at more than 70 m/s; inside an obstacle, among many, with loads of any kind."""
    random = np.random.default_rng(0)
    seen = [measurement(random, 0.0) for _ in range(500)]
    states = np.array([each.state for each in seen])
    assert (states[:, 0] < -30).any() and (states[:, 0] > 70).any() and (np.abs(states[:, :3]).max(axis=1) == 0).any()
    assert (np.abs(states[:, 2]) > 5).any()
    assert any(len(each.obstacles) > 8 for each in seen)
    assert any(np.allclose(each.state[4:], o.position) for each in seen for o in each.obstacles)
    loads = np.array([each.wheel_loads for each in seen])
    assert loads.min() < 0 and loads.max() > 5e4
    assert all(each.is_finite for each in seen)


@pytest.mark.parametrize(
    "u, wrong",
    [
        ([0.0, 0, 0, 0, 0], None),
        ([0.05, -3000, 0, 0, 0], None),
        ([np.nan, 0, 0, 0, 0], "the command is not finite"),
        ([0.0, -4000, 0, 0, 0], "a wheel force exceeds its limit"),
        ([-0.51, 0, 0, 0, 0], "the steering angle exceeds the lock"),
        ([0.49, 0, 0, 0, 0], "the steering angle exceeds its rate"),
    ],
)
def test_what_is_wrong_is_found(u: list[float], wrong: str | None) -> None:
    """Each limit by itself; a front wheel at rest carries 4508 N, of which 0.95 mu is 3640 N."""
    scenario = load("paper")
    held = Held(np.zeros(5), static_loads(scenario))
    assert Limits.of(scenario).fault(np.array(u), held) == wrong


def test_the_table_tells_what_was_wrong() -> None:
    """By the sentence, with the number of steps."""
    text = as_markdown(Fuzz(7, 100, (Fault(3, (), "it raised"), Fault(4, (), "it raised")), {"plan": 98}))
    assert "- 2 steps: it raised" in text
    assert "| plan | 98 |" in text
