"""What counts as avoided when a solution is driven again."""

from dataclasses import replace

import pytest

from swerve.scenario import load
from swerve.study.limit.best import best
from swerve.study.limit.means import Means
from swerve.study.limit.resimulate import resimulate
from swerve.study.limit.scene import Scene
from swerve.study.limit.trajectory import Sought


@pytest.mark.parametrize(("nearer", "is_avoided"), [(0.0, True), (1.5e-3, True), (3e-3, False), (0.5, False)])
def test_a_rectangle_may_be_touched_by_two_millimetres(nearer: float, is_avoided: bool) -> None:
    """Braking's limit touches the car; 1.5 mm of overlap are what a solver leaves, 3 mm are a collision."""
    scene = Scene.of(load("stopped-car-town"))
    found = best(scene, Means.BRAKING, Sought.DISTANCE)
    assert found is not None
    closer = replace(found.trajectory, distance=found.trajectory.distance - nearer)
    drive = resimulate(scene, closer)
    assert drive.is_avoided is is_avoided
    assert drive.clearance == pytest.approx(0.0, abs=1e-4)


def test_a_clear_ellipse_does_not_excuse_a_rectangle() -> None:
    """With an ellipse far behind a car, sqrt(rho) is large, and a car that is hit is hit all the same."""
    car = Scene.of(load("stopped-car-town"))
    disc = Scene.of(load("paper", ['obstacles.0.position=["200 m", "0 m"]'])).obstacles
    both = replace(car, obstacles=car.obstacles + disc)
    found = best(car, Means.BRAKING, Sought.DISTANCE)
    assert found is not None
    drive = resimulate(both, replace(found.trajectory, distance=found.trajectory.distance - 0.5))
    assert drive.ratio is not None and drive.ratio > 1
    assert not drive.is_clear and not drive.is_avoided
