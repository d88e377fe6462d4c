"""What a worker does, and the key under which it is kept."""

import pickle

import pytest

from swerve.conventions import GRAVITY
from swerve.scenario import load
from swerve.simulate import run
from swerve.study.map.boundary import Condition
from swerve.study.map.cell import Cell
from swerve.study.map.task import Limits, Trial, perform

HERE = Condition(20.0, 0.85, 0.0)
CELL = Cell.of(load("paper"), HERE)


@pytest.mark.parametrize("distance", [16.0, 29.0])
def test_a_record_is_that_of_the_run(distance: float) -> None:
    """The same numbers as those of the scenario run by itself, also where the task was sent through a pipe."""
    trial = Trial(CELL, distance, "brake", "planar", 3)
    (record,) = perform(pickle.loads(pickle.dumps(trial))).values()
    result = run(CELL.at(distance), "brake", "planar", 3).result
    assert (record.who, record.condition, record.distance) == ("brake", HERE, distance)
    assert (record.outcome, record.decision) == (result.outcome.value, result.decision)
    assert (record.outcome == "avoided") is (distance > 27)
    assert record.impact_speed == result.impact_speed
    if record.is_avoided:
        assert record.min_distance_ratio == result.min_distance_ratio
        assert record.max_sideslip == result.max_sideslip


def test_a_run_goes_no_further_than_its_first_contact() -> None:
    """Just inside the obstacle, at most as far as a sample's way: 1 m of its 2 m."""
    (record,) = Trial(CELL, 16.0, "brake", "planar", 0)().values()
    assert record.min_distance_ratio is not None
    assert 0.5 < record.min_distance_ratio < 1


def test_a_key_is_that_of_the_task() -> None:
    """The same for the same task, another one for any other."""
    other = Cell.of(load("paper"), Condition(20.0, 0.85, 0.5))
    weighted = Cell.of(load("paper", ["controller.weights.speed=2"]), HERE)
    given = [
        (CELL, 16.0, "brake", "planar", 0),
        (CELL, 16.1, "brake", "planar", 0),
        (CELL, 16.0, "unified", "planar", 0),
        (CELL, 16.0, "brake", "multibody", 0),
        (CELL, 16.0, "brake", "planar", 1),
        (other, 16.0, "brake", "planar", 0),
        (weighted, 16.0, "brake", "planar", 0),
    ]
    keys = [Trial(*each).key for each in given]
    assert len(set(keys)) == len(given)
    assert keys == [Trial(*each).key for each in given]
    assert Trial(Cell.of(load("paper"), HERE), *given[0][1:]).key == keys[0]


def test_an_obstacle_over_the_start_is_a_collision_without_a_run() -> None:
    """Another one that is shifted with the first may come to lie there."""
    beside = "obstacles.1={position=[-12, 0], size=[4, 2]}"
    cell = Cell.of(load("paper", [beside]), HERE)
    (record,) = Trial(cell, 37.0, "brake", "planar", 0)().values()
    assert (record.outcome, record.decision, record.min_clearance) == ("collided", None, 0.0)


def test_limits_of_a_cell_share_a_task() -> None:
    """Braking's is the closed form with a share of 0.95 of the friction; nothing helps below the point mass's."""
    limits = Limits(CELL, ("limit: braking", "limit: point-mass"))
    records = limits()
    assert set(records) == set(limits.keys.values())
    braking, point_mass = (records[limits.keys[name]] for name in limits.names)
    assert braking.outcome == point_mass.outcome == "avoided"
    assert braking.distance == pytest.approx(2 + 20**2 / (2 * 0.95 * 0.85 * GRAVITY), abs=0.02)
    assert point_mass.distance < braking.distance
