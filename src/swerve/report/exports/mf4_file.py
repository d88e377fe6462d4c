"""The log as ASAM MDF 4: a group of channels for each table, each with its unit, on the table's time as master.

A channel has the name of its column. Where both tables have one of a name, that of the controller's step is what was
asked for, and says so: `delta` acts, `delta_command` was commanded.
"""

from datetime import UTC, datetime
from pathlib import Path
from typing import Final

import numpy as np
from asammdf import MDF, Signal

from swerve.report.figures.style import caption
from swerve.simulate import Run, Table

VERSION: Final = "4.10"
COMPRESSED: Final = 2  # asammdf's number for: transposed, then deflated
START: Final = datetime.fromtimestamp(0.0, UTC)  # a simulation has no date: the same run gives the same file


def write_mf4(run: Run, path: Path) -> None:
    """Write a run's log to an .mf4 file; OSError as the file system says."""
    motion, steps = run.log.motion, run.log.steps
    with MDF(version=VERSION) as file:
        file.start_time = START
        file.header.comment = caption(run)
        _append(file, "motion", motion, {})
        _append(file, "steps", steps, {name: f"{name}_command" for name in steps.columns if name in motion.columns})
        file.save(path, overwrite=True, compression=COMPRESSED)


def _append(file: MDF, name: str, table: Table, renamed: dict[str, str]) -> None:
    """Append a table as a group of channels."""
    time = table["time"]
    signals = [
        Signal(
            _samples(table[column]), time, unit=table.units[column], name=renamed.get(column, column), encoding="utf-8"
        )
        for column in table.columns
        if column != "time"
    ]
    file.append(signals, acq_name=name, comment=name, common_timebase=True)


def _samples(values: np.ndarray) -> np.ndarray:
    """Values (n,) as MDF holds them: words as bytes."""
    return np.char.encode(values, "utf-8") if values.dtype.kind == "U" else values
