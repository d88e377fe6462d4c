"""A convex quadratic program, its solvers, and the proof that an answer is its minimiser."""

from swerve.qp.problem import Problem
from swerve.qp.solution import Solution, Status, WarmStart
from swerve.qp.solvers import ITERATION_LIMIT, SOLVERS, solve

__all__ = ["ITERATION_LIMIT", "SOLVERS", "Problem", "Solution", "Status", "WarmStart", "solve"]
