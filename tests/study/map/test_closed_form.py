"""The closed forms, against a point mass that is driven step by step."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.conventions import GRAVITY
from swerve.study.map.closed_form import braking_distance, swerving_distance, turning_speed

speeds, frictions, widths = st.floats(2.0, 40.0), st.floats(0.2, 1.1), st.floats(0.5, 4.0)
STEP = 1e-4  # [s]


@given(speeds, frictions)
def test_a_point_mass_stops_within_the_braking_distance(speed: float, friction: float) -> None:
    """Summed up step by step."""
    velocities = np.arange(speed, 0.0, -friction * GRAVITY * STEP)
    assert braking_distance(speed, friction) == pytest.approx(velocities.sum() * STEP, rel=2e-3)


@given(speeds, frictions, widths)
def test_a_point_mass_is_aside_after_the_swerving_distance(speed: float, friction: float, width: float) -> None:
    """The distance travelled until the lateral motion, summed up step by step, comes to the width."""
    times = np.arange(0.0, 6.0, STEP)
    aside = np.cumsum(friction * GRAVITY * times) * STEP
    assert swerving_distance(speed, friction, width) == pytest.approx(speed * times[aside >= width][0], rel=2e-3)


def test_nothing_has_to_be_travelled_where_nothing_is_in_the_way() -> None:
    """A width of 0, or less, needs no distance."""
    assert swerving_distance(20.0, 0.85, 0.0) == swerving_distance(20.0, 0.85, -1.0) == 0.0


@given(frictions, widths, st.floats(0.0, 1.0))
def test_at_the_turning_speed_both_need_the_same_distance(friction: float, width: float, share: float) -> None:
    """And above it swerving needs less."""
    extent = share * width
    speed = turning_speed(friction, width, extent)
    assert speed is not None
    braking = braking_distance(speed, friction) + extent
    assert braking == pytest.approx(swerving_distance(speed, friction, width))
    assert braking_distance(1.1 * speed, friction) + extent > swerving_distance(1.1 * speed, friction, width)


def test_a_long_gap_is_never_braked_for_better() -> None:
    """Where bumper to bumper is further than the width, no speed has both alike."""
    assert turning_speed(0.85, 2.0, 3.0) is None
