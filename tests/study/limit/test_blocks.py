"""Rows of all intervals and their derivatives, against CasADi's own of the rows written out."""

import casadi as ca
import numpy as np

from swerve.study.limit.blocks import FIXED, Block, kernels

N = 3
SCALE = np.array([2.0, 0.5, 3.0])
INDEX = np.array([[FIXED, 0, 2], [1, 3, 4], [5, 5, 5]])  # the first is given at the start, the last is the same for all


def written_out(x: ca.MX, start: ca.MX, data: ca.MX) -> ca.MX:
    """The same rows, interval by interval."""
    found = []
    for k in range(N):
        a = start if k == 0 else SCALE[0] * x[int(INDEX[0, k])]
        b, c = SCALE[1] * x[int(INDEX[1, k])], SCALE[2] * x[5]
        found += [a * b * c + data[k], ca.sin(b) * c**2]
    return ca.vertcat(*found)


def test_rows_and_derivatives_are_those_of_the_rows_written_out() -> None:
    """Values, Jacobian and the Hessian's upper triangle, to 1e-12, at ten points."""
    y, d = ca.SX.sym("y", 3), ca.SX.sym("d")
    rows = kernels("test_rows", y, d, ca.vertcat(y[0] * y[1] * y[2] + d, ca.sin(y[1]) * y[2] ** 2))
    x, start, data = ca.MX.sym("x", 6), ca.MX.sym("start"), ca.MX.sym("data", N)
    weights = ca.MX.sym("lambda", 2 * N)
    fixed = ca.horzcat(ca.vertcat(start, 0, 0), ca.MX(3, N - 1))
    block = Block(rows, INDEX, SCALE, fixed, data.T, x)
    expected = written_out(x, start, data)
    hessian = ca.triu(ca.hessian(ca.dot(weights, expected), x)[0])
    given = [x, start, data, weights]
    ours = ca.Function("ours", given, [block.rows, block.jacobian, block.hessian(weights)])
    theirs = ca.Function("theirs", given, [expected, ca.jacobian(expected, x), hessian])
    random = np.random.default_rng(1)
    for _ in range(10):
        at = [random.uniform(-1, 1, each.numel()) for each in given]
        for one, other in zip(ours(*at), theirs(*at), strict=True):
            assert np.allclose(ca.DM(one).full(), ca.DM(other).full(), rtol=0, atol=1e-12)
    assert block.n_rows == 2 * N
