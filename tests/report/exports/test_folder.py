"""Reading a run's folder back: all that is in it, or one line that says what is wrong."""

import json
from collections.abc import Callable
from dataclasses import replace
from math import nan
from pathlib import Path

import numpy as np
import pyarrow
import pyarrow.parquet
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from swerve.errors import InputError
from swerve.report.exports.folder import FILES, read_run_folder
from swerve.report.tables import write_table
from swerve.simulate import Log, Outcome, Table
from swerve.simulate.result import Divergence, Range
from tests.report.exports.folders import with_motion, write_folder
from tests.report.runs import FAILING, MOST_SHOWN, made


def test_a_run_comes_back(tmp_path: Path) -> None:
    """Scenario, result and every column with its unit are as they were before the run was written."""
    done = made(*MOST_SHOWN, FAILING, seed=3)
    read = read_run_folder(write_folder(done, tmp_path))
    assert (read.scenario, read.result, read.plans) == (done.scenario, done.result, ())
    for table, original in ((read.log.motion, done.log.motion), (read.log.steps, done.log.steps)):
        assert table.units == original.units
        assert list(table.columns) == list(original.columns)
        for name in original.columns:
            np.testing.assert_array_equal(table[name], original[name])
            assert table[name].dtype.kind == original[name].dtype.kind


def test_a_run_that_diverged_comes_back(tmp_path: Path) -> None:
    """Numbers that JSON has as null are nan again where a number is meant, and None where there is none."""
    lost = replace(
        made().result,
        outcome=Outcome.DIVERGED,
        min_clearance=None,
        max_steer=nan,
        lateral_offset=Range(nan, 1.0, nan),
        divergence=Divergence(0.5, {"vx": 20.0, "vy": nan}),
    )
    read = read_run_folder(write_folder(replace(made(), result=lost), tmp_path)).result
    assert read.to_json() == lost.to_json()
    assert (read.min_clearance, read.outcome) == (None, Outcome.DIVERGED)
    assert np.isnan([read.max_steer, read.lateral_offset.min, read.lateral_offset.final]).all()


def _result(**changes: object) -> Callable[[Path], object]:
    """What changes values of result.json."""

    def change(folder: Path) -> None:
        path = folder / "result.json"
        path.write_text(json.dumps(json.loads(path.read_text()) | changes))

    return change


def _text(name: str, text: str) -> Callable[[Path], object]:
    return lambda folder: (folder / name).write_text(text)


def _motion(**columns: np.ndarray) -> Callable[[Path], object]:
    return lambda folder: write_table(with_motion(made(), **columns).log.motion, made(), folder / "motion.parquet")


def _ways(text: str) -> Callable[[Path], object]:
    steps = made().log.steps
    columns = {**steps.columns, "branches": np.full(len(steps["time"]), text)}
    return lambda folder: write_table(Table(columns, steps.units), made(), folder / "steps.parquet")


def _without(name: str, file: str = "motion.parquet") -> Callable[[Path], object]:
    def change(folder: Path) -> None:
        path = folder / file
        pyarrow.parquet.write_table(pyarrow.parquet.read_table(path).drop_columns([name]), path)

    return change


def _in_feet(folder: Path) -> None:
    motion = made().log.motion
    table = Table(motion.columns, {**motion.units, "X": "ft"})
    write_table(table, made(), folder / "motion.parquet")


def _half(folder: Path) -> None:
    content = (folder / "motion.parquet").read_bytes()
    (folder / "motion.parquet").write_bytes(content[: len(content) // 2])


def _foreign(folder: Path) -> None:
    pyarrow.parquet.write_table(pyarrow.table({"time": [0.0, 1.0]}), folder / "steps.parquet")


def _nested(folder: Path) -> None:
    path = folder / "motion.parquet"
    read = pyarrow.parquet.read_table(path)
    lists = pyarrow.array([[1.0]] * len(read))
    pyarrow.parquet.write_table(read.append_column("lists", lists), path)


DAMAGES = {
    "no result": (
        lambda folder: (folder / "result.json").unlink(),
        "is no run's folder: has no result.json; write a f",
    ),
    "no steps": (lambda folder: (folder / "steps.parquet").unlink(), "is no run's folder: has no steps.parquet; "),
    "no JSON": (_text("result.json", "{"), "result.json: is no run's result; write a folder that"),
    "another JSON": (_text("result.json", "[1]"), "result.json: is no run's result; "),
    "JSON of depth": (_text("result.json", "[" * 50_000), "result.json: is no run's result; "),
    "endless JSON": (_text("result.json", " " * 200_000), "result.json: is no run's result; "),
    "another version": (
        _result(version="7.3.1"),
        r"result.json: was written by swerve 7.3.1, this is \S+; make the run",
    ),
    "no version": (_result(version=None), "result.json: was written by swerve None, this is "),
    "no speed": (_result(speed=None), "result.json: speed: .*; make the run again"),
    "a new outcome": (_result(outcome="flew"), "result.json: outcome: .*; make the run again"),
    "broken scenario": (_text("scenario.toml", "name ="), "scenario.toml: not valid TOML"),
    "another scenario": (
        lambda folder: (folder / "scenario.toml").write_text(made("road.friction=0.3").scenario.to_toml()),
        "motion.parquet: was recorded in another scenario than scenario.toml; ",
    ),
    "another seed": (_result(seed=8), "motion.parquet: has another seed than result.json; "),
    "another controller": (_result(controller="unified"), "motion.parquet: has another controller than result.json; "),
    "no Parquet": (_text("motion.parquet", "time,X\n0,0\n"), "motion.parquet: is no Parquet file that can be read; "),
    "half a Parquet": (_half, "motion.parquet: is no Parquet file that can be read; "),
    "another's Parquet": (_foreign, "steps.parquet: has another version than result.json; "),
    "no X": (_without("X"), r"motion.parquet: column X \[m\] is missing; make the run again"),
    "X in feet": (_in_feet, r"motion.parquet: column X \[m\] is in ft; "),
    "no ways": (_without("branches", "steps.parquet"), r"steps.parquet: column branches \[\] is missing; make the run"),
    "ways that are none": (
        _ways("[1]"),
        "steps.parquet: column branches, row 0: is no list of ways; make the",
    ),
    "ways that are no JSON": (_ways("[{"), "steps.parquet: column branches, row 0: is no list of ways; "),
    "a column of lists": (_nested, "motion.parquet: column lists holds neither numbers nor words; "),
    "time goes back": (_motion(time=made().log.motion["time"][::-1]), "motion.parquet: column time does not ascend"),
    "time is none": (_motion(time=made().log.motion["time"] * nan), "motion.parquet: column time does not ascend"),
    "no row": (
        _motion(**{name: values[:0] for name, values in made().log.motion.columns.items()}),
        "motion.parquet: column time does not ascend",
    ),
}


@pytest.mark.parametrize(("damage", "message"), DAMAGES.values(), ids=list(DAMAGES))
def test_a_folder_that_is_no_run_s_is_refused(tmp_path: Path, damage: Callable[[Path], object], message: str) -> None:
    """A file that is missing, broken, foreign, or of another version or run is named on one line, with the cure."""
    folder = write_folder(made(), tmp_path / "run")
    read_run_folder(folder)
    damage(folder)
    with pytest.raises(InputError, match=message) as caught:
        read_run_folder(folder)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("name", ["absent", "file", "nul\0"])
def test_what_is_no_folder_is_refused(tmp_path: Path, name: str) -> None:
    """A path that leads nowhere, and a file, are no folders of a run."""
    (tmp_path / "file").touch()
    with pytest.raises(InputError, match=r"is no run's folder: there is no such folder; write a folder that `swerve"):
        read_run_folder(tmp_path / name)


def test_the_log_may_have_more_columns(tmp_path: Path) -> None:
    """A column that this reader does not know comes back all the same."""
    steps = made().log.steps
    more = Table({**steps.columns, "reason": np.full(20, "it is")}, {**steps.units, "reason": ""})
    folder = write_folder(replace(made(), log=Log(made().log.motion, more)), tmp_path)
    assert set(read_run_folder(folder).log.steps["reason"]) == {"it is"}


def test_a_folder_s_name_adds_no_column(tmp_path: Path) -> None:
    """A folder that is called as partitions of data sets are is read as any other."""
    folder = write_folder(made(), tmp_path / "speed=20")
    assert list(read_run_folder(folder).log.motion.columns) == list(made().log.motion.columns)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(name=st.sampled_from(FILES), at=st.floats(0, 1), junk=st.binary(max_size=40), is_cut=st.booleans())
def test_no_damage_ends_in_anything_but_a_message(
    tmp_path: Path, name: str, at: float, junk: bytes, is_cut: bool
) -> None:
    """Whatever bytes of a file are replaced, and wherever it is cut: it is read, or refused in one line."""
    folder = write_folder(made(), tmp_path)
    content = (folder / name).read_bytes()
    start = round(at * len(content))
    rest = b"" if is_cut else content[start + len(junk) :]
    (folder / name).write_bytes(content[:start] + junk + rest)
    try:
        assert read_run_folder(folder).scenario == made().scenario or name == "scenario.toml"
    except InputError as error:
        assert "\n" not in str(error)
