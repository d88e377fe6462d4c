"""The numbers behind Fig. 3 and Fig. 4."""

from itertools import pairwise

import numpy as np
import pytest

from swerve.vehicle.fitting.figures import figure_3, figure_4
from tests.vehicle.fitting.points import force


def test_the_ellipses_of_figure_3_are_ellipses() -> None:
    """Each has the semi-axes mu Fz and mu Fz M(alpha), and follows eq. (2) but for the floor under its root."""
    for ellipse in figure_3(load=4000.0, friction=0.8, slip_angles_deg=(1.0, 3.0, 8.0)):
        across = 0.8 * force(
            4000.0,
            ellipse.slip_angle,
            13.0409 - 1.4758e-4 * 4000,
            1.4465 + 7.4666e-7 * 4000,
            1.0161 - 9.0695e-6 * 4000,
        )
        assert ellipse.lateral.max() == pytest.approx(across, rel=1e-9)
        assert ellipse.longitudinal.max() == pytest.approx(3200.0)
        assert ellipse.error < 2e-6
        inside = np.abs(ellipse.longitudinal) < 3100
        x, y = ellipse.longitudinal[inside] / 3200, ellipse.lateral[inside] / across
        np.testing.assert_allclose(np.hypot(x, y), 1.0, rtol=1e-9)


def test_the_ellipses_grow_with_the_slip_angle() -> None:
    """To the peak, more slip is more lateral force at every longitudinal one."""
    laterals = [ellipse.lateral for ellipse in figure_3()]
    assert all((more >= less).all() for less, more in pairwise(laterals))


def test_figure_4_is_within_half_a_percent_of_the_peak() -> None:
    """The printed lines are at most 0.0454 from B of Table 1, and eq. (4) on them 0.36 % of the peak from its force."""
    figure = figure_4()
    assert figure.largest_error["B"] == pytest.approx(0.0454, abs=1e-4)
    assert figure.largest_error["C"] == pytest.approx(0.00041, abs=1e-5)
    assert figure.largest_error["D"] == pytest.approx(0.00284, abs=1e-5)
    assert max(each.relative_error for each in figure.forces) == pytest.approx(0.00361, abs=1e-5)


def test_the_forces_of_figure_4_are_the_formula_s() -> None:
    """Data are eq. (3) with Table 1's column, the other curve eq. (4) with the printed lines and no wheel force."""
    each = figure_4().forces[2]
    i = 55
    alpha = float(each.slip_angles[i])
    assert each.data[i] == pytest.approx(force(4780.0, alpha, 12.3569, 1.4499, 0.9741))
    lines = (13.0409 - 1.4758e-4 * 4780, 1.4465 + 7.4666e-7 * 4780, 1.0161 - 9.0695e-6 * 4780)
    assert each.reduced[i] == pytest.approx(force(4780.0, alpha, *lines))
    assert each.rms_error <= each.largest_error
