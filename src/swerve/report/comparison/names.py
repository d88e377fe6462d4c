"""Names of files that come from names of scenarios."""

import re
from collections.abc import Sequence
from typing import Final

LONGEST: Final = 60  # characters of a scenario's name in that of a file
TAKEN: Final = "report"  # the name of the page with the whole table


def file_names(names: Sequence[str]) -> list[str]:
    """A name for the files of each scenario: letters, digits, dots, dashes; no two alike, whatever the case."""
    found: list[str] = []
    for name in names:
        safe = re.sub(r"[^A-Za-z0-9._-]+", "_", name[:LONGEST]).lstrip(".") or "_"
        found.append(_distinct(safe, {TAKEN, *map(str.lower, found)}))
    return found


def _distinct(name: str, taken: set[str]) -> str:
    number, candidate = 1, name
    while candidate.lower() in taken:
        number += 1
        candidate = f"{name}-{number}"
    return candidate


def folder_name(name: str, controller: str) -> str:
    """Of the run of a controller in the scenario whose files have this name."""
    return f"{name}-{controller}"
