"""The results of a map in its folder, kept from the moment they are there, whatever ends the process.

    DIR/runs/KEY.parquet   what has just ended, a few records a file, each moved into place when it is whole
    DIR/runs.parquet       all of it in canonical order, written at the end over what was there

Every file's metadata has the format, swerve's version and all settings, its columns have units. Nothing in them depends
on the clock or on who ran what when, so that the same settings give the same bytes.
"""

import json
import os
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import fields
from pathlib import Path
from types import TracebackType
from typing import Any, Final, Self

import pyarrow
import pyarrow.parquet
from filelock import FileLock, Timeout

from swerve import __version__
from swerve.errors import InputError, one_line, shown_path
from swerve.study.map.boundary import Boundary, Condition, RunRecord
from swerve.study.map.settings import MapSettings

FORMAT: Final = "1"
FORMAT_KEY: Final = b"swerve.map.format"  # of the metadata
VERSION_KEY: Final = b"swerve.version"
SETTINGS_KEY: Final = b"swerve.map.settings"
UNIT: Final = b"unit"  # of a column's metadata
PARTIAL: Final = ".partial"  # ends the name of a file that is not whole

UNITS: Final[Mapping[str, str]] = {
    "key": "",
    "who": "",
    "speed": "m/s",
    "friction": "1",
    "offset": "m",
    "distance": "m",
    "outcome": "",
    "decision": "",
    "min_clearance": "m",
    "impact_speed": "m/s",
    "min_distance_ratio": "1",
    "max_sideslip": "rad",
}
IN_CONDITION: Final = tuple(field.name for field in fields(Condition))


class Store:
    """All records of one map, by their tasks' keys; one process at a time has it open.

    Raises:
        InputError: the folder is another process's, or holds what is not this map's, or cannot be written; what it
            held before stays.
    """

    def __init__(self, directory: Path, settings: MapSettings) -> None:
        self._directory, self._parts = directory, directory / "runs"
        self._metadata = {
            FORMAT_KEY: FORMAT.encode(),
            VERSION_KEY: __version__.encode(),
            SETTINGS_KEY: json.dumps(settings.to_json(), sort_keys=True).encode(),
        }
        self._order = {who: i for i, who in enumerate((*settings.controllers, *settings.limits))}
        self._lock = FileLock(directory / ".lock")
        self.records: dict[str, RunRecord] = {}

    def __enter__(self) -> Self:
        self._directory.mkdir(parents=True, exist_ok=True)
        try:
            self._lock.acquire(timeout=0)
        except Timeout as error:
            fault = "another map is being written there; wait for it, or write another folder"
            raise InputError(f"--out {shown_path(self._directory)}: {fault}") from error
        try:
            self._read()
        except BaseException:
            self._lock.release()
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._lock.release()
        if not self.records:  # then nothing was begun, and nothing shall be left
            Path(self._lock.lock_file).unlink(missing_ok=True)
            with suppress(OSError):
                self._directory.rmdir()

    def add(self, records: Mapping[str, RunRecord]) -> None:
        """Keep some more; when this returns they are on the disk."""
        self._write(records, self._parts / f"{min(records)}.parquet")
        self.records.update(records)

    def finish(self) -> Path:
        """Put all of them into one file, and return its path."""
        path = self._directory / "runs.parquet"
        self._write(self.records, path)
        for part in self._parts.glob("*.parquet"):
            part.unlink()
        if self._parts.is_dir():
            self._parts.rmdir()
        return path

    def _read(self) -> None:
        whole = self._directory / "runs.parquet"
        for path in [*([whole] if whole.exists() else []), *sorted(self._parts.glob("*.parquet"))]:
            self.records.update(self._records_in(path))
        for path in [*self._directory.glob(f"*{PARTIAL}"), *self._parts.glob(f"*{PARTIAL}")]:
            path.unlink()

    def _records_in(self, path: Path) -> dict[str, RunRecord]:
        try:
            table = pyarrow.parquet.read_table(path, partitioning=None)
        except (pyarrow.ArrowException, OSError) as error:
            fault = f"cannot be read: {one_line(str(error))}"
            raise InputError(f"{shown_path(path)}: {fault}; move it away, or write another --out") from error
        self._check(path, table.schema.metadata or {})
        return {row.pop("key"): _record(row) for row in table.to_pylist()}

    def _check(self, path: Path, found: Mapping[bytes, bytes]) -> None:
        cure = "write another --out, or move what is there away"
        for key, noun in ((FORMAT_KEY, "the format of a map"), (VERSION_KEY, "swerve")):
            if found.get(key) != self._metadata[key]:
                there = found[key].decode() if key in found else "none"
                here = self._metadata[key].decode()
                raise InputError(f"{shown_path(path)}: of version {there} of {noun}, this is version {here}; {cure}")
        there, here = (json.loads(each[SETTINGS_KEY]) for each in (found, self._metadata))
        others = [name for name in here if there.get(name) != here[name]]
        if others:
            fault = f"of a map with other settings: {' and '.join(others)}"
            raise InputError(f"{shown_path(path)}: {fault}; write the same, or another --out")

    def _write(self, records: Mapping[str, RunRecord], path: Path) -> None:
        """Through a file beside it that is moved over it when it is whole and on the disk."""
        partial = path.with_name(path.name + PARTIAL)
        try:
            path.parent.mkdir(exist_ok=True)
            with partial.open("wb") as stream:
                pyarrow.parquet.write_table(self._table(records), stream)
                stream.flush()
                os.fsync(stream.fileno())
            os.replace(partial, path)
        except OSError as error:
            with suppress(OSError):
                partial.unlink(missing_ok=True)
            fault = f"cannot be written: {error.strerror or one_line(str(error))}"
            cure = f"{len(self.records)} results are kept there; make room, and the same command goes on from them"
            raise InputError(f"--out {shown_path(self._directory)}: {fault}; {cure}") from error

    def _table(self, records: Mapping[str, RunRecord]) -> pyarrow.Table:
        ordered = sorted(records.items(), key=lambda item: self._place(item[1]))
        rows = [_row(key, record) for key, record in ordered]
        return pyarrow.Table.from_pylist(rows, schema=schema(UNITS, self._metadata))

    def _place(self, record: RunRecord) -> tuple[int, float, Condition, float]:
        return self._order[record.who], record.condition.friction, record.condition, record.distance


def schema(units: Mapping[str, str], metadata: Mapping[bytes, bytes]) -> pyarrow.Schema:
    """Columns by their units: words where there is none, else numbers; with the file's metadata."""
    columns = [
        pyarrow.field(name, pyarrow.float64() if unit else pyarrow.string(), metadata={UNIT: unit.encode()})
        for name, unit in units.items()
    ]
    return pyarrow.schema(columns, metadata=dict(metadata))


def flat(record: RunRecord | Boundary) -> dict[str, Any]:
    """The fields of a dataclass, those of its condition among them."""
    row = {name: value for name, value in vars(record).items() if name != "condition"}
    return vars(record.condition) | row


def _row(key: str, record: RunRecord) -> dict[str, Any]:
    return {"key": key, **flat(record)}


def _record(row: dict[str, Any]) -> RunRecord:
    return RunRecord(condition=Condition(*(row.pop(name) for name in IN_CONDITION)), **row)


def kept(records: Iterable[RunRecord], who: str, condition: Condition) -> list[RunRecord]:
    """Those of one series in one cell, by distance."""
    mine = (each for each in records if (each.who, each.condition) == (who, condition))
    return sorted(mine, key=lambda each: each.distance)
