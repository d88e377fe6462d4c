"""Table 1 and the three printed lines of sec. 3, made into curves and fitted again."""

import numpy as np
import pytest

from swerve.vehicle.fitting.fit import tyre_of
from swerve.vehicle.fitting.table_1 import LOADS, PRINTED_LINES, TABLE_1
from swerve.vehicle.fitting.table_1_refit import refit_table_1
from swerve.vehicle.tyre import PASSENGER_215_55_R17

REFIT = refit_table_1()


def test_table_1_comes_back() -> None:
    """All four parameters at all eight loads, far beyond the printed digits, E as near to zero as printed."""
    for each, column in zip(REFIT.fit.loads, TABLE_1, strict=True):
        assert pytest.approx((column.B, column.C, column.D), rel=1e-9) == (each.full.B, each.full.C, each.full.D)
        assert abs(each.full.E) < 1e-9
        assert each.full.rms_error < 1e-6
    assert max(REFIT.largest_error.values()) < 1e-9


@pytest.mark.parametrize("letter", ["B", "C", "D"])
def test_the_printed_lines_come_back_within_the_rounding_of_table_1(letter: str) -> None:
    """The printed digits of B, C and D leave the lines this much room, and the printed lines are within it."""
    line = REFIT.lines[letter]
    assert line.is_within_rounding
    x, y = np.array(LOADS), np.array([getattr(column, letter) for column in TABLE_1])
    assert (line.fitted.per_newton, line.fitted.at_no_load) == pytest.approx(tuple(np.polyfit(x, y, 1)), rel=1e-9)


@pytest.mark.parametrize(
    ("letter", "at_no_load", "per_newton"),
    [("B", "13.0408", "-1.4758e-04"), ("C", "1.4465", "7.4404e-07"), ("D", "1.0161", "-9.0689e-06")],
)
def test_the_lines_through_the_printed_table(letter: str, at_no_load: str, per_newton: str) -> None:
    """To the printed digits: 13.0409, 7.4666e-7 and -9.0695e-6 are printed, the other three numbers are the same."""
    fitted = REFIT.lines[letter].fitted
    assert (f"{fitted.at_no_load:.4f}", f"{fitted.per_newton:.4e}") == (at_no_load, per_newton)


def test_rounding_bounds_are_reached() -> None:
    """Moving every entry of Table 1 half a digit, the worst way for the slope, moves the slope by the bound."""
    x = np.array(LOADS)
    y = np.array([column.B for column in TABLE_1])
    worst = y + 5e-5 * np.sign(x - x.mean())
    moved = np.polyfit(x, worst, 1)[0] - np.polyfit(x, y, 1)[0]
    assert REFIT.lines["B"].rounding[1] == pytest.approx(moved, rel=1e-6)


def test_lse_is_a_root_of_squares() -> None:
    """LSE grows as the force itself and is 0.30 to 0.32 % of the peak; a sum of squares would grow as its square."""
    assert REFIT.misfit_exponent == pytest.approx(0.97, abs=0.01)
    assert min(REFIT.misfit) == pytest.approx(0.0030, abs=5e-5)
    assert max(REFIT.misfit) == pytest.approx(0.0032, abs=5e-5)


def test_the_library_s_tyre_has_the_printed_lines() -> None:
    """The paper's tyre is made of the printed numbers, and the fitted tyre is near it."""
    tyre, fitted = PASSENGER_215_55_R17, tyre_of(REFIT.fit.lines)
    printed = [number for line in PRINTED_LINES.values() for number in (line.at_no_load, line.per_newton)]
    assert [tyre.b0, tyre.b1, tyre.c0, tyre.c1, tyre.d0, tyre.d1] == printed
    assert fitted.b0 == pytest.approx(tyre.b0, rel=1e-5)
    assert fitted.d1 == pytest.approx(tyre.d1, rel=1e-4)
