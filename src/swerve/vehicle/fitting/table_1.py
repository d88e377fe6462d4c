"""Table 1 of the paper, its three printed lines, and curves made of it.

Source: Yuan, Sun, Gordon: Unified decision making and control for highway collision avoidance, Vehicle System Dynamics,
sec. 3: the tyre 215/55 R17 of CarSim. The row E, from 4e-19 to 1.4e-16, is E = 0 to within the rounding of a computer.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from swerve.vehicle.fitting.curve import magic_formula
from swerve.vehicle.fitting.data import LoadBlock, TyreData


@dataclass(frozen=True)
class Column:
    """One load of Table 1.

    Attributes, with the paper's letters:
        Fz [N], B [1/rad], C [1], D [1], E [1], LSE [N].
    """

    Fz: float
    B: float
    C: float
    D: float
    E: float
    LSE: float


TABLE_1: Final = (
    Column(1594.0, 12.7603, 1.4481, 0.9988, 0.0293e-15, 5.0962),
    Column(3187.0, 12.5691, 1.4490, 0.9871, 0.0603e-15, 10.0173),
    Column(4780.0, 12.3569, 1.4499, 0.9741, 0.0387e-15, 14.7306),
    Column(6374.0, 12.1300, 1.4510, 0.9601, 0.0033e-15, 19.2219),
    Column(7968.0, 11.8914, 1.4522, 0.9455, 0.1406e-15, 23.4742),
    Column(9562.0, 11.6432, 1.4535, 0.9302, 0.0347e-15, 27.4771),
    Column(11155.0, 11.3866, 1.4549, 0.9144, 0.0107e-15, 31.2175),
    Column(12749.0, 11.1227, 1.4564, 0.8982, 0.0004e-15, 34.6881),
)
LOADS: Final = tuple(column.Fz for column in TABLE_1)  # [N]
ROUNDING: Final = 5e-5  # of B, C and D as printed: half a unit of the last digit


@dataclass(frozen=True)
class PrintedLine:
    """A line as the paper prints it, and the unit of its last digits.

    Attributes:
        at_no_load: in the parameter's unit.
        per_newton: in it over [N].
        digit_at_no_load: unit of the last digit of `at_no_load`.
        digit_per_newton: unit of the last digit of `per_newton`.
    """

    at_no_load: float
    per_newton: float
    digit_at_no_load: float
    digit_per_newton: float


PRINTED_LINES: Final = {
    "B": PrintedLine(13.0409, -1.4758e-4, 1e-4, 1e-8),
    "C": PrintedLine(1.4465, 7.4666e-7, 1e-4, 1e-11),
    "D": PrintedLine(1.0161, -9.0695e-6, 1e-4, 1e-10),
}

SLIP_ANGLES: Final = np.radians(np.arange(-20.0, 20.25, 0.5))  # [rad]


def table_1_data() -> TyreData:
    """Curves of eq. (3) with the parameters of Table 1 and mu = 1, -20 to 20 deg, in place of CarSim's data."""
    blocks = []
    for column in TABLE_1:
        forces = column.Fz * magic_formula(SLIP_ANGLES, column.B, column.C, column.D, column.E)
        loads = np.full_like(SLIP_ANGLES, column.Fz)
        blocks.append(LoadBlock(f"load {column.Fz:g} N", loads, SLIP_ANGLES, forces))
    return TyreData("Table 1", "curves of its parameters", tuple(blocks))
