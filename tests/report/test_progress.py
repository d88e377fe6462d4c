"""Progress on a stream: when it speaks, how, and what it leaves behind."""

import re
from types import SimpleNamespace
from typing import Any

import pytest

from swerve.report import Progress


class FakeStream:
    """A stream that remembers; a terminal if told so."""

    def __init__(self, *, terminal: bool) -> None:
        self.text = ""
        self._terminal = terminal

    def isatty(self) -> bool:
        """Whether it is a terminal."""
        return self._terminal

    def write(self, text: str) -> int:
        """Remember the text."""
        self.text += text
        return len(text)

    def flush(self) -> None:
        """Nothing to do."""


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> SimpleNamespace:
    """The clock that progress looks at, set by hand [s]."""
    hand = SimpleNamespace(now=100.0)
    monkeypatch.setattr("swerve.report.progress.time", SimpleNamespace(monotonic=lambda: hand.now))
    return hand


def _progress(clock: SimpleNamespace, *, terminal: bool) -> str:
    """What is shown of work that takes 20 s and tells of itself every 10 ms."""
    stream: Any = FakeStream(terminal=terminal)
    with Progress(stream) as progress:
        for step in range(2000):
            progress(step / 2000)
            clock.now += 0.01
    return str(stream.text)


def test_progress_in_a_file_is_plain_lines(clock: SimpleNamespace) -> None:
    """Where the stream is no terminal, progress is a line after a second and then one every five, no control codes."""
    assert _progress(clock, terminal=False).splitlines() == [f"swerve: {p}% done" for p in (5, 30, 55, 80)]


def test_progress_on_a_terminal_goes_away(clock: SimpleNamespace) -> None:
    """On a terminal, progress is one line that renews itself and is wiped at the end."""
    text = _progress(clock, terminal=True)
    assert "\n" not in text
    assert "\rswerve:  50%" in text
    assert re.search(r"\r +\r$", text)


def test_quick_work_shows_no_progress(clock: SimpleNamespace) -> None:
    """Work of less than a second is silent."""
    stream: Any = FakeStream(terminal=True)
    with Progress(stream) as progress:
        clock.now += 0.9
        progress(0.9)
    assert stream.text == ""


def test_a_part_tells_its_share_of_the_whole(clock: SimpleNamespace) -> None:
    """Half of a part from 20 % to 80 % is half of the whole."""
    stream: Any = FakeStream(terminal=False)
    with Progress(stream) as progress:
        clock.now += 2.0
        progress.part(0.2, 0.8)(0.5)
    assert stream.text == "swerve: 50% done\n"
