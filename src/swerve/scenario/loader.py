"""From a library name or a TOML file, and the overrides on it, to a checked scenario."""

import tomllib
from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path
from typing import Any, Final

from pydantic import ValidationError

from swerve.errors import InputError, nearest, one_line
from swerve.scenario.overrides import apply, parse_override
from swerve.scenario.problems import input_error
from swerve.scenario.scenario import Scenario

LIBRARY: Final = files("swerve.scenario") / "library"
LARGEST_FILE: Final = 1_000_000  # [byte]


def library_names() -> list[str]:
    """The names of the scenarios that come with swerve, in alphabetical order."""
    return sorted(entry.name.removesuffix(".toml") for entry in LIBRARY.iterdir() if entry.name.endswith(".toml"))


def load(name_or_path: str | Path, overrides: Sequence[str] = ()) -> Scenario:
    """The scenario of a library name, or of a TOML file.

    Args:
        name_or_path: a path is one that ends in .toml or holds a separator; anything else is a name.
        overrides: each KEY=VALUE, applied in order.

    Returns:
        The scenario, checked.

    Raises:
        InputError: there is no such scenario, it cannot be read, or something in it is wrong.
    """
    given = str(name_or_path)
    if isinstance(name_or_path, Path) or given.endswith(".toml") or given != Path(given).name:
        return parse(_read(Path(given)), one_line(given), overrides)
    names = library_names()
    if given not in names:
        guess = nearest(given, names)
        advice = f"did you mean {guess}?" if guess else f"write one of {', '.join(names)}"
        raise InputError(f"{one_line(given)}: no such scenario; {advice} (a file of your own ends in .toml)")
    return parse((LIBRARY / f"{given}.toml").read_bytes(), f"{given}.toml", overrides)


def parse(content: bytes, file: str, overrides: Sequence[str] = ()) -> Scenario:
    """The scenario in the bytes of a TOML document; `file` is what messages call it.

    Raises:
        InputError: it is not UTF-8, not TOML, or not a scenario.
    """
    tables = _tables(content, file)
    parsed = [parse_override(text) for text in overrides]
    for override in parsed:
        tables = apply(override, tables)
    try:
        return Scenario.model_validate(tables)
    except ValidationError as error:
        raise input_error(error, file, parsed) from error


def _read(path: Path) -> bytes:
    try:
        with path.open("rb") as stream:
            content = stream.read(LARGEST_FILE + 1)
    except (OSError, ValueError) as error:  # ValueError: a path that no file system can hold
        reason = getattr(error, "strerror", None) or str(error)
        cure = "write a TOML file's path, or a name that `swerve scenarios` lists"
        raise InputError(f"{one_line(str(path))}: cannot be read: {reason}; {cure}") from error
    if len(content) > LARGEST_FILE:
        raise InputError(f"{one_line(str(path))}: no scenario file: larger than {LARGEST_FILE} bytes")
    return content


def _tables(content: bytes, file: str) -> dict[str, Any]:
    try:
        tables = tomllib.loads(content.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        raise InputError(f"{file}: not UTF-8 text, at byte {error.start}; save it as UTF-8") from error
    except RecursionError as error:
        raise InputError(f"{file}: not valid TOML: nested too deep") from error
    except ValueError as error:  # TOMLDecodeError, with line and column; or a whole number of thousands of digits
        raise InputError(f"{file}: not valid TOML: {one_line(str(error), 120)}") from error
    if not tables:
        raise InputError(f"{file}: empty; a scenario has name, duration, [road], [ego] and [goal] at least")
    return tables
