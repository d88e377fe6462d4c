"""Required accelerations and threat numbers: closed forms, and a search by driving."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from swerve.conventions import GRAVITY
from swerve.study.criticality import Scene
from swerve.study.criticality.manoeuvre import available_lateral_acceleration
from swerve.study.criticality.required import required_deceleration, required_lateral_acceleration
from swerve.study.criticality.threat import brake_threat_number, steer_threat_number
from tests.study.criticality.scenes import FRONT, WIDTH, box, is_hit, scene


@given(st.floats(5, 60), st.floats(0, 30), st.floats(1, 100), st.floats(0.1, 1.2))
def test_the_brake_threat_number_straight_ahead(speed: float, lead: float, gap: float, friction: float) -> None:
    """BTN = (v - w)^2 / (2 d a), with what braking can have of the friction; 0 where it does not close."""
    at = scene(box(gap + FRONT + 2, vx=lead), speed=speed, friction=friction)
    exact = max(speed - lead, 0) ** 2 / (2 * gap * 0.95 * friction * GRAVITY)
    assume(lead == 0 or lead < 0.9 * speed or lead > speed)  # or it is met beyond the time that is looked at
    assert brake_threat_number(at, required_deceleration(at))[0] == pytest.approx(exact, rel=1e-4)


@given(st.floats(5, 40), st.floats(5, 60), st.floats(-1.5, 1.5))
def test_the_lateral_acceleration_past_a_box(speed: float, gap: float, y: float) -> None:
    """2 shift / TTC^2, the shift being both half widths and the offset; the easier side makes the threat number."""
    at = scene(box(gap + FRONT + 2, y=y), speed=speed)
    ttc = gap / speed
    left, right = (required_lateral_acceleration(at, side) for side in (1, -1))
    assert left[0] == pytest.approx(2 * (WIDTH / 2 + 0.9 + y) / ttc**2, rel=1e-6)
    assert right[0] == pytest.approx(2 * (WIDTH / 2 + 0.9 - y) / ttc**2, rel=1e-6)
    easier = 2 * (WIDTH / 2 + 0.9 - abs(y)) / ttc**2
    assert steer_threat_number(at, left, right)[0] == pytest.approx(easier / available_lateral_acceleration(at)[0])


def test_a_crossing_car_asks_for_the_braking_that_a_search_finds() -> None:
    """The smallest constant deceleration that lets it pass, by driving and bisection."""
    at = scene(box(40, -16, vy=9, heading=np.pi / 2))
    low, high = 0.0, 20.0
    for _ in range(20):
        middle = (low + high) / 2
        low, high = (middle, high) if is_hit(at, *_braked(at, middle)) else (low, middle)
    assert 1 < high < 10
    assert required_deceleration(at)[0] == pytest.approx(high, rel=1e-3)


def test_from_the_side_no_braking_helps() -> None:
    """Infinite where it would be hit standing."""
    assert required_deceleration(scene(box(0, 12, vy=-6), speed=1.0))[0] == np.inf


def _braked(at: Scene, deceleration: float) -> tuple[np.ndarray, np.ndarray]:
    """Times and poses of braking straight on."""
    times = np.arange(1.5, 2.5, 1e-4)  # the obstacle is in the way until 2.1 s
    braking = np.minimum(times, 20 / max(deceleration, 1e-9))
    x = 20 * braking - deceleration * braking**2 / 2 + (0 if deceleration else 20 * (times - braking))
    return times, np.column_stack((x, np.zeros((len(times), 2))))
