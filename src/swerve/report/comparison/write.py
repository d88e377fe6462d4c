"""The folder of a comparison.

comparison.json, .parquet, .md      the whole table
SCENARIO.png, .pdf                  the paths from above, and the measures
report.html                         the cars of the scenario together; of several scenarios the whole table, with
SCENARIO.html                       a page for each
SCENARIO-CONTROLLER/                each run as `swerve run --out` writes it, without its figures
"""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from swerve.report.comparison.files import as_markdown, write_parquet
from swerve.report.comparison.names import file_names, folder_name
from swerve.report.comparison.overview import write_overview
from swerve.report.comparison.table import comparison_json
from swerve.report.page import write_comparison as write_page
from swerve.report.write import Write, record, write_all, write_text
from swerve.study.comparison import Comparison, Group

Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1


def write_comparison(comparison: Comparison, directory: Path, progress: Progress = lambda share: None) -> list[Path]:
    """Write a comparison with all its runs.

    Args:
        comparison: that is over.
        directory: is made where it does not exist; files of an earlier comparison in it are replaced.
        progress: called with the share that is done [1].

    Returns:
        The files, and the folders of the runs.

    Raises:
        OSError: they cannot be written; then the directory is as it was.
    """
    names = file_names([group.scenario.name for group in comparison.groups])
    files: dict[str, Write] = {
        "comparison.json": partial(write_text, comparison_json(comparison) + "\n"),
        "comparison.parquet": partial(write_parquet, comparison),
        "comparison.md": partial(write_text, as_markdown(comparison)),
    }
    is_single = len(names) == 1 and bool(comparison.groups[0].runs)
    if not is_single:
        files["report.html"] = partial(write_overview, comparison, names)
    for group, name in zip(comparison.groups, names, strict=True):
        files |= _of_group(group, name, "report" if is_single else name)
    written = write_all(files, directory, progress)
    return list(dict.fromkeys(path if path.parent == directory else path.parent for path in written))


def _of_group(group: Group, name: str, page: str) -> dict[str, Write]:
    """Figure, page and folders of a scenario that was run."""
    from swerve.report.figures import writers
    from swerve.report.figures.comparison import comparison

    runs = {entry.controller: entry.run for entry in group.entries if entry.run is not None}
    if not runs:
        return {}
    refusals = [f"{entry.controller} refused: {entry.refusal}" for entry in group.entries if entry.run is None]
    files: dict[str, Write] = {f"{page}.html": lambda path: write_page([*runs.values()], path, refusals)}
    files |= writers({name: comparison}, group)
    for controller, run in runs.items():
        files |= {f"{folder_name(name, controller)}/{each}": write for each, write in record(run).items()}
    return files
