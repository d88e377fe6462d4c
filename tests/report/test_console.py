"""What is printed where: colours, characters and width by what the stream can show."""

import io
import os
from collections.abc import Mapping

import pytest

from swerve.report import Console, result_table, run_summary
from swerve.report.track import ASCII, UNICODE
from tests.report.results import COLLIDED, RESULT
from tests.report.runs import made


class Stream(io.TextIOWrapper):
    """A stream of an encoding, which is a terminal or not."""

    def __init__(self, encoding: str, *, is_terminal: bool) -> None:
        super().__init__(io.BytesIO(), encoding=encoding)
        self._is_terminal = is_terminal

    def isatty(self) -> bool:
        """Whether it is a terminal."""
        return self._is_terminal


@pytest.mark.parametrize(
    ("environment", "is_terminal", "has_colour"),
    [
        ({"TERM": "xterm-256color"}, True, True),
        ({"TERM": "xterm-256color", "NO_COLOR": "1"}, True, False),
        ({"TERM": "xterm-256color", "NO_COLOR": ""}, True, True),
        ({"TERM": "dumb"}, True, False),
        ({"TERM": "xterm-256color"}, False, False),
    ],
)
def test_colours_are_for_terminals(
    monkeypatch: pytest.MonkeyPatch, environment: Mapping[str, str], is_terminal: bool, has_colour: bool
) -> None:
    """There are colours on a terminal, unless NO_COLOR is set or it is dumb, and none in a pipe or a file."""
    monkeypatch.setattr("sys.platform", "linux")
    console = Console.of(Stream("utf-8", is_terminal=is_terminal), environment)
    assert console.has_colour == has_colour
    assert ("\x1b[32mavoided\x1b[0m: The vehicle" in result_table(RESULT, console)) == has_colour
    assert ("\x1b[31mcollided\x1b[0m: The vehicle" in result_table(COLLIDED, console)) == has_colour


def test_an_older_windows_console_has_no_colours(monkeypatch: pytest.MonkeyPatch) -> None:
    """On Windows there are colours in its new terminal alone."""
    monkeypatch.setattr("sys.platform", "win32")
    stream = Stream("utf-8", is_terminal=True)
    assert not Console.of(stream, {}).has_colour
    assert Console.of(stream, {"WT_SESSION": "1"}).has_colour


@pytest.mark.parametrize("encoding", ["utf-8", "ascii", "cp1252", "cp437", "latin-1"])
@pytest.mark.parametrize("term", ["xterm", "linux", "dumb", ""])
def test_every_character_can_be_shown(encoding: str, term: str) -> None:
    """What is printed is of the stream's encoding, and plain where the terminal's font has no Braille."""
    stream = Stream(encoding, is_terminal=True)
    console = Console.of(stream, {"TERM": term})
    assert console.charset is (UNICODE if encoding == "utf-8" and term in ("xterm", "") else ASCII)
    print(run_summary(made(controller="unified"), console), file=stream, flush=True)


def test_the_width_is_the_terminal_s(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a terminal a line may be as long as it is wide, anywhere else 80 characters."""
    monkeypatch.setattr("shutil.get_terminal_size", lambda fallback: os.terminal_size((63, 24)))
    assert Console.of(Stream("utf-8", is_terminal=True), {}).width == 63
    assert Console.of(Stream("utf-8", is_terminal=False), {}).width == 80


def test_a_summary_is_the_table_and_the_drawing() -> None:
    """The drawing stands below the table where there is room for it, and the table alone where there is not."""
    done = made(controller="unified")
    table = result_table(done.result)
    assert run_summary(done, Console(44)) == table
    summary = run_summary(done, Console(80))
    assert summary.startswith(f"{table}\n\n")
    assert "# obstacle, * centre of gravity" in summary
