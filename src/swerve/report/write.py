"""The files of a run, and those of a reproduction of the paper.

What draws, what fits tyres and what writes Parquet is imported where it is used: it takes longer to import than a run
takes, and most runs write nothing.
"""

import json
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from swerve.report import ablation
from swerve.report.output import filled
from swerve.report.terminal import result_json
from swerve.simulate import Run

if TYPE_CHECKING:  # it brings what fits tyres
    from swerve.study.reproduce import Reproduction

Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1
Write = Callable[[Path], None]  # writes the file of this path


def write_run(run: Run, directory: Path, progress: Progress = lambda share: None) -> list[Path]:
    """Write a run: result.json, scenario.toml, its log as Parquet, its figures as PNG and PDF, report.html.

    Args:
        run: that is over.
        directory: is made where it does not exist; files of an earlier run in it are replaced.
        progress: called with the share that is done [1].

    Returns:
        The files.

    Raises:
        OSError: they cannot be written; then the directory is as it was.
    """
    from swerve.report.figures import FIGURES, writers

    return write_all({**record(run), **writers(FIGURES, run)}, directory, progress)


def write_record(run: Run, directory: Path) -> list[Path]:
    """Write a run as `write_run` does, without its figures, which take longer than all else."""
    return write_all(record(run), directory, lambda share: None)


def record(run: Run) -> dict[str, Write]:
    """All that a run's folder needs for being read back, and its report."""
    from swerve.report.page import write_page
    from swerve.report.tables import write_table

    return {
        "result.json": partial(write_text, result_json(run.result) + "\n"),
        "scenario.toml": partial(write_text, run.scenario.to_toml()),
        "motion.parquet": lambda path: write_table(run.log.motion, run, path),
        "steps.parquet": lambda path: write_table(run.log.steps, run, path),
        "report.html": partial(write_page, run),
    }


def write_reproduction(
    reproduction: "Reproduction", directory: Path, progress: Progress = lambda share: None
) -> list[Path]:
    """Write a reproduction: Fig. 3 to 5 and 7 to 10 of the paper as PNG and PDF, Table 1 and the ablation as text.

    A table is Markdown, CSV and JSON.

    Args:
        reproduction: of the paper.
        directory: as for `write_run`.
        progress: as for `write_run`.

    Returns:
        The files.

    Raises:
        OSError: as for `write_run`.
    """
    from swerve.report import table1
    from swerve.report.figures import FORCE_FIGURES, PAPER_FIGURES, TYRE_FIGURES, writers

    rows, tyre = reproduction.ablation, reproduction.tyre
    files: dict[str, Write] = {
        "table1.md": partial(write_text, table1.as_markdown(tyre)),
        "table1.csv": partial(write_text, table1.as_csv(tyre)),
        "table1.json": partial(write_text, table1.as_json(tyre)),
        "ablation.md": partial(write_text, ablation.as_markdown(rows)),
        "ablation.csv": partial(write_text, ablation.as_csv(rows)),
        "ablation.json": partial(write_text, ablation.as_json(rows)),
        **writers(TYRE_FIGURES, tyre),
        "fig05_lateral_forces.json": partial(write_text, json.dumps(reproduction.forces.to_json(), indent=2) + "\n"),
        **writers(FORCE_FIGURES, reproduction.forces),
        **writers(PAPER_FIGURES, reproduction.paper),
    }
    return write_all(files, directory, progress)


def write_all(files: Mapping[str, Write], directory: Path, progress: Progress) -> list[Path]:
    """Write every file by its name, which may have a folder before it, and none where one of them fails."""
    with filled(directory) as place:
        for i, (name, write) in enumerate(files.items(), start=1):
            (place / name).parent.mkdir(exist_ok=True)
            write(place / name)
            progress(i / len(files))
    return [directory / name for name in files]


def write_text(text: str, path: Path) -> None:
    """Write UTF-8 with the same line ends on every system."""
    path.write_text(text, encoding="utf-8", newline="\n")
