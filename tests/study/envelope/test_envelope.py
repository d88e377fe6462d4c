"""The envelope: the table of limits, the approach to it, and a part of it."""

from math import sqrt

import pytest

from swerve.conventions import GRAVITY
from swerve.report.envelope import as_markdown
from swerve.simulate import Outcome
from swerve.study.envelope import LIMITS, REQUIRED, SPEEDS, Cell, Condition, Envelope, approach, conditions


def test_the_limits_are_near_those_of_a_point_mass() -> None:
    """A mass that accelerates sideways with mu g needs v sqrt(2 w / (mu g)) for a width w = 2 m; a vehicle that may
    brake as well, and has to turn first, is within 15 % of it.
    """
    for each in conditions():
        assert each.limit == pytest.approx(each.speed * sqrt(2 * 2 / (each.friction * GRAVITY)), rel=0.15)


def test_a_limit_grows_with_speed_and_falls_with_friction() -> None:
    """Without exception."""
    rows = [[limit for limit in row if limit is not None] for row in LIMITS.values()]
    assert all(row == sorted(row) for row in rows)
    assert list(LIMITS) == sorted(LIMITS)
    for column in zip(*LIMITS.values(), strict=True):
        known = [limit for limit in column if limit is not None]
        assert known == sorted(known, reverse=True)
    assert len(list(conditions())) == len(LIMITS) * len(SPEEDS) - 2


def test_a_condition_is_the_papers_scene_elsewhere() -> None:
    """A disc of 2 m in the vehicle's line, at the ratio times the limit."""
    scene = Condition(25.0, 0.5, 24.7).scene(1.2)
    assert (scene.ego.speed, scene.goal.speed, scene.road.friction) == (25.0, 25.0, 0.5)
    assert scene.obstacles[0].position == pytest.approx((1.2 * 24.7, 0.0))
    assert scene.obstacles[0].semi_axes == (2.0, 2.0)


def test_the_approach_ends_at_the_first_hit() -> None:
    """A disc from half of the limit on cannot be avoided, nor can what is behind it count."""
    condition = Condition(20.0, 0.85, 14.8)
    cell = approach(condition, "planar", (1.5, 0.5, 1.3))
    assert (cell.ratio, cell.failed, cell.outcome) == (1.5, 0.5, Outcome.COLLIDED)
    assert cell.reaches(1.5)
    assert not cell.reaches(1.4)


@pytest.mark.parametrize("speed, friction", [(15.0, 1.0), (20.0, 0.85), (25.0, 0.3)])
def test_on_its_own_model_it_comes_as_near_as_it_is_to(speed: float, friction: float) -> None:
    """At the ratio that is required on the planar plant the disc is avoided."""
    condition = next(each for each in conditions() if (each.speed, each.friction) == (speed, friction))
    assert approach(condition, "planar", (REQUIRED["planar"],)).outcome is None


def test_the_table_marks_what_falls_short() -> None:
    """Bold where the ratio is not reached; a cell without a limit is empty."""
    first, second = Condition(15.0, 0.5, 14.9), Condition(20.0, 0.5, 19.8)
    other = Condition(20.0, 1.0, 14.2)
    cells = (
        Cell(first, 1.02, 1.01, Outcome.COLLIDED),
        Cell(second, 1.2, 1.15, Outcome.SPUN),
        Cell(other, None, 1.5, Outcome.SPUN),
    )
    text = as_markdown([Envelope("planar", cells)])
    assert "1 of 3 reach 1.04 times the limit." in text
    assert "| 0.5 | 15.2 m, 1.02 | **23.8 m, 1.20** |" in text
    assert "| 1 |  | **none down from 1.5** |" in text
