"""CSV files, read back by Python's own reader."""

import csv
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from swerve.report.exports import formats_named, write_exports
from swerve.report.exports.csv_file import write_csv
from swerve.simulate import Table
from tests.report.runs import FAILING, made


def _read(path: Path) -> tuple[list[str], list[list[str]]]:
    with path.open(newline="", encoding="utf-8") as stream:
        head, *rows = csv.reader(stream)
    return head, rows


@pytest.mark.parametrize("name", ["motion", "steps"])
def test_the_log_comes_back_from_csv(tmp_path: Path, name: str) -> None:
    """Each column has its name and unit above it, and every number comes back bit by bit; nan is an empty field."""
    done = made(FAILING)
    paths = write_exports(done, formats_named("csv", "--to"), tmp_path)
    assert [path.name for path in paths] == ["motion.csv", "steps.csv"]
    table = getattr(done.log, name)
    head, rows = _read(tmp_path / f"{name}.csv")
    assert head == [f"{column} [{unit}]" if unit else column for column, unit in table.units.items()]
    for column, fields in zip(table.columns, zip(*rows, strict=True), strict=True):
        values = table[column]
        read = fields if values.dtype.kind == "U" else [float(field) if field else np.nan for field in fields]
        np.testing.assert_array_equal(read, values)


def test_there_are_empty_fields_and_words() -> None:
    """The run of the test above has what it says: steps with a friction use that is nan, and words."""
    steps = made(FAILING).log.steps
    assert np.isnan(steps["friction_use_fl"]).any()
    assert any(steps["fallback"])


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(st.floats(allow_nan=False), min_size=1), st.text(st.characters(codec="utf-8"), max_size=20))
def test_any_number_and_any_word_comes_back(tmp_path: Path, numbers: list[float], word: str) -> None:
    """The smallest, the largest and infinite numbers, and words with commas, quotes and breaks, are as they were."""
    word = word.replace("\r", "").replace("\0", "")
    table = Table({"x": np.array(numbers), "word": np.full(len(numbers), word)}, {"x": "m", "word": ""})
    write_csv(table, tmp_path / "table.csv")
    head, rows = _read(tmp_path / "table.csv")
    assert head == ["x [m]", "word"]
    assert [float(row[0]) for row in rows] == numbers
    assert {row[1] for row in rows} == {str(table["word"][0])}
