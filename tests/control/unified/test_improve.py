"""Iterations of one way: the merit falls, failures are counted, the deadline ends them."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.control.plan import Passing
from swerve.control.unified import improve as module
from swerve.control.unified.deadline import PROGRAM, ROLL_OUT, Deadline
from swerve.control.unified.held import Held
from swerve.control.unified.improve import SMALLEST_TRUST, WayPlan, improve
from swerve.control.unified.situation import Situation
from swerve.qp import Problem, Solution
from swerve.qp.solution import Status
from swerve.world import Ellipse, Obstacle, Steady
from tests.control.unified.situations import AHEAD, BLOCKING, BOX_CAR, PASSED, random_inputs, seeds, situation
from tests.vehicle.motions import STATIC

FAR_AHEAD = Obstacle(Ellipse((2.0, 2.0)), Steady((38.0, 0.0)))


def begun(found: Situation, inputs: np.ndarray | None = None) -> WayPlan:
    """A plan before its first iteration."""
    return WayPlan(found, found.roll_out(np.zeros((20, 5)) if inputs is None else inputs), 1.0)


@pytest.mark.parametrize("of", [(), BOX_CAR])
@pytest.mark.parametrize("passing", list(Passing))
def test_improving_lowers_the_merit(passing: Passing, of: tuple[str, ...]) -> None:
    """Each further iteration leaves the merit as it was or lower; a swerve ends on its side, a stop in its lane."""
    first_guess = np.tile([0.0, *(-0.4 * STATIC)], (20, 1)) if passing is Passing.BEHIND else None
    plan = begun(situation((passing,), FAR_AHEAD if passing is Passing.BEHIND else AHEAD, of=of), first_guess)
    merits = [plan.step.merit]
    for k in range(6):
        plan = improve(plan, 1)
        assert (plan.n_solved, plan.n_failed) == (k + 1, 0)
        merits.append(plan.step.merit)
    assert (np.diff(merits) <= 1e-9).all()
    assert merits[-1] < 0.9 * merits[0]
    end = plan.step.trajectory.states[-1]
    if passing is Passing.BEHIND:
        assert plan.violation == 0
        assert abs(end[5]) < 0.3
    else:
        assert end[5] * passing.value > 0


@settings(max_examples=8)
@given(st.floats(0.01, 0.6), st.floats(-0.3, 0.3))
def test_no_iterations_no_change(steering: float, lateral: float) -> None:
    """With no iteration to do the plan is the one it began with, and no program was solved."""
    obstacle = Obstacle(Ellipse((2.0, 2.0)), Steady((25.0, lateral)))
    before = begun(situation((Passing.LEFT,), obstacle), np.tile([steering, 0, 0, 0, 0], (20, 1)))
    assert improve(before, 0) is before
    assert (before.n_solved, before.n_failed, before.is_shaped) == (0, 0, False)


@settings(max_examples=8)
@given(seeds, st.sampled_from(list(Passing)))
def test_the_merit_never_rises_from_anywhere(seed: int, passing: Passing) -> None:
    """From any inputs, however bad, improving never makes a plan worse, and its trust stays a share."""
    before = begun(situation((passing,), AHEAD), random_inputs(np.random.default_rng(seed), 2.0))
    after = improve(before, 3)
    assert after.step.merit <= before.step.merit
    assert SMALLEST_TRUST <= after.trust <= 1.0
    assert 1 <= after.n_solved + after.n_failed <= 3
    np.testing.assert_array_equal(after.step.trajectory.states[0], before.step.trajectory.states[0])


def test_it_comes_to_rest() -> None:
    """Improved again and again a plan ends where nothing changes any more, and not where it began."""
    plan = begun(situation((Passing.LEFT,), AHEAD))
    merits = [plan.step.merit]
    for _ in range(12):
        plan = improve(replace(plan, trust=1.0), 10)
        merits.append(plan.step.merit)
    assert merits[-1] > 0.99 * merits[-3]
    assert merits[-1] < 0.05 * merits[0]


def test_left_and_right_are_mirror_images() -> None:
    """Straight ahead of the obstacle both sides cost the same, by plans that mirror each other."""
    left, right = (improve(begun(situation((side,), AHEAD)), 4).step for side in PASSED)
    assert left.merit == pytest.approx(right.merit, rel=1e-6)
    np.testing.assert_allclose(left.trajectory.states[:, 5], -right.trajectory.states[:, 5], atol=1e-5)


def nothing(problem: Problem, *rest: Any, **named: Any) -> Solution:
    """A solver without an answer."""
    return Solution.without_answer(problem, Status.FAILED, 0, "none")


def test_what_the_first_solver_fails_at_the_second_one_answers(monkeypatch: pytest.MonkeyPatch) -> None:
    """The plan is that of the first one, had it not failed, and no failure is counted."""
    before = begun(situation((Passing.LEFT,), AHEAD))
    wanted = improve(before, 1)
    solve = module.solve

    def failing(problem: Problem, solver: str = "daqp", **named: Any) -> Solution:
        return nothing(problem) if solver == "daqp" else solve(problem, solver, **named)

    monkeypatch.setattr(module, "solve", failing)
    found = improve(before, 1)
    assert (found.n_solved, found.n_failed) == (1, 0)
    np.testing.assert_allclose(found.step.trajectory.states, wanted.step.trajectory.states, atol=1e-3)
    assert found.step.merit == pytest.approx(wanted.step.merit, rel=1e-4)


def test_what_held_before_is_where_the_solver_begins() -> None:
    """The same program again takes next to no iteration, and has the same answer."""
    found = begun(situation((Passing.LEFT,), AHEAD))
    program, sensitivities = found.situation.program, found.situation.sensitivities(found.step)
    problem, labels = program.labelled(found.step.trajectory, sensitivities, found.situation.full_trust)
    assert len(set(labels.tolist())) == len(problem.row_lower)
    cold = module.solve(problem)
    held = Held.by(cold, labels)
    warm = module.solve(problem, warm_start=held.start(problem.gradient.size, labels))
    assert warm.iterations < 0.2 * cold.iterations
    np.testing.assert_allclose(warm.x, cold.x, atol=1e-7)


def test_what_held_another_program_does_no_harm() -> None:
    """Labels that are unknown hold nothing, and a program of another size begins without bounds."""
    held = Held(np.ones(3), {7: 2.0, 9: -1.0})
    begin = held.start(4, np.array([9, 8]))
    np.testing.assert_array_equal(begin.bound_multipliers, np.zeros(4))
    np.testing.assert_array_equal(begin.row_multipliers, [-1.0, 0.0])
    np.testing.assert_array_equal(held.start(3, np.array([7])).bound_multipliers, np.ones(3))


def test_a_program_without_an_answer_ends_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """The plan stays what it was, with one failure counted."""
    monkeypatch.setattr(module, "solve", nothing)
    before = begun(situation((Passing.LEFT,), AHEAD))
    after = improve(before, 5)
    assert (after.n_solved, after.n_failed) == (0, 1)
    assert after.step is before.step


def test_a_promise_is_what_the_program_sees(monkeypatch: pytest.MonkeyPatch) -> None:
    """An answer that stays where it is promises nothing, so no roll-out is spent on it."""

    def stay(problem: Problem, *rest: Any, **named: Any) -> Solution:
        solution = solve(problem, *rest, **named)
        x = solution.x.copy()
        x[: BLOCKING.n] = 0.0
        x[BLOCKING.n :] = solved_slacks(problem)
        return replace(solution, x=x)

    solve = module.solve

    def solved_slacks(problem: Problem) -> np.ndarray:
        held = replace(
            problem,
            lower=np.concatenate([np.zeros(BLOCKING.n), problem.lower[BLOCKING.n :]]),
            upper=np.concatenate([np.zeros(BLOCKING.n), problem.upper[BLOCKING.n :]]),
        )
        return solve(held).x[BLOCKING.n :]

    monkeypatch.setattr(module, "solve", stay)
    rolled: list[Any] = []
    before = begun(situation((Passing.LEFT,), AHEAD))
    real = Situation.roll_out
    monkeypatch.setattr(Situation, "roll_out", lambda self, inputs: rolled.append(1) or real(self, inputs))
    after = improve(before, 3)
    assert after.step.trajectory is before.step.trajectory or after.step.merit <= before.step.merit
    assert after.n_solved == 1
    assert not rolled


def test_the_deadline_ends_it_after_the_first() -> None:
    """Whatever the time, one program is tried; the next only while there is time."""
    found = replace(situation((Passing.LEFT,), AHEAD), deadline=Deadline(0.0, None))
    assert improve(begun(found), 5).n_solved == 1
    later = replace(found, deadline=Deadline(2.5 * PROGRAM, None))
    assert 1 < improve(begun(later), 6).n_solved < 6


# The deadline itself


@given(st.lists(st.sampled_from([PROGRAM, ROLL_OUT]), max_size=40), st.floats(0.0, 0.1))
def test_work_is_counted_without_a_clock(work: list[float], allowed: float) -> None:
    """The time is over as soon as the work done takes longer than allowed."""
    deadline = Deadline(allowed, None)
    for each in work:
        deadline.count(each)
    assert deadline.is_over == (sum(work) > allowed)


def test_with_a_clock_only_the_clock_counts() -> None:
    """Time begins with the deadline; work is not counted."""
    now = [100.0]
    deadline = Deadline(0.5, lambda: now[0])
    deadline.count(1e9)
    assert not deadline.is_over
    now[0] = 100.5
    assert not deadline.is_over
    now[0] = 100.51
    assert deadline.is_over
