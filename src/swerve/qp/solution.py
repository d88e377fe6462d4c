"""What a solver answers: the point, the multipliers that prove it, and a status that is a sentence."""

from dataclasses import dataclass, field
from enum import Enum

import numpy as np

from swerve.qp.problem import Array, Problem


class Status(Enum):
    """How a solver ended; the value is the sentence for a reader."""

    SOLVED = "The minimiser was found."
    INFEASIBLE = "No point meets all constraints."
    ITERATION_LIMIT = "The solver reached its iteration limit before the minimiser."
    FAILED = "The problem is not one the solver can answer, or its numbers broke down."

    @property
    def sentence(self) -> str:
        """The status in words."""
        return self.value


@dataclass(frozen=True, eq=False)
class WarmStart:
    """A guess of the multipliers, whose signs tell which constraints are active.

    A hint: it may change how long the search takes, not what is found. DAQP begins with that active set; PIQP, an
    interior-point method, has no use for it.

    Attributes:
        bound_multipliers: (n,) of the bounds.
        row_multipliers: (m,) of the rows.
    """

    bound_multipliers: Array
    row_multipliers: Array

    @property
    def multipliers(self) -> Array:
        """All multipliers, (n + m,), those of the bounds first."""
        return np.concatenate((self.bound_multipliers, self.row_multipliers), dtype=np.float64)

    def check_shapes(self, problem: Problem) -> None:
        """Refuse multipliers that do not fit the problem.

        Raises:
            ValueError: there is not one multiplier for each bound and each row.
        """
        fits = self.bound_multipliers.shape == problem.lower.shape
        if not (fits and self.row_multipliers.shape == problem.row_lower.shape):
            given = f"{self.bound_multipliers.shape} and {self.row_multipliers.shape}"
            wanted = f"{problem.lower.shape} and {problem.row_lower.shape}"
            raise ValueError(f"a warm start's multipliers of bounds and rows must be {wanted}, got {given}")


@dataclass(frozen=True, eq=False)
class Solution:
    """Answer of a solver to `problem`; it proves itself by residuals that are computed when asked for.

    Attributes:
        problem: what was asked.
        x: (n,) the minimiser; nan unless the status is SOLVED.
        bound_multipliers: (n,) lambda, positive where x is held by `upper`, negative by `lower`; nan unless SOLVED.
        row_multipliers: (m,) mu, likewise for `row_upper` and `row_lower`.
        status: how the solver ended.
        iterations: that the solver took: changes of the active set for DAQP, Newton steps for PIQP.
        solver: name of the solver.
        reason: the solver's own words when the status is FAILED, else empty.
    """

    problem: Problem = field(repr=False)
    x: Array
    bound_multipliers: Array
    row_multipliers: Array
    status: Status
    iterations: int
    solver: str
    reason: str = ""

    @classmethod
    def without_answer(
        cls, problem: Problem, status: Status, iterations: int, solver: str, reason: str = ""
    ) -> "Solution":
        """The Solution of a solver that found none: x and multipliers are nan, so that nobody can drive by them."""
        n, m = problem.gradient.size, problem.row_lower.size
        nothing = np.full(n + m, np.nan)
        return cls(problem, nothing[:n], nothing[:n], nothing[n:], status, iterations, solver, reason)

    @property
    def is_solved(self) -> bool:
        """Whether the solver says that x is the minimiser."""
        return self.status is Status.SOLVED

    @property
    def warm_start(self) -> WarmStart | None:
        """Start for a similar problem; None when there is no answer to start from."""
        return WarmStart(self.bound_multipliers, self.row_multipliers) if self.is_solved else None

    @property
    def cost(self) -> float:
        """Value of 1/2 x' H x + f' x."""
        return self.problem.cost(self.x)

    @property
    def primal_residual(self) -> float:
        """Largest violation of a bound or a row."""
        return self.problem.primal_residual(self.x)

    @property
    def dual_residual(self) -> float:
        """Largest element of |H x + f + lambda + G' mu|, or of a multiplier that pushes against a missing limit."""
        return self.problem.dual_residual(self.x, self.bound_multipliers, self.row_multipliers)

    @property
    def duality_gap(self) -> float:
        """Primal minus dual cost: what a feasible, stationary x costs above the minimum, at most."""
        return self.problem.duality_gap(self.x, self.bound_multipliers, self.row_multipliers)

    def is_optimal(self, tolerance: float = 1e-6) -> bool:
        """Whether x and the multipliers meet the optimality conditions, whatever the solver says.

        With d = 1 + max |x| and s = max(max H_ii, max |f|), or 1 where that is 0, the residuals are held against d,
        s d and s d^2, so that the verdict does not depend on the unit of the cost. A nan is never optimal.
        """
        d = 1.0 + float(np.abs(self.x).max())
        s = max(float(self.problem.hessian.diagonal().max()), float(np.abs(self.problem.gradient).max())) or 1.0
        return (
            self.primal_residual <= tolerance * d
            and self.dual_residual <= tolerance * s * d
            and abs(self.duality_gap) <= tolerance * s * d**2
        )
