"""What the program is made of: its structure, where its variables and rows are, and its parameters."""

from dataclasses import dataclass
from typing import Any, Final

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import DELTA, N_STATES
from swerve.study.limit.grid import N_INTERVALS
from swerve.study.limit.means import Means
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]

STATE_SCALE: Final = np.array([10.0, 1.0, 1.0, 0.3, 10.0, 1.0])  # [m/s, m/s, rad/s, rad, m, m] per unit of a variable
LOCK_SCALE: Final = 5.0  # of the steering lock's share: small angles matter
DISTANCE_SCALE: Final = 10.0  # [m]
GLOBALS: Final = 3  # D [10 m], mu [1], s [m]


@dataclass(frozen=True)
class Structure:
    """What the expressions depend on; all else is a parameter of the program.

    Attributes:
        vehicle: its numbers are constants of the program, which halves its size.
        means: the free inputs.
        ellipses: whether each obstacle is an ellipse, or a rectangle.
        n_vertices: of the footprint.
    """

    vehicle: Vehicle
    means: Means
    ellipses: tuple[bool, ...]
    n_vertices: int

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
    """Where the variables are, and the rows by the name of what they ask.

    Attributes:
        states: (N, 6) of x_1 ... x_N.
        inputs: (N, n) of v_0 ... v_N-1.
        lines: (n_obstacles, N, 2).
        globals: (3,) of D, mu, s.
        rows: slice of each group.
    """

    states: NDArray[np.int_]
    inputs: NDArray[np.int_]
    lines: NDArray[np.int_]
    globals: NDArray[np.int_]
    rows: dict[str, slice]

    @property
    def n(self) -> int:
        """Number of variables."""
        return int(self.globals[-1]) + 1


class Given(dict[str, Any]):
    """Parameters by name: symbols, or numbers."""

    def vector(self) -> Any:
        """All of them, in order."""
        return ca.vertcat(*(ca.vec(value) for value in self.values()))


def given(structure: Structure) -> Given:
    """A symbol for each parameter; `numbers.parameters` has their meaning."""
    n, nodes = len(structure.ellipses), N_INTERVALS + 1
    sizes = {
        "start": (6, 1),
        "step": (1, 1),
        "slip_speed_floor": (1, 1),
        "cost": (GLOBALS, 1),
        "proximity": (1, 1),
        "vertices": (2, structure.n_vertices),
        "inputs": (structure.n_inputs, N_INTERVALS),
    }
    sizes |= {f"poses{i}": (3, nodes) for i in range(n)} | {f"half{i}": (2, 1) for i in range(n)}
    sizes |= {f"lines{i}": (2, N_INTERVALS) for i in range(n)}
    return Given({name: ca.SX.sym(name, *size) for name, size in sizes.items()})


def layout(structure: Structure, rows: dict[str, ca.SX]) -> Layout:
    """Where everything is, for rows in their order."""
    n_inputs, n_obstacles = structure.n_inputs, len(structure.ellipses)
    sizes = np.cumsum([N_STATES * N_INTERVALS, n_inputs * N_INTERVALS, 2 * n_obstacles * N_INTERVALS, GLOBALS])
    states, inputs, lines, last = np.split(np.arange(sizes[-1]), sizes[:-1])
    ends = np.cumsum([0, *(each.numel() for each in rows.values())])
    slices = {name: slice(int(ends[i]), int(ends[i + 1])) for i, name in enumerate(rows)}
    shape = (n_obstacles, N_INTERVALS, 2)
    return Layout(
        states.reshape(N_INTERVALS, N_STATES), inputs.reshape(N_INTERVALS, n_inputs), lines.reshape(shape), last, slices
    )
