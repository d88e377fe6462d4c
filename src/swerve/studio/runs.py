"""The finished runs of a folder, and nothing outside of it."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from swerve.errors import InputError, SwerveError, shown_path
from swerve.report.exports.folder import read_result

REPORT: Final = "report.html"
NEEDED: Final = ("result.json", REPORT)
SHOWN: Final = ("scenario", "controller", "plant", "seed", "outcome", "decision", "min_clearance", "impact_speed")
MADE_HERE: Final = re.compile(r"studio-(\d{1,6})")
MOST_MADE_HERE: Final = 500  # runs of the studio in one folder


@dataclass(frozen=True)
class Runs:
    """A folder with a run's folder in each of its own, or that of a single run.

    Attributes:
        directory: where they are.
    """

    directory: Path

    def names(self) -> dict[str, Path]:
        """Each run's folder by its name; links that lead out are no runs of this folder."""
        root = self.directory.resolve()
        inside = [each for each in sorted(root.iterdir()) if each.is_dir() and each.resolve() == each]
        return {each.name: each for each in [root, *inside] if _is_run(each)}

    def path(self, name: str) -> Path | None:
        """A run's folder; None where there is no run of this name. A name is looked up, and never part of a path."""
        return self.names().get(name)

    def listed(self) -> list[dict[str, Any]]:
        """What the list shows of each run, the latest first; of one that cannot be read, why."""
        paths = sorted(self.names().values(), key=_finished_at, reverse=True)
        return [{"name": path.name, "finished": _finished_at(path), **_summary(path)} for path in paths]

    def new(self) -> Path:
        """The folder for the next run of the studio; InputError where there are too many."""
        numbers = [int(found[1]) for each in self.directory.iterdir() if (found := MADE_HERE.fullmatch(each.name))]
        if len(numbers) >= MOST_MADE_HERE:
            fault = f"has {len(numbers)} runs of the studio"
            raise InputError(f"{shown_path(self.directory)}: {fault}; remove some of them, or view another folder")
        return self.directory / f"studio-{max(numbers, default=0) + 1:04d}"


def _is_run(path: Path) -> bool:
    return all((path / name).is_file() and not (path / name).is_symlink() for name in NEEDED)


def _finished_at(path: Path) -> float:
    """In seconds since 1970."""
    return (path / REPORT).stat().st_mtime


def _summary(path: Path) -> dict[str, Any]:
    try:
        result = read_result(path / "result.json").to_json()
    except SwerveError as error:
        return {**dict.fromkeys(SHOWN), "fault": str(error)}
    return {**{key: result[key] for key in SHOWN}, "fault": None}
