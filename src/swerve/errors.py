"""What swerve raises on purpose, and how its messages are worded."""

from collections.abc import Iterable
from difflib import get_close_matches

LONGEST_SHOWN = 80  # characters of a user's word that a message repeats
LONGEST_PATH = 160  # characters of a path


class SwerveError(Exception):
    """Any error that swerve raises on purpose; its text is one line, meant for the user."""


class InputError(SwerveError):
    """Wrong input: the text names the file, the key, the value and what would be right."""


def one_line(text: str, longest: int = LONGEST_SHOWN) -> str:
    """A user's own word as a message repeats it: no control characters, no more than `longest` characters."""
    safe = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text[:longest])
    return safe if len(text) <= longest else safe[: longest - 3] + "..."


def shown_path(path: object) -> str:
    """A path as a message repeats it; of a long one the end, which has the file's name."""
    safe = one_line(str(path), len(str(path)))
    return safe if len(safe) <= LONGEST_PATH else "..." + safe[3 - LONGEST_PATH :]


def shown(value: object) -> str:
    """A wrong value as a message repeats it: on one line, short, in TOML's words."""
    match value:
        case bool():
            return str(value).lower()
        case str():
            return f"'{one_line(value)}'"
        case dict():
            return "a table"
        case list() | tuple():
            return "a list"
        case int() if value.bit_length() > 200:  # Python refuses to print the longest ones
            return "a number of more than 60 digits"
    return one_line(str(value))


def nearest(word: str, known: Iterable[str]) -> str | None:
    """The known name most like `word`, whatever the case; None when none is alike."""
    names = {name.lower(): name for name in known}
    found = get_close_matches(word.lower(), names, n=1)
    return names[found[0]] if found else None


def unknown(kind: str, word: object, known: Iterable[str]) -> str:
    """The sentence that refuses a name outside a closed list: with the nearest right one, and all of them."""
    names = list(known)
    guess = nearest(word, names) if isinstance(word, str) else None
    advice = f"did you mean {guess}? ({kind}s: {', '.join(names)})" if guess else f"write one of {', '.join(names)}"
    return f"unknown {kind} {shown(word)}; {advice}"
