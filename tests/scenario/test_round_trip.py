"""A scenario as TOML, and back."""

import tomllib
from typing import Any

import pytest
from hypothesis import given

from swerve.scenario import Scenario, library_names, load, parse
from tests.scenario.strategies import tables


@given(tables())
def test_a_scenario_survives_its_own_toml(scenario_tables: dict[str, Any]) -> None:
    """Written as TOML and read again, any scenario is equal to itself, to the last bit."""
    scenario = Scenario.model_validate(scenario_tables)
    assert parse(scenario.to_toml().encode(), "written.toml") == scenario


@pytest.mark.parametrize("name", library_names())
def test_a_library_scenario_survives_its_own_toml(name: str) -> None:
    """So is every scenario of the library."""
    scenario = load(name)
    assert parse(scenario.to_toml().encode(), "written.toml") == scenario


def test_the_toml_is_complete_and_in_si() -> None:
    """The document has no units and no hidden default in it."""
    document = tomllib.loads(load("paper", ["ego.parameters.mass=1.6 t"]).to_toml())
    assert document["ego"]["speed"] == 20.0
    assert document["ego"]["parameters"] == {"mass": 1600.0}
    assert document["controller"]["sample_time"] == 0.05
    assert document["plant"]["step"] == 0.001
