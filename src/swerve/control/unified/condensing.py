"""Condensing: from Jacobians of each sample to sensitivities of the whole motion with respect to the free inputs.

The free inputs z are those of the first Nc samples, in units of INPUT_SCALE; the last of them is held until Np.
From dx_0 = 0,   dx_k+1 = A_k dx_k + B_k E_k z,   where E_k picks (and scales) the input that acts in sample k:
du = INPUT_SCALE * (basis z_block), with the basis of the inputs that the vehicle has (control/actuation.py).
This is W of sec. 4.3.2, for a model that varies along the plan and an input that is held.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from swerve.control.actuation import EVERYTHING, Actuation
from swerve.control.settings import Horizon
from swerve.control.unified.prediction import Linearisation
from swerve.conventions import N_STATES, PSI, X, Y

Array = NDArray[np.float64]

INPUT_SCALE = np.array([0.1, 1e3, 1e3, 1e3, 1e3])  # [rad, N, N, N, N]


@dataclass(frozen=True, eq=False)
class Sensitivities:
    """Derivatives with respect to the n = m Nc free inputs, in SI over INPUT_SCALE.

    Attributes:
        states: (Np, 6, n) of the states at the end of each sample.
        poses: (2 Np, 3, n) of X, Y, psi at every half sample but the first; then of those beyond the horizon.
        front_slip: (Np, n).
        rear_slip: (Np, n).
    """

    states: Array
    poses: Array
    front_slip: Array
    rear_slip: Array

    def extended(self, poses: Array) -> "Sensitivities":
        """The same with those of poses beyond the horizon, (n_beyond, 3, n)."""
        return replace(self, poses=np.concatenate([self.poses, poses]))


class Blocking:
    """Which free input acts in which sample: the first Nc one by one, then the last of them."""

    def __init__(self, horizon: Horizon, actuation: Actuation = EVERYTHING) -> None:
        """Blocks for Np samples and Nc free inputs, of those that there are."""
        self.n_samples, self.n_blocks = horizon.prediction, horizon.control
        self.actuation = actuation
        self.n = actuation.n_free * self.n_blocks
        self.block = np.minimum(np.arange(self.n_samples), self.n_blocks - 1)

    def spread(self, z: Array) -> Array:
        """Changes of the inputs (Np, 5) in SI for scaled free changes z (n,)."""
        free = z.reshape(self.n_blocks, -1) @ self.actuation.basis.T
        return np.asarray((free * INPUT_SCALE)[self.block])

    def embedding(self) -> Array:
        """(5 Nc, n) from scaled free changes to scaled changes of all inputs, block by block."""
        return np.asarray(np.kron(np.eye(self.n_blocks), self.actuation.basis), dtype=np.float64)

    def hold(self, inputs: Array) -> Array:
        """Inputs (Np, 5) with the last free one held from there on."""
        return np.asarray(inputs[self.block])

    def free(self, inputs: Array) -> Array:
        """The free ones (Nc, 5) of inputs (Np, 5), in SI."""
        return inputs[: self.n_blocks]


def condense(linearisation: Linearisation, blocking: Blocking) -> Sensitivities:
    """Sensitivities of states, poses and slip angles along a trajectory."""
    n_samples, n, n_free = blocking.n_samples, blocking.n, blocking.actuation.n_free
    basis = blocking.actuation.basis
    A, B = linearisation.A, linearisation.B * INPUT_SCALE @ basis
    states = np.zeros((n_samples + 1, N_STATES, n))
    for k, block in enumerate(blocking.block):
        # states[k] depends on blocks before `end`; in states[k + 1] block `block` has had its say too
        start, end = n_free * block, n_free * (block + 1)
        np.matmul(A[k], states[k, :, :end], out=states[k + 1, :, :end])
        states[k + 1, :, start:end] += B[k]
    outputs = linearisation.C @ states[:-1]
    by_block = outputs.reshape(n_samples, -1, blocking.n_blocks, n_free)
    by_block[np.arange(n_samples), :, blocking.block] += linearisation.D * INPUT_SCALE @ basis
    poses = np.empty((2 * n_samples, 3, n))
    poses[0::2], poses[1::2] = outputs[:, :3], states[1:, (X, Y, PSI)]
    return Sensitivities(states[1:], poses, outputs[:, 3], outputs[:, 4])
