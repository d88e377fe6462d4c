"""The lane keeper: comes to its lane without overshooting much, and mirrors."""

import numpy as np
import pytest

from swerve.control.lane_keeping import SPEEDS, LaneKeeping
from swerve.conventions import DELTA
from tests.control.unified.situations import model
from tests.vehicle.motions import SEDAN, STATIC


def driven(speed: float, offset: float) -> np.ndarray:
    """States (n, 6) of 12 s towards a lateral offset [m], the nonlinear model being steered."""
    lane = LaneKeeping.of(model(), SEDAN, 0.85, offset)
    states = [np.array([speed, 0.0, 0, 0, 0, 0])]
    for _ in range(240):
        u = np.zeros(5)
        u[DELTA] = lane.angle(states[-1])
        states.append(model().advance(states[-1], u, STATIC, 0.05))
    return np.array(states)


@pytest.mark.parametrize("speed", [3.0, 10.0, 20.0, 35.0])
def test_it_comes_to_its_lane(speed: float) -> None:
    """From one lane to the next: there within 12 s, a tenth of the way too far at most, within the grip."""
    states = driven(speed, 3.5)
    y = states[:, 5]
    assert y.max() < 3.85
    assert y[-1] == pytest.approx(3.5, abs=0.05 if speed >= 10 else 0.6)
    lateral = np.diff(states[:, 1]) / 0.05 + states[1:, 0] * states[1:, 2]
    assert np.abs(lateral).max() < 0.8 * 0.85 * 9.81


def test_left_is_the_mirror_of_right() -> None:
    """The way to the right is the mirrored way to the left."""
    np.testing.assert_allclose(driven(20.0, 2.0)[:, 5], -driven(20.0, -2.0)[:, 5], atol=1e-9)


def test_in_its_lane_it_does_nothing() -> None:
    """No deviation, no angle."""
    assert not driven(20.0, 0.0)[:, 5].any()


@pytest.mark.parametrize("speed", [0.0, 1.0, 3.1, 20.0, 22.5, 69.9, 70.0, 90.0])
def test_its_gain_is_linear_between_speeds(speed: float) -> None:
    """For a small deviation of each kind, the angle is that of gains interpolated one by one, and held beyond."""
    lane = LaneKeeping.of(model(), SEDAN, 0.85, 0.0)
    for i, place in enumerate((1, 2, 3, 5)):
        state = np.array([speed, 0.0, 0, 0, 0, 0])
        state[place] = 1e-3
        assert lane.angle(state) == pytest.approx(-1e-3 * np.interp(speed, SPEEDS, lane.gains[:, i]))
