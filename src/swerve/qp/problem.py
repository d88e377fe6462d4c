"""The quadratic program, and how far a point is from solving it.

    minimise    1/2 x' H x + f' x
    subject to  lower     <=  x   <= upper          (bounds, multiplier lambda)
                row_lower <=  G x <= row_upper      (rows, multiplier mu)

A multiplier is positive where the upper side holds x back, negative where the lower side does and zero elsewhere.
With H positive semidefinite, x is a minimiser exactly when it meets the constraints and (Boyd and Vandenberghe,
Convex Optimization, sec. 5.5.3), with sigma(y; l, u) = sum_i max(y_i, 0) u_i + min(y_i, 0) l_i,

    H x + f + lambda + G' mu = 0                                                              (stationary)
    x' H x + f' x + sigma(lambda; lower, upper) + sigma(mu; row_lower, row_upper) = 0         (no duality gap)
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Problem:
    """A convex quadratic program with n variables and m rows.

    Any units of the cost and the variables will do. A row counts as met to 1e-6 (1 + max |x|), so choose units of the
    rows in which that is little. The arrays are read-only by agreement: a Solution points at them.

    Attributes:
        hessian: (n, n) H, symmetric positive semidefinite.
        gradient: (n,) f.
        lower: (n,) smallest x, -inf where there is none.
        upper: (n,) largest x, +inf where there is none.
        rows: (m, n) G; (0, n) for no rows.
        row_lower: (m,) smallest G x, -inf where there is none; equal to `row_upper` for an equality.
        row_upper: (m,) largest G x, +inf where there is none.
    """

    hessian: Array
    gradient: Array
    lower: Array
    upper: Array
    rows: Array
    row_lower: Array
    row_upper: Array

    def check_shapes(self) -> None:
        """Refuse arrays that do not fit together.

        Raises:
            ValueError: an array has the wrong shape; the text names it.
        """
        n, m = self.gradient.size, self.row_lower.size
        if not (
            self.hessian.shape == (n, n)
            and self.rows.shape == (m, n)
            and self.gradient.shape == self.lower.shape == self.upper.shape == (n,)
            and self.row_lower.shape == self.row_upper.shape == (m,)
            and n > 0
        ):
            shapes = ", ".join(f"{name} {array.shape}" for name, array in vars(self).items())
            raise ValueError(f"the arrays of a problem with n = {n} > 0 and m = {m} do not fit together: {shapes}")

    def check(self) -> None:
        """Refuse what no solver could use; for the place where a problem is first set up, not for every step.

        Raises:
            ValueError: shapes do not fit, an array is not of float64, a number is nan or infinite, or the Hessian is
                not symmetric; the text names it.
        """
        self.check_shapes()
        for name, array in vars(self).items():
            if array.dtype != np.float64:
                raise ValueError(f"{name} must be of float64, got {array.dtype}")
        if not self.is_finite:
            raise ValueError("a problem has a number that is nan or infinite, or a bound on the wrong side of infinity")
        asymmetry = float(np.abs(self.hessian - self.hessian.T).max())
        if asymmetry > 1e-9 * np.abs(self.hessian).max():
            raise ValueError(f"hessian is not symmetric: it differs from its transpose by {asymmetry:.3g}")

    @property
    def is_finite(self) -> bool:
        """Whether all is finite but for bounds that are not there: no nan, no lower +inf, no upper -inf."""
        return bool(
            np.isfinite(self.hessian).all()
            and np.isfinite(self.gradient).all()
            and np.isfinite(self.rows).all()
            and (self.lower < np.inf).all()
            and (self.upper > -np.inf).all()
            and (self.row_lower < np.inf).all()
            and (self.row_upper > -np.inf).all()
        )

    def cost(self, x: Array) -> float:
        """Value of 1/2 x' H x + f' x."""
        return float(0.5 * x @ self.hessian @ x + self.gradient @ x)

    def primal_residual(self, x: Array) -> float:
        """Largest violation of a bound or a row, at least 0, in the unit of that bound or row; nan for a nan."""
        on_rows = self.rows @ x
        excess = (x - self.upper, self.lower - x, on_rows - self.row_upper, self.row_lower - on_rows)
        return float(np.concatenate(excess).max(initial=0.0))

    def dual_residual(self, x: Array, bound_multipliers: Array, row_multipliers: Array) -> float:
        """Largest element of |H x + f + lambda + G' mu|, or of a multiplier that pushes against a missing limit."""
        stationarity = self.hessian @ x + self.gradient + bound_multipliers + row_multipliers @ self.rows
        limits = self._limits(bound_multipliers, row_multipliers)
        unfounded = np.concatenate((bound_multipliers, row_multipliers))[np.isinf(limits)]
        return float(np.abs(np.concatenate((stationarity, unfounded))).max())

    def duality_gap(self, x: Array, bound_multipliers: Array, row_multipliers: Array) -> float:
        """Primal minus dual cost of a stationary x; a multiplier against a missing limit is dual residual instead."""
        limits = self._limits(bound_multipliers, row_multipliers)
        support = np.concatenate((bound_multipliers, row_multipliers)) @ np.where(np.isinf(limits), 0.0, limits)
        return float(x @ self.hessian @ x + self.gradient @ x + support)

    def _limits(self, bound_multipliers: Array, row_multipliers: Array) -> Array:
        """Return the side of each bound and row that its multiplier pushes against, (n + m,)."""
        on_bounds = np.where(bound_multipliers > 0, self.upper, self.lower)
        return np.concatenate((on_bounds, np.where(row_multipliers > 0, self.row_upper, self.row_lower)))
