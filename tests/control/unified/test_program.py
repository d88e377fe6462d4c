"""The convex program against the cost and the limits that it is made of."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar

from swerve.control.plan import Passing
from swerve.control.unified.condensing import Sensitivities, condense
from swerve.control.unified.limits import InputBox, Lane, ObstacleLimit, Penalty, Rows, SlipLimit, SteeringRateLimit
from swerve.control.unified.limits.obstacle import SAG
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.program import Program
from swerve.control.unified.separation import Separation
from swerve.control.unified.terms import InputRate, Tracking, WheelForce
from swerve.control.unified.terms.term import Quadratic
from swerve.conventions import VX, VY, Y
from swerve.qp import Problem, solve
from swerve.world import Ellipse, Point
from tests.control.unified.situations import (
    AHEAD,
    BLOCKING,
    BOX_CAR,
    LANES,
    RUNNING,
    forecast,
    model,
    random_inputs,
    random_roll_out,
    seeds,
    situation,
)
from tests.vehicle.motions import SEDAN, STATIC

TRUST = np.array([0.08, 4e3, 4e3, 4e3, 4e3])
TIMES = np.arange(41) * 0.025
RATE = 0.6  # [rad/s]
BARE, COMFORTABLE = Penalty(5e3, 1e5), Penalty(5e3, 1e5, 0.3, 1e3)
BOX = InputBox.of(SEDAN, 0.85, STATIC, BLOCKING)
passings = st.sampled_from(list(Passing))
SEPARATION = Separation(Point(), 41, 41)


def program(
    *places: np.ndarray,
    passing: Passing = Passing.LEFT,
    rate: bool = True,
    price: Penalty = BARE,
    growth: float = 0.0,
) -> Program:
    """All terms and all limits, round discs at these places."""
    terms = (
        Tracking(VX, 20.0, 1.0),
        Tracking(VY, 0.0, 1.0),
        Tracking(Y, 0.0, 10.0),
        InputRate.of(np.array([1e2, 1e-6, 1e-6, 1e-6, 1e-6]), BLOCKING).after(np.array([0.01, 0, 0, 0, 0])),
        WheelForce(1e-8, BLOCKING),
    )
    discs = [forecast(Ellipse((2.0, 2.0)), place) for place in places]
    soft = [ObstacleLimit(i, each, TIMES, SEPARATION, passing, 0.01, price, growth) for i, each in enumerate(discs)]
    hard = (SteeringRateLimit(RATE * 0.05, 0.01, BLOCKING),) if rate else ()
    return Program(terms, BOX, hard, (*soft, SlipLimit(0.12, Penalty(1e3, 1e5))))


def ahead(trajectory: Trajectory, metres: float = 6.0) -> np.ndarray:
    """A place in front of where the trajectory ends."""
    x, y, psi = trajectory.states[-1, [4, 5, 3]]
    return np.array([x + metres * np.cos(psi), y + metres * np.sin(psi)])


def smallest_slacks(problem: Problem, z: np.ndarray, n_soft: int) -> np.ndarray:
    """What each slack must be for z to keep the soft rows, where none has a comfort."""
    slacks = np.zeros(n_soft)
    for row, low, high in zip(problem.rows, problem.row_lower, problem.row_upper, strict=True):
        taken = np.flatnonzero(row[len(z) :])
        if len(taken):
            missing = max(low - row[: len(z)] @ z, row[: len(z)] @ z - high, 0.0)
            slacks[taken[0]] = max(slacks[taken[0]], missing)
    return slacks


@settings(max_examples=12)
@given(seeds, passings)
def test_the_program_is_the_sum_of_its_parts(seed: int, passing: Passing) -> None:
    """At any change z, with slacks as small as they can be, it costs the terms' models and the prices of the
    violations.
    """
    trajectory, sensitivities, random = random_roll_out(seed)
    found = program(ahead(trajectory), ahead(trajectory, 3.0), passing=passing)
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
    """The steering rate can't be bought; slacks are not negative, those of a comfort no larger than it; the bounds on z
    are those of the box.
    """
    trajectory, sensitivities, _ = random_roll_out(seed)
    found = program(ahead(trajectory), price=COMFORTABLE)
    problem = found.convex(trajectory, sensitivities, TRUST)
    hard = (problem.rows[:, BLOCKING.n :] == 0).all(axis=1)
    assert np.count_nonzero(hard) == BLOCKING.n_blocks
    np.testing.assert_array_equal(problem.lower[BLOCKING.n :], 0.0)
    np.testing.assert_array_equal(problem.upper[BLOCKING.n :], [np.inf, np.inf, 0.3])
    lower, upper = found.box.bounds(trajectory, TRUST)
    np.testing.assert_array_equal(problem.lower[: BLOCKING.n], lower)
    np.testing.assert_array_equal(problem.upper[: BLOCKING.n], upper)


class Pull:
    """A term w (z_0 - wish)^2, with something on the other inputs to keep them where they are."""

    def __init__(self, weight: float, wish: float) -> None:
        """Weight and wish."""
        self.weight, self.wish = weight, wish

    def value(self, trajectory: Trajectory) -> float:
        """At no change at all."""
        return self.weight * self.wish**2

    def quadratic(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Quadratic:
        """Its own model."""
        hessian, gradient = np.eye(BLOCKING.n), np.zeros(BLOCKING.n)
        hessian[0, 0], gradient[0] = 2 * self.weight, -2 * self.weight * self.wish
        return Quadratic(hessian, gradient)


class Fence:
    """A soft limit z_0 >= least."""

    def __init__(self, least: float, price: Penalty) -> None:
        """Where it is and what it costs."""
        self.least, self.penalty = least, price

    @property
    def name(self) -> str:
        """Its name."""
        return "fence"

    def violation(self, trajectory: Trajectory) -> float:
        """At no change at all."""
        return max(0.0, self.least)

    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """A single row."""
        return Rows(np.eye(BLOCKING.n)[:1], np.array([self.least]), np.array([np.inf]))


@settings(max_examples=60)
@given(
    st.floats(-0.3, 0.3),
    st.floats(-0.3, 0.3),
    st.floats(0.5, 50.0),
    st.sampled_from([0.0, 0.05, 0.2]),
    st.floats(0.1, 5.0),
)
def test_two_slacks_are_the_exact_penalty(
    wish: float, least: float, weight: float, comfort: float, cheap: float
) -> None:
    """The optimum over z and both slacks is that of the cost plus the price of the violation, by brute force."""
    price = Penalty(10.0, 100.0, comfort, cheap)
    found = Program((Pull(weight, wish),), BOX, (), (Fence(least, price),))
    _, sensitivities, _ = random_roll_out(0)
    wide = np.array([1.0, 1e4, 1e4, 1e4, 1e4])  # no trust region
    still = model().roll_out(RUNNING, np.zeros((20, 5)), STATIC)
    solution = solve(found.convex(still, sensitivities, wide))
    assert solution.is_solved

    def cost(z: float) -> float:
        return weight * (z - wish) ** 2 + price.of(max(0.0, least - z))

    brute = minimize_scalar(cost, bounds=(-0.5, 0.5), method="bounded", options={"xatol": 1e-9})
    assert cost(float(solution.x[0])) <= brute.fun + 1e-3 * (1 + comfort)
    assert solution.cost + weight * wish**2 == pytest.approx(brute.fun, abs=1e-3)


@settings(max_examples=15)
@given(seeds, st.sampled_from([BARE, COMFORTABLE]), passings, st.sampled_from([0.0, 1.0]))
def test_no_change_costs_in_the_program_what_it_costs(
    seed: int, price: Penalty, passing: Passing, growth: float
) -> None:
    """At the point of expansion the program's price of all slacks is the score's penalty, but for what curvature may
    take: it promises nothing that is no gain.
    """
    trajectory, sensitivities, _ = random_roll_out(seed)
    found = program(ahead(trajectory, 1.0), passing=passing, price=price, growth=growth)
    problem = found.convex(trajectory, sensitivities, np.zeros(5))
    lower, upper = problem.lower.copy(), problem.upper.copy()
    lower[: BLOCKING.n] = np.minimum(lower[: BLOCKING.n], 0.0)
    upper[: BLOCKING.n] = np.maximum(upper[: BLOCKING.n], 0.0)
    hard = (problem.rows[:, BLOCKING.n :] == 0).all(axis=1)
    soft = Problem(
        problem.hessian,
        problem.gradient,
        lower,
        upper,
        problem.rows[~hard],
        problem.row_lower[~hard],
        problem.row_upper[~hard],
    )
    solution = solve(soft)
    assert solution.is_solved
    missed = found.score(trajectory).violations[0]
    slack = (price.linear + 2 * price.quadratic * (missed + SAG)) * SAG
    penalty = found.score(trajectory).penalty
    assert penalty - 1e-3 * (1 + penalty) <= solution.cost <= penalty + slack + 1e-3 * (1 + penalty)


@settings(max_examples=10)
@given(seeds)
def test_without_hard_rows_there_is_always_an_answer(seed: int) -> None:
    """However badly a trajectory fares, slacks make the program feasible, and the solver proves its optimum."""
    random = np.random.default_rng(seed)
    trajectory = model().roll_out(RUNNING, random_inputs(random, 6.0), STATIC)
    found = program(np.array([8.0, 0.0]), rate=False, price=COMFORTABLE)
    solution = solve(found.convex(trajectory, condense(model().linearise(trajectory, STATIC), BLOCKING), TRUST))
    assert solution.is_solved
    assert solution.is_optimal(1e-5)


@settings(max_examples=10)
@given(seeds)
def test_a_score_is_cost_and_prices(seed: int) -> None:
    """The merit of a trajectory is the sum of its terms and of the prices of what it violates; what only misses its
    comfort misses no clearance.
    """
    trajectory, _, _ = random_roll_out(seed)
    found = program(ahead(trajectory, 1.0), ahead(trajectory, 4.0), price=COMFORTABLE)
    score = found.score(trajectory)
    violations = [limit.violation(trajectory) for limit in found.soft]
    assert score.violations == tuple(violations)
    assert score.cost == pytest.approx(sum(term.value(trajectory) for term in found.terms))
    prices = sum(1e3 * min(v, 0.3) + 5e3 * max(0.0, v - 0.3) + 1e5 * max(0.0, v - 0.3) ** 2 for v in violations[:2])
    prices += 1e3 * violations[2] + 1e5 * violations[2] ** 2
    assert score.merit == pytest.approx(score.cost + prices)
    assert found.missed_clearance(score) == pytest.approx(max(0.0, max(violations[:2]) - 0.3))
    assert found.off_road(score) == 0.0


def test_clearance_edges_and_lanes_are_told_apart() -> None:
    """What is missed of an edge is off the road, of an obstacle is clearance, and a lane is neither."""
    found = situation((Passing.BEHIND,), AHEAD, of=(*BOX_CAR, *LANES))
    inputs = np.zeros((20, 5))
    inputs[:, 0] = -0.05
    step = found.roll_out(inputs)
    by_name = dict(zip((limit.name for limit in found.program.soft), step.score.violations, strict=True))
    assert set(by_name) == {"obstacle 0", "lane", "left edge", "right edge", "slip"}
    assert found.program.off_road(step.score) == by_name["right edge"] > 0
    assert by_name["left edge"] == 0.0
    assert by_name["lane"] > found.program.missed_clearance(step.score)
    assert any(isinstance(limit, Lane) for limit in found.program.soft)


def test_what_diverged_costs_everything() -> None:
    """A trajectory that is not finite has an infinite merit, so that nothing prefers it."""
    diverged = model().roll_out(np.full(6, np.nan), np.zeros((20, 5)), STATIC)
    assert program(np.array([25.0, 0.0])).score(diverged).merit == np.inf


def test_without_obstacles_nothing_is_missed() -> None:
    """A program without obstacles has no missed clearance, whatever the slip angles are."""
    found = program()
    inputs = np.zeros((20, 5))
    inputs[:, 0] = 0.3
    score = found.score(model().roll_out(RUNNING, inputs, STATIC))
    assert score.violations[0] > 0
    assert found.missed_clearance(score) == 0.0


def test_what_holds_a_solution_has_a_name() -> None:
    """A limit is active where leaving it out would change the optimum, and is not where it wouldn't."""
    trajectory, sensitivities, _ = random_roll_out(0)
    for least, names in ((0.2, ("fence",)), (-0.2, ())):
        found = Program((Pull(1.0, 0.0),), BOX, (), (Fence(least, BARE),))
        still = model().roll_out(RUNNING, np.zeros((20, 5)), STATIC)
        assert found.active(solve(found.convex(still, sensitivities, np.array([1.0, 1e4, 1e4, 1e4, 1e4])))) == names
    two = Program((Pull(1.0, 0.0),), BOX, (), (Fence(-0.2, BARE), Fence(0.1, COMFORTABLE)))
    assert two.active(solve(two.convex(trajectory, sensitivities, TRUST))) == ("fence",)


def test_clipping_keeps_box_and_hard_limits() -> None:
    """Inputs come back within the box, at the steering rate, the last free one held."""
    found = program(np.array([25.0, 0.0]))
    clipped = found.clip(np.tile([2.0, 1e5, -1e5, 0.0, 10.0], (20, 1)))
    assert (np.abs(clipped) <= BOX.largest + 1e-12).all()
    assert np.abs(np.diff(clipped[:, 0], prepend=0.01)).max() <= RATE * 0.05 + 1e-12
    np.testing.assert_array_equal(clipped[15:], np.tile(clipped[14], (5, 1)))


def test_each_obstacle_has_a_limit_of_its_own() -> None:
    """Two obstacles in the same place are two limits, told apart by their index."""
    names = [limit.name for limit in situation((Passing.LEFT, Passing.LEFT), AHEAD, AHEAD).program.soft]
    assert names[:2] == ["obstacle 0", "obstacle 1"]
