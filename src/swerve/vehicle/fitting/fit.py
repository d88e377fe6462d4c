"""From tyre data to the reduced tyre of sec. 3: a curve for each load, then lines through B, C and D over the load."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from swerve.vehicle.fitting.curve import Curve, fit_curve, magic_formula
from swerve.vehicle.fitting.data import LoadBlock, TyreData
from swerve.vehicle.fitting.line import Line, fit_line
from swerve.vehicle.tyre import Tyre

LETTERS: Final = ("B", "C", "D")


@dataclass(frozen=True)
class LoadFit:
    """One load, fitted three ways.

    Attributes:
        full: eq. (3) with E free, as in Table 1.
        reduced: eq. (3) with E = 0, which the lines go through.
        line_error: root mean square of the data from eq. (3) with B, C and D from the lines, shifts left out [N].
    """

    full: Curve
    reduced: Curve
    line_error: float


@dataclass(frozen=True)
class TyreFit:
    """What a fit found.

    Attributes:
        file: of the data.
        note: what the data are, one line.
        loads: one entry for each load, rising.
        lines: "B" [1/rad], "C" [1], "D" [1] over the load.
    """

    file: str
    note: str
    loads: tuple[LoadFit, ...]
    lines: dict[str, Line]

    @property
    def tyre(self) -> Tyre:
        """The tyre that a vehicle takes."""
        return tyre_of(self.lines)


def fit_tyre(data: TyreData) -> TyreFit:
    """Fit tyre data as in sec. 3 of the paper, with mu = 1 for their surface.

    Raises:
        InputError: the points of some load do not tell its curve, or are not on one.
    """
    full = [fit_curve(block, data.file, curvature=True) for block in data.blocks]
    reduced = [fit_curve(block, data.file, curvature=False) for block in data.blocks]
    loads = [curve.load for curve in reduced]
    lines = {letter: fit_line(loads, [getattr(curve, letter) for curve in reduced]) for letter in LETTERS}
    errors = [_line_error(block, lines) for block in data.blocks]
    return TyreFit(data.file, data.note, tuple(map(LoadFit, full, reduced, errors)), lines)


def tyre_of(lines: dict[str, Line]) -> Tyre:
    """The reduced tyre with these lines for "B", "C" and "D"."""
    B, C, D = (lines[letter] for letter in LETTERS)
    return Tyre(B.at_no_load, B.per_newton, C.at_no_load, C.per_newton, D.at_no_load, D.per_newton)


def _line_error(block: LoadBlock, lines: dict[str, Line]) -> float:
    B, C, D = (lines[letter].at(block.loads) for letter in LETTERS)
    rest = block.loads * magic_formula(block.slip_angles, B, C, D) - block.forces
    return float(np.sqrt(np.mean(rest**2)))
