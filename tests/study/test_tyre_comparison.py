"""Fig. 5: eq. (4) against the tyres of the multibody plant."""

from functools import cache

import numpy as np
import pytest

from swerve.conventions import WHEELS
from swerve.report.figures.fig05_lateral_forces import lateral_forces
from swerve.study.manoeuvres import SmoothLaneChange
from swerve.study.tyre_comparison import TyreComparison, compare_tyres


@cache
def _comparison() -> TyreComparison:
    return compare_tyres()


def test_eq_4_reproduces_the_lateral_forces() -> None:
    """Within 3 % of the peak at every wheel, which has both braked and driven."""
    assert tuple(each.wheel for each in _comparison().wheels) == WHEELS
    for each in _comparison().wheels:
        assert 0.001 < each.relative_error < 0.03
        assert each.rms_error < each.largest_error < 0.1 * each.peak


def test_it_is_evaluated_from_the_same_slip_loads_and_forces() -> None:
    """mu Fz D sin(C atan(B alpha)) inside the friction circle, written out."""
    motion, tyre = _comparison().run.motion, _comparison().run.car.vehicle.tyre
    for each in _comparison().wheels:
        load, alpha, fx = (motion[f"{name}_{each.wheel}"] for name in ("Fz", "alpha", "Fx"))
        b, c, d = (getattr(tyre, f"{x}0") + getattr(tyre, f"{x}1") * load for x in "bcd")
        expected = d * np.sin(c * np.arctan(b * alpha)) * np.sqrt((0.6 * load) ** 2 - fx**2)
        np.testing.assert_allclose(each.reduced, expected, rtol=1e-9, atol=1e-6)


def test_the_errors_are_its_numbers() -> None:
    """Root mean square, largest, and relative to the peak, for each wheel."""
    for each in _comparison().wheels:
        error = each.reduced - each.full
        values = _comparison().to_json()[each.wheel]
        assert values["rms_error"] == pytest.approx(np.sqrt((error**2).mean()))
        assert values["largest_error"] == pytest.approx(np.abs(error).max())
        assert values["relative_error"] == pytest.approx(values["rms_error"] / np.abs(each.full).max())


def test_a_harder_change_has_a_larger_error() -> None:
    """The error is of combined slip and relaxation, so it grows with both."""
    gentle = compare_tyres(manoeuvre=SmoothLaneChange(offset=1.0, acceleration=1.0))
    assert all(a.rms_error < b.rms_error for a, b in zip(gentle.wheels, _comparison().wheels, strict=True))


def test_the_figure_has_a_panel_for_each_wheel_with_units() -> None:
    """Four panels with both curves, and the errors in their titles."""
    panels = lateral_forces(_comparison()).axes
    assert len(panels) == 4
    for axes, each in zip(panels, _comparison().wheels, strict=True):
        assert len(axes.lines) == 2
        assert f"{each.rms_error:.0f} N" in axes.get_title()
    assert panels[0].get_ylabel().endswith("[kN]") and panels[2].get_xlabel() == "time [s]"
