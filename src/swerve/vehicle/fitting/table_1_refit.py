"""Table 1 of the paper made into curves and fitted again, with the error of each number.

CarSim's tyre data are not public. Curves with the parameters of Table 1 stand in their place, which tests the fit and
the lines, and not how well eq. (3) meets CarSim.
"""

from dataclasses import dataclass

import numpy as np

from swerve.vehicle.fitting.fit import LETTERS, TyreFit, fit_tyre
from swerve.vehicle.fitting.line import Line
from swerve.vehicle.fitting.table_1 import LOADS, PRINTED_LINES, ROUNDING, TABLE_1, table_1_data


@dataclass(frozen=True)
class LineComparison:
    """A printed line beside the least-squares line through the printed values.

    Attributes:
        printed: at no load, in the parameter's unit, and per [N].
        fitted: the line through Table 1, fitted again.
        rounding: by how much the rounding of Table 1's values can move the fitted line's two numbers.
    """

    printed: tuple[float, float]
    fitted: Line
    rounding: tuple[float, float]

    @property
    def difference(self) -> tuple[float, float]:
        """Fitted less printed, at no load and per [N]."""
        at_no_load, per_newton = self.printed
        return self.fitted.at_no_load - at_no_load, self.fitted.per_newton - per_newton

    @property
    def is_within_rounding(self) -> bool:
        """Whether the rounding of Table 1 explains both differences."""
        return all(abs(d) <= r for d, r in zip(self.difference, self.rounding, strict=True))


@dataclass(frozen=True)
class Table1Refit:
    """Table 1, made into curves and fitted again.

    Attributes:
        fit: of the curves.
        largest_error: of B [1/rad], C, D and E [1] over all loads, fitted less printed.
        lines: "B", "C", "D".
        misfit: LSE over the peak force D Fz, a load each [1].
        misfit_exponent: LSE grows as the peak force to this power [1]: 1 is a root of squares, 2 would be their sum.
    """

    fit: TyreFit
    largest_error: dict[str, float]
    lines: dict[str, LineComparison]
    misfit: tuple[float, ...]
    misfit_exponent: float


def refit_table_1() -> Table1Refit:
    """Make curves of Table 1 and fit them again."""
    fit = fit_tyre(table_1_data())
    curves = [load.full for load in fit.loads]
    errors = {
        letter: max(abs(getattr(c, letter) - getattr(p, letter)) for c, p in zip(curves, TABLE_1, strict=True))
        for letter in (*LETTERS, "E")
    }
    rounding = _rounding_of_lines()
    lines = {
        letter: LineComparison((p.at_no_load, p.per_newton), fit.lines[letter], rounding)
        for letter, p in PRINTED_LINES.items()
    }
    peaks = np.array([column.D * column.Fz for column in TABLE_1])
    lse = np.array([column.LSE for column in TABLE_1])
    exponent = float(np.polyfit(np.log(peaks), np.log(lse), 1)[0])
    return Table1Refit(fit, errors, lines, tuple(float(share) for share in lse / peaks), exponent)


def _rounding_of_lines() -> tuple[float, float]:
    """The most that values, each moved by half a unit of Table 1's last digit, move their line's two numbers."""
    loads = np.array(LOADS)
    from_mean = loads - loads.mean()
    slope = from_mean / (from_mean @ from_mean)  # weights of the values in the slope
    at_no_load = 1 / len(loads) - slope * loads.mean()
    return ROUNDING * float(np.abs(at_no_load).sum()), ROUNDING * float(np.abs(slope).sum())
