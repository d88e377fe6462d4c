"""Step acceptance: nothing is taken that the nonlinear model does not confirm."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.control.unified.acceptance import GOOD, STEP_LENGTHS, Step, accept
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.program import Score

CHANGE = np.ones((20, 5))
merits = st.floats(0.0, 1e6) | st.just(np.inf)


def step(inputs: np.ndarray, merit: float) -> Step:
    """A step with this merit."""
    n = len(inputs)
    motion = Trajectory(inputs, np.zeros((n + 1, 6)), np.zeros((2 * n + 1, 3)), *(np.zeros(n),) * 2, np.zeros((n, 4)))
    return Step(motion, Score(merit, 0.0, ()))


def by_length(table: dict[float, float], tried: list[float]) -> Callable[[np.ndarray], Step]:
    """A roll-out whose merit is looked up by the step length; notes what was tried."""

    def roll_out(inputs: np.ndarray) -> Step:
        tried.append(float(inputs[0, 0]))
        return step(inputs, table[tried[-1]])

    return roll_out


@given(merits, st.tuples(merits, merits, merits), st.floats(-1e6, 1e6))
def test_the_merit_never_rises(before: float, after: tuple[float, float, float], promise: float) -> None:
    """Whatever the model answers and whatever was promised, the merit is as it was or lower, and is its
    trajectory's.
    """
    current = step(np.zeros((20, 5)), before)
    table = dict(zip(STEP_LENGTHS, after, strict=True))
    taken = accept(current, CHANGE, promise, by_length(table, []))
    assert taken.merit <= before
    if taken.length > 0:
        assert taken.merit == table[taken.length]
        np.testing.assert_array_equal(taken.trajectory.inputs, taken.length * CHANGE)
    else:
        assert taken.trajectory is current.trajectory


@given(merits, st.tuples(merits, merits, merits), st.floats(0.0, 1e6))
def test_the_first_good_step_or_else_the_best(before: float, after: tuple[float, ...], promise: float) -> None:
    """Lengths are tried from the whole on until the best so far keeps a share of the promise; failing that, the
    best.
    """
    tried: list[float] = []
    table = dict(zip(STEP_LENGTHS, after, strict=True))
    taken = accept(step(np.zeros((20, 5)), before), CHANGE, promise, by_length(table, tried))
    best = before
    for i, length in enumerate(STEP_LENGTHS):
        best = min(best, table[length])
        if before - best >= GOOD * length * promise:
            assert tried == list(STEP_LENGTHS[: i + 1])
            break
    else:
        assert tried == list(STEP_LENGTHS)
    assert taken.merit == best


def test_a_whole_step_that_keeps_its_promise_is_taken_at_once() -> None:
    """One roll-out is enough where the linear model was right."""
    tried: list[float] = []
    table = {1.0: 50.0, 0.5: 10.0, 0.25: 0.0}
    taken = accept(step(np.zeros((20, 5)), 100.0), CHANGE, 60.0, by_length(table, tried))
    assert (tried, taken.length, taken.merit) == ([1.0], 1.0, 50.0)


@pytest.mark.parametrize("answer", [np.inf, np.nan])
def test_what_diverges_is_never_taken(answer: float) -> None:
    """A merit that is infinite or none leaves the current trajectory in place, with length 0."""
    current = step(np.zeros((20, 5)), 100.0)
    taken = accept(current, CHANGE, 60.0, by_length(dict.fromkeys(STEP_LENGTHS, answer), []))
    assert taken.trajectory is current.trajectory
    assert taken.length == 0.0


def test_an_old_length_is_forgotten() -> None:
    """Where nothing better was found the length is 0, even if the current trajectory came by a step."""
    current = step(np.zeros((20, 5)), 100.0)
    before = accept(current, CHANGE, 60.0, by_length({1.0: 50.0}, []))
    assert before.length == 1.0
    table = {1.0 + length: 99.0 for length in STEP_LENGTHS}
    assert accept(before, CHANGE, 60.0, by_length(table, [])).length == 0.0
