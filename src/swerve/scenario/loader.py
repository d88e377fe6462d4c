"""From a library name, a member of a family or a TOML file, and the overrides on it, to a checked scenario."""

from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path
from typing import Any, Final

from pydantic import ValidationError

from swerve.errors import InputError, nearest, one_line, shown_path
from swerve.scenario.document import read_document, tables_of
from swerve.scenario.families import FAMILIES, member_tables
from swerve.scenario.overrides import apply, parse_override
from swerve.scenario.problems import input_error
from swerve.scenario.scenario import Scenario
from swerve.scenario.tyre import FOLDER

LIBRARY: Final = files("swerve.scenario") / "library"
CONTENTS: Final = "a scenario has name, duration, [road], [ego] and [goal] at least"


def library_names() -> list[str]:
    """The names of the scenarios that come with swerve, in alphabetical order."""
    return sorted(entry.name.removesuffix(".toml") for entry in LIBRARY.iterdir() if entry.name.endswith(".toml"))


def load(name_or_path: str | Path, overrides: Sequence[str] = ()) -> Scenario:
    """The scenario of a library name, of a family's member, or of a TOML file.

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
        path = Path(given)
        content = read_document(path, "scenario", "write a TOML file's path, or a name that `swerve scenarios` lists")
        return parse(content, shown_path(given), overrides, path.parent)
    if given in library_names():
        return parse((LIBRARY / f"{given}.toml").read_bytes(), f"{given}.toml", overrides)
    tables = member_tables(given)
    if tables is None:
        raise InputError(f"{one_line(given)}: no such scenario; {_advice(given)} (a file of your own ends in .toml)")
    return _checked(tables, given, overrides)


def _advice(wrong: str) -> str:
    """What to write in place of a name that is none."""
    guess = nearest(wrong, library_names())
    names = ", ".join([*library_names(), *(family.pattern for family in FAMILIES)])
    return f"did you mean {guess}?" if guess else f"write one of {names}"


def parse(content: bytes, file: str, overrides: Sequence[str] = (), folder: Path | None = None) -> Scenario:
    """The scenario in the bytes of a TOML document.

    Args:
        content: of the document.
        file: what messages call it.
        overrides: each KEY=VALUE, applied in order.
        folder: where the files that it names are looked for before the working directory.

    Raises:
        InputError: it is not UTF-8, not TOML, or not a scenario.
    """
    return _checked(tables_of(content, file, CONTENTS), file, overrides, folder)


def _checked(tables: dict[str, Any], file: str, overrides: Sequence[str], folder: Path | None = None) -> Scenario:
    """The scenario in tables, with the overrides on them."""
    parsed = [parse_override(text) for text in overrides]
    for override in parsed:
        tables = apply(override, tables)
    try:
        return Scenario.model_validate(tables, context={FOLDER: folder})
    except ValidationError as error:
        raise input_error(error, Scenario, file, parsed) from error
