"""Sec. 4.2 and 4.3: cost (10) and constraints (14), (15) in the canonical form G dU <= gamma of (16).

MISPRINT 4: W lets the input after Nc fall back to u_k: its last column acts in sample Nc alone.
MISPRINT 5: (15) is written for i < Nc; sec. 4.3.2 poses it over Np, which is done here. "I (x) P W" is shorthand
for P acting on each stage of W. W's height 4 Nc is a misprint for 5 Nc, and Q's 6 x 6 for 3 x 3.
"""

import numpy as np
from numpy.typing import NDArray

from swerve.control.as_printed.discretisation import Discrete
from swerve.control.settings import Horizon
from swerve.conventions import N_INPUTS, N_STATES, X, Y
from swerve.qp import Problem

Array = NDArray[np.float64]

OUTPUTS = (0, 1, Y)  # rows of c: vx, vy, Y
INPUT_SCALE = np.array([0.1, 1e3, 1e3, 1e3, 1e3])  # [rad, N, N, N, N] of the solver's variables


def response(model: Discrete, horizon: Horizon, *, with_drift: bool, hold_input: bool) -> tuple[Array, Array]:
    """The predicted xi~ at k+1 .. k+Np as free + forced U~: free (Np, 6) and W (Np, 6, 5 Nc).

    Args:
        model: of one sample.
        horizon: Np, Nc.
        with_drift: with the term d ("drift"); without it the free response is zero.
        hold_input: u(k + Nc - 1) acts until Np ("hold-input"), else u~ is zero after Nc.
    """
    free = np.zeros((horizon.prediction, N_STATES))
    W = np.zeros((horizon.prediction, N_STATES, N_INPUTS * horizon.control))
    last_free, last_W = np.zeros(N_STATES), np.zeros_like(W[0])
    for k in range(horizon.prediction):
        # the last_* are the response at k: one more sample passes, in which input `block`, if any, acts
        last_free = model.A @ last_free + (model.d if with_drift else 0.0)
        last_W = model.A @ last_W
        if k < horizon.control or hold_input:
            block = min(k, horizon.control - 1)
            last_W[:, N_INPUTS * block : N_INPUTS * (block + 1)] += model.B
        free[k], W[k] = last_free, last_W
    return free, W


def obstacle_rows(free: Array, W: Array, rho: Array, gradient: Array) -> tuple[Array, Array]:
    """(15), linearised once at (X_k, Y_k) for each obstacle: matrix @ U~ >= bound.

    Args:
        free: (Np, 6) of `response`.
        W: (Np, 6, 5 Nc) of `response`.
        rho: (m, Np) rho^k of each obstacle at its position in each sample.
        gradient: (m, Np, 2) p1, p2 likewise.

    Returns:
        matrix (m Np, 5 Nc) and bound (m Np,).
    """
    matrix = np.einsum("mkj,kjn->mkn", gradient, W[:, (X, Y)])
    bound = 1 - rho - np.einsum("mkj,kj->mk", gradient, free[:, (X, Y)])
    return matrix.reshape(-1, W.shape[2]), bound.ravel()


def canonical(
    free: Array, W: Array, deviation: Array, Q: Array, R: Array, lower: Array, upper: Array, rows: tuple[Array, Array]
) -> Problem:
    """The quadratic program in dU, in units of INPUT_SCALE.

    Args:
        free: (Np, 6).
        W: (Np, 6, 5 Nc).
        deviation: (3,) eta_ref - eta_k.
        Q: (3,) its diagonal.
        R: (5,) its diagonal.
        lower: (5,) u_min - u_k.
        upper: (5,) u_max - u_k.
        rows: of the obstacles, over U~.
    """
    n = W.shape[2]
    blocks = n // N_INPUTS
    N2 = np.kron(np.tri(blocks), np.diag(INPUT_SCALE))  # (17) with u~(k-1) = 0: U~ = N2 dU
    eta = (W[:, OUTPUTS] @ N2).reshape(-1, n)
    residual = (free[:, OUTPUTS] - deviation).ravel()
    weight = np.tile(Q, len(W))
    hessian = 2 * (eta.T * weight) @ eta + 2 * np.diag(np.tile(R * INPUT_SCALE**2, blocks))
    unscale = np.tile(INPUT_SCALE, blocks)[:, np.newaxis]
    matrix, bound = rows
    infinite = np.full(n, np.inf)
    return Problem(
        hessian=hessian,
        gradient=2 * (eta.T * weight) @ residual,
        lower=-infinite,
        upper=infinite,
        rows=np.vstack([N2 / unscale, matrix @ N2]),
        row_lower=np.concatenate([np.tile(lower, blocks) / unscale[:, 0], bound]),
        row_upper=np.concatenate([np.tile(upper, blocks) / unscale[:, 0], np.full(len(bound), np.inf)]),
    )
