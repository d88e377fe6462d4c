"""From (8) to (9): the linear model over one sample, by Euler's rule as in the paper, or exactly.

    xi~(k+1) = A^d xi~(k) + B^d u~(k) + d,    d = Ts f(xi_k, u_k) by Euler

MISPRINT 1: (9) lacks d, which is how far the vehicle moves in a sample with nothing changed; without it the predicted
car stands still. The exact form holds for an input that is held: the exponential of [A B f; 0 0 0] Ts.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm

Array = NDArray[np.float64]


class Discrete(NamedTuple):
    """A^d (6, 6), B^d (6, 5), d (6,)."""

    A: Array
    B: Array
    d: Array


def euler(f: Array, A: Array, B: Array, sample_time: float) -> Discrete:
    """Euler's rule, as the paper's `c2d` was set to use."""
    return Discrete(np.eye(len(A)) + sample_time * A, sample_time * B, sample_time * f)


def exact(f: Array, A: Array, B: Array, sample_time: float) -> Discrete:
    """Zero-order hold ("discretisation")."""
    n, m = B.shape
    whole = np.zeros((n + m + 1, n + m + 1))
    whole[:n] = np.column_stack([A, B, f])
    held = expm(sample_time * whole)[:n]
    return Discrete(held[:, :n], held[:, n : n + m], held[:, -1])
