"""The ablation as Markdown, CSV and JSON."""

import csv
import json
from dataclasses import replace
from io import StringIO

from swerve.report.ablation import as_csv, as_json, as_markdown
from swerve.simulate.result import StepTime
from swerve.study.ablation import Ablation, Row
from tests.report.results import ABLATION


def test_the_markdown_is_two_tables() -> None:
    """One has what each row came to in each scene, the other what it changed; all rows of a table are of one width."""
    text = as_markdown(ABLATION)
    lines = [line for line in text.splitlines() if line.startswith("|")]
    assert len(lines) == 2 * (2 + len(ABLATION.rows))
    assert [line.count("|") for line in lines] == [4] * 4 + [3] * 4
    assert "| as printed | collided 0.000<br>0.0 deg<br>2 / 3 | collided 0.000<br>0.0 deg<br>2 / 3 |" in lines
    assert "| unified, bare | avoided 1.012<br>5.7 deg<br>2 / 3 | avoided none<br>5.7 deg<br>2 / 3 |" in lines
    assert "| unified, bare | It works. |" in lines
    assert "- `wet`: on a wet road\n" in text


def test_the_csv_has_a_line_for_each_run() -> None:
    """Values are in SI, and a field without a value is empty."""
    lines = list(csv.DictReader(StringIO(as_csv(ABLATION))))
    assert [(line["variant"], line["scenario"]) for line in lines] == [
        ("as printed", "paper"),
        ("as printed", "wet"),
        ("unified, bare", "paper"),
        ("unified, bare", "wet"),
    ]
    assert (lines[2]["outcome"], lines[2]["min_distance_ratio"], lines[2]["max_steer"]) == ("avoided", "1.0123", "0.1")
    assert lines[3]["min_distance_ratio"] == lines[3]["impact_speed"] == ""


def test_the_json_holds_what_makes_a_row_again() -> None:
    """A row has its controller, its settings, its sentence and a result for each scene."""
    bare = json.loads(as_json(ABLATION))["rows"][1]
    assert (bare["controller"], bare["overrides"]) == ("unified", ["controller.unified.iterations=1"])
    assert bare["change"] == "It works."
    assert bare["results"]["wet"]["min_distance_ratio"] is None
    assert bare["results"]["paper"]["solver_failures"] == 3


def test_nothing_of_the_machine_is_in_the_files() -> None:
    """On a slower machine the same runs give the same files."""
    slower = [
        Row(row.variant, tuple(replace(each, step_time=StepTime(9.0, 9.0, 9.0), wall_time=9.0) for each in row.results))
        for row in ABLATION.rows
    ]
    for write in (as_markdown, as_csv, as_json):
        assert write(Ablation(ABLATION.scenes, tuple(slower))) == write(ABLATION)
