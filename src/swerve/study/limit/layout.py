"""What the program is made of: its structure, where its variables are, and its parameters."""

from dataclasses import dataclass
from typing import Any, Final

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import DELTA, N_STATES
from swerve.study.limit.means import Means

Array = NDArray[np.float64]
Indices = NDArray[np.int_]

STATE_SCALE: Final = np.array([10.0, 1.0, 1.0, 0.3, 10.0, 1.0])  # [m/s, m/s, rad/s, rad, m, m] per unit of a variable
LOCK_SCALE: Final = 5.0  # of the steering lock's share: small angles matter
DISTANCE_SCALE: Final = 10.0  # [m]
N_GLOBALS: Final = 3  # D [10 m], mu [1], s [m]


@dataclass(frozen=True)
class Structure:
    """What the expressions depend on; all else is a parameter of the program.

    Attributes:
        means: the free inputs.
        ellipses: whether each obstacle is an ellipse, or a rectangle.
        n_vertices: of the footprint.
        has_edges: whether the road has.
        n_intervals: N.
    """

    means: Means
    ellipses: tuple[bool, ...]
    n_vertices: int
    has_edges: bool
    n_intervals: int

    @property
    def n_inputs(self) -> int:
        """Number of free inputs."""
        return int(self.means.directions.shape[1])

    @property
    def input_scale(self) -> Array:
        """(n_inputs,) units of each input's variable in a share of it."""
        scale: Array = np.where(self.means.directions[DELTA] > 0, LOCK_SCALE, 1.0)
        return scale


@dataclass(frozen=True)
class Layout:
    """Where the variables are.

    Attributes:
        states: (N, 6) of x_1 ... x_N.
        inputs: (N, n) of v_0 ... v_N-1.
        lines: (n_obstacles, N, 2).
        globals: (3,) of D, mu, s.
    """

    states: Indices
    inputs: Indices
    lines: Indices
    globals: Indices

    @classmethod
    def of(cls, structure: Structure) -> "Layout":
        """One group after the other, each interval by interval."""
        n, n_obstacles, n_inputs = structure.n_intervals, len(structure.ellipses), structure.n_inputs
        sizes = np.cumsum([N_STATES * n, n_inputs * n, 2 * n_obstacles * n, N_GLOBALS])
        states, inputs, lines, last = np.split(np.arange(sizes[-1]), sizes[:-1])
        return cls(states.reshape(n, N_STATES), inputs.reshape(n, n_inputs), lines.reshape(n_obstacles, n, 2), last)

    @property
    def n(self) -> int:
        """Number of variables."""
        return int(self.globals[-1]) + 1


class Given(dict[str, Any]):
    """Parameters by name: symbols, or numbers."""

    def vector(self) -> Any:
        """All of them, in order."""
        return ca.vertcat(*(ca.vec(value) for value in self.values()))


def given(structure: Structure, n_model: int) -> Given:
    """A symbol for each parameter, of which the model takes `n_model`; `numbers.parameters` has their meaning."""
    n, n_obstacles = structure.n_intervals, len(structure.ellipses)
    sizes = {
        "start": (N_STATES, 1),
        "step": (1, 1),
        "model": (n_model, 1),
        "cost": (N_GLOBALS, 1),
        "proximity": (1, 1),
        "vertices": (2, structure.n_vertices),
        "inputs": (structure.n_inputs, n),
    }
    sizes |= {f"poses{i}": (3, n + 1) for i in range(n_obstacles)} | {f"half{i}": (2, 1) for i in range(n_obstacles)}
    sizes |= {f"lines{i}": (2, n) for i in range(n_obstacles)}
    return Given({name: ca.MX.sym(name, *size) for name, size in sizes.items()})
