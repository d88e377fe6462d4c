"""The runs of a folder: those in it, all of those, and nothing else."""

from pathlib import Path

import pytest

from swerve.errors import InputError
from swerve.studio import runs
from swerve.studio.runs import Runs


def _run_in(directory: Path) -> Path:
    directory.mkdir(parents=True)
    for name in ("result.json", "report.html"):
        (directory / name).touch()
    return directory


def test_runs_are_the_folders_with_a_result_and_a_report(folder: Path) -> None:
    """Files and folders without them are none; a run that cannot be read is listed with the reason."""
    assert set(Runs(folder).names()) >= {"as printed", "unified", "two-obstacles", "<b>&", "broken"}
    assert not set(Runs(folder).names()) & {"empty", "notes.txt", folder.name}
    listed = {each["name"]: each for each in Runs(folder).listed()}
    assert listed["broken"]["fault"].endswith("is no run's result; write a folder that `swerve run --out` filled")
    assert listed["unified"]["fault"] is None
    assert listed["unified"]["controller"] == "unified"


def test_one_run_s_folder_is_a_list_of_one(folder: Path) -> None:
    """A folder that is itself a run's is shown by its own name."""
    assert Runs(folder / "unified").names() == {"unified": (folder / "unified").resolve()}


@pytest.mark.parametrize(
    "name", ["..", ".", "", "../outside", "inside/../../outside", "/etc", "link", "inside/deep", "x\0"]
)
def test_a_name_never_leads_out(name: str, tmp_path: Path) -> None:
    """Paths, links to other places and runs that are deeper are no names of runs."""
    outside = _run_in(tmp_path / "outside")
    _run_in(tmp_path / "root" / "inside")
    _run_in(tmp_path / "root" / "inside" / "deep")
    (tmp_path / "root" / "link").symlink_to(outside)
    assert name not in Runs(tmp_path / "root").names()


def test_a_report_that_is_a_link_is_none(tmp_path: Path) -> None:
    """A folder whose report leads to another file is no run."""
    run = _run_in(tmp_path / "run")
    (run / "report.html").unlink()
    (run / "report.html").symlink_to("/etc/passwd")
    assert Runs(tmp_path).names() == {}


def test_new_runs_follow_the_last_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A new run's folder has the next number, and there is an end to them."""
    assert Runs(tmp_path).new().name == "studio-0001"
    for name in ("studio-0002", "studio-0007", "studio-x", "other"):
        (tmp_path / name).mkdir()
    assert Runs(tmp_path).new().name == "studio-0008"
    monkeypatch.setattr(runs, "MOST_MADE_HERE", 2)
    with pytest.raises(InputError, match="has 2 runs of the studio; remove some"):
        Runs(tmp_path).new()
