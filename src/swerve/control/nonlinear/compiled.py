"""The program of a size, formulated and compiled; once in a process, as all of that is without numbers."""

from dataclasses import dataclass
from functools import cache
from pathlib import Path

from swerve.control.nonlinear.formulation import Formulation, formulate
from swerve.control.nonlinear.functions import functions
from swerve.control.nonlinear.layout import Layout
from swerve.control.nonlinear.library import library
from swerve.control.nonlinear.stage import stage
from swerve.control.settings import Horizon


@dataclass(frozen=True, eq=False)
class Compiled:
    """What all programs of a size share.

    Attributes:
        layout: of the variables.
        formulation: as expressions.
        library: with the functions that a solver calls.
    """

    layout: Layout
    formulation: Formulation
    library: Path


@cache
def compiled(solver: str, horizon: Horizon, n_tracked: int, n_obstacles: int, n_pairs: int) -> Compiled:
    """The program for a solver's name.

    Args:
        solver: in `solver.SOLVERS`.
        horizon: all samples, those in which no state is tracked included.
        n_tracked: samples in which one is.
        n_obstacles: that there may be.
        n_pairs: for each of them.

    Raises:
        SwerveError: it can't be compiled.
    """
    arrange = Layout.stages if solver == "fatrop" else Layout.shared
    layout = arrange(horizon, n_obstacles + 1)
    formulation = formulate(layout, n_tracked, n_obstacles, n_pairs)
    made = functions(formulation, stage(n_obstacles * n_pairs), solver)
    return Compiled(layout, formulation, library(f"nonlinear_program_{solver}", made))
