"""`--set KEY=VALUE`: one value of a scenario replaced before it is checked.

KEY is dotted, with list indices as in obstacles.0.position or obstacles[0].position; VALUE is TOML where it can be
read as such, and otherwise the text itself, so that ego.speed=72 km/h needs no quotes.
"""

import re
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from swerve.errors import InputError, one_line
from swerve.scenario.keys import dotted

DEEPEST = 8  # parts of a key; more than any key of a scenario has
LONGEST_INDEX = 6  # digits


@dataclass(frozen=True)
class Override:
    """A parsed `--set`.

    Attributes:
        text: as it was written.
        path: the parts of its key.
        value: what it sets.
    """

    text: str
    path: tuple[str, ...]
    value: Any

    def __str__(self) -> str:
        return f"--set {one_line(self.text)}"


def parse_override(text: str) -> Override:
    """The override in KEY=VALUE.

    Raises:
        InputError: there is no "=", or no key.
    """
    key, equals, value = text.partition("=")
    if not equals:
        raise InputError(f"--set {one_line(text)}: no '='; write KEY=VALUE, such as road.friction=0.4")
    path = tuple(part.strip() for part in re.sub(r"\[(\d+)\]", r".\1", key).split("."))
    if not all(path):
        raise InputError(f"--set {one_line(text)}: no dotted key before '='; write one such as road.friction=0.4")
    if len(path) > DEEPEST:
        raise InputError(f"--set {one_line(text)}: {one_line(key)}: unknown key; none has more than {DEEPEST} parts")
    return Override(text, path, _value(value.strip()))


def apply(override: Override, tables: dict[str, Any]) -> dict[str, Any]:
    """A copy of a scenario's tables with one value replaced; absent tables are made.

    Raises:
        InputError: the key leads through a value, or to an entry that a list does not have.
    """
    result: dict[str, Any] = _replaced(tables, override, 0)
    return result


def _value(text: str) -> Any:
    try:
        document = tomllib.loads(f"value = {text}")
    except (ValueError, RecursionError):  # not TOML, a number beyond Python's, a list deeper than its stack
        return text
    return document["value"] if len(document) == 1 else text


def _replaced(node: Any, override: Override, depth: int) -> Any:
    """`node`, at the first `depth` parts of the override's path, with the rest of the path set to its value."""
    if depth == len(override.path):
        return override.value
    part = override.path[depth]
    if node is None:
        node = [] if _is_index(part) else {}
    if isinstance(node, dict):
        return {**node, part: _replaced(node.get(part), override, depth + 1)}
    here = dotted(override.path[:depth])
    if not isinstance(node, list):
        raise InputError(f"{override}: {here} is a value, not a table; write {here}=VALUE")
    if not _is_index(part) or int(part) > len(node):
        cure = f"write an index from 0 to {len(node)}, which appends"
        raise InputError(f"{override}: {here} is a list of length {len(node)}; {cure}")
    return _with_entry(node, int(part), override, depth)


def _with_entry(node: Sequence[Any], index: int, override: Override, depth: int) -> list[Any]:
    """A list with one entry replaced, or with one more."""
    entry = node[index] if index < len(node) else None
    return [*node[:index], _replaced(entry, override, depth + 1), *node[index + 1 :]]


def _is_index(part: str) -> bool:
    return part.isascii() and part.isdigit() and len(part) <= LONGEST_INDEX
