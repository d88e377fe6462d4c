"""Bad measurements at every point of a run: counted, answered, never an exception."""

from collections.abc import Callable
from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
import pytest

from swerve.scenario import load
from swerve.signals import Measurement
from swerve.simulate import CONTROLLERS, run
from swerve.simulate.assemble import sensor_of
from swerve.simulate.loop import Sense

SHORT = ("duration=1.4 s",)
N_STEPS = 28


def spoiled(when: Callable[[int], bool], spoil: Callable[[Measurement], Measurement]) -> Sense:
    """The paper's own sensing, but for the steps k in which it is spoiled."""
    measure = sensor_of(load("paper")).measure

    def sense(time: float, *rest: Any) -> Measurement:
        good = measure(time, *rest)
        return spoil(good) if when(round(time / 0.05)) else good

    return sense


def blinded(when: Callable[[int], bool]) -> Sense:
    """A state of nan in some steps."""
    return spoiled(when, lambda good: replace(good, state=good.state * np.nan))


SPOILED = {
    "state of nan": lambda good: replace(good, state=good.state * np.nan),
    "loads of inf": lambda good: replace(good, wheel_loads=good.wheel_loads * np.inf),
    "late": lambda good: replace(good, stamp=good.time - 0.1),
    "obstacle of nan": lambda good: replace(
        good, obstacles=tuple(replace(each, position=(np.nan, 0.0)) for each in good.obstacles)
    ),
}


@pytest.mark.parametrize("first", range(0, N_STEPS, 3))
def test_a_burst_at_any_time_is_survived(first: int) -> None:
    """Three bad measurements in a row, at the start, in the middle of the swerve or after: three fallbacks, and
    clear.
    """
    done = run(load("paper", SHORT), plant="planar", sense=blinded(lambda k: first <= k < first + 3))
    assert done.result.fallback_steps == min(3, N_STEPS - first)
    assert [k for k, plan in enumerate(done.plans) if plan.fallback] == list(range(first, min(first + 3, N_STEPS)))
    assert done.result.outcome.value == "avoided"
    assert np.isfinite(done.log.motion["Y"]).all()


@pytest.mark.parametrize(
    ("controller", "kind"),
    # what a driver asked for a while ago is still the best guess of what a driver asks for
    [each for each in product(CONTROLLERS, SPOILED) if each != ("driver", "late")],
)
def test_every_kind_is_counted(controller: str, kind: str) -> None:
    """With every third measurement bad, every third step is a fallback, of every controller."""
    done = run(load("paper", SHORT), controller, "planar", sense=spoiled(lambda k: k % 3 == 1, SPOILED[kind]))
    bad = [k for k in range(N_STEPS) if k % 3 == 1]
    assert set(bad) <= {k for k, plan in enumerate(done.plans) if plan.fallback}
    assert done.result.fallback_steps >= len(bad)
    if controller == "unified":
        assert done.result.fallback_steps == len(bad)
        assert done.result.outcome.value == "avoided"
        words = done.log.steps["fallback"][bad]
        assert all(words)
    assert np.isfinite(done.log.motion.stack("vx", "vy", "r", "psi", "X", "Y")).all()


@pytest.mark.parametrize("controller", CONTROLLERS)
def test_noise_from_a_broken_sensor_is_no_exception(controller: str) -> None:
    """Random entries of nan and infinity in a third of the steps: the run ends with finite motion and a full log."""
    random = np.random.default_rng(11)

    def broken(good: Measurement) -> Measurement:
        state, loads = good.state.copy(), good.wheel_loads.copy()
        state[random.integers(6)] = random.choice([np.nan, np.inf, -np.inf])
        loads[random.integers(4)] = random.choice([np.nan, np.inf, 1.0])
        return replace(good, state=state, wheel_loads=loads)

    bad = set(random.choice(N_STEPS, 9, replace=False).tolist())
    done = run(load("paper", SHORT), controller, "planar", sense=spoiled(lambda k: k in bad, broken))
    assert done.result.steps == N_STEPS
    assert done.result.fallback_steps >= len(bad)
    assert np.isfinite(done.log.motion["X"]).all()


@pytest.mark.parametrize("controller", ["unified", "as-printed"])  # those that solve programs
def test_a_solver_that_never_answers_is_no_exception(controller: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """With a solver that fails every time the run goes through, every step a fallback and every failure counted."""
    from swerve.qp import Solution
    from swerve.qp.solution import Status

    def no_answer(problem: Any, *rest: Any, **named: Any) -> Solution:
        return Solution.without_answer(problem, Status.FAILED, 0, "none")

    monkeypatch.setattr("swerve.control.unified.improve.solve", no_answer)
    monkeypatch.setattr("swerve.control.as_printed.controller.solve", no_answer)
    result = run(load("paper", SHORT), controller, "planar").result
    assert result.fallback_steps == N_STEPS
    assert result.solver_failures >= N_STEPS
