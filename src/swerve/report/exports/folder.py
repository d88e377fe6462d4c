"""The folder of a finished run, read back: every file of it checked before anything is made of it."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final, get_type_hints

import numpy as np
import pyarrow
import pyarrow.parquet
from pydantic import TypeAdapter, ValidationError

from swerve import __version__
from swerve.conventions import STATE_UNITS, STATES, WHEELS
from swerve.errors import InputError, one_line, shown_path
from swerve.report.tables import CONTROLLER, PLANT, SCENARIO, SEED, UNIT, VERSION
from swerve.report.tried import TRIED
from swerve.scenario import Scenario, load, parse
from swerve.simulate import Log, Run, Table
from swerve.simulate.result import Result

FILES: Final = ("result.json", "scenario.toml", "motion.parquet", "steps.parquet")
CURE: Final = "write a folder that `swerve run --out` filled"
AGAIN: Final = "make the run again"
LARGEST_RESULT: Final = 100_000  # [byte]
WORDS: Final = ("branch", "reason", "branches", "active", "fallback")  # columns of the decision
USES: Final = {f"friction_use_{wheel}": "1" for wheel in WHEELS}
NEEDED: Final = {  # columns, each with its unit, without which nothing can be shown
    "motion.parquet": {"time": "s", **dict(zip(STATES, STATE_UNITS, strict=True)), "delta": "rad"},
    "steps.parquet": {"time": "s", "delta": "rad", "step_time": "s", **dict.fromkeys(WORDS, ""), **USES},
}


def read_run_folder(directory: Path) -> Run:
    """The run in a folder that `write_run` filled.

    Args:
        directory: with result.json, scenario.toml, motion.parquet and steps.parquet.

    Returns:
        The run, without its plans: a folder does not hold them.

    Raises:
        InputError: a file is missing, broken, another version's, or not of the same run as the others.
    """
    missing = [name for name in FILES if not (directory / name).is_file()]
    if missing:
        fault = f"has no {missing[0]}" if directory.is_dir() else "there is no such folder"
        raise InputError(f"{shown_path(directory)}: is no run's folder: {fault}; {CURE}")
    result = read_result(directory / "result.json")
    scenario = load(directory / "scenario.toml")
    motion, steps = (_table(directory / name, result, scenario) for name in FILES[2:])
    _check_branches(directory / "steps.parquet", steps)
    return Run(scenario, Log(motion, steps), (), result)


def read_result(path: Path) -> Result:
    """The result in its JSON file; a number that is null there is nan again where its type has no None.

    Raises:
        InputError: it cannot be read, is broken, or another version's.
    """
    try:
        with path.open("rb") as stream:
            values = json.loads(stream.read(LARGEST_RESULT))
        version = values["version"]
    except OSError as error:
        raise InputError(f"{shown_path(path)}: cannot be read: {error.strerror}; {CURE}") from error
    except (ValueError, RecursionError, LookupError, TypeError) as error:
        raise InputError(f"{shown_path(path)}: is no run's result; {CURE}") from error
    if _release(version) != _release(__version__):
        fault = f"was written by swerve {one_line(str(version), 20)}, this is {__version__}"
        raise InputError(f"{shown_path(path)}: {fault}; {AGAIN} with this version, from the folder's scenario.toml")
    numbers = {name for name, kind in get_type_hints(Result).items() if kind is float}
    known = {key: _with_nan(each) if key in numbers or isinstance(each, dict) else each for key, each in values.items()}
    try:
        return TypeAdapter(Result).validate_python(known)
    except ValidationError as error:
        key = ".".join(map(str, error.errors()[0]["loc"]))
        raise InputError(f"{shown_path(path)}: {key}: {error.errors()[0]['msg']}; {AGAIN}") from error


def _release(version: object) -> list[str]:
    """Major and minor number, within which files stay as they are."""
    return str(version).split(".")[:2]


def _with_nan(value: Any) -> Any:
    """A value with nan for every None in it."""
    if isinstance(value, dict):
        return {key: _with_nan(each) for key, each in value.items()}
    return np.nan if value is None else value


def _table(path: Path, result: Result, scenario: Scenario) -> Table:
    try:
        read = pyarrow.parquet.ParquetFile(path).read()  # `read_table` takes columns from folders' names too
        read.validate(full=True)
    except (OSError, pyarrow.ArrowException) as error:
        raise InputError(f"{shown_path(path)}: is no Parquet file that can be read; {CURE}") from error
    _check_run(path, read.schema.metadata or {}, result, scenario)
    units = {field.name: (field.metadata or {}).get(UNIT, b"?").decode("utf-8", "replace") for field in read.schema}
    for name, unit in NEEDED[path.name].items():
        if units.get(name) != unit:
            found = f"is in {one_line(units[name], 20)}" if name in units else "is missing"
            raise InputError(f"{shown_path(path)}: column {name} [{unit}] {found}; {AGAIN}")
    table = Table({name: _column(path, name, read[name]) for name in read.column_names}, units)
    time = table["time"]
    if len(time) == 0 or not np.isfinite(time).all() or (np.diff(time) <= 0).any():
        raise InputError(f"{shown_path(path)}: column time does not ascend from row to row; {AGAIN}")
    return table


def _check_run(path: Path, metadata: Mapping[bytes, bytes], result: Result, scenario: Scenario) -> None:
    """Whether a table was recorded in the run whose result and scenario stand beside it."""
    stated = {
        VERSION: result.version,
        CONTROLLER: result.controller,
        PLANT: result.plant,
        SEED: str(result.seed),
    }
    for key, value in stated.items():
        if metadata.get(key) != value.encode():
            what = key.decode().removeprefix("swerve.")
            raise InputError(f"{shown_path(path)}: has another {what} than result.json; {CURE}")
    if parse(metadata.get(SCENARIO, b""), shown_path(path)) != scenario:
        raise InputError(f"{shown_path(path)}: was recorded in another scenario than scenario.toml; {CURE}")


def _check_branches(path: Path, steps: Table) -> None:
    """Whether the ways that were tried in each step can be read."""
    for k, text in enumerate(steps["branches"].tolist()):
        try:
            TRIED.validate_json(str(text))
        except ValidationError as error:
            raise InputError(f"{shown_path(path)}: column branches, row {k}: is no list of ways; {AGAIN}") from error


def _column(path: Path, name: str, values: "pyarrow.ChunkedArray") -> np.ndarray[Any, np.dtype[np.generic]]:
    """The values (n,) of a column: words, or numbers of the kind that they were written as."""
    if pyarrow.types.is_string(values.type):
        return np.array(values.to_pylist(), dtype=str)
    if not (pyarrow.types.is_floating(values.type) or pyarrow.types.is_integer(values.type)):
        fault = f"column {one_line(name)} holds neither numbers nor words"
        raise InputError(f"{shown_path(path)}: {fault}; {AGAIN}")
    return np.asarray(values.to_numpy())
