"""The Magic Formula of property files against another project's numbers, and against what its coefficients mean."""

from dataclasses import fields
from math import atan, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.vehicle.fitting.magic_formula import LateralCoefficients, cornering_stiffness, lateral_force
from swerve.vehicle.fitting.property_file import read_property_file
from tests.vehicle.fitting.points import HERE


def coefficients(name: str) -> LateralCoefficients:
    """Those of a sample file."""
    source = read_property_file(HERE / name)
    return LateralCoefficients(
        **{f.name: source.number(f.name) for f in fields(LateralCoefficients) if source.entry(f.name)}
    )


MF_61, MF_52 = coefficients("sample_61.tir"), coefficients("sample_52.tir")

# load [N], slip angle [rad], camber [rad], pressure [Pa], and the force [N] that TyreDyn (Niek van Rossem, MIT licence,
# commit 4b10d78) computes from sample_61.tir without its corrections of large angles
TYREDYN_61 = [
    (1000.0, -0.2, 0.0, 210e3, 953.310115205229),
    (4300.0, 0.03, 0.0, 210e3, -2189.240750747573),
    (4300.0, -0.08, 0.05, 230e3, 3593.211718685133),
    (8000.0, 0.15, -0.04, 230e3, -6257.332813695251),
    (8000.0, 0.15, 0.0, 190e3, -6417.630833041812),
    (6000.0, 0.25, 0.0, 250e3, -4847.603107038872),
]
# likewise from sample_52.tir, as 6.1 with PKY4 = 2, which without camber is 5.2
TYREDYN_52 = [
    (1000.0, -0.2, 1039.901352345906),
    (4100.0, 0.03, -1904.0928142151668),
    (8000.0, 0.15, -6345.871327754478),
    (4100.0, -0.001, -69.3244575805532),
]

slip_angles = st.floats(-0.4, 0.4)
loads = st.floats(500.0, 9000.0)
cambers = st.floats(-0.1, 0.1)


@pytest.mark.parametrize(("load", "slip_angle", "camber", "pressure", "expected"), TYREDYN_61)
def test_version_6_gives_another_project_s_numbers(
    load: float, slip_angle: float, camber: float, pressure: float, expected: float
) -> None:
    """Load, slip, camber, pressure and all scaling factors count as there, to its 1e-6 N of rounding in By."""
    dpi = pressure / 230e3 - 1
    result = lateral_force(MF_61, load, slip_angle, version="6.x", camber=camber, dpi=dpi)
    assert float(result) == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize(("load", "slip_angle", "expected"), TYREDYN_52)
def test_version_5_gives_another_project_s_numbers(load: float, slip_angle: float, expected: float) -> None:
    """Without camber 5.2 is 6.1 with PKY4 = 2."""
    assert float(lateral_force(MF_52, load, slip_angle, version="5.2")) == pytest.approx(expected, rel=1e-8)


def test_camber_of_version_5_is_the_printed_formula() -> None:
    """With camber, 5.2 is what its manual prints, written out here in numbers."""
    fz, alpha, gamma = 5000.0, 0.06, 0.07 * 0.9
    dfz = (fz - 4100) / 4100
    alpha_y = alpha + 0.0028 + 0.0007 * dfz + 0.042 * gamma
    mu = (0.94 - 0.13 * dfz) * (1 - 2.1 * gamma**2)
    curvature = (-0.8 - 0.4 * dfz) * (1 - (0.1 - 2.5 * gamma))
    stiffness = -18 * 4100 * sin(2 * atan(fz / (1.75 * 4100))) * (1 - 0.3 * gamma)
    vertical = fz * (0.011 - 0.004 * dfz + (-0.21 - 0.08 * dfz) * gamma)
    x = stiffness / (1.31 * mu * fz) * alpha_y
    expected = mu * fz * sin(1.31 * atan(x - curvature * (x - atan(x)))) + vertical
    assert float(lateral_force(MF_52, fz, alpha, version="5.2", camber=0.07)) == pytest.approx(expected, rel=1e-12)


@given(loads, cambers, st.sampled_from(["5.2", "6.x"]))
def test_the_slope_through_the_shifted_origin_is_the_cornering_stiffness(
    load: float, camber: float, version: str
) -> None:
    """Ky is the derivative of Fy where alpha + SHy = 0."""
    c = MF_52 if version == "5.2" else MF_61
    own = camber * (c.LGAY if version == "5.2" else 1.0)
    step, alphas = 1e-6, np.linspace(-0.1, 0.1, 2001)
    slopes = np.diff(lateral_force(c, load, alphas, version=version, camber=camber)) / np.diff(alphas)
    at = alphas[np.abs(slopes).argmax()]
    near = lateral_force(c, load, np.array([at - step, at + step]), version=version, camber=camber)
    assert abs(near[1] - near[0]) / (2 * step) == pytest.approx(abs(float(cornering_stiffness(c, load, own))), rel=2e-3)


@given(loads, slip_angles)
def test_without_shifts_and_asymmetry_the_force_is_odd(load: float, slip_angle: float) -> None:
    """A tyre with no ply steer, no conicity and no camber gives the mirrored force at the mirrored slip angle."""
    values = {f.name: getattr(MF_61, f.name) for f in fields(LateralCoefficients)}
    symmetric = LateralCoefficients(**values | dict.fromkeys(("PHY1", "PHY2", "PVY1", "PVY2", "PEY3"), 0.0))
    there = lateral_force(symmetric, load, slip_angle, version="6.x")
    back = lateral_force(symmetric, load, -slip_angle, version="6.x")
    assert float(there) == -float(back)
