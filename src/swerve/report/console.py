"""What can be shown where a command prints: how wide, with which characters, in colour or not.

Colour is for terminals alone, and not where NO_COLOR is set (https://no-color.org) or TERM is "dumb".
"""

import os
import shutil
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, TextIO

from swerve.report.track import ASCII, UNICODE, Charset

WIDTH: Final = 80  # where nobody says [character]
PLAIN_TERMINALS: Final = ("dumb", "linux")  # whose fonts have no Braille
COLOURS: Final = {  # ANSI's number of what is printed, by its part
    "good": 32,
    "bad": 31,
    "edge": 1,
    "lane": 2,
    "oncoming": 1,
    "obstacle": 31,
    "path": 36,
}


@dataclass(frozen=True)
class Console:
    """A stream as it is printed to.

    Attributes:
        width: of a line [character].
        charset: that it can show.
        has_colour: whether it shows colours.
    """

    width: int = WIDTH
    charset: Charset = ASCII
    has_colour: bool = False

    @classmethod
    def of(cls, stream: TextIO, environment: Mapping[str, str] = os.environ) -> "Console":
        """What `stream` can show, by its encoding and by what the environment says of the terminal."""
        terminal = environment.get("TERM", "")
        has_colour = stream.isatty() and not environment.get("NO_COLOR") and terminal != "dumb"
        if sys.platform == "win32":
            has_colour = has_colour and "WT_SESSION" in environment  # the older console prints the codes as they are
        width = shutil.get_terminal_size((WIDTH, 24)).columns if stream.isatty() else WIDTH
        is_plain = terminal in PLAIN_TERMINALS or not _can_encode(stream, UNICODE)
        return cls(width, ASCII if is_plain else UNICODE, has_colour)

    def paint(self, part: str, text: str) -> str:
        """A part's characters in its colour, where there are colours."""
        return f"\x1b[{COLOURS[part]}m{text}\x1b[0m" if self.has_colour else text


PLAIN: Final = Console()


def _can_encode(stream: TextIO, charset: Charset) -> bool:
    try:
        characters = (charset.edge, charset.oncoming, charset.obstacle, charset.path, charset.axis)
        "".join(characters).encode(stream.encoding or "ascii")
    except (UnicodeEncodeError, LookupError):
        return False
    return True
