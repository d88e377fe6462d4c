"""The bound from below, against closed forms and brute force."""

import numpy as np
import pytest

from swerve.conventions import GRAVITY
from swerve.study.limit import point_mass
from tests.study.limit.scenes import scene


@pytest.mark.parametrize(("speed", "friction"), [(20.0, 0.85), (35.0, 0.3), (10.0, 1.0)])
def test_a_point_mass_that_goes_aside_is_allowed(speed: float, friction: float) -> None:
    """Between the closed form of going aside abreast of the centre, less 3 %, and that plus the radius."""
    aside = speed * np.sqrt(2 * 2 / (friction * GRAVITY))
    bound = point_mass.smallest_distance(scene(f"ego.speed={speed}", f"road.friction={friction}"))
    assert 0.97 * min(aside, speed**2 / (2 * friction * GRAVITY)) <= bound <= aside + 2


def test_at_walking_pace_stopping_is_the_bound() -> None:
    """v^2 / (2 mu g), to within 2 mm."""
    bound = point_mass.smallest_distance(scene("ego.speed=3"))
    assert bound == pytest.approx(9 / (2 * 0.85 * GRAVITY), abs=2e-3)


def test_no_point_mass_comes_by_below_it() -> None:
    """20,000 random sequences of full accelerations all hit the disc from 0.98 of the bound."""
    here = scene()
    distance = 0.98 * point_mass.smallest_distance(here)
    random = np.random.default_rng(1)
    step, grip = 0.01, 0.85 * GRAVITY
    angles = np.repeat(random.uniform(-np.pi, np.pi, (20_000, 6)), 30, axis=1)
    acceleration = grip * np.stack([np.cos(angles), np.sin(angles)])
    velocity = np.cumsum(acceleration, axis=2) * step + np.array([20.0, 0.0])[:, np.newaxis, np.newaxis]
    place = np.cumsum(velocity - acceleration * step / 2, axis=2) * step
    away = np.hypot(place[0] - distance, place[1])
    assert (away.min(axis=1) < 2.0).all()


def test_the_friction_bound_fits_the_distance_bound() -> None:
    """On the least friction of a distance, that distance is the smallest."""
    here = scene()
    least = point_mass.smallest_friction(here)
    assert point_mass.smallest_distance(here.on(least)) == pytest.approx(here.distance, rel=0.01)
