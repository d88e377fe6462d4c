"""The numbers behind Fig. 3 and Fig. 4 of the paper, each with its error.

CarSim's tyre data are not public; in Fig. 4 curves with the parameters of Table 1 stand in their place.
"""

from dataclasses import dataclass
from math import pi
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.vehicle.fitting.curve import magic_formula
from swerve.vehicle.fitting.fit import LETTERS
from swerve.vehicle.fitting.table_1 import LOADS, SLIP_ANGLES, TABLE_1
from swerve.vehicle.tyre import PASSENGER_215_55_R17, factors, lateral_force
from swerve.vehicle.tyre import magic_formula as reduced_magic_formula

Array = NDArray[np.float64]

FIG_3_LOAD: Final = 4780.0  # [N] of Table 1, near a front wheel's; the paper does not say
FIG_3_FRICTION: Final = 0.85  # [1] sec. 5; the paper does not say
FIG_3_SLIP_ANGLES: Final = (1.0, 2.0, 4.0, 6.0, 8.0)  # [deg] to near the peak; the paper does not say
N_ALONG: Final = 181  # points of an ellipse's upper half


@dataclass(frozen=True, eq=False)
class FrictionEllipse:
    """Eq. (4) at one slip angle.

    Attributes:
        slip_angle: [rad].
        longitudinal: (n,) [N].
        lateral: (n,) [N].
        error: largest deviation of eq. (2)'s left side from 1 along it [1].
    """

    slip_angle: float
    longitudinal: Array
    lateral: Array
    error: float


@dataclass(frozen=True, eq=False)
class ForceComparison:
    """Pure lateral force at one load: data and eq. (4) with the printed lines, mu = 1.

    Attributes:
        load: [N].
        slip_angles: (n,) [rad].
        data: (n,) [N].
        reduced: (n,) [N].
    """

    load: float
    slip_angles: Array
    data: Array
    reduced: Array

    @property
    def rms_error(self) -> float:
        """Root mean square of the difference [N]."""
        return float(np.sqrt(np.mean((self.reduced - self.data) ** 2)))

    @property
    def largest_error(self) -> float:
        """Largest difference [N]."""
        return float(np.abs(self.reduced - self.data).max())

    @property
    def relative_error(self) -> float:
        """Largest difference over the data's largest force [1]."""
        return self.largest_error / float(np.abs(self.data).max())


@dataclass(frozen=True, eq=False)
class Figure4:
    """Fig. 4: B, C, D over the load with their printed lines, and the lateral force.

    Attributes:
        loads: (8,) [N].
        values: "B" [1/rad], "C" [1], "D" [1], (8,) each, of Table 1.
        on_lines: the same, of the printed lines.
        forces: one entry for each load.
    """

    loads: Array
    values: dict[str, Array]
    on_lines: dict[str, Array]
    forces: tuple[ForceComparison, ...]

    @property
    def largest_error(self) -> dict[str, float]:
        """Largest distance of Table 1 from the printed line, of "B" [1/rad], "C" [1] and "D" [1]."""
        return {letter: float(np.abs(self.on_lines[letter] - self.values[letter]).max()) for letter in LETTERS}


def figure_3(
    load: float = FIG_3_LOAD, friction: float = FIG_3_FRICTION, slip_angles_deg: tuple[float, ...] = FIG_3_SLIP_ANGLES
) -> tuple[FrictionEllipse, ...]:
    """The friction ellipses of eq. (4) with the paper's tyre.

    Args:
        load: vertical [N].
        friction: mu [1].
        slip_angles_deg: above 0 [deg].
    """
    limit = friction * load
    longitudinal = limit * np.cos(np.linspace(pi, 0.0, N_ALONG))
    tyre, ellipses = PASSENGER_215_55_R17, []
    for slip in np.radians(slip_angles_deg):
        lateral = np.array([float(lateral_force(tyre, slip, fx, friction, load)) for fx in longitudinal])
        largest = limit * float(reduced_magic_formula(tyre, slip, load))
        error = np.abs((longitudinal / limit) ** 2 + (lateral / largest) ** 2 - 1).max()
        ellipses.append(FrictionEllipse(float(slip), longitudinal, lateral, float(error)))
    return tuple(ellipses)


def figure_4() -> Figure4:
    """Table 1 against the printed lines, as values and as forces."""
    loads = np.array(LOADS)
    values = {letter: np.array([getattr(column, letter) for column in TABLE_1]) for letter in LETTERS}
    on_lines = dict(zip(LETTERS, factors(PASSENGER_215_55_R17, loads), strict=True))
    forces = []
    for column in TABLE_1:
        data = column.Fz * magic_formula(SLIP_ANGLES, column.B, column.C, column.D, column.E)
        reduced = column.Fz * magic_formula(SLIP_ANGLES, *factors(PASSENGER_215_55_R17, column.Fz))
        forces.append(ForceComparison(column.Fz, SLIP_ANGLES, data, reduced))
    return Figure4(loads, values, on_lines, tuple(forces))
