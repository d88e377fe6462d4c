"""The fit against parameters that are known, with noise, shifts and points that do not tell them."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.errors import InputError
from swerve.vehicle.fitting import LoadBlock, TyreData, fit_tyre
from swerve.vehicle.fitting.curve import fit_curve, magic_formula
from swerve.vehicle.fitting.line import fit_line
from swerve.vehicle.tyre import magic_formula as reduced
from tests.vehicle.fitting.points import DEGREES, data, force


@st.composite
def tyres(draw: st.DrawFn) -> tuple[list[float], list[list[float]]]:
    """Loads [N], and B, C, D at each, anywhere that a tyre's are."""
    loads = [draw(st.floats(800.0, 2000.0))]
    for _ in range(draw(st.integers(2, 6))):
        loads.append(loads[-1] * draw(st.floats(1.1, 1.8)))
    return loads, [[draw(st.floats(8.0, 25.0)), draw(st.floats(1.2, 1.9)), draw(st.floats(0.4, 1.8))] for _ in loads]


@given(tyres())
@settings(max_examples=25)
def test_curves_give_their_parameters_back(tyre: tuple[list[float], list[list[float]]]) -> None:
    """From points on curves with E = 0 the fit finds each load's B, C and D, no E, no shift and no error."""
    loads, parameters = tyre
    fit = fit_tyre(data(loads, parameters))
    for each, load, (B, C, D) in zip(fit.loads, loads, parameters, strict=True):
        curve = each.reduced
        assert pytest.approx((B, C, D), rel=1e-7) == (curve.B, curve.C, curve.D)
        assert pytest.approx((B, C, D), rel=1e-3) == (each.full.B, each.full.C, each.full.D)
        assert pytest.approx(0.0, abs=1e-2) == each.full.E
        assert curve.horizontal_shift == pytest.approx(0.0, abs=1e-9)
        assert curve.rms_error < 1e-6 * load


@given(st.floats(-1.5, 0.9))
@settings(max_examples=10)
def test_the_curvature_is_found(E: float) -> None:
    """From points with an E of their own the fit with E free finds it, and E = 0 leaves an error."""
    made = data([1500.0, 3000.0, 6000.0], [(12.0, 1.4, 1.0, E)] * 3)
    curve = fit_curve(made.blocks[1], "f", curvature=True)
    assert pytest.approx((12.0, 1.4, 1.0), rel=1e-5) == (curve.B, curve.C, curve.D)
    assert pytest.approx(E, abs=1e-4) == curve.E
    assert fit_curve(made.blocks[1], "f", curvature=False).rms_error > curve.rms_error - 1e-9


@given(st.floats(-0.01, 0.01), st.floats(-0.03, 0.03))
@settings(max_examples=10)
def test_shifts_are_fitted_and_left_out(horizontal: float, vertical: float) -> None:
    """A curve moved sideways and up has the same B, C and D, and its shifts are told."""
    alphas, load = np.radians(DEGREES), 3000.0
    forces = np.array([force(load, a + horizontal, 12.0, 1.4, 1.0) for a in alphas]) + vertical * load
    curve = fit_curve(LoadBlock("here", np.full_like(alphas, load), alphas, forces), "f", curvature=False)
    assert pytest.approx((12.0, 1.4, 1.0), rel=1e-6) == (curve.B, curve.C, curve.D)
    assert (curve.horizontal_shift, curve.vertical_shift) == pytest.approx((horizontal, vertical), abs=1e-8)


def test_points_on_one_side_have_no_shift() -> None:
    """With slip angles of one sign nothing tells a shift, so none is fitted."""
    positive = [d for d in DEGREES if d >= 0]
    fit = fit_tyre(data([1500.0, 3000.0, 6000.0], [(12.0, 1.4, 1.0)] * 3, positive))
    assert {each.reduced.horizontal_shift for each in fit.loads} == {None}
    assert pytest.approx(12.0, rel=1e-7) == fit.loads[0].reduced.B


@pytest.mark.parametrize("seed", range(4))
def test_noise_is_averaged_out_and_reported(seed: int) -> None:
    """With 2 % noise the tyre is within 1 % of the peak force of the true one, and the error reported is the noise."""
    rng = np.random.default_rng(seed)
    loads, noise = [1500.0, 3000.0, 4500.0, 6000.0], 0.02
    truth = [(13.5 - 3e-4 * load, 1.45, 1.02 - 1.5e-5 * load) for load in loads]
    degrees = list(np.linspace(-14.0, 14.0, 141))
    blocks = [
        LoadBlock(b.place, b.loads, b.slip_angles, b.forces + noise * b.load * rng.standard_normal(len(b.loads)))
        for b in data(loads, truth, degrees).blocks
    ]
    fit = fit_tyre(TyreData("f", "noisy", tuple(blocks)))
    for each, load, (B, C, D) in zip(fit.loads, loads, truth, strict=True):
        alphas = np.radians(degrees)
        true = load * magic_formula(alphas, B, C, D)
        found = np.array([load * float(reduced(fit.tyre, a, load)) for a in alphas])
        assert np.abs(found - true).max() < 0.01 * D * load
        assert each.reduced.rms_error == pytest.approx(noise * load, rel=0.2)
        assert each.full.rms_error <= each.reduced.rms_error * (1 + 1e-9)


def test_each_point_counts_at_its_own_load() -> None:
    """Loads that scatter by 3 % within a block leave B, C and D as they are: force over load is what is fitted."""
    rng, alphas = np.random.default_rng(1), np.radians(DEGREES)
    loads = 3000.0 * (1 + 0.03 * rng.uniform(-1, 1, len(alphas)))
    forces = np.array([force(load, a, 12.0, 1.4, 1.0) for load, a in zip(loads, alphas, strict=True)])
    curve = fit_curve(LoadBlock("here", loads, alphas, forces), "f", curvature=False)
    assert pytest.approx((12.0, 1.4, 1.0), rel=1e-7) == (curve.B, curve.C, curve.D)


def test_the_error_on_the_lines_is_that_of_the_tyre() -> None:
    """The last column is the root mean square of the data from the tyre that a vehicle gets."""
    made = data(
        [1500.0, 3000.0, 4500.0, 6000.0], [(13.0, 1.4, 1.0), (12.0, 1.5, 1.0), (12.5, 1.4, 0.9), (11, 1.45, 0.9)]
    )
    fit = fit_tyre(made)
    for each, block in zip(fit.loads, made.blocks, strict=True):
        rest = [
            block.load * float(reduced(fit.tyre, a, block.load)) - f
            for a, f in zip(block.slip_angles, block.forces, strict=True)
        ]
        assert each.line_error == pytest.approx(np.sqrt(np.mean(np.square(rest))))
        assert each.line_error > 1.0


def test_lines_are_those_of_least_squares() -> None:
    """Slope, value at no load and R^2 are NumPy's, and a flat line explains all of nothing."""
    loads, values = [1000.0, 2500.0, 4000.0, 8000.0], [12.0, 11.9, 11.2, 10.1]
    line = fit_line(loads, values)
    slope, at_no_load = np.polyfit(loads, values, 1)
    assert (line.at_no_load, line.per_newton) == pytest.approx((at_no_load, slope))
    assert line.r_squared == pytest.approx(np.corrcoef(loads, values)[0, 1] ** 2)
    assert fit_line(loads, [1.45] * 4).r_squared == 1.0
    np.testing.assert_allclose(line.at([0.0, 1000.0]), [at_no_load, at_no_load + 1000 * slope])


@pytest.mark.parametrize(
    ("degrees", "changes", "message"),
    [
        (np.linspace(-1.5, 1.5, 31), {}, "slip angles reach 1.5 deg, 42% of the peak at load 1500 N; add larger ones"),
        (DEGREES, {"shuffled": True}, "of its peak; mend the columns or their units"),
    ],
)
def test_points_that_do_not_tell_a_curve_are_refused(degrees: Any, changes: dict[str, bool], message: str) -> None:
    """Slip angles that end before the bend, and points on no curve."""
    made = data([1500.0, 3000.0, 6000.0], [(12.0, 1.4, 1.0)] * 3, degrees)
    if changes:
        rng = np.random.default_rng(0)
        blocks = [
            LoadBlock(b.place, b.loads, b.slip_angles, b.forces * rng.choice([1.0, 0.1, -0.3], len(b.forces)))
            for b in made.blocks
        ]
        made = TyreData("made.csv", "", tuple(blocks))
    with pytest.raises(InputError) as caught:
        fit_tyre(made)
    assert message in str(caught.value)
    assert str(caught.value).startswith("made.csv: load 1500 N: ")
