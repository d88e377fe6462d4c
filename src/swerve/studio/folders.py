"""The folders in a folder that hold runs, maps or comparisons, with their pages, and nothing outside of it.

A name that was asked for is looked up here, and never part of a path.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Final

REPORT: Final = "report.html"  # of a run, or of a comparison
TABLE: Final = "comparison.json"
MAP: Final = "map.html"


def folders(directory: Path, needed: tuple[str, ...]) -> dict[str, Path]:
    """A folder itself and those directly in it, as far as they have the files; links that lead out are none of it."""
    root = directory.resolve()
    inside = [each for each in sorted(root.iterdir()) if each.is_dir() and each.resolve() == each]
    return {each.name: each for each in [root, *inside] if all(_is_file(each / name) for name in needed)}


def maps(directory: Path) -> dict[str, Path]:
    """The folders that `swerve map --out` has filled, by name."""
    return folders(directory, (MAP,))


def comparisons(directory: Path) -> dict[str, Path]:
    """The folders that `swerve compare --out` has filled, by name."""
    return folders(directory, (TABLE, REPORT))


def pages(directory: Path) -> dict[str, Path]:
    """The pages directly in a folder by their names; none where there is no such folder, or it is a link."""
    inside = directory.iterdir() if directory.is_dir() and not directory.is_symlink() else ()
    return {each.name: each for each in inside if each.suffix == ".html" and _is_file(each)}


def latest_first(known: Mapping[str, Path], file: str) -> list[tuple[Path, float]]:
    """Each folder, and when its file was written, in seconds since 1970."""
    found = [(path, (path / file).stat().st_mtime) for path in known.values()]
    return sorted(found, key=lambda each: each[1], reverse=True)


def _is_file(path: Path) -> bool:
    return path.is_file() and not path.is_symlink()
