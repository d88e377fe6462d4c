"""Files that others made: read as text or refused, and numbers in them that are finite or refused."""

import math
import re
from pathlib import Path
from typing import Final

from swerve.errors import InputError, one_line, shown_path

LARGEST_FILE: Final = 20_000_000  # [byte]
_NUMBER: Final = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d{1,4})?", re.ASCII)
_NOT_TEXT: Final = re.compile(r"[\x00-\x08\x0e-\x1f\x7f]")


def read_lines(path: Path) -> list[str]:
    """The lines of a text file, in UTF-8 or, where it is not that, Latin-1.

    Raises:
        InputError: it cannot be read, is too large, empty, or no text.
    """
    file = shown_path(path)
    try:
        with path.open("rb") as stream:
            content = stream.read(LARGEST_FILE + 1)
    except (OSError, ValueError) as error:  # ValueError: a path that no file system can hold
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(f"{file}: cannot be read: {reason}; write the path of a .csv or .tir file") from error
    if len(content) > LARGEST_FILE:
        raise InputError(f"{file}: larger than {LARGEST_FILE} bytes; write fewer points")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("latin-1")
    if not text.strip():
        raise InputError(f"{file}: empty; write tyre data in it")
    lines = re.split(r"\r\n|\r|\n", text)
    for number, line in enumerate(lines, start=1):
        if _NOT_TEXT.search(line):
            raise InputError(f"{file}: line {number}: no text but binary data; save it as UTF-8 text")
    return lines


def finite_number(text: str) -> float:
    """The number that `text` writes, with a point for decimals.

    Raises:
        ValueError: it is none, or not finite; the text says which.
    """
    word = text.strip()
    if not _NUMBER.fullmatch(word):
        try:
            is_number = not math.isfinite(float(word))
        except ValueError:
            is_number = False
        raise ValueError(f"'{one_line(word, 40)}' is {'not finite' if is_number else 'no number'}")
    value = float(word)
    if not math.isfinite(value):
        raise ValueError(f"'{one_line(word, 40)}' is not finite")
    return value
