"""Options that several commands take, and how their values are checked."""

import argparse
from collections.abc import Iterable

from swerve.errors import InputError, unknown


def add_seed(parser: argparse.ArgumentParser) -> None:
    """Add --seed to a command's parser."""
    parser.add_argument("--seed", type=_seed, default=0, help="of all that is random [0]")


def _seed(text: str) -> int:
    if not (text.isascii() and text.isdigit() and len(text) <= 18):
        raise argparse.ArgumentTypeError(f"{text[:40]!r} is no seed; write a whole number from 0, of at most 18 digits")
    return int(text)


def checked(kind: str, name: str | None, known: Iterable[str], option: str | None = None) -> str | None:
    """A name that is known, or None where none was given; the option is called as the kind is, unless said.

    Raises:
        InputError: it is not known.
    """
    if name is not None and name not in known:
        raise InputError(f"--{option or kind}: {unknown(kind, name, known)}")
    return name
