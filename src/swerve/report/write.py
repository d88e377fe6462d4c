"""The files of a run, and those of a reproduction of the paper.

What draws and what writes Parquet is imported where it is used: it takes longer to import than a run takes, and most
runs write nothing.
"""

from pathlib import Path

from swerve.report.ablation import as_csv, as_json, as_markdown
from swerve.report.output import filled
from swerve.report.terminal import result_json
from swerve.simulate import Run
from swerve.study.reproduce import Reproduction


def write_run(run: Run, directory: Path) -> list[Path]:
    """Write a run: result.json, scenario.toml, its log as Parquet, its figures as PNG and PDF.

    Args:
        run: that is over.
        directory: is made where it does not exist; files of an earlier run in it are replaced.

    Returns:
        The files.

    Raises:
        OSError: they cannot be written; then the directory is as it was.
    """
    from swerve.report.figures import FIGURES, save
    from swerve.report.tables import write_table

    with filled(directory) as partial:
        (partial / "result.json").write_text(result_json(run.result) + "\n", encoding="utf-8")
        (partial / "scenario.toml").write_text(run.scenario.to_toml(), encoding="utf-8")
        write_table(run.log.motion, run, partial / "motion.parquet")
        write_table(run.log.steps, run, partial / "steps.parquet")
        for name, draw in FIGURES.items():
            save(draw(run), partial, name)
        names = sorted(path.name for path in partial.iterdir())
    return [directory / name for name in names]


def write_reproduction(reproduction: Reproduction, directory: Path) -> list[Path]:
    """Write a reproduction: Fig. 7 to 10 of the paper as PNG and PDF, the ablation as Markdown, CSV and JSON.

    Args:
        reproduction: of the paper.
        directory: as for `write_run`.

    Returns:
        The files.

    Raises:
        OSError: as for `write_run`.
    """
    from swerve.report.figures import PAPER_FIGURES, save

    with filled(directory) as partial:
        for name, draw in PAPER_FIGURES.items():
            save(draw(reproduction.paper), partial, name)
        for suffix, text in (("md", as_markdown), ("csv", as_csv), ("json", as_json)):
            (partial / f"ablation.{suffix}").write_text(text(reproduction.ablation), encoding="utf-8", newline="\n")
        names = sorted(path.name for path in partial.iterdir())
    return [directory / name for name in names]
