"""First guesses: a pulse to the side and half of it back, within what the vehicle can do."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.control import Side
from swerve.control.unified.seeds import seeds
from tests.control.unified.situations import SIDES, model
from tests.vehicle.motions import SEDAN, STATIC


@given(st.floats(-5.0, 60.0), st.sampled_from(SIDES), st.integers(1, 60))
def test_guesses_are_possible(speed: float, side: Side, n: int) -> None:
    """At any speed, for any horizon, each guess begins to its side, stays within the lock and uses no wheel force."""
    guesses = seeds(SEDAN, 0.85, 0.12, speed, side, n)
    assert len(guesses) > 0
    for inputs in guesses:
        assert inputs.shape == (n, 5)
        assert np.abs(inputs[:, 0]).max() <= SEDAN.steering_limit
        assert (inputs[:, 1:] == 0).all()
        if n >= 5:
            assert inputs[0, 0] * side.value > 0
            assert inputs[-1, 0] * side.value < 0


@pytest.mark.parametrize("speed", [10.0, 20.0, 35.0])
def test_right_is_the_mirror_of_left(speed: float) -> None:
    """The guesses of the two sides are mirror images."""
    left, right = (seeds(SEDAN, 0.85, 0.12, speed, side, 20) for side in SIDES)
    np.testing.assert_array_equal(left, -np.array(right))


@pytest.mark.parametrize("speed", [10.0, 20.0, 35.0])
def test_guesses_stay_in_hand(speed: float) -> None:
    """Rolled out, guesses go to their side, by more and less, and do not spin the vehicle."""
    reached = []
    for inputs in seeds(SEDAN, 0.85, 0.12, speed, Side.LEFT, 20):
        trajectory = model().roll_out(np.array([speed, 0, 0, 0, 0, 0]), inputs, STATIC)
        reached.append(trajectory.states[:, 5].max())
        assert np.abs(np.arctan2(trajectory.states[:, 1], trajectory.states[:, 0])).max() < 0.5
    assert min(reached) > 0
    assert max(reached) > 2.5
    assert max(reached) > 4 * min(reached)
