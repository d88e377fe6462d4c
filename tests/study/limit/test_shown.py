"""What is shown of limits: JSON and table."""

import json

import pytest

from swerve.conventions import GRAVITY
from swerve.report.limit import limits_json, limits_table
from swerve.scenario import load
from swerve.study.limit import Means, limits_of


def test_json_and_table_say_the_same() -> None:
    """Braking's closed form is in both; JSON is one line that any reader takes."""
    limits = limits_of(load("paper"), [Means.BRAKING])
    told = json.loads(limits_json(limits))
    braking = told["limits"]["braking"]
    assert "\n" not in limits_json(limits)
    assert braking["distance"] == pytest.approx(2 + 400 / (2 * 0.95 * 0.85 * GRAVITY), abs=0.01)
    assert braking["time_to_collision"] == pytest.approx((braking["distance"] - 2) / 20, abs=2e-3)
    assert braking["at_distance"]["distance_ratio"] >= 0.999
    assert told["point_mass"]["distance"] < braking["distance"]
    assert f"{braking['distance']:.2f} m" in limits_table(limits)
