"""Rows that every interval has alike, with derivatives put together from those of one interval.

An interval's own variables are picked from the program's, y = s * x[index], or fixed, and its rows c(y, d) stand below
those of the interval before. So with the compiled functions of one interval

    dg/dx   = sum over i, j of  s_j dc_i/dy_j  at row i and column index_j,
    Hessian = sum over i, j of  s_i s_j d2(lambda' c)/dy_i dy_j  at row index_i and column index_j.

CasADi, left to itself, would write all intervals out: ten seconds of building for each program, and three times the
price of an evaluation.
"""

from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_matrix

from swerve.kernel.library import compiled

Array = NDArray[np.float64]
Indices = NDArray[np.int_]

FIXED = -1  # index of an interval's variable that is none of the program's


@dataclass(frozen=True, eq=False)
class Kernels:
    """Functions of one interval's variables y and numbers d.

    Attributes:
        value: (y, d) -> c.
        jacobian: (y, d) -> (c, dc/dy).
        hessian: (y, d, lambda) -> the Hessian of lambda' c.
    """

    value: ca.Function
    jacobian: ca.Function
    hessian: ca.Function


def kernels(name: str, y: ca.SX, d: ca.SX, c: ca.SX) -> Kernels:
    """Rows c of an interval with their derivatives, compiled where there is a compiler."""
    weights = ca.SX.sym("lambda", c.numel())
    first = ca.densify(ca.jacobian(c, y))
    second = ca.densify(ca.hessian(ca.dot(weights, c), y)[0])
    return Kernels(
        _fast(ca.Function(f"limit_{name}", [y, d], [c])),
        _fast(ca.Function(f"limit_{name}_jacobian", [y, d], [c, first])),
        _fast(ca.Function(f"limit_{name}_hessian", [y, d, weights], [second])),
    )


def _fast(function: ca.Function) -> ca.Function:
    library = compiled(function)
    return function if library is None else ca.external(function.name(), str(library))


@dataclass(frozen=True, eq=False)
class Block:
    """The rows of all intervals.

    Attributes:
        kernels: of one.
        index: (n_y, N) which variables of the program its own are, or FIXED.
        scale: (n_y,) s.
        fixed: (n_y, N) what is added to s x[index]; it gives the fixed ones their values.
        data: (n_d, N) d.
        x: (n,) the program's variables.
    """

    kernels: Kernels
    index: Indices
    scale: Array
    fixed: ca.MX
    data: ca.MX
    x: ca.MX

    @property
    def n_intervals(self) -> int:
        """N."""
        return int(self.index.shape[1])

    @property
    def n_rows(self) -> int:
        """n_c N."""
        return int(self.kernels.value.size1_out(0)) * self.n_intervals

    @property
    def _arguments(self) -> tuple[ca.MX, ca.MX]:
        """The variables and numbers of all intervals."""
        at, where = np.nonzero((self.index != FIXED).T.ravel())[0], self.index.T.ravel()
        scale = np.tile(self.scale, self.n_intervals)
        pick = ca.DM(csc_matrix((scale[at], (at, where[at])), (where.size, self.x.numel())))
        return ca.reshape(pick @ self.x, *self.index.shape) + self.fixed, self.data

    @property
    def rows(self) -> ca.MX:
        """(n_c N,) of g."""
        return ca.vec(self.kernels.value.map(self.n_intervals)(*self._arguments))

    @property
    def jacobian(self) -> ca.MX:
        """(n_c N, n), sparse."""
        blocks = self.kernels.jacobian.map(self.n_intervals)(*self._arguments)[1]
        n_c, n_y, n = blocks.size1(), len(self.index), self.n_intervals
        k, j, i = np.indices((n, n_y, n_c)).reshape(3, -1)
        column = self.index[j, k]
        return _placed(blocks, self.scale[j], (k * n_c + i, column), (n_c * n, self.x.numel()), column != FIXED)

    def hessian(self, weights: ca.MX) -> ca.MX:
        """(n, n) of lambda' g for lambda (n_c N,): its upper triangle, sparse."""
        n_y, n = len(self.index), self.n_intervals
        blocks = self.kernels.hessian.map(n)(*self._arguments, ca.reshape(weights, -1, n))
        k, j, i = np.indices((n, n_y, n_y)).reshape(3, -1)
        row, column = self.index[i, k], self.index[j, k]
        size = self.x.numel()
        upper = (row != FIXED) & (row <= column)
        return _placed(blocks, self.scale[i] * self.scale[j], (row, column), (size, size), upper)


def _placed(blocks: ca.MX, scale: Array, places: tuple[Indices, Indices], shape: tuple[int, int], kept: Array) -> ca.MX:
    """A sparse matrix of the entries of blocks, column by column, that are kept; those at one place add up."""
    flat = places[1][kept] * shape[0] + places[0][kept]
    found, entry = np.unique(flat, return_inverse=True)
    which = np.flatnonzero(kept)
    sums = ca.DM(csc_matrix((scale[which], (entry, which)), (len(found), kept.size)))
    pattern = ca.Sparsity.triplet(*shape, (found % shape[0]).tolist(), (found // shape[0]).tolist())
    return ca.MX(pattern, sums @ ca.vec(blocks))
