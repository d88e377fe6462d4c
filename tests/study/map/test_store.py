"""The store: what it keeps, and what it refuses."""

import os
import subprocess
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pyarrow.parquet
import pytest

from swerve.errors import InputError
from swerve.scenario import load
from swerve.study.map import store as store_module
from swerve.study.map.boundary import Condition, RunRecord
from swerve.study.map.settings import MapSettings
from swerve.study.map.store import UNITS, Store

HERE, THERE = Condition(20.0, 0.85, 0.0), Condition(15.0, 1.0, -0.5)
SETTINGS = MapSettings(
    load("paper"), ("unified", "brake"), "planar", (15.0, 20.0), (0.85, 1.0), (0.0,), 0.1, ("both",), 0
)
RECORDS = {
    "a": RunRecord("unified", HERE, 16.4, "avoided", "brake+steer-left", 0.02, None, 1.01, 0.1),
    "b": RunRecord("unified", THERE, 16.3, "collided", "steer-left", 0.0, 12.5, 0.98, 0.2),
    "c": RunRecord("brake", HERE, 2.1, "collided"),
    "d": RunRecord("limit: both", HERE, float("inf"), "none"),
}


def fill(directory: Path, *keys: str, settings: MapSettings = SETTINGS) -> None:
    """Records, a file each, of a map that is then stopped."""
    with Store(directory, settings) as store:
        for key in keys:
            store.add({key: RECORDS[key]})


def contents(directory: Path) -> dict[str, bytes]:
    """Every file in a folder, but for the lock."""
    return {str(path): path.read_bytes() for path in directory.rglob("*") if path.is_file() and path.name != ".lock"}


def test_what_was_kept_is_there_again(tmp_path: Path) -> None:
    """Record by record, with all of its values, whether the map was finished or not."""
    fill(tmp_path, "a", "b", "c", "d")
    with Store(tmp_path, SETTINGS) as store:
        assert store.records == RECORDS
        store.finish()
    assert not (tmp_path / "runs").exists()
    with Store(tmp_path, SETTINGS) as store:
        assert store.records == RECORDS


def test_the_file_does_not_depend_on_the_order_of_the_runs(tmp_path: Path) -> None:
    """Byte by byte."""
    for name, order in (("one", "abcd"), ("other", "dbca")):
        fill(tmp_path / name, *order[:2])
        with Store(tmp_path / name, SETTINGS) as store:
            store.add({key: RECORDS[key] for key in order[2:]})
            store.finish()
    assert (tmp_path / "one/runs.parquet").read_bytes() == (tmp_path / "other/runs.parquet").read_bytes()


def test_every_column_has_its_unit(tmp_path: Path) -> None:
    """In the file's own metadata."""
    fill(tmp_path, "a")
    schema = pyarrow.parquet.read_schema(tmp_path / "runs/a.parquet")
    assert {field.name: field.metadata[b"unit"].decode() for field in schema} == UNITS


def test_a_file_that_was_not_whole_is_cleared_away(tmp_path: Path) -> None:
    """A process that was killed while it wrote leaves one; what is whole is read."""
    fill(tmp_path, "a")
    (tmp_path / "runs/b.parquet.partial").write_bytes(b"PAR1 and no more")
    with Store(tmp_path, SETTINGS) as store:
        assert set(store.records) == {"a"}
    assert [path.name for path in (tmp_path / "runs").iterdir()] == ["a.parquet"]


@pytest.mark.parametrize("name", ["runs.parquet", "runs/a.parquet"])
@pytest.mark.parametrize("constant, value", [("FORMAT", "0"), ("__version__", "0.0.9")])
def test_results_of_another_version_are_refused_and_stay(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, constant: str, value: str
) -> None:
    """With the file and both versions."""
    with monkeypatch.context() as patch:
        patch.setattr(store_module, constant, value)
        fill(tmp_path, "a")
        if name == "runs.parquet":
            with Store(tmp_path, SETTINGS) as store:
                store.finish()
    before = contents(tmp_path)
    with pytest.raises(InputError, match=rf"{name}: of version {value} of .*, this is version .*; write another --out"):
        fill(tmp_path, "b")
    assert contents(tmp_path) == before


@pytest.mark.parametrize(
    "changes, named",
    [
        ({"seed": 1}, "seed"),
        ({"tolerance": 0.2, "speeds": (15.0,)}, "speeds and tolerance"),
        ({"scenario": load("paper", ["controller.weights.speed=2"])}, "scenario"),
    ],
)
def test_results_of_other_settings_are_refused_and_stay(tmp_path: Path, changes: dict[str, Any], named: str) -> None:
    """With the settings that differ."""
    fill(tmp_path, "a")
    before = contents(tmp_path)
    with pytest.raises(InputError, match=f"a map with other settings: {named}; write the same"):
        fill(tmp_path, "b", settings=replace(SETTINGS, **changes))
    assert contents(tmp_path) == before


def test_what_is_no_parquet_is_refused(tmp_path: Path) -> None:
    """By its name, and it stays."""
    (tmp_path / "runs.parquet").write_bytes(b"something else")
    with pytest.raises(InputError, match=r"runs\.parquet: cannot be read"):
        fill(tmp_path, "a")
    assert (tmp_path / "runs.parquet").read_bytes() == b"something else"


def test_a_parquet_file_of_somebody_else_is_refused(tmp_path: Path) -> None:
    """It says nothing of a map."""
    pyarrow.parquet.write_table(pyarrow.table({"x": [1.0]}), tmp_path / "runs.parquet")
    with pytest.raises(InputError, match=r"runs\.parquet: of version none of the format of a map"):
        fill(tmp_path, "a")


def test_one_map_at_a_time(tmp_path: Path) -> None:
    """The second one that wants to write there is told so."""
    with Store(tmp_path, SETTINGS), pytest.raises(InputError, match="another map is being written there"):
        fill(tmp_path, "a")


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of 64 kB."""
    if not hasattr(os, "geteuid") or os.geteuid() != 0:
        pytest.skip("only root may mount a file system")
    place = tmp_path / "small"
    place.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(place)]
    if subprocess.run(mount, check=False, capture_output=True).returncode != 0:
        pytest.skip("this machine mounts no file system")
    yield place
    subprocess.run(["umount", str(place)], check=True)


def test_a_full_disk_is_told_and_what_was_kept_stays(small_disk: Path) -> None:
    """One message with the reason and the number of results; the next map goes on from these."""
    record = RECORDS["a"]
    with (
        pytest.raises(InputError, match=r"No space left on device; \d+ results are kept there") as refused,
        Store(small_disk, SETTINGS) as store,
    ):
        for i in range(1000):
            store.add({f"{i:04}": replace(record, distance=float(i))})
    with Store(small_disk, SETTINGS) as store:
        assert f" {len(store.records)} results" in str(refused.value)
        assert [each.distance for each in store.records.values()] == list(range(len(store.records)))
        assert store.records


def test_an_unwritable_folder_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """With what the file system says; nothing is left behind."""

    def refuse(source: object, target: object) -> None:
        raise PermissionError(13, "Permission denied")

    fill(tmp_path, "a")
    before = contents(tmp_path)
    monkeypatch.setattr("os.replace", refuse)
    with pytest.raises(InputError, match="cannot be written: Permission denied; 1 results are kept there"):
        fill(tmp_path, "b")
    assert contents(tmp_path) == before
