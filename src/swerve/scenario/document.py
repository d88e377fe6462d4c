"""TOML documents that a user wrote: read, or refused in one line that says why."""

import tomllib
from pathlib import Path
from typing import Any, Final

from swerve.errors import InputError, one_line, shown_path

LARGEST_FILE: Final = 1_000_000  # [byte]


def read_document(path: Path, kind: str, cure: str) -> bytes:
    """The bytes of a document.

    Args:
        path: of its file.
        kind: what it is to be, such as "scenario".
        cure: what to write where it cannot be read.

    Raises:
        InputError: it cannot be read, or is too large.
    """
    try:
        with path.open("rb") as stream:
            content = stream.read(LARGEST_FILE + 1)
    except (OSError, ValueError) as error:  # ValueError: a path that no file system can hold
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(f"{shown_path(path)}: cannot be read: {reason}; {cure}") from error
    if len(content) > LARGEST_FILE:
        raise InputError(f"{shown_path(path)}: no {kind} file: larger than {LARGEST_FILE} bytes")
    return content


def tables_of(content: bytes, file: str, contents: str) -> dict[str, Any]:
    """The tables of a document; `file` is what messages call it, `contents` says what it has at least.

    Raises:
        InputError: it is not UTF-8, not TOML, or empty.
    """
    try:
        tables = tomllib.loads(content.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        raise InputError(f"{file}: not UTF-8 text, at byte {error.start}; save it as UTF-8") from error
    except RecursionError as error:
        raise InputError(f"{file}: not valid TOML: nested too deep") from error
    except ValueError as error:  # TOMLDecodeError, with line and column; or a whole number of thousands of digits
        raise InputError(f"{file}: not valid TOML: {one_line(str(error), 120)}") from error
    if not tables:
        raise InputError(f"{file}: empty; {contents}")
    return tables
