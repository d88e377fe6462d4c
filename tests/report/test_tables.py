"""Parquet files: every column comes back with its unit, and the scenario with the file."""

from pathlib import Path

import numpy as np
import pyarrow.parquet
import pytest

from swerve.report.tables import read_scenario, write_table
from swerve.scenario.loader import parse
from swerve.simulate import run
from tests.report.runs import FAILING, MOST_SHOWN, made


@pytest.mark.parametrize("name", ["motion", "steps"])
def test_a_table_comes_back(tmp_path: Path, name: str) -> None:
    """Columns come back in order, bit by bit, words as words, each with its unit."""
    done = made(FAILING)
    table = getattr(done.log, name)
    write_table(table, done, tmp_path / "table.parquet")
    read = pyarrow.parquet.read_table(tmp_path / "table.parquet")
    assert read.column_names == list(table.columns)
    for column in read.column_names:
        np.testing.assert_array_equal(read[column].to_numpy(), table[column])
        assert read.field(column).metadata[b"unit"].decode() == table.units[column]


def test_a_file_runs_again_from_itself(tmp_path: Path) -> None:
    """Scenario, controller, plant and seed in the file's metadata make the same run again."""
    done = made(*MOST_SHOWN, seed=3)
    path = tmp_path / "motion.parquet"
    write_table(done.log.motion, done, path)
    metadata = pyarrow.parquet.read_schema(path).metadata
    scenario = parse(read_scenario(path).encode(), path.name)
    assert scenario == done.scenario
    assert metadata[b"swerve.version"].decode() == done.result.version
    controller, plant, seed = (metadata[f"swerve.{key}".encode()].decode() for key in ("controller", "plant", "seed"))
    again = run(scenario, controller, plant, int(seed))
    assert again.result.seed == 3
    np.testing.assert_array_equal(again.log.motion["Y"], done.log.motion["Y"])
