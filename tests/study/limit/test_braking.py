"""Braking alone has a closed form: v^2 / (2 mu g 0.95), and the obstacle's radius."""

import numpy as np
import pytest

from swerve.conventions import GRAVITY
from swerve.study.limit.best import best, least_violation
from swerve.study.limit.contact import time_to_collision
from swerve.study.limit.means import Means
from swerve.study.limit.trajectory import Sought
from tests.study.limit.scenes import scene

RADIUS = 2.0  # [m]


@pytest.mark.parametrize(("speed", "friction"), [(20.0, 0.85), (35.0, 0.3)])
def test_the_distance_is_the_closed_form(speed: float, friction: float) -> None:
    """Within 1 cm, at any speed and friction, and driven again it touches nothing."""
    found = best(scene(f"ego.speed={speed}", f"road.friction={friction}"), Means.BRAKING, Sought.DISTANCE)
    assert found is not None
    expected = RADIUS + speed**2 / (2 * 0.95 * friction * GRAVITY)
    assert found.trajectory.distance == pytest.approx(expected, abs=0.01)
    assert found.drive.ratio is not None and found.drive.ratio >= 0.999
    assert found.drive.states[-1, 0] < 0.11
    assert np.allclose(found.trajectory.shares[:, 0], 0.0)


def test_the_friction_is_the_closed_form() -> None:
    """At 25 m the least friction for braking alone is v^2 / (2 g 0.95 (D - R))."""
    found = best(scene(), Means.BRAKING, Sought.FRICTION)
    assert found is not None
    assert found.trajectory.friction == pytest.approx(400 / (2 * GRAVITY * 0.95 * 23), rel=1e-3)


def test_three_percent_less_is_too_near() -> None:
    """At 0.97 of the smallest distance braking alone overlaps the obstacle by what is missing."""
    limit = RADIUS + 400 / (2 * 0.95 * 0.85 * GRAVITY)
    missed = least_violation(scene().at(0.97 * limit), Means.BRAKING)
    assert missed == pytest.approx(0.03 * limit, rel=0.02)


def test_a_slower_lead_takes_its_speed_off() -> None:
    """An obstacle at 10 m/s is braked for as one at rest at the difference of both speeds."""
    moving = scene('obstacles.0.velocity=["10 m/s", "0 m/s"]', "ego.speed=30")
    found = best(moving, Means.BRAKING, Sought.DISTANCE)
    assert found is not None
    assert found.trajectory.distance == pytest.approx(RADIUS + 400 / (2 * 0.95 * 0.85 * GRAVITY), abs=0.02)


def test_the_time_to_collision_is_gap_over_speed() -> None:
    """(D - R) / v for a resting disc; none for one beside the way."""
    assert time_to_collision(scene()) == pytest.approx(23 / 20, abs=1e-3)
    assert time_to_collision(scene('obstacles.0.position=["25 m", "5 m"]')) is None
