"""A scenario in a cell: where its obstacles are, and how long it runs."""

import pytest

from swerve.conventions import GRAVITY
from swerve.errors import InputError
from swerve.scenario import Scenario, load
from swerve.scenario.loader import parse
from swerve.simulate import run
from swerve.study.map.boundary import Condition
from swerve.study.map.cell import SETTLING, Cell, covers_start

HERE = Condition(25.0, 0.5, 0.5)


def test_a_cell_is_the_scenario_elsewhere() -> None:
    """Speed, goal, friction and offset are the cell's, the distance is the one asked for."""
    there = Cell.of(load("paper"), HERE).at(31.4)
    assert (there.ego.speed, there.goal.speed, there.road.friction) == (25.0, 25.0, 0.5)
    assert there.obstacles[0].position == (31.4, 0.5)


DRIVING_OFF = """obstacles.0={size=[4, 2], waypoints=[
    {time=0, position=[25, 0]}, {time=2, position=[30, 0]}, {time=3, position=[45, 0]}]}"""


@pytest.mark.parametrize("overrides", [("slalom",), ("slower-lead",), ("paper", DRIVING_OFF)])
def test_all_obstacles_are_shifted_alike(overrides: tuple[str, ...]) -> None:
    """What lies between them, and when, stays as it was."""
    name, *rest = overrides
    scenario = load(name, rest)
    cell = Cell.of(scenario, Condition(20.0, 0.85, 0.0))
    there = cell.at(cell.scene.distance + 7.0)
    for before, after in zip(scenario.obstacles, there.obstacles, strict=True):
        for time in (0.0, 1.3):
            x, y = after.to_world().position_at(time) - before.to_world().position_at(time)
            assert (x, y) == pytest.approx((7.0, 0.0))


def test_a_cells_scenario_can_be_written_and_read() -> None:
    """It is a scenario like any other."""
    there = Cell.of(load("slower-lead"), HERE).at(30.0)
    assert parse(there.to_toml().encode(), "there") == there


def test_bumper_to_bumper_touches_and_further_off_does_not() -> None:
    """The extent is half of the vehicle's length and the disc's radius."""
    cell = Cell.of(load("paper", ["ego.footprint=rectangle"]), Condition(20.0, 0.85, 0.0))
    assert covers_start(cell.at(cell.extent - 0.01))
    assert not covers_start(cell.at(cell.extent + 0.01))


def test_a_run_lasts_until_its_end_is_known() -> None:
    """From afar until it stands and a while longer; from near until it is past."""
    cell = Cell.of(load("paper"), Condition(20.0, 0.85, 0.0))
    stopping = 20.0 / (0.85 * GRAVITY)
    assert cell.at(60.0).duration > stopping + SETTLING
    assert SETTLING + 10.0 / 20.0 < cell.at(12.0).duration < stopping + SETTLING


@pytest.mark.parametrize("distance", [14.0, 16.0, 30.0])
def test_a_longer_run_would_not_end_otherwise(distance: float) -> None:
    """Twice the duration, the same outcome and the same impact."""
    there = Cell.of(load("paper"), Condition(20.0, 0.85, 0.0)).at(distance)
    longer = there.model_copy(update={"duration": 2 * there.duration})
    one, two = (run(each, "unified", "planar").result for each in (there, longer))
    assert (one.outcome, one.impact_speed) == (two.outcome, two.impact_speed)


def test_a_moving_obstacle_has_its_time() -> None:
    """Its motion is timed by the scenario's duration, which is kept."""
    scenario: Scenario = load("braking-lead-motorway")
    cell = Cell.of(scenario, Condition(30.0, 0.85, 0.0))
    assert cell.at(cell.extent + 1.0).duration >= scenario.duration


def test_what_has_no_distance_is_refused() -> None:
    """An obstacle that crosses, and none ahead."""
    with pytest.raises(InputError, match="moves across the road"):
        Cell.of(load("pedestrian-crossing"), HERE)
    with pytest.raises(InputError, match="none is ahead"):
        Cell.of(load("paper", ["obstacles=[]"]), HERE)
