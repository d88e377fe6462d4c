"""The files of a run and of a reproduction."""

import json
from pathlib import Path

import matplotlib.image
import pytest

from swerve.report import prepare_output, result_json, write_reproduction, write_run
from swerve.scenario import load
from swerve.study.reproduce import Reproduction
from swerve.study.tyre_comparison import compare_tyres
from swerve.study.tyre_work import tyre_work
from tests.report.results import ABLATION
from tests.report.runs import made

PAGES = {"top_view", "states", "wheel_forces", "steering"}
RUN_FILES = {"result.json", "scenario.toml", "motion.parquet", "steps.parquet", "report.html"}
RUN_FILES |= {f"{page}.{suffix}" for page in PAGES for suffix in ("png", "pdf")}


def test_a_run_is_written(tmp_path: Path) -> None:
    """Result, scenario, log and figures are there; the result is what --json prints, the scenario loads to itself."""
    done, directory = made(controller="unified"), tmp_path / "a" / "run"
    prepare_output(directory)
    told: list[float] = []
    paths = write_run(done, directory, told.append)
    assert {path.name for path in paths} == {path.name for path in directory.iterdir()} == RUN_FILES
    assert (directory / "result.json").read_text() == result_json(done.result) + "\n"
    assert load(directory / "scenario.toml") == done.scenario
    for page in PAGES:
        assert matplotlib.image.imread(directory / f"{page}.png")[..., :3].std() > 0.02  # of 1: not blank
        assert (directory / f"{page}.pdf").read_bytes().startswith(b"%PDF")
    assert told == sorted(told)
    assert told[-1] == 1.0


def test_an_earlier_run_is_replaced(tmp_path: Path) -> None:
    """In the folder of an earlier run every file becomes the new run's, and other files stay."""
    for name in (*RUN_FILES, "notes.txt"):
        (tmp_path / name).write_text("earlier")
    write_run(made(seed=1), tmp_path)
    assert json.loads((tmp_path / "result.json").read_text())["seed"] == 1
    assert {path.name for path in tmp_path.iterdir()} == RUN_FILES | {"notes.txt"}
    assert [path.name for path in tmp_path.iterdir() if path.read_bytes() == b"earlier"] == ["notes.txt"]


@pytest.mark.parametrize("where", ["new", "old"])
def test_a_run_that_cannot_be_written_changes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, where: str
) -> None:
    """Where the disk is full half way through, a new directory is not there and an old one is as it was."""
    (tmp_path / "old").mkdir()
    (tmp_path / "old" / "result.json").write_text("earlier")

    def fail(table: object, run: object, path: Path) -> None:
        path.write_bytes(b"PAR1")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("swerve.report.tables.write_table", fail)
    with pytest.raises(OSError, match="No space left"):
        write_run(made(), tmp_path / where)
    assert [path.name for path in tmp_path.iterdir()] == ["old"]
    assert [path.name for path in (tmp_path / "old").iterdir()] == ["result.json"]
    assert (tmp_path / "old" / "result.json").read_text() == "earlier"


def test_a_reproduction_is_written(tmp_path: Path) -> None:
    """Figures are there by number, and Table 1 and the ablation in three forms."""
    reproduction = Reproduction(tyre_work(), compare_tyres(), made(controller="unified"), ABLATION)
    paths = write_reproduction(reproduction, tmp_path / "new")
    names = {path.name for path in paths}
    assert names == {path.name for path in (tmp_path / "new").iterdir()}
    figures = {"fig07_top_view", "fig08_states", "fig09_wheel_forces", "fig10_steering"}
    figures |= {"fig03_friction_ellipses", "fig04_line_fits", "fig05_lateral_forces"}
    assert names == {"fig05_lateral_forces.json"} | {
        f"{name}.{suffix}" for name in figures for suffix in ("png", "pdf")
    } | {f"{name}.{suffix}" for name in ("table1", "ablation") for suffix in ("md", "csv", "json")}
