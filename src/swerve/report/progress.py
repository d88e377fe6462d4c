"""How much of the work is done, on a terminal's line or in a log's lines."""

import time
from collections.abc import Callable
from types import TracebackType
from typing import Final, Self, TextIO

PATIENCE: Final = 1.0  # time before progress is shown [s]
LINE_EVERY: Final = 5.0  # time between lines where the stream is no terminal [s]
RENEWED_EVERY: Final = 0.1  # time between two states of a terminal's line [s]


class Progress:
    """The share of the work that is done, on a stream, once it has taken longer than a second.

    On a terminal it is one line that renews itself and goes away; anywhere else it is now and then a plain line.
    """

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._next = time.monotonic() + PATIENCE
        self._is_shown = False

    def __call__(self, share: float) -> None:
        """Tell that `share`, from 0 to 1, is done."""
        now = time.monotonic()
        if now < self._next:
            return
        if self._stream.isatty():
            self._stream.write(f"\rswerve: {share:4.0%}")
            self._is_shown, self._next = True, now + RENEWED_EVERY
        else:
            self._stream.write(f"swerve: {share:.0%} done\n")
            self._next = now + LINE_EVERY
        self._stream.flush()

    def part(self, start: float, end: float) -> Callable[[float], None]:
        """What a part of the work calls with its own share, which is that of the whole from `start` to `end`."""
        return lambda share: self(start + share * (end - start))

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._is_shown:
            self._stream.write("\r" + " " * len("swerve: 100%") + "\r")
            self._stream.flush()
