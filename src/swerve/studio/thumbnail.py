"""A finished run's small picture, drawn once."""

from functools import lru_cache
from pathlib import Path
from typing import Final

from swerve.report.exports.folder import read_run_folder
from swerve.report.picture import picture

STYLE: Final = (
    ".road{fill:#e9ecf0}.obstacle{fill:#b84a00}.path-1{stroke:#006fae}.lane{stroke:#75808b}@media(prefers-color-scheme:"
    "dark){.road{fill:#20262d}.obstacle{fill:#f0883e}.path-1{stroke:#56b4e9}.lane{stroke:#84909c}}"
)


@lru_cache(maxsize=500)
def thumbnail(directory: Path, changed: float) -> str:
    """The picture of the run in a folder; `changed`, when it was written, is there to keep old ones from being shown.

    Raises:
        InputError: the folder cannot be read.
    """
    del changed
    return picture([read_run_folder(directory)], STYLE)
