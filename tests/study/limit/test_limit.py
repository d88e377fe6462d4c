"""The limit of the paper's scene: what is found, what it leaves, and what holds of any limit."""

from math import inf

import pytest

from swerve.scenario import load
from swerve.study.limit import Means, grid, limit_of
from swerve.study.limit.best import best, least_violation
from swerve.study.limit.point_mass import smallest_distance
from swerve.study.limit.resimulate import TOUCH
from swerve.study.limit.scene import Scene
from swerve.study.limit.trajectory import Sought
from tests.study.limit.scenes import scene

PAPER = scene()
CAR = Scene.of(load("stopped-car-town"))
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
    """14.9 m with wheel torques, little more with brakes alike left and right; more means are never worse."""
    found = {means: distance(PAPER, means) for means in Means}
    bound = smallest_distance(PAPER)
    assert bound < found[Means.INDIVIDUAL] <= 14.9
    assert found[Means.INDIVIDUAL] <= found[Means.BOTH] <= 14.95
    assert found[Means.BOTH] <= found[Means.STEERING] <= 15.35
    assert found[Means.BRAKING] == pytest.approx(27.2, abs=0.3)


@pytest.mark.slow
def test_three_percent_less_cannot_be_avoided() -> None:
    """At 0.97 of the limit every start overlaps the obstacle by more than 10 cm."""
    for means in (Means.STEERING, Means.BOTH, Means.INDIVIDUAL):
        assert least_violation(PAPER.at(0.97 * distance(PAPER, means)), means) > 0.1


@pytest.mark.slow
@pytest.mark.parametrize("means", [Means.STEERING, Means.BOTH, Means.INDIVIDUAL])
def test_three_percent_less_hits_a_rectangle(means: Means) -> None:
    """A stopped car between the road's edges: every start overlaps it, by more than a drive may."""
    found = best(CAR, means, Sought.DISTANCE)
    assert found is not None and found.drive.is_avoided
    assert 10 * TOUCH < least_violation(CAR.at(0.97 * found.trajectory.distance), means) < inf


@pytest.mark.slow
def test_a_mirrored_scene_has_the_same_limit() -> None:
    """An obstacle 0.8 m to the left is as hard as one 0.8 m to the right, and easier than one straight ahead."""
    left, right = (distance(scene(OFFSET.format(y)), Means.INDIVIDUAL) for y in (0.8, -0.8))
    assert left == pytest.approx(right, rel=0.01)
    assert left < distance(PAPER, Means.INDIVIDUAL)


@pytest.mark.slow
def test_a_grid_twice_as_fine_has_the_same_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """To within 5 mm: that brakes alike left and right take 10 cm more than free ones is no matter of the grid."""
    usual = distance(PAPER, Means.BOTH)
    monkeypatch.setattr(grid, "N_INTERVALS", 2 * grid.N_INTERVALS)
    assert distance(scene(), Means.BOTH) == pytest.approx(usual, abs=5e-3)


@pytest.mark.slow
def test_every_start_agrees() -> None:
    """Left or right, braking little or much, or from steering's limit: all come within 1 % of the same distance.

    A scene that is its own mirror image is spared the starts to the right, and has the same limit.
    """
    symmetric, other = (best(each, Means.BOTH, Sought.DISTANCE) for each in (PAPER, scene(OFFSET.format(1e-6))))
    assert symmetric is not None and other is not None
    assert symmetric.n_agreeing == symmetric.n_starts == 3
    assert other.n_agreeing == other.n_starts == 5
    assert symmetric.trajectory.distance == pytest.approx(other.trajectory.distance, abs=5e-3)


@pytest.mark.slow
def test_the_friction_and_the_distance_are_two_sides_of_one_limit() -> None:
    """On the least friction at 25 m, 25 m is the smallest distance."""
    least = best(PAPER, Means.STEERING, Sought.FRICTION)
    assert least is not None and least.drive.is_avoided
    assert distance(PAPER.on(least.trajectory.friction), Means.STEERING) == pytest.approx(25.0, rel=0.02)


@pytest.mark.slow
def test_two_rectangles_between_edges() -> None:
    """Past two parked cars the manoeuvre goes left, then right, and stays on the road."""
    here = Scene.of(load("slalom"))
    found = best(here, Means.BOTH, Sought.DISTANCE)
    assert found is not None
    assert found.drive.is_avoided and found.drive.is_inside and found.drive.ratio is None
    assert smallest_distance(here) < found.trajectory.distance < 17.5


@pytest.mark.slow
def test_the_same_scenario_has_the_same_limit() -> None:
    """Twice the same bits; and the least friction is at most the road's where the distance leaves room."""
    first, second = (limit_of(load("paper"), Means.STEERING) for _ in range(2))
    assert first.distance == second.distance and first.friction == second.friction
    assert first.friction is not None and first.friction < 0.85
