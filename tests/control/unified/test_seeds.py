"""First guesses: a pulse to the side and half of it back, or a straight stop, within what the vehicle can do."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.control.plan import Passing
from swerve.control.unified.seeds import seeds
from swerve.control.unified.way import Way
from tests.control.unified.situations import PASSED, Array, model
from tests.vehicle.motions import SEDAN, STATIC, mirrored

LARGEST = np.array([0.5, *(0.95 * 0.85 * STATIC)])
BRAKE = Way((Passing.BEHIND,), (0,))
passings = st.sampled_from(list(Passing))


def guesses(way: Way, speed: float = 20.0, n: int = 20, *, steers: bool = True) -> list[Array]:
    """The guesses of a way."""
    return seeds(SEDAN, 0.85, 0.12, speed, way, LARGEST, n, steers)


def past(side: Passing, then: Passing | None = None) -> Way:
    """Past one obstacle on a side, and then what."""
    return Way((side,), (0,)) if then is None else Way((side, then), (0, 1))


@given(st.floats(-5.0, 60.0), passings, passings, st.integers(1, 60), st.booleans())
def test_guesses_are_possible(speed: float, first: Passing, then: Passing, n: int, steers: bool) -> None:
    """At any speed, for any horizon and way, each guess is within lock and wheel forces."""
    found = guesses(past(first, then), speed, n, steers=steers)
    assert found
    for inputs in found:
        assert inputs.shape == (n, 5)
        if steers:
            assert (np.abs(inputs) <= LARGEST + 1e-9).all()
        else:
            assert (inputs[:, 0] == 0).all()


@given(st.floats(-5.0, 60.0), st.sampled_from(PASSED), st.integers(5, 60))
def test_a_swerve_begins_to_its_side(speed: float, side: Passing, n: int) -> None:
    """It steers to its side first, then back, and uses no wheel force unless it is to stop afterwards."""
    for inputs in guesses(past(side), speed, n):
        assert inputs[0, 0] * side.value > 0
        assert inputs[-1, 0] * side.value < 0
        assert (inputs[:, 1:] == 0).all()
    for inputs in guesses(past(side, Passing.BEHIND), speed, n):
        assert inputs[0, 0] * side.value > 0
        assert (inputs[:, 1:] < 0).all()


@given(st.floats(-5.0, 60.0), st.integers(1, 60))
def test_a_stop_is_straight(speed: float, n: int) -> None:
    """A way that passes nothing brakes with all wheels, more and less, wheels straight."""
    found = guesses(BRAKE, speed, n)
    for inputs in found:
        assert (inputs[:, 0] == 0).all()
        assert (inputs[:, 1:] < 0).all()
    assert len({float(inputs[0, 1]) for inputs in found}) == len(found)


@pytest.mark.parametrize("steers", [True, False])
@pytest.mark.parametrize("speed", [10.0, 20.0, 35.0])
@pytest.mark.parametrize("then", [None, Passing.BEHIND])
def test_right_is_the_mirror_of_left(speed: float, steers: bool, then: Passing | None) -> None:
    """The guesses of the two sides are mirror images, by wheel forces too."""
    left, right = (guesses(past(side, then), speed, steers=steers) for side in PASSED)
    for one, other in zip(left, right, strict=True):
        np.testing.assert_allclose(one, [mirrored(u) for u in other], rtol=1e-12)


@pytest.mark.parametrize("speed", [10.0, 20.0, 35.0])
def test_guesses_stay_in_hand(speed: float) -> None:
    """Rolled out, guesses go to their side, by more and less, and do not spin the vehicle."""
    reached = []
    for inputs in guesses(past(Passing.LEFT), speed):
        trajectory = model().roll_out(np.array([speed, 0, 0, 0, 0, 0]), inputs, STATIC)
        reached.append(trajectory.states[:, 5].max())
        assert np.abs(np.arctan2(trajectory.states[:, 1], trajectory.states[:, 0])).max() < 0.5
    assert min(reached) > 0
    assert max(reached) > 2.5
    assert max(reached) > 4 * min(reached)


def test_without_steering_the_forces_turn_it() -> None:
    """Opposite forces left and right take it to its side."""
    reached = [
        model().roll_out(np.array([20.0, 0, 0, 0, 0, 0]), inputs, STATIC).states[:, 5].max()
        for inputs in guesses(past(Passing.LEFT), steers=False)
    ]
    assert max(reached) > 0.3
