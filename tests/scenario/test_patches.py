"""Friction that differs from place to place, as scenarios write it."""

import pytest

from swerve.errors import InputError
from swerve.scenario import load
from swerve.scenario.loader import parse
from swerve.simulate import run

ROAD = """
name = "patches"
duration = "0.2 s"
goal = { speed = 20, lateral_offset = 0 }
ego = { position = [0, 0], speed = 20, footprint = "point" }
[road]
friction = 0.85
[[road.patches]]
x = ["10 m", "30 m"]
friction = 0.3
"""


def test_patches_become_a_map() -> None:
    """A patch without an interval has no bounds that way, and a road without patches has one friction."""
    friction = parse(ROAD.encode(), "patches.toml").road.to_friction()
    assert friction.at([[5, 0], [20, 1e4]]).tolist() == [0.85, 0.3]
    assert load("paper").road.to_friction().patches == ()


def test_a_scenario_with_patches_is_written_and_read_again() -> None:
    """Through TOML it comes back equal."""
    scenario = parse(ROAD.encode(), "patches.toml")
    assert parse(scenario.to_toml().encode(), "again.toml") == scenario


def test_an_interval_that_descends_is_refused() -> None:
    """The message has the key of the patch."""
    with pytest.raises(InputError, match=r"road.patches.0.x: goes from 30 m to 10 m; write the smaller first"):
        parse(ROAD.replace('["10 m", "30 m"]', '["30 m", "10 m"]').encode(), "patches.toml")


def test_too_many_patches_are_refused() -> None:
    """The plant has a place for eight."""
    more = 8 * "[[road.patches]]\nfriction = 0.5\n"
    with pytest.raises(InputError, match=r"road.patches: are 9; write at most 8"):
        parse((ROAD + more).encode(), "patches.toml")


def test_the_planar_plant_refuses_patches() -> None:
    """It has one friction, and would drop the others silently."""
    scenario = parse(ROAD.encode(), "patches.toml")
    with pytest.raises(InputError, match=r"road.patches: the planar plant has one friction"):
        run(scenario, plant="planar")
    assert run(scenario, plant="multibody").log.motion["vx"].size == 201
