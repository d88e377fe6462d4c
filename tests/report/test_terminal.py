"""What commands print about results."""

import json
from dataclasses import replace

from swerve.report import ablation_table, result_json, result_table
from swerve.simulate import Outcome
from swerve.simulate.result import Range
from tests.report.results import ABLATION, RESULT


def test_the_table_of_a_run_is_for_people() -> None:
    """It has the outcome in a sentence, distances with units, and a word for what does not exist."""
    assert result_table(RESULT).splitlines() == [
        "scenario        wet, unified on planar, seed 7",
        "outcome         avoided: The vehicle touched nothing and stayed in hand.",
        "decision        steer-left",
        "distance ratio  1.012 at the least (1 is contact)",
        "clearance       none at the least",
        "lateral offset  -0.10 to 3.00 m, 0.01 m at the end",
        "speed           18.00 to 20.00 m/s (64.80 to 72.00 km/h)",
        "sideslip        2.86 deg at the most",
        "steps           100: 2 fallback, 3 solver failures",
        "step time       1.50 ms median, 4.00 ms p99",
    ]


def test_a_run_that_diverged_has_a_table_and_json() -> None:
    """Numbers that are not finite are "none" in the table and null in the JSON, which stays one line."""
    lost = replace(RESULT, outcome=Outcome.DIVERGED, lateral_offset=Range(float("nan"), float("inf"), 0.0))
    assert "lateral offset  none to none, 0.00 m at the end" in result_table(lost)
    assert json.loads(result_json(lost))["lateral_offset"] == {"min": None, "max": None, "final": 0.0}
    assert "\n" not in result_json(lost)


def test_the_ablation_has_a_line_for_each_variant() -> None:
    """A line has outcome, distance ratio, steering and failed steps of each scene, below the scenes' names."""
    lines = ablation_table(ABLATION).splitlines()
    assert lines[0].split() == ["paper", "wet"]
    assert lines[2].split() == ["as", "printed", *["collided", "0.000", "0.0", "2/3"] * 2]
    assert lines[3].split() == ["unified,", "bare", "avoided", "1.012", "5.7", "2/3", "avoided", "none", "5.7", "2/3"]
    assert lines[1].index("outcome") == lines[2].index("collided") == lines[3].index("avoided")
    assert max(map(len, lines)) < 120
