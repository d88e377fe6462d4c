"""The same problem with a Hessian of unit diagonal, so that solvers, whose tolerances are absolute, see no units.

With x = D z and D_ii = sqrt(c / H_ii), the cost divided by c has the Hessian D H D / c. Up to a factor n, no other
diagonal scaling makes its condition number smaller (van der Sluis, Numerische Mathematik 14, 1969). The middle c, that
of the largest and the smallest H_ii in logarithm, keeps D near one: bounds are met to the solver's tolerance times D.
"""

import math
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from swerve.qp.problem import Array, Problem
from swerve.qp.solution import Solution

WEIGHTLESS: Final = 1e-16  # [largest H_ii] a variable whose H_ii is no more keeps its unit


@dataclass(frozen=True, eq=False)
class Equilibration:
    """The scales of one problem.

    Attributes:
        sizes: (n,) diagonal of D: x per z.
        cost: c, cost of `problem` per cost of the scaled one.
    """

    sizes: Array
    cost: float

    @classmethod
    def of(cls, problem: Problem) -> "Equilibration":
        """The scales of `problem`: ones where no variable has a finite weight."""
        weights = problem.hessian.diagonal()
        heaviest = float(weights.max())
        if not 0.0 < heaviest < math.inf:
            return cls(np.ones(weights.size), 1.0)
        weighted = weights > WEIGHTLESS * heaviest
        cost = math.sqrt(heaviest) * math.sqrt(float(weights[weighted].min()))
        return cls(np.sqrt(cost / np.where(weighted, weights, cost)), cost)

    def scaled(self, problem: Problem) -> Problem:
        """The problem in z."""
        by_size = self.sizes / self.cost
        return Problem(
            hessian=problem.hessian * self.sizes * by_size[:, None],
            gradient=problem.gradient * by_size,
            lower=problem.lower / self.sizes,
            upper=problem.upper / self.sizes,
            rows=problem.rows * self.sizes,
            row_lower=problem.row_lower,
            row_upper=problem.row_upper,
        )

    def unscaled(self, solution: Solution, problem: Problem) -> Solution:
        """The solution of `problem` that belongs to a `solution` in z."""
        return replace(
            solution,
            problem=problem,
            x=solution.x * self.sizes,
            bound_multipliers=solution.bound_multipliers * (self.cost / self.sizes),
            row_multipliers=solution.row_multipliers * self.cost,
        )
