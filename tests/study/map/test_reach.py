"""How near to the limit the unified controller comes, in three cells; the map has it for all."""

import pytest

from swerve.scenario import load
from swerve.study.map.boundary import Condition
from swerve.study.map.cell import Cell
from swerve.study.map.task import Trial
from tests.study.limits import LIMITS

CELLS = [(15.0, 1.0), (20.0, 0.85), (25.0, 0.3)]  # speed [m/s], friction [1]
REQUIRED = {"planar": 1.04, "multibody": 1.15}  # of the limit, from which on it is to be avoided [1]


@pytest.mark.parametrize("plant", REQUIRED)
@pytest.mark.parametrize("speed, friction, limit", [each for each in LIMITS if each[:2] in CELLS])
def test_the_disc_is_avoided_as_near_as_it_is_to(plant: str, speed: float, friction: float, limit: float) -> None:
    """At the ratio to the limit that is required on each plant."""
    cell = Cell.of(load("paper"), Condition(speed, friction, 0.0))
    (record,) = Trial(cell, REQUIRED[plant] * limit, "unified", plant, 0)().values()
    assert record.is_avoided, record
