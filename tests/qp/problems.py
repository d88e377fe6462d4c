"""Quadratic programs for the tests: with every kind of limit, feasible by construction, small or of an MPC's size."""

from dataclasses import replace

import numpy as np

from swerve.qp import Problem, Solution
from swerve.qp.problem import Array

NO_ROWS = (np.zeros(0), np.zeros(0))


def boxed(hessian: Array, gradient: Array, lower: float = -np.inf, upper: float = np.inf) -> Problem:
    """A problem with the same bounds on each variable and no rows."""
    n = len(gradient)
    return Problem(hessian, gradient, np.full(n, lower), np.full(n, upper), np.zeros((0, n)), *NO_ROWS)


def around(rng: np.random.Generator, value: Array) -> tuple[Array, Array]:
    """Limits around `value`: on each side finite or none, a few of them equal."""
    lower = np.where(rng.random(value.size) < 0.7, value - rng.exponential(size=value.size), -np.inf)
    upper = np.where(rng.random(value.size) < 0.7, value + rng.exponential(size=value.size), np.inf)
    equal = rng.random(value.size) < 0.1
    return np.where(equal, value, lower), np.where(equal, value, upper)


def feasible(rng: np.random.Generator, n: int, m: int) -> Problem:
    """A strictly convex problem that a random point meets."""
    root = rng.normal(size=(n, n))
    inside = rng.normal(size=n)
    rows = rng.normal(size=(m, n))
    hessian = root.T @ root + 0.1 * np.eye(n)
    return Problem(hessian, 3 * rng.normal(size=n), *around(rng, inside), rows, *around(rng, rows @ inside))


def unrelated(rng: np.random.Generator, n: int, m: int) -> Problem:
    """A strictly convex problem whose limits belong to different points: many have no solution."""
    problem = feasible(rng, n, m)
    row_lower, row_upper = around(rng, 2 * rng.normal(size=m))
    return replace(problem, row_lower=row_lower, row_upper=row_upper)


def predictive(seed: int, steps: int = 12) -> list[Problem]:
    """Condensed problems of a predictive controller, each near the one before: 75 inputs, 2 slacks, 140 soft rows."""
    rng = np.random.default_rng(seed)
    horizon, n_states, n_inputs = 15, 6, 5
    transition = np.eye(n_states) + 0.05 * rng.normal(size=(n_states, n_states))
    transition /= max(1.0, 1.02 * np.abs(np.linalg.eigvals(transition)).max())
    influence = 0.3 * rng.normal(size=(n_states, n_inputs))
    outputs = rng.normal(size=(10, n_states))
    state = 3 * rng.normal(size=n_states)
    problems = []
    for _ in range(steps):
        a = transition + 1e-3 * rng.normal(size=transition.shape)
        b = influence + 6e-3 * rng.normal(size=influence.shape)
        blocks, powers = [np.zeros((n_states, 77))], [np.eye(n_states)]
        for k in range(horizon):
            block = a @ blocks[-1]
            block[:, n_inputs * k : n_inputs * (k + 1)] += b
            blocks.append(block)
            powers.append(a @ powers[-1])
        free = np.concatenate(powers[1:]) @ state
        forced = np.concatenate(blocks[1:])
        weights = np.tile([1.0, 1.0, 10.0, 0.1, 0.1, 5.0], horizon)
        hessian = 2 * forced.T @ (weights[:, None] * forced) + np.diag([0.6] * 75 + [100.0] * 2)
        gradient = 2 * forced.T @ (weights * free) + np.r_[np.zeros(75), 10.0, 10.0]
        rows = (np.kron(np.eye(horizon), outputs) @ forced)[:140]
        offset = (np.kron(np.eye(horizon), outputs) @ free)[:140]
        rows[::2, -2] = rows[1::2, -1] = -1.0
        lower, upper = np.r_[np.full(75, -1.0), 0.0, 0.0], np.r_[np.full(75, 1.0), np.inf, np.inf]
        problems.append(Problem(hessian, gradient, lower, upper, rows, np.full(140, -np.inf), 2.2 - offset))
        state = 0.97 * state + 0.03 * rng.normal(size=n_states)
    return problems


def mirrored(problem: Problem) -> Problem:
    """The problem in -x: all limits change sides."""
    return replace(
        problem,
        gradient=-problem.gradient,
        lower=-problem.upper,
        upper=-problem.lower,
        row_lower=-problem.row_upper,
        row_upper=-problem.row_lower,
    )


def distance(one: Solution, other: Solution) -> float:
    """Largest difference of two minimisers."""
    return float(np.abs(one.x - other.x).max())
