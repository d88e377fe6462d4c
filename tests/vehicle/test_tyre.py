"""The reduced tyre against eq. (2), (3), (4) and Table 1 of the paper, written out once more."""

import math

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.vehicle.tyre import PASSENGER_215_55_R17 as TYRE
from swerve.vehicle.tyre import factors, lateral_force, longitudinal_force, magic_formula

# Table 1: vertical load [N], B, C, D
TABLE_1 = np.array(
    [
        [1594, 12.7603, 1.4481, 0.9988],
        [3187, 12.5691, 1.4490, 0.9871],
        [4780, 12.3569, 1.4499, 0.9741],
        [6374, 12.1300, 1.4510, 0.9601],
        [7968, 11.8914, 1.4522, 0.9455],
        [9562, 11.6432, 1.4535, 0.9302],
        [11155, 11.3866, 1.4549, 0.9144],
        [12749, 11.1227, 1.4564, 0.8982],
    ]
)

slips = st.floats(-1.5, 1.5)
fz = st.floats(300.0, 12_000.0)
mu = st.floats(0.05, 1.5)


def by_hand(slip: float, longitudinal: float, friction: float, load: float) -> float:
    """Eq. (3) and (4) with the numbers of sec. 3."""
    B, C, D = -1.4758e-4 * load + 13.0409, 7.4666e-7 * load + 1.4465, -9.0695e-6 * load + 1.0161
    M = D * math.sin(C * math.atan(B * slip))
    return M * math.sqrt((friction * load) ** 2 - longitudinal**2)


@given(slips, st.floats(-0.99, 0.99), mu, fz)
def test_the_lateral_force_is_that_of_the_paper(slip: float, share: float, friction: float, load: float) -> None:
    """Eq. (4), computed by hand."""
    fx = share * friction * load
    assert lateral_force(TYRE, slip, fx, friction, load) == pytest.approx(by_hand(slip, fx, friction, load), rel=1e-12)


@given(slips.filter(lambda slip: abs(slip) > 1e-3), st.floats(-0.99, 0.99), mu, fz)
def test_forces_lie_on_the_friction_ellipse(slip: float, share: float, friction: float, load: float) -> None:
    """Eq. (2): (Fx / Fx_max)^2 + (Fy / Fy_max)^2 = 1 with Fx_max = mu Fz and Fy_max the force without Fx."""
    fx = share * friction * load
    largest = lateral_force(TYRE, slip, 0.0, friction, load)
    fy = lateral_force(TYRE, slip, fx, friction, load)
    assert share**2 + (fy / largest) ** 2 == pytest.approx(1.0, rel=1e-9)


@given(slips, st.floats(-3.0, 3.0), mu, fz)
def test_a_demand_beyond_the_circle_gets_the_circle(slip: float, share: float, friction: float, load: float) -> None:
    """The wheel force is the demand within mu Fz, and mu Fz beyond; almost nothing is then left for the side."""
    fx = longitudinal_force(share * friction * load, friction, load)
    assert fx == pytest.approx(min(max(share, -1.0), 1.0) * friction * load)
    if abs(share) >= 1:
        assert abs(lateral_force(TYRE, slip, fx, friction, load)) <= 2e-3 * friction * load


@given(fz)
def test_the_peak_slip_is_where_the_force_is_largest(load: float) -> None:
    """No slip angle gives more than the one of the peak, where M = D."""
    peak = TYRE.peak_slip(load)
    grid = np.linspace(0.0, 0.6, 6001)  # [rad]
    values = [magic_formula(TYRE, slip, load) for slip in grid]
    assert magic_formula(TYRE, peak, load) == pytest.approx(factors(TYRE, load)[2], rel=1e-12)
    assert max(values) <= magic_formula(TYRE, peak, load) * (1 + 1e-12)
    assert grid[int(np.argmax(values))] == pytest.approx(peak, abs=2e-4)


def test_the_peak_is_near_8_6_degrees() -> None:
    """At the front wheels' static load the peak is where the notes on the paper say it is."""
    assert math.degrees(TYRE.peak_slip(4508.0)) == pytest.approx(8.6, abs=0.2)


@given(mu, fz)
def test_the_slope_at_no_slip_is_the_cornering_stiffness(friction: float, load: float) -> None:
    """dFy/dalpha at zero is B C D mu Fz."""
    B, C, D = factors(TYRE, load)
    h = 1e-5  # [rad]
    slope = (lateral_force(TYRE, h, 0.0, friction, load) - lateral_force(TYRE, -h, 0.0, friction, load)) / (2 * h)
    assert slope == pytest.approx(B * C * D * friction * load, rel=1e-6)


@given(slips, st.floats(-0.99, 0.99), mu, fz)
def test_the_tyre_is_the_same_to_both_sides(slip: float, share: float, friction: float, load: float) -> None:
    """The lateral force changes its sign with the slip angle, and not with that of the wheel force."""
    fx = share * friction * load
    here = lateral_force(TYRE, slip, fx, friction, load)
    assert lateral_force(TYRE, -slip, fx, friction, load) == -here
    assert lateral_force(TYRE, slip, -fx, friction, load) == here
    assert here * slip >= 0


def test_the_lines_fit_table_1() -> None:
    """The printed lines for B, C and D stay near the table that they were fitted to."""
    fitted = np.array([factors(TYRE, load) for load in TABLE_1[:, 0]])
    assert (np.abs(fitted / TABLE_1[:, 1:] - 1) < [4e-3, 4e-4, 3e-3]).all()


@pytest.mark.parametrize("share", [-1.0, 1.0, 0.0, 1.5])
def test_derivatives_stay_finite_on_the_circle(share: float) -> None:
    """Where the root of (4) ends, its derivatives by slip angle and wheel force are numbers."""
    slip, demand = ca.SX.sym("alpha"), ca.SX.sym("demand")
    force = lateral_force(TYRE, slip, longitudinal_force(demand, 0.85, 4500.0), 0.85, 4500.0)
    gradient = ca.Function("gradient", [slip, demand], [ca.jacobian(force, ca.vertcat(slip, demand))])
    assert np.isfinite(np.array(gradient(0.05, share * 0.85 * 4500.0))).all()
