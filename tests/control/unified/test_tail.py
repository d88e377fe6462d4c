"""The path beyond the horizon: a point mass, and its derivatives by finite differences."""

import numpy as np
import pytest
from hypothesis import given
from scipy.integrate import solve_ivp

from swerve.control import Side
from swerve.control.unified.tail import GRIP, Tail
from swerve.conventions import GRAVITY
from tests.control.unified.situations import SIDES, random_start, seeds

TAIL = Tail.of(0.85, 20, 0.05)


@pytest.mark.parametrize("side", SIDES)
@given(seed=seeds)
def test_it_is_a_point_mass_that_is_pushed_to_its_side(side: Side, seed: int) -> None:
    """From the last state on the mass moves as if a part of the grip pushed it along Y, keeping its heading."""
    end = random_start(np.random.default_rng(seed))
    vx, vy, _, psi, x, y = end
    push = side.value * GRIP * 0.85 * GRAVITY
    start = [x, y, vx * np.cos(psi) - vy * np.sin(psi), vx * np.sin(psi) + vy * np.cos(psi)]
    path = solve_ivp(lambda _, p: [p[2], p[3], 0.0, push], (0, 1.0), start, t_eval=TAIL.times, rtol=1e-10, atol=1e-10)
    found = TAIL.poses(end, side)
    np.testing.assert_allclose(found[:, :2], path.y[:2].T, atol=1e-7)
    np.testing.assert_array_equal(found[:, 2], psi)


def test_it_is_as_long_as_the_horizon() -> None:
    """Twenty samples of 50 ms, the first of them one sample after the horizon's end."""
    np.testing.assert_allclose(TAIL.times, np.arange(1, 21) * 0.05)
    assert 0 < TAIL.acceleration < 0.85 * GRAVITY


@pytest.mark.parametrize("side", SIDES)
@given(seed=seeds)
def test_sensitivities_are_the_slopes(side: Side, seed: int) -> None:
    """Moving the last state moves the path as the sensitivities say, in every direction of the state."""
    end = random_start(np.random.default_rng(seed))
    found = TAIL.sensitivities(end, np.eye(6))
    for j in range(6):
        d = np.eye(6)[j] * 1e-6
        slope = (TAIL.poses(end + d, side) - TAIL.poses(end - d, side)) / 2e-6
        np.testing.assert_allclose(found[:, :, j], slope, atol=1e-6)


def test_sensitivities_are_linear_in_those_of_the_state() -> None:
    """Through any map from free inputs to the last state the path's derivatives follow by the chain rule."""
    random = np.random.default_rng(2)
    end, of_end = random_start(random), random.normal(size=(6, 11))
    found = TAIL.sensitivities(end, of_end)
    assert found.shape == (20, 3, 11)
    np.testing.assert_allclose(found, TAIL.sensitivities(end, np.eye(6)) @ of_end, atol=1e-9)
