"""`swerve manoeuvres` and `swerve manoeuvre`: what they print and write, and their exit status."""

import json
from pathlib import Path

import pyarrow.parquet
import pytest

from swerve.cli import main
from swerve.study.manoeuvres import MANOEUVRES

Outputs = pytest.CaptureFixture[str]


def test_the_library_is_listed_a_line_each(capsys: Outputs) -> None:
    """Each manoeuvre with what it is for and its source; as JSON too."""
    assert main(["manoeuvres"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == list(MANOEUVRES)
    assert main(["manoeuvres", "--json"]) == 0
    listed = json.loads(capsys.readouterr().out)
    assert [each["name"] for each in listed] == list(MANOEUVRES)
    assert all(each["description"] and each["source"] for each in listed)


def test_a_manoeuvre_prints_its_measures(capsys: Outputs) -> None:
    """A row each, with unit and meaning, no wider than a terminal of 120."""
    assert main(["manoeuvre", "double-lane-change", "--plant", "planar"]) == 0
    out = capsys.readouterr().out
    assert "ISO 3888-2" in out
    assert "cones_hit" in out and "least_clearance" in out
    assert max(map(len, out.splitlines())) <= 120


def test_json_is_one_object_with_units(capsys: Outputs) -> None:
    """Speed and friction are those that were asked for, in SI, and every measure has a unit; what is not is null."""
    options = ["--plant", "planar", "--speed", "36 km/h", "--friction", "50 %", "--vehicle", "bmw-320i", "--json"]
    assert main(["manoeuvre", "double-lane-change", *options]) == 0
    printed = capsys.readouterr().out
    result = json.loads(printed)
    assert len(printed.splitlines()) == 1
    assert result["parameters"]["speed"] == {"value": 10.0, "unit": "m/s"}
    assert result["parameters"]["friction"]["value"] == 0.5
    assert result["parameters"]["exit_width"]["value"] is None
    assert (result["vehicle"], result["plant"]) == ("bmw-320i", "planar")
    assert all(measure["unit"] for measure in result["measures"].values())


def test_files_are_written(tmp_path: Path, capsys: Outputs) -> None:
    """Result, motion with units, and the figure; the printed JSON is the result."""
    folder = tmp_path / "new"
    assert main(["manoeuvre", "double-lane-change", "--out", str(folder), "--json"]) == 0
    names = ["manoeuvre.pdf", "manoeuvre.png", "motion.parquet", "result.json"]
    assert sorted(path.name for path in folder.iterdir()) == names
    assert (folder / "result.json").read_text() == capsys.readouterr().out
    schema = pyarrow.parquet.read_schema(folder / "motion.parquet")
    assert schema.field("r").metadata[b"unit"] == b"rad/s"
    assert json.loads(schema.metadata[b"swerve.manoeuvre"])["manoeuvre"] == "double-lane-change"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["step-stear"], "did you mean step-steer?"),
        (["step-steer", "--plant", "plannar"], "did you mean planar?"),
        (["step-steer", "--vehicle", "d-clas-sedan"], "did you mean d-class-sedan?"),
        (["step-steer", "--speed", "80 kg"], "--speed: '80 kg' is not a speed"),
        (["step-steer", "--speed", "nan"], "not finite"),
        (["step-steer", "--speed", "-5"], "is not from 1 to 100"),
        (["step-steer", "--friction", "7"], "is not from 0.01 to 2"),
        (["step-steer", "--friction", "0.2"], "reaches no more than"),
        (["split-friction-braking", "--friction", "0.1"], "friction must be at least low_friction"),
        (["split-friction-braking", "--plant", "planar"], "take the multibody plant"),
    ],
)
def test_wrong_input_is_refused_in_one_line(
    arguments: list[str], said: str, tmp_path: Path, capsys: Outputs, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Status 2, one message on stderr with the cure, and nothing written."""
    monkeypatch.chdir(tmp_path)
    assert main(["manoeuvre", *arguments, "--out", "there"]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert said in captured.err and len(captured.err.splitlines()) == 1
    assert list(tmp_path.iterdir()) == []
