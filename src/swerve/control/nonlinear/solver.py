"""Fatrop and IPOPT, each with the compiled program, called through buffers that are bound once."""

from pathlib import Path
from typing import Any, Final

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.control.nonlinear.buffered import Buffered
from swerve.control.nonlinear.layout import Layout
from swerve.conventions import N_INPUTS

Array = NDArray[np.float64]

TOLERANCE: Final = 1e-6  # of both; at 1e-8, by which Fatrop relaxes the bounds, it goes on to its iteration limit
FIRST_BARRIER: Final = 1e-5  # their own is 0.1; the guess is near, and costs are in units of the program's
ITERATION_LIMIT: Final = 300  # ten times what a program of a drive takes; its guess stands in beyond
SOLVERS: Final[dict[str, dict[str, Any]]] = {
    "fatrop": {"tolerance": TOLERANCE, "mu_init": FIRST_BARRIER, "max_iter": ITERATION_LIMIT, "print_level": 0},
    "ipopt": {
        "tol": TOLERANCE,
        "mu_init": FIRST_BARRIER,
        "max_iter": ITERATION_LIMIT,
        "warm_start_init_point": "yes",  # keep the guess; otherwise it is pushed further from the bounds
        "print_level": 0,
        "sb": "yes",
    },
}
BUFFER_MEMORY: Final = 1  # CasADi's number of the memory that a buffer works in; a plain call has 0


class Solver:
    """One solver with one program. Not for two threads at once: the buffers are its own."""

    def __init__(self, name: str, program: Path, layout: Layout, n_rows: int) -> None:
        """Bind `program`, a library, to the solver of this name; each sample has `n_rows` beside the dynamics."""
        options: dict[str, Any] = {name: SOLVERS[name], "print_time": False, "calc_lam_p": False}
        if layout.is_staged:
            options |= _stages(layout, n_rows)
        self._function = ca.nlpsol(name, name, str(program), options)
        self._call = Buffered(self._function)

    def __call__(self, **inputs: Array) -> tuple[dict[str, Array], bool, int]:
        """Solve with CasADi's inputs x0, p, lbx, ubx, lbg, ubg: its outputs, success, and the number of iterations."""
        outputs = self._call(**inputs)
        statistics = self._function.stats(BUFFER_MEMORY)
        return outputs, bool(statistics["success"]), int(statistics["iter_count"])


def _stages(layout: Layout, n_rows: int) -> dict[str, Any]:
    """What Fatrop has to know of the stages; left to detect them, it guesses where one ends."""
    n_after = layout.n_samples + 1 - layout.n_free
    return {
        "structure_detection": "manual",
        "N": layout.n_samples,
        "nx": [layout.n_slacks] + [layout.n_dynamics] * layout.n_samples,
        "nu": [N_INPUTS] * layout.n_free + [0] * n_after,
        "ng": [n_rows] * layout.n_samples + [0],
        "equality": ([True] * layout.n_dynamics + [False] * n_rows) * layout.n_samples,
    }
