"""What is wrong with a file of settings, said in its own terms: where, which key, which value, what would be right."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pydantic import ValidationError

from swerve.errors import InputError, one_line, shown
from swerve.scenario.keys import Location, dotted, right_keys, table_at, tables_in
from swerve.scenario.overrides import Override
from swerve.scenario.settings import KeyedError, Settings

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

MOST_TOLD = 3  # problems in one message


@dataclass(frozen=True)
class Problem:
    """One fault: where it is, and the sentence that says what it is and what would be right."""

    location: Location
    sentence: str


def input_error(error: ValidationError, root: type[Settings], file: str, overrides: Sequence[Override]) -> InputError:
    """The one-line error for all that validation found in `file`, a `root`, with `overrides` applied to it."""
    faults = sorted(error.errors(include_url=False), key=lambda details: details["type"] == "missing")
    sentences, last_origin = [], ""
    for problem in (_problem(details, root) for details in faults[:MOST_TOLD]):
        origin = _origin(problem, file, overrides)
        place = "" if origin == last_origin else f"{origin}: "
        sentences.append(f"{place}{one_line(dotted(problem.location))}: {problem.sentence}")
        last_origin = origin
    rest = len(faults) - len(sentences)
    return InputError("; also ".join(sentences) + (f"; and {rest} more" if rest else ""))


def _origin(problem: Problem, file: str, overrides: Sequence[Override]) -> str:
    """What to mend: the last override that set the key or something round or in it, else the file."""
    where = tuple(map(str, problem.location))
    for override in reversed(overrides):
        common = min(len(where), len(override.path))
        if where[:common] == override.path[:common]:
            return str(override)
    return " ".join([file, *(["with", *map(str, overrides)] if overrides else [])])


def _problem(details: "ErrorDetails", root: type[Settings]) -> Problem:
    location, value = details["loc"], details["input"]
    cause = details.get("ctx", {}).get("error")
    if isinstance(cause, KeyedError):
        keys = [int(key) if key.isdigit() else key for key in cause.key.split(".")]
        return Problem((*location, *keys), cause.sentence)
    match details["type"]:
        case "value_error":
            return Problem(location, str(cause))
        case "extra_forbidden":
            return Problem(location, _unknown_key(location, root))
        case "missing" if isinstance(location[-1], str):
            return Problem(location, _missing(location, root))
        case "missing" | "too_long" | "too_short":
            last = location[:-1] if isinstance(location[-1], int) else location
            return Problem(last, 'not a list of two values; write one such as ["25 m", "0 m"]')
        case "tuple_type":
            return Problem(location, f"{shown(value)} is not a list; write it between [ and ]")
        case "model_type":
            return Problem(location, f"{shown(value)} is not a table; write a table [{one_line(dotted(location))}]")
    return Problem(location, f"{shown(value)}: {details['msg'].lower()}")


def _unknown_key(location: Location, root: type[Settings]) -> str:
    guesses = right_keys(location, root)
    if guesses:
        return f"unknown key; did you mean {' or '.join(guesses)}?"
    return f"unknown key; the keys here are {', '.join(tables_in(table_at(location[:-1], root))) or 'none'}"


def _missing(location: Location, root: type[Settings]) -> str:
    field = table_at(location[:-1], root).model_fields[str(location[-1])]
    return f"missing; write one such as {location[-1]} = {(field.examples or [])[0]}"
