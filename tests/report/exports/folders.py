"""Folders of runs, without the figures that take longest to make."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from swerve.report import result_json
from swerve.report.tables import write_table
from swerve.simulate import Log, Run, Table
from tests.report.runs import made


def write_folder(run: Run, directory: Path) -> Path:
    """The files of a run that are read back; the directory."""
    directory.mkdir(parents=True, exist_ok=True)
    (directory / "result.json").write_text(result_json(run.result) + "\n")
    (directory / "scenario.toml").write_text(run.scenario.to_toml())
    write_table(run.log.motion, run, directory / "motion.parquet")
    write_table(run.log.steps, run, directory / "steps.parquet")
    return directory


def with_motion(run: Run, **columns: np.ndarray) -> Run:
    """A run with other columns in its motion."""
    motion = run.log.motion
    return replace(run, log=Log(Table({**motion.columns, **columns}, motion.units), run.log.steps))


def diverged() -> Run:
    """A run whose last samples are no numbers, after some that are beyond all bounds."""
    done = made()
    columns = {}
    for name in ("vx", "vy", "r", "psi", "X", "Y", "delta"):
        columns[name] = done.log.motion[name].copy()
        columns[name][-40:-20] = 1e200
        columns[name][-20:] = np.nan
    return with_motion(done, **columns)
