"""Runs of a map drawn together: for each condition a page with all controllers at one distance.

They lie in a folder beside the map's page, which links to them.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final

from swerve.report.output import filled
from swerve.report.page import write_comparison
from swerve.simulate import Run
from swerve.study.map.boundary import Condition

FOLDER: Final = "replays"


def replay_name(condition: Condition) -> str:
    """The file of a condition's page."""
    return f"speed-{condition.speed:g}-friction-{condition.friction:g}-offset-{condition.offset:g}.html"


def write_replays(runs: Mapping[Condition, Sequence[Run]], directory: Path) -> list[Path]:
    """Write a comparison for each condition.

    Args:
        runs: of each condition, in one scene; those without any are left out.
        directory: of the map's page; the comparisons come into its folder `replays`.

    Returns:
        The files.

    Raises:
        ValueError: the scenes of one condition's runs differ.
        OSError: as the file system says; then the folder is as it was.
    """
    pages = {replay_name(condition): each for condition, each in runs.items() if each}
    with filled(directory / FOLDER) as place:
        for name, each in pages.items():
            write_comparison(each, place / name)
    return [directory / FOLDER / name for name in pages]
