"""The grammar of a tyre property file (.tir): sections in brackets, and in them KEY = value.

    [MODEL]
    FITTYP    = 61         $ what follows $ or ! is a comment
    TYRESIDE  = 'LEFT'

Keys are looked up without their section, whatever their case; the ones asked for here occur in one section alone.
Tables, which begin with a line in braces, are passed over.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from swerve.errors import InputError, one_line, shown_path
from swerve.vehicle.fitting.source_file import finite_number, read_lines

_NO_EQUALS: Final = re.compile(r"[A-Za-z]\w*\s+[+-]?[\d.]+(?:[eE][+-]?\d+)?\s*(?:[$!].*)?", re.ASCII)
_ENTRY: Final = re.compile(r"(\w+)\s*=\s*(?:'([^']*)'|\"([^\"]*)\"|([^$!]*)).*", re.ASCII)


@dataclass(frozen=True)
class Entry:
    """One value, as text, and its line."""

    text: str
    line: int


@dataclass(frozen=True)
class PropertyFile:
    """A tyre property file.

    Attributes:
        file: what messages call it.
        entries: by key, in capitals; under each every place where it stands.
    """

    file: str
    entries: Mapping[str, tuple[Entry, ...]]

    def entry(self, key: str) -> Entry | None:
        """The value of a key, None where there is none; InputError when there are two."""
        found = self.entries.get(key, ())
        if len(found) > 1:
            fault = f"{key} again, after line {found[0].line}"
            raise InputError(f"{self.file}: line {found[1].line}: {fault}; write it once")
        return found[0] if found else None

    def number(self, key: str, default: float | None = None) -> float:
        """The value of a key as a number, `default` where it is absent.

        Raises:
            InputError: it is absent without a default, no number or not finite.
        """
        entry = self.entry(key)
        if entry is None:
            if default is None:
                raise InputError(f"{self.file}: no {key}; write it, as in {key} = 1.0")
            return default
        try:
            return finite_number(entry.text)
        except ValueError as error:
            cure = "write a plain number" + ("" if default is None else ", or delete the line")
            raise InputError(f"{self.file}: line {entry.line}: {key}: {error}; {cure}") from error

    def place(self, key: str) -> str:
        """Where a key that is there stands, for messages."""
        return f"{self.file}: line {self.entries[key][0].line}"


def read_property_file(path: Path) -> PropertyFile:
    """The keys and values of a tyre property file.

    Raises:
        InputError: it cannot be read, or has no sections.
    """
    entries: dict[str, tuple[Entry, ...]] = {}
    has_section = False
    for number, line in enumerate(read_lines(path), start=1):
        text = line.strip()
        if re.match(r"\[\s*\w+\s*\]", text):
            has_section = True
        elif match := _ENTRY.fullmatch(text):
            value = next(group for group in match.groups()[1:] if group is not None)
            key = match[1].upper()
            entries[key] = (*entries.get(key, ()), Entry(value.strip(), number))
        elif _NO_EQUALS.fullmatch(text):
            fault = f"no '=' in '{one_line(text, 40)}'"
            raise InputError(f"{shown_path(path)}: line {number}: {fault}; write KEY = value")
    if not (has_section and entries):
        cure = "write one with sections such as [MODEL], and KEY = value in them"
        raise InputError(f"{shown_path(path)}: no tyre property file; {cure}")
    return PropertyFile(shown_path(path), entries)
