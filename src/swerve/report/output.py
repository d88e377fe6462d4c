"""Output directories: found fit before anything is run, and filled without a half-written file ever showing."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

from swerve.errors import InputError, shown_path

PARTIAL: Final = ".swerve-partial-"  # begins the name of the directory in which files are made


def prepare_output(directory: Path) -> None:
    """See to it that files can be written to `directory`: do it, and undo it.

    Raises:
        InputError: they cannot, or it is a file.
    """
    try:
        made = _make(directory)
        try:
            with TemporaryDirectory(prefix=PARTIAL, dir=directory):
                pass
        finally:
            _unmake(made)
    except (OSError, ValueError) as error:  # ValueError: a path that no file system can hold
        reason = getattr(error, "strerror", None) or str(error)
        cure = "write the path of a new or existing directory that you can write to"
        raise InputError(f"--out {shown_path(directory)}: cannot be written: {reason}; {cure}") from error


@contextmanager
def filled(directory: Path) -> Iterator[Path]:
    """A place to make files and folders in: each file is moved to `directory` at the end, over one of the same name.

    Where making them fails, `directory` stays as it was: with its earlier files, or absent.

    Raises:
        OSError: what the file system says.
    """
    made = _make(directory)
    try:
        with TemporaryDirectory(prefix=PARTIAL, dir=directory) as partial:  # inside: the same file system for certain
            yield Path(partial)
            for path in sorted(each for each in Path(partial).rglob("*") if each.is_file()):
                target = directory / path.relative_to(partial)
                made[:0] = _make(target.parent)
                os.replace(path, target)
    except BaseException:
        _unmake(made)
        raise


def _make(directory: Path) -> list[Path]:
    """Make a directory and its parents; the new ones, innermost first."""
    made: list[Path] = []
    try:
        for each in [*reversed(directory.parents), directory]:
            if not each.is_dir():
                each.mkdir()
                made.insert(0, each)
    except BaseException:
        _unmake(made)
        raise
    return made


def _unmake(made: list[Path]) -> None:
    """Remove directories, as far as they are empty."""
    for each in made:
        try:
            each.rmdir()
        except OSError:  # somebody else's file is in it by now
            return
