"""Times to collision, usual and worst: closed forms of constant speeds."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.conventions import GRAVITY
from swerve.study.criticality.time_to_collision import HORIZON, time_to_collision
from swerve.study.criticality.worst_time_to_collision import worst_time_to_collision
from tests.study.criticality.scenes import FRONT, WIDTH, box, scene


@given(st.floats(1, 60), st.floats(0, 40), st.floats(0.5, 200))
def test_straight_behind_it_is_gap_over_closing_speed(speed: float, lead: float, gap: float) -> None:
    """d / (v - w) where it closes, infinite where it does not within the horizon."""
    found = time_to_collision(scene(box(gap + FRONT + 2, vx=lead), speed=speed))[0]
    exact = gap / (speed - lead) if speed > lead else np.inf
    assert found == pytest.approx(exact if exact <= HORIZON else np.inf, rel=1e-9)


def test_the_first_of_several_obstacles_counts() -> None:
    """Nearest is not first: an oncoming car further away is met earlier."""
    near, oncoming = box(52 + FRONT, vx=15), box(102 + FRONT, vx=-20)
    assert time_to_collision(scene(near, oncoming))[0] == pytest.approx(100 / 40)


@pytest.mark.parametrize(("y", "is_met"), [(WIDTH / 2 + 0.9 - 0.01, True), (WIDTH / 2 + 0.9 + 0.01, False)])
def test_beside_the_path_nothing_is_met(y: float, is_met: bool) -> None:
    """Boxes that overlap by a centimetre meet, and a centimetre apart they pass."""
    assert np.isfinite(time_to_collision(scene(box(40, y=y)))[0]) == is_met


def test_no_obstacle_is_no_conflict() -> None:
    """Both times are infinite."""
    assert time_to_collision(scene())[0] == worst_time_to_collision(scene())[0] == np.inf


@given(st.floats(1, 40), st.floats(0.5, 100), st.floats(0.1, 1.2))
def test_the_worst_time_straight_ahead(speed: float, gap: float, friction: float) -> None:
    """d = v t + 2 mu g t^2 / 2: both accelerate towards each other."""
    grip = friction * GRAVITY
    exact = (-speed + np.sqrt(speed**2 + 4 * grip * gap)) / (2 * grip)
    found = worst_time_to_collision(scene(box(gap + FRONT + 2), speed=speed, friction=friction))[0]
    assert found == pytest.approx(exact, abs=1e-3)


@given(st.floats(6, 60), st.floats(-15, 15), st.floats(-15, 15), st.floats(-15, 15))
def test_the_worst_time_is_the_shortest(x: float, y: float, vx: float, vy: float) -> None:
    """Keeping the velocity is one of the things that both could do."""
    at = scene(box(x, y, vx, vy))
    assert worst_time_to_collision(at)[0] <= time_to_collision(at)[0]
