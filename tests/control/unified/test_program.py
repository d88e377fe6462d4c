"""The convex program against the cost and the limits that it is made of."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.control import Side
from swerve.control.unified.branch import Situation, improve
from swerve.control.unified.condensing import condense
from swerve.control.unified.limits import InputBox, ObstacleLimit, Penalty, SlipLimit, SteeringRateLimit
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.program import Program
from swerve.control.unified.tail import Tail
from swerve.control.unified.terms import InputRate, Tracking, WheelForce
from swerve.conventions import VX, VY, Y
from swerve.qp import Problem, solve
from swerve.world import Ellipse, Obstacle, Point, Steady
from tests.control.unified.situations import BLOCKING, RUNNING, SIDES, model, random_inputs, random_roll_out, seeds
from tests.vehicle.motions import SEDAN, STATIC

TRUST = np.array([0.08, 4e3, 4e3, 4e3, 4e3])
TIMES = np.arange(41) * 0.025
RATE = 0.6  # [rad/s]


def program(*obstacles: Obstacle, side: Side = Side.LEFT, rate: bool = True) -> Program:
    """All terms and all limits, round these obstacles."""
    terms = (
        Tracking(VX, 20.0, 1.0),
        Tracking(VY, 0.0, 1.0),
        Tracking(Y, 0.0, 10.0),
        InputRate.of(np.array([1e2, 1e-6, 1e-6, 1e-6, 1e-6]), BLOCKING).after(np.array([0.01, 0, 0, 0, 0])),
        WheelForce(1e-8, BLOCKING),
    )
    tail = Tail.of(0.85, 20, 0.05)
    soft = [ObstacleLimit(each, Point(), side, TIMES, tail, 0.01, Penalty(5e3, 1e5)) for each in obstacles]
    hard = (SteeringRateLimit(RATE * 0.05, 0.01, BLOCKING),) if rate else ()
    return Program(terms, InputBox.of(SEDAN, 0.85, STATIC, BLOCKING), hard, (*soft, SlipLimit(0.12, Penalty(1e3, 1e5))))


def ahead(trajectory: Trajectory, metres: float = 6.0) -> Obstacle:
    """A disc in front of where the trajectory ends."""
    x, y, psi = trajectory.states[-1, [4, 5, 3]]
    return Obstacle(Ellipse((2.0, 2.0)), Steady((x + metres * np.cos(psi), y + metres * np.sin(psi))))


def smallest_slacks(problem: Problem, z: np.ndarray, n_soft: int) -> np.ndarray:
    """What each slack must be for z to keep the soft rows."""
    slacks = np.zeros(n_soft)
    for row, low, high in zip(problem.rows, problem.row_lower, problem.row_upper, strict=True):
        taken = np.flatnonzero(row[len(z) :])
        if len(taken):
            missing = max(low - row[: len(z)] @ z, row[: len(z)] @ z - high, 0.0)
            slacks[taken[0]] = max(slacks[taken[0]], missing)
    return slacks


@settings(max_examples=12)
@given(seeds)
def test_the_program_is_the_sum_of_its_parts(seed: int) -> None:
    """At any change z, with slacks as small as they can be, it costs the terms' models and the prices of the
    violations.
    """
    trajectory, sensitivities, random = random_roll_out(seed)
    found = program(ahead(trajectory), ahead(trajectory, 3.0))
    problem = found.convex(trajectory, sensitivities, TRUST)
    problem.check()
    z = random.uniform(-0.3, 0.3, BLOCKING.n)
    wanted = 0.0
    for term in found.terms:
        hessian, gradient = term.quadratic(trajectory, sensitivities)
        wanted += gradient @ z + z @ hessian @ z / 2
    slacks = []
    for limit in found.soft:
        rows = limit.rows(trajectory, sensitivities)
        on = rows.matrix @ z
        excess = np.concatenate([[0.0], rows.lower - on, on - rows.upper])
        slacks.append(float(excess.max()))
        wanted += limit.penalty.of(slacks[-1])
    np.testing.assert_allclose(smallest_slacks(problem, z, 3), slacks, atol=1e-12)
    assert problem.cost(np.concatenate([z, slacks])) == pytest.approx(wanted, rel=1e-9)


@settings(max_examples=12)
@given(seeds)
def test_hard_rows_have_no_slack_and_slacks_no_sign(seed: int) -> None:
    """The steering rate can't be bought; slacks are not negative; the bounds on z are those of the box."""
    trajectory, sensitivities, _ = random_roll_out(seed)
    found = program(ahead(trajectory))
    problem = found.convex(trajectory, sensitivities, TRUST)
    hard = (problem.rows[:, BLOCKING.n :] == 0).all(axis=1)
    assert np.count_nonzero(hard) == BLOCKING.n_blocks
    np.testing.assert_array_equal(problem.lower[BLOCKING.n :], 0.0)
    np.testing.assert_array_equal(problem.upper[BLOCKING.n :], np.inf)
    lower, upper = found.box.bounds(trajectory, TRUST)
    np.testing.assert_array_equal(problem.lower[: BLOCKING.n], lower)
    np.testing.assert_array_equal(problem.upper[: BLOCKING.n], upper)


@settings(max_examples=10)
@given(seeds)
def test_without_hard_rows_there_is_always_an_answer(seed: int) -> None:
    """However badly a trajectory fares, slacks make the program feasible, and the solver proves its optimum."""
    random = np.random.default_rng(seed)
    trajectory = model().roll_out(RUNNING, random_inputs(random, 6.0), STATIC)
    found = program(Obstacle(Ellipse((2.0, 2.0)), Steady((8.0, 0.0))), rate=False)
    solution = solve(found.convex(trajectory, condense(model().linearise(trajectory, STATIC), BLOCKING), TRUST))
    assert solution.is_solved
    assert solution.is_optimal(1e-5)


@settings(max_examples=10)
@given(seeds)
def test_a_score_is_cost_and_prices(seed: int) -> None:
    """The merit of a trajectory is the sum of its terms and of the prices of what it violates."""
    trajectory, _, _ = random_roll_out(seed)
    found = program(ahead(trajectory, 1.0))
    score = found.score(trajectory)
    violations = [limit.violation(trajectory) for limit in found.soft]
    assert score.violations == tuple(violations)
    assert score.cost == pytest.approx(sum(term.value(trajectory) for term in found.terms))
    prices = 5e3 * violations[0] + 1e5 * violations[0] ** 2 + 1e3 * violations[1] + 1e5 * violations[1] ** 2
    assert score.merit == pytest.approx(score.cost + prices)
    assert found.missed_clearance(score) == violations[0]


def test_what_diverged_costs_everything() -> None:
    """A trajectory that is not finite has an infinite merit, so that nothing prefers it."""
    diverged = model().roll_out(np.full(6, np.nan), np.zeros((20, 5)), STATIC)
    assert program(Obstacle(Ellipse((2.0, 2.0)), Steady((25.0, 0.0)))).score(diverged).merit == np.inf


def test_without_obstacles_nothing_is_missed() -> None:
    """A program without obstacles has no missed clearance, whatever the slip angles are."""
    found = program()
    inputs = np.zeros((20, 5))
    inputs[:, 0] = 0.3
    score = found.score(model().roll_out(RUNNING, inputs, STATIC))
    assert score.violations[0] > 0
    assert found.missed_clearance(score) == 0.0


@pytest.mark.parametrize("side", SIDES)
def test_improving_lowers_the_merit(side: Side) -> None:
    """Each further iteration leaves the merit as it was or lower, and the plan gets round on its side."""
    situation = Situation(
        side, program(Obstacle(Ellipse((2.0, 2.0)), Steady((25.0, 0.0))), side=side), model(), RUNNING, STATIC, TRUST
    )
    step = situation.roll_out(np.zeros((20, 5)))
    merits = [step.merit]
    for _ in range(6):
        plan = improve(situation, step, 1.0, 1)
        assert (plan.n_solved, plan.n_failed, plan.side) == (1, 0, side)
        step = plan.step
        merits.append(step.merit)
    assert (np.diff(merits) <= 1e-9).all()
    assert merits[-1] < 0.7 * merits[0]
    assert step.trajectory.states[-1, 5] * side.value > 0


@settings(max_examples=8)
@given(st.floats(0.01, 0.6), st.floats(-0.3, 0.3))
def test_no_iterations_no_change(steering: float, lateral: float) -> None:
    """With no iteration to do the plan is the one it began with, and no program was solved."""
    obstacle = Obstacle(Ellipse((2.0, 2.0)), Steady((25.0, lateral)))
    situation = Situation(Side.LEFT, program(obstacle), model(), RUNNING, STATIC, TRUST)
    step = situation.roll_out(np.tile([steering, 0, 0, 0, 0], (20, 1)))
    plan = improve(situation, step, 0.5, 0)
    assert plan.step is step
    assert (plan.n_solved, plan.n_failed, plan.trust, plan.is_shaped) == (0, 0, 0.5, False)
    assert plan.violation == situation.missed_clearance(step)
