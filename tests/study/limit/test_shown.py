"""What is shown of limits: JSON, table and map."""

import json

import numpy as np
import pytest

from swerve.conventions import GRAVITY
from swerve.report.limit import limits_json, limits_table, map_markdown
from swerve.scenario import load
from swerve.study.limit import Means, limits_of
from swerve.study.limit.map import limit_map


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


def test_a_map_has_a_row_for_each_friction_and_a_column_for_each_speed() -> None:
    """Braking's distance, less the radius, falls as 1 / mu."""
    found = limit_map("paper", Means.BRAKING, speeds=(20.0,), frictions=(0.5, 1.0))
    distances = np.array([row[0].distance for row in found.cells], dtype=float) - 2
    assert distances[0] / distances[1] == pytest.approx(2.0, rel=1e-3)
    rows = map_markdown(found).splitlines()
    assert sum(row.startswith("|") for row in rows) == 4
    assert any(f"{distances[1] + 2:.1f} (" in row for row in rows)
