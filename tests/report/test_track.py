"""The drawing of a run in text: what is where in it, and that it fits."""

import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.report.console import Console
from swerve.report.track import ASCII, NARROWEST, UNICODE, WIDEST, track
from swerve.simulate import Log, Run, Table
from tests.report.runs import FAILING, MOST_SHOWN, made

PLACES = 70  # along X, in 80 characters
LABEL = 9  # characters before the drawing itself
ANSI = re.compile(r"\x1b\[\d+m")


def _rows(text: str) -> tuple[list[str], list[float]]:
    """The lines of a drawing, without their labels, and Y of the middle of each [m]."""
    lines = [line.ljust(WIDEST) for line in text.splitlines()[:-2]]
    labelled = [(i, float(line[:7].removesuffix(" m"))) for i, line in enumerate(lines) if line[:7].strip()]
    (i, high), (k, low) = labelled[0], labelled[-1]
    return [line[LABEL:] for line in lines], [high + (low - high) * (n - i) / (k - i) for n in range(len(lines))]


def _scale(text: str) -> tuple[float, float]:
    """Of a drawing that begins at X = 0: how many places a metre is, from the ruler's last label, and its error."""
    ruler = text.splitlines()[-2]
    last = list(re.finditer(r"(\d+) m", ruler))[-1]
    return (last.start() - LABEL + 0.5) / float(last[1]), 0.5 / float(last[1])


def _places(text: str, character: str) -> list[tuple[int, float]]:
    """Where a character is: number of the place in its line, and Y [m]."""
    rows, heights = _rows(text)
    return [(j, y) for row, y in zip(rows, heights, strict=True) for j, each in enumerate(row) if each == character]


def test_the_path_is_where_the_vehicle_was() -> None:
    """In every place along X the drawn path is in a line that the path passes there, and none is left out."""
    done = made("duration=3 s", controller="unified")
    motion, text = done.log.motion, track(done, 80, ASCII)
    marks = _places(text, "*")
    n = max(j for j, _ in marks) + 1
    cell = np.ptp(motion["X"]) / n
    height = abs(np.diff(_rows(text)[1])[0])
    assert {j for j, _ in marks} == set(range(n))
    for j, y in marks:
        passed = motion["Y"][(motion["X"] >= j * cell - 1e-6) & (motion["X"] <= (j + 1) * cell + 1e-6)]
        assert passed.min() - height * 0.51 - 0.06 <= y <= passed.max() + height * 0.51 + 0.06  # labels are rounded


def test_braille_is_the_same_path_and_finer() -> None:
    """A dot's place along X and Y is within a dot's size of the path."""
    done = made("duration=3 s", controller="unified")
    motion, text = done.log.motion, track(done, 80, UNICODE)
    rows, heights = _rows(text)
    dot, height = np.ptp(motion["X"]) / (2 * PLACES), abs(np.diff(heights)[0]) / 4
    seen = 0
    for row, middle in zip(rows, heights, strict=True):
        for j, character in enumerate(row):
            dots = ord(character) - 0x2800
            if not 0 < dots < 256:
                continue
            for bit, (right, down) in enumerate([(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (0, 3), (1, 3)]):
                if dots >> bit & 1:
                    seen += 1
                    x, y = (2 * j + right + 0.5) * dot, middle + (1.5 - down) * height
                    assert np.hypot((motion["X"] - x) / dot, (motion["Y"] - y) / height).min() < 0.9
    assert seen >= 2 * PLACES


def test_an_obstacle_covers_its_places() -> None:
    """A place is the obstacle's where the obstacle reaches into it, but for those of the path."""
    done = made("duration=3 s", "obstacles.0.semi_axes=[6, 2]", "obstacles.0.position=[30, 0]", controller="unified")
    text = track(done, 80, ASCII)
    marks, path = set(_places(text, "#")), set(_places(text, "*"))
    heights = _rows(text)[1]
    cell, height = np.ptp(done.log.motion["X"]) / PLACES, abs(np.diff(heights)[0])
    for y in heights:
        for j in range(PLACES):
            x = np.linspace(j * cell, (j + 1) * cell, 21)[:, np.newaxis] - 30
            ratio = np.hypot(x / 6, (y + np.linspace(-0.5, 0.5, 21) * height) / 2).min()
            if (j, y) not in path and abs(ratio - 1) > 0.05:
                assert ((j, y) in marks) == (ratio < 1)
    assert len(marks) > 20


def test_an_obstacle_that_moves_is_where_the_vehicle_came_nearest() -> None:
    """One that comes towards the vehicle, beside it, is drawn where they met."""
    done = made("obstacles=[{position=[60, 4], velocity=[-20, 0], size=[4, 2]}]", "duration=2 s")
    text = track(done, 80, ASCII)
    columns = [j for j, _ in _places(text, "#")]
    met = (min(columns) + max(columns) + 1) / 2 * np.ptp(done.log.motion["X"]) / PLACES
    assert met == pytest.approx(30, abs=2.5)


def test_lanes_and_edges_are_lines() -> None:
    """Both edges are drawn along the whole road, and what is between lanes in another character."""
    text = track(made("road.lane_width=3.5", "road.lanes_left=1", "road.lanes_right=1", "obstacles=[]"), 80, ASCII)
    rows, heights = _rows(text)
    spacing = abs(np.diff(heights)[0])
    for character, places in (("=", (5.25, -5.25)), ("-", (1.75, -1.75))):
        drawn = [y for row, y in zip(rows, heights, strict=True) if set(row.strip()) == {character}]
        np.testing.assert_allclose(drawn, places, atol=spacing / 2 + 0.06)


def test_the_line_between_directions_is_another_one() -> None:
    """It is neither an edge nor a line between lanes of one direction."""
    lanes = ("road.lane_width=3.5", "road.lanes_left=2", "road.lanes_right=0", "road.lanes_oncoming=1")
    rows, heights = _rows(track(made(*lanes, "obstacles=[]"), 80, ASCII))
    drawn = {row.strip()[:1]: y for row, y in zip(rows, heights, strict=True) if len(set(row.strip())) == 1}
    assert drawn[":"] == pytest.approx(5.25, abs=0.6)
    assert drawn["-"] == pytest.approx(1.75, abs=0.6)


def test_the_ruler_is_true() -> None:
    """A label of X stands where that X is: at the place of the obstacle that is there."""
    done = made("duration=3 s", "obstacles.0.position=[40, 3]", "obstacles.0.semi_axes=[0.5, 0.5]")
    text = track(done, 100, ASCII)
    scale, error = _scale(text)
    columns = [j for j, _ in _places(text, "#")]
    assert (min(columns) + max(columns) + 1) / 2 == pytest.approx(40 * scale, abs=40 * error + 1)


@settings(deadline=None, max_examples=30)
@given(st.integers(1, 300), st.booleans(), st.sampled_from(["wide", "plain", "failing"]))
def test_a_drawing_fits_the_terminal(width: int, is_fine: bool, which: str) -> None:
    """No line is longer than the terminal is wide, none ends in blanks, and there are but few; or there is none."""
    done = {"wide": made(*MOST_SHOWN, controller="unified"), "plain": made(), "failing": made(FAILING)}[which]
    lines = track(done, width, UNICODE if is_fine else ASCII).splitlines()
    assert bool(lines) == (width >= NARROWEST)
    assert all(len(line) < width and line == line.rstrip() for line in lines)
    assert len(lines) <= 15


def _lost() -> Run:
    motion = made().log.motion
    columns = {name: np.append(values[:-5], np.full(5, np.nan)) for name, values in motion.columns.items()}
    return replace(made(), log=Log(Table({**columns, "time": motion["time"]}, motion.units), made().log.steps))


@pytest.mark.parametrize(
    ("done", "is_drawn"),
    [
        (lambda: made("ego.speed=0", "goal.speed=0"), False),
        (lambda: made("ego.heading=90 deg", "obstacles=[]"), False),
        (_lost, True),
        (lambda: made("duration=30 s", "obstacles.0.position=[400, 0]"), True),
        (lambda: made("obstacles.0.position=[5, 400]"), True),
    ],
    ids=["at rest", "sideways", "diverged", "long", "far aside"],
)
def test_any_run_can_be_asked_for(done: Callable[[], Run], is_drawn: bool) -> None:
    """A run without a way along X has no drawing; any other has, within its few lines, one of which is Y = 0."""
    text = track(done(), 80, UNICODE)
    assert bool(text) == is_drawn
    assert ("  0.0 m \u2502" in text) == is_drawn
    assert len(text.splitlines()) <= 15


def test_what_is_far_aside_does_not_flatten_the_drawing() -> None:
    """An obstacle that never came near has no part in how high the drawing is."""
    assert track(made("obstacles.0.position=[5, 400]"), 80, ASCII) == track(
        made("obstacles.0.position=[5, -400]"), 80, ASCII
    )


def test_a_long_run_is_drawn_where_it_came_nearest() -> None:
    """Of 600 m the 200 m round the obstacle are drawn, and the obstacle is in them."""
    text = track(made("duration=30 s", "obstacles.0.position=[400, 0]"), 80, ASCII)
    assert "400 m" in text.splitlines()[-2]
    assert _places(text, "#")


def test_colours_are_all_that_is_added() -> None:
    """Without its colours a coloured drawing is the plain one; each part has some."""
    done = made(*MOST_SHOWN, controller="unified")
    coloured = track(done, 80, UNICODE, Console(80, UNICODE, has_colour=True).paint)
    assert ANSI.sub("", coloured) == track(done, 80, UNICODE)
    assert {code.group() for code in ANSI.finditer(coloured)} == {f"\x1b[{n}m" for n in (0, 1, 2, 31, 36)}
    assert "\x1b" not in track(done, 80, UNICODE, Console(80, UNICODE).paint)
