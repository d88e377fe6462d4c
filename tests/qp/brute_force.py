"""The minimiser of a small strictly convex problem by trying every active set."""

from itertools import combinations, product

import numpy as np

from swerve.qp import Problem
from swerve.qp.problem import Array

TOLERANCE = 1e-9


def minimiser(problem: Problem) -> Array | None:
    """The one point that meets all optimality conditions; None when no active set has one: the problem is infeasible.

    At most n constraints need be active at once: of more, some are combinations of the others.
    """
    n = problem.gradient.size
    normals = np.concatenate((np.eye(n), problem.rows))
    lower = np.concatenate((problem.lower, problem.row_lower))
    upper = np.concatenate((problem.upper, problem.row_upper))
    for size in range(n + 1):
        for active in map(list, combinations(range(len(normals)), size)):
            for on_upper in product((False, True), repeat=size):
                limits = np.where(on_upper, upper[active], lower[active])
                point = _stationary(problem, normals[active], limits)
                if point is None:
                    continue
                x, multipliers = point
                pushes = np.where(on_upper, multipliers, -multipliers) >= -TOLERANCE
                values = normals @ x
                inside = (values >= lower - TOLERANCE).all() and (values <= upper + TOLERANCE).all()
                if inside and (pushes | (lower[active] == upper[active])).all():
                    return x
    return None


def _stationary(problem: Problem, normals: Array, limits: Array) -> tuple[Array, Array] | None:
    """Minimiser and multipliers with the given constraints as equalities; None if they are infinite or dependent."""
    size, n = normals.shape
    if not np.isfinite(limits).all() or (size and np.linalg.matrix_rank(normals) < size):
        return None
    matrix = np.block([[problem.hessian, normals.T], [normals, np.zeros((size, size))]])
    both = np.linalg.solve(matrix, np.concatenate((-problem.gradient, limits)))
    return both[:n], both[n:]
