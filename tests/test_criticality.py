"""`swerve criticality`: what it prints of a scenario and of a run, and what it refuses."""

import json
from pathlib import Path
from shutil import copy

import numpy as np
import pytest

from swerve.cli import main
from swerve.scenario import load
from swerve.study.criticality import UNITS, Scene, measure

Outputs = pytest.CaptureFixture[str]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files of a short run that ends in a collision."""
    out = tmp_path_factory.mktemp("run")
    options = ["--set", "obstacles.0.position=[15, 0]", "--set", "duration=1.5 s", "--plant", "planar", "--quiet"]
    assert main(["run", "paper", "--controller", "as-printed", *options, "--out", str(out)]) == 0
    return out


def test_a_scenario_is_measured_at_its_start(capsys: Outputs) -> None:
    """A line for each measure with its unit, no wider than a terminal of 120."""
    assert main(["criticality", "paper"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines[2 : 2 + len(UNITS)]] == list(UNITS)
    assert lines[3].split()[:3] == ["ttc", "1.150", "s"]
    assert max(map(len, lines)) <= 120


def test_json_has_the_numbers_of_the_function(capsys: Outputs) -> None:
    """One object; what is not finite is a word that every language's number parser takes."""
    assert main(["criticality", "paper", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    values = measure(Scene.of_start(load("paper"), "multibody"))
    assert found["measures"].keys() == UNITS.keys()
    for name, each in found["measures"].items():
        assert each["unit"] == UNITS[name]
        assert [float(value) for value in each["values"]] == values[name].tolist()
    assert found["measures"]["ttb"]["values"] == ["-Infinity"]
    assert found["pet"] == "Infinity"


def test_a_run_is_measured_at_every_sample(folder: Path, capsys: Outputs) -> None:
    """From the folder alone: 31 instants, the last of them after the point of no return, which it passed for good."""
    assert main(["criticality", str(folder), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["plant"] == "planar"
    assert found["time"] == pytest.approx(np.arange(31) * 0.05)
    ttr = [float(value) for value in found["measures"]["ttr"]["values"]]
    lost = found["point_of_no_return"]
    assert ttr[round(lost / 0.05)] == -np.inf
    assert all(value > 0 for value in ttr[: round(lost / 0.05)])
    assert float(found["measures"]["clearance"]["worst"]["value"]) == 0
    assert main(["criticality", str(folder)]) == 0
    assert f"point of no return  {lost:.2f} s" in capsys.readouterr().out


def test_a_folder_without_a_run_is_refused(folder: Path, tmp_path: Path, capsys: Outputs) -> None:
    """So is one whose motion is something else; in one line that says what would be right."""
    assert main(["criticality", str(tmp_path)]) == 2
    assert "has no result.json; write a folder that `swerve run --out` filled" in capsys.readouterr().err
    for name in ("result.json", "scenario.toml", "steps.parquet"):
        copy(folder / name, tmp_path)
    copy(folder / "steps.parquet", tmp_path / "motion.parquet")
    assert main(["criticality", str(tmp_path)]) == 2
    assert "column vx [m/s] is missing" in capsys.readouterr().err
    (tmp_path / "motion.parquet").write_bytes(b"no parquet")
    assert main(["criticality", str(tmp_path)]) == 2
    captured = capsys.readouterr()
    assert "is no Parquet file that can be read" in captured.err
    assert len(captured.err.splitlines()) == 1
    assert captured.out == ""


def test_an_unknown_scenario_is_refused(capsys: Outputs) -> None:
    """As `swerve run` refuses it."""
    assert main(["criticality", "papper"]) == 2
    assert "did you mean paper" in capsys.readouterr().err
