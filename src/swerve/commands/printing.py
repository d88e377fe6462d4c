"""What several commands print alike."""

from collections.abc import Iterable
from pathlib import Path
from typing import TextIO


def print_paths(paths: Iterable[Path], stream: TextIO) -> None:
    """A line for each file that was written."""
    for path in paths:
        print(f"wrote {path}", file=stream)
