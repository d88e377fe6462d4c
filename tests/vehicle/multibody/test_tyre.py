"""The full vehicle's tyre: the paper's own lateral curve, combined with slip, behind a relaxation length."""

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from swerve.vehicle.multibody import tyre
from swerve.vehicle.tyre import factors, lateral_force
from tests.vehicle.multibody.cars import NUMBERS, SEDAN

Array = NDArray[np.float64]

slips = st.floats(-3.0, 3.0)
loads = st.just(0.0) | st.floats(1.0, 9000.0)


def contact(
    kappa: float, tangent: float, load: float, vx: float = 20.0, rolling: float = 20.0, vy: float = 0.0
) -> tuple[Array, Array]:
    """Rates and forces, in numbers, at friction 0.85."""
    done = tyre.contact(NUMBERS, (ca.DM(kappa), ca.DM(tangent)), ca.DM(vx), ca.DM(rolling), ca.DM(vy), 0.85, load)
    return np.array([float(rate) for rate in done.rates]), np.array([float(force) for force in done.forces])


@given(st.floats(-1.2, 1.2), loads)
def test_pure_lateral_slip_gives_the_papers_curve(angle: float, load: float) -> None:
    """Without longitudinal slip Fy is eq. (4) without longitudinal force, at every load."""
    _, (fx, fy) = contact(0.0, np.tan(angle), load)
    assert fx == 0
    assert fy == pytest.approx(float(lateral_force(SEDAN.tyre, angle, 0.0, 0.85, load)), rel=2e-6, abs=1e-2)


@given(st.floats(-1.0, 1.0), loads)
def test_pure_longitudinal_slip_gives_the_magic_formula(kappa: float, load: float) -> None:
    """Fx = mu Fz D sin(Cx atan(Bx kappa))."""
    _, (fx, fy) = contact(kappa, 0.0, load)
    curve = np.sin(NUMBERS.Cx * np.arctan(NUMBERS.Bx * kappa))
    assert fy == 0
    assert fx == pytest.approx(0.85 * load * factors(SEDAN.tyre, load)[2] * curve, rel=1e-6, abs=1e-2)


@given(slips, slips, loads)
def test_no_force_leaves_the_circle(kappa: float, tangent: float, load: float) -> None:
    """However it slips, the force is mu Fz D at most, and resists."""
    _, (fx, fy) = contact(kappa, tangent, load)
    assert np.hypot(fx, fy) <= 0.85 * load * factors(SEDAN.tyre, load)[2] * (1 + 1e-12)
    assert fx * kappa >= 0
    assert fy * tangent >= 0


def test_a_locked_wheel_is_pushed_back_against_its_sliding() -> None:
    """At 40 degrees of sideslip with a locked wheel, the force is within 4 degrees of opposite to the velocity."""
    angle = np.radians(40.0)
    _, (fx, fy) = contact(-1.0, -np.tan(angle), 4500.0, vx=20.0, rolling=0.0, vy=20.0 * np.tan(angle))
    assert abs(np.degrees(np.arctan2(-fy, -fx)) - 40.0) < 4.0


@pytest.mark.parametrize("component", [0, 1])
def test_small_slip_comes_after_the_relaxation_length(component: int) -> None:
    """After a small step of slip, its transient has gone 1 - 1/e of the way when the wheel has rolled sigma."""
    sigma, wanted, speed = (NUMBERS.sx, NUMBERS.sy)[component], 1e-3, 20.0
    slip, step = np.zeros(2), 1e-5
    for _ in range(round(sigma / speed / step)):
        rolling = speed * (1 + wanted) if component == 0 else speed
        vy = -speed * wanted if component == 1 else 0.0
        slip = slip + step * contact(*slip, 4500.0, speed, rolling, vy)[0]
    assert slip[component] == pytest.approx(wanted * (1 - np.exp(-1)), rel=5e-3)


@pytest.mark.parametrize("kappa", [-1.0, -0.12, 0.05])
def test_steady_slip_is_that_of_the_wheel(kappa: float) -> None:
    """The transient rests where the slip is that of the wheel's own speeds."""
    rates, _ = contact(kappa, 0.1, 4500.0, vx=10.0, rolling=10.0 * (1 + kappa), vy=-1.0)
    if kappa <= 0:
        np.testing.assert_allclose(rates, 0.0, atol=1e-9)
    else:  # a driven wheel's slip is taken over its own speed
        assert contact(kappa / (1 + kappa), 0.0, 4500.0, 10.0, 10.0 * (1 + kappa))[0][0] == pytest.approx(0, abs=1e-9)


def test_at_standstill_it_is_a_damped_spring() -> None:
    """With no speed at all its slip stays, and the force with it; moving away from it, damping adds to the force."""
    rates, (fx, _) = contact(-0.02, 0.0, 4500.0, 0.0, 0.0)
    np.testing.assert_array_equal(rates, 0.0)
    assert fx < 0
    assert contact(-0.02, 0.0, 4500.0, 0.05, 0.0)[1][0] < fx


def test_it_carries_nothing_in_the_air() -> None:
    """Without load there is no force, and its slip is still a number."""
    rates, forces = contact(-0.3, 0.4, 0.0, 5.0, 1.0, -3.0)
    np.testing.assert_array_equal(forces, 0.0)
    assert np.isfinite(rates).all()
