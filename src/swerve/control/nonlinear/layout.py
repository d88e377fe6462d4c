"""Where the variables of the program are in the vector of all of them. Both solvers read the same program through it.

    stages (Fatrop):   [s, u_0 | z_1, u_1 | ... | z_Np],   z_k = [x_k; u_k-1; s]
    shared (IPOPT):    [u_0 | x_1, u_1 | ... | x_Np | s]

x_0 and u_-1 are known, and the last free input is held to the end of the horizon. Fatrop's stages see their neighbours'
states alone, so what the cost and the limits share between stages travels in z: the input before, and the slacks.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.settings import Horizon
from swerve.conventions import N_INPUTS, N_STATES

Indices = NDArray[np.int_]


@dataclass(frozen=True, eq=False)
class Layout:
    """Indices of the variables; those that stages share have the same index wherever they appear.

    Attributes:
        inputs: (Nc, 5) of u_0 to u_Nc-1.
        states: (Np, 6) of x_1 to x_Np.
        previous: (Np, 5) of u_0 to u_Np-1 as the cost of the next stage sees them.
        slacks: (Np + 1, n_slacks) of s as each stage sees it.
        is_staged: whether `previous` and `slacks` are variables of their own at each stage.
    """

    inputs: Indices
    states: Indices
    previous: Indices
    slacks: Indices
    is_staged: bool

    @classmethod
    def stages(cls, horizon: Horizon, n_slacks: int) -> "Layout":
        """The layout for Fatrop."""
        z = np.full(horizon.prediction + 1, N_STATES + N_INPUTS + n_slacks)
        z[0] = n_slacks
        ends = np.cumsum(z + N_INPUTS * (np.arange(len(z)) < horizon.control))  # of each stage
        ends_of_z = np.append(0, ends[:-1]) + z
        slacks = _before(ends_of_z, n_slacks)
        previous = _before(slacks[1:, 0], N_INPUTS)
        states = _before(previous[:, 0], N_STATES)
        return cls(_before(ends[: horizon.control], N_INPUTS), states, previous, slacks, is_staged=True)

    @classmethod
    def shared(cls, horizon: Horizon, n_slacks: int) -> "Layout":
        """The layout for IPOPT."""
        is_free = np.arange(horizon.prediction) < horizon.control
        ends = np.cumsum(N_STATES + N_INPUTS * is_free)  # of u_k, x_k+1
        states = _before(ends, N_STATES)
        inputs = _before(states[: horizon.control, 0], N_INPUTS)
        held = inputs[np.minimum(np.arange(horizon.prediction), horizon.control - 1)]
        slacks = np.tile(ends[-1] + np.arange(n_slacks), (horizon.prediction + 1, 1))
        return cls(inputs, states, held, slacks, is_staged=False)

    @property
    def n(self) -> int:
        """Number of variables."""
        return 1 + max(int(self.states.max()), int(self.slacks.max()))

    @property
    def n_samples(self) -> int:
        """Np."""
        return len(self.states)

    @property
    def n_free(self) -> int:
        """Nc."""
        return len(self.inputs)

    @property
    def n_slacks(self) -> int:
        """Slacks at a stage."""
        return len(self.slacks[0])

    @property
    def n_dynamics(self) -> int:
        """Rows that tie the end of a sample to the next stage."""
        return N_STATES + (N_INPUTS + self.n_slacks) * self.is_staged

    def held(self, inputs: NDArray[np.float64]) -> NDArray[np.float64]:
        """Inputs (Np, 5) of which the last free one is held."""
        return np.asarray(inputs[np.minimum(np.arange(self.n_samples), self.n_free - 1)])


def _before(ends: Indices, n: int) -> Indices:
    """The n indices before each of the ends (m,): (m, n)."""
    return np.asarray(ends)[:, np.newaxis] + np.arange(-n, 0)
