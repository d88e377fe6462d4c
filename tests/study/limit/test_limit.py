"""The limit of the paper's scene: what is found, what it leaves, and what holds of any limit."""

import pytest

from swerve.scenario import load
from swerve.study.limit import Means, limit_of
from swerve.study.limit.best import best, least_violation
from swerve.study.limit.point_mass import smallest_distance
from swerve.study.limit.scene import Scene
from swerve.study.limit.trajectory import Sought
from tests.study.limit.scenes import scene

PAPER = scene()
OFFSET = 'obstacles.0.position=["25 m", "{} m"]'


def distance(here: Scene, means: Means) -> float:
    """The smallest distance [m], of a control that was driven again."""
    found = best(here, means, Sought.DISTANCE)
    assert found is not None
    assert found.drive.is_avoided
    assert found.drive.ratio is not None and found.drive.ratio >= 0.999
    return found.trajectory.distance


@pytest.mark.slow
def test_the_papers_scene() -> None:
    """14.9 m with all means, little more with brakes alike left and right; more means are never worse."""
    found = {means: distance(PAPER, means) for means in Means}
    bound = smallest_distance(PAPER)
    assert bound < found[Means.INDIVIDUAL] <= 14.9
    assert found[Means.INDIVIDUAL] <= found[Means.BOTH] <= 15.0
    assert found[Means.BOTH] <= found[Means.STEERING] <= 15.6
    assert found[Means.BRAKING] == pytest.approx(27.2, abs=0.3)


@pytest.mark.slow
def test_three_percent_less_cannot_be_avoided() -> None:
    """At 0.97 of the limit every start overlaps the obstacle by more than 10 cm."""
    shortest = distance(PAPER, Means.INDIVIDUAL)
    assert least_violation(PAPER.at(0.97 * shortest), Means.INDIVIDUAL) > 0.1


@pytest.mark.slow
def test_a_mirrored_scene_has_the_same_limit() -> None:
    """An obstacle 0.8 m to the left is as hard as one 0.8 m to the right, and easier than one straight ahead."""
    left, right = (distance(scene(OFFSET.format(y)), Means.INDIVIDUAL) for y in (0.8, -0.8))
    assert left == pytest.approx(right, rel=0.01)
    assert left < distance(PAPER, Means.INDIVIDUAL)


@pytest.mark.slow
def test_the_same_scenario_has_the_same_limit() -> None:
    """Twice the same bits; and the least friction is at most the road's where the distance leaves room."""
    first, second = (limit_of(load("paper"), Means.STEERING) for _ in range(2))
    assert first.distance == second.distance and first.friction == second.friction
    assert first.friction is not None and first.friction < 0.85
