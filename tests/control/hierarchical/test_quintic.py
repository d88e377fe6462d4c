"""The polynomial meets what is asked of its ends, by finite differences; its sharpest bend is the formula's."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.control.hierarchical.quintic import Quintic, sharpest

lengths = st.floats(5.0, 80.0)


@given(st.floats(-5, 5), st.floats(-0.4, 0.4), st.floats(-0.02, 0.02), lengths, st.floats(-8, 8))
def test_it_meets_its_ends(y: float, slope: float, bend: float, length: float, target: float) -> None:
    """Position, slope and bend at both ends, the derivatives by finite differences of the polynomial itself."""
    path, h = Quintic.between(3.0, np.array([y, slope, bend]), length, target), 1e-3
    for x, expected, inwards in ((3.0, (y, slope, bend), 1), (3.0 + length, (target, 0.0, 0.0), -1)):
        at = path.at(x + inwards * h * np.arange(4.0))[0]
        first = inwards * (-11 * at[0] + 18 * at[1] - 9 * at[2] + 2 * at[3]) / (6 * h)
        second = (2 * at[0] - 5 * at[1] + 4 * at[2] - at[3]) / h**2
        assert at[0] == pytest.approx(expected[0], abs=1e-9)
        assert first == pytest.approx(expected[1], abs=1e-6)
        assert second == pytest.approx(expected[2], abs=2e-3)


@given(lengths, st.floats(-8, 8))
def test_its_derivatives_are_those_of_its_values(length: float, target: float) -> None:
    """y' and y'' along the way are the differences of y; beyond its ends it is straight."""
    path = Quintic.between(0.0, np.array([0.5, 0.1, 0.005]), length, target)
    x, h = np.linspace(0.1, 0.9, 9) * length, 1e-3
    y, slope, bend = path.at(x)
    before, after = path.at(x - h)[0], path.at(x + h)[0]
    np.testing.assert_allclose(slope, (after - before) / (2 * h), atol=1e-5)
    np.testing.assert_allclose(bend, (after - 2 * y + before) / h**2, atol=1e-5)
    np.testing.assert_allclose(path.at(length + np.array([1.0, 50.0]))[0], target, atol=1e-9)
    np.testing.assert_allclose(path.at(np.array([-2.0]))[0], 0.5 - 0.2, atol=1e-9)


@given(lengths)
def test_its_sharpest_bend(length: float) -> None:
    """From straight to straight the largest |y''| is 10 / sqrt(3) D / L^2; a small D has no slope to speak of."""
    found = sharpest(np.zeros(3), np.array([length]), 0.01)[0]
    assert found == pytest.approx(10 / np.sqrt(3) * 0.01 / length**2, rel=5e-3)
