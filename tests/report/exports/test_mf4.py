"""MF4 files, read back by asammdf."""

from pathlib import Path

import numpy as np
import pytest
from asammdf import MDF

from swerve.report.exports.mf4_file import write_mf4
from swerve.simulate import Run
from tests.report.exports.folders import diverged
from tests.report.runs import FAILING, made


@pytest.mark.parametrize(
    "done", [made(controller="unified"), made(FAILING), diverged()], ids=["fine", "failing", "lost"]
)
def test_the_log_comes_back_from_mf4(tmp_path: Path, done: Run) -> None:
    """Every column is a channel with its unit, bit by bit, on the table's time; words are words."""
    write_mf4(done, tmp_path / "run.mf4")
    with MDF(tmp_path / "run.mf4") as file:
        for group, table in enumerate((done.log.motion, done.log.steps)):
            channels = [channel.name for channel in file.groups[group].channels]
            assert len(channels) == len(table.columns)
            for name, column in zip(channels, table.columns, strict=True):
                signal = file.get(name, group=group)
                values = np.char.decode(signal.samples, "utf-8") if signal.samples.dtype.kind == "S" else signal.samples
                np.testing.assert_array_equal(values, table[column])
                np.testing.assert_array_equal(signal.timestamps, table["time"])
                assert signal.unit == table.units[column]


def test_a_channel_is_found_by_its_name(tmp_path: Path) -> None:
    """No two channels but the times have the same name: what was commanded is told from what acts."""
    done = made(controller="unified")
    write_mf4(done, tmp_path / "run.mf4")
    with MDF(tmp_path / "run.mf4") as file:
        names = [channel.name for group in file.groups for channel in group.channels if channel.name != "time"]
        assert len(names) == len(set(names))
        np.testing.assert_array_equal(file.get("delta").samples, done.log.motion["delta"])
        np.testing.assert_array_equal(file.get("Fx_rr_command").samples, done.log.steps["Fx_rr"])
        assert [group.channel_group.acq_name for group in file.groups] == ["motion", "steps"]
        assert "paper: unified on planar, seed 0" in file.header.comment
