"""The finished runs of a folder, and nothing outside of it."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from swerve.errors import InputError, SwerveError, shown_path
from swerve.report.exports.folder import read_result
from swerve.studio.folders import REPORT, folders, latest_first

RESULT: Final = "result.json"
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
        """Each run's folder by its name."""
        return folders(self.directory, (RESULT, REPORT))

    def listed(self) -> list[dict[str, Any]]:
        """What the list shows of each run, the latest first; of one that cannot be read, why."""
        found = latest_first(self.names(), REPORT)
        return [{"name": path.name, "finished": finished, **_summary(path)} for path, finished in found]

    def new(self) -> Path:
        """The folder for the next run of the studio; InputError where there are too many."""
        numbers = [int(found[1]) for each in self.directory.iterdir() if (found := MADE_HERE.fullmatch(each.name))]
        if len(numbers) >= MOST_MADE_HERE:
            fault = f"has {len(numbers)} runs of the studio"
            raise InputError(f"{shown_path(self.directory)}: {fault}; remove some of them, or view another folder")
        return self.directory / f"studio-{max(numbers, default=0) + 1:04d}"


def _summary(path: Path) -> dict[str, Any]:
    try:
        result = read_result(path / RESULT).to_json()
    except SwerveError as error:
        return {**dict.fromkeys(SHOWN), "fault": str(error)}
    return {**{key: result[key] for key in SHOWN}, "fault": None}
