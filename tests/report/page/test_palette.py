"""The page's colours: readable by WCAG 2.2 AA, and told apart by colour-blind readers."""

import re
from importlib.resources import files
from itertools import combinations

import pytest

from tests.report.page.colour import READERS, contrast, difference, luminance

SHEET = (files("swerve.report.page") / "css" / "palette.css").read_text(encoding="utf-8")
PALETTE = {
    name: {"light": light, "dark": dark}
    for name, light, dark in re.findall(r"--([\w-]+): light-dark\((#\w{6}), (#\w{6})\)", SHEET)
}
LINES = ["line-1", "line-2", "line-3", "line-4"]
TEXT = [(word, ground) for word in ("ink", "muted", "accent") for ground in ("page", "card")]
TEXT += [(word, "road") for word in ("ink", "muted", *LINES)]
TEXT += [("on-accent", "accent"), ("on-badge", "good"), ("on-badge", "bad"), ("muted", "grid")]
MARKS = [(mark, ground) for mark in ("obstacle", "force", "lane", *LINES) for ground in ("card", "road")]
MARKS += [("accent", "card"), ("bad", "card"), ("lane", "grid")]


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize(("word", "ground"), TEXT)
def test_text_is_readable(word: str, ground: str, theme: str) -> None:
    """Text stands out from what it is written on by at least 4.5:1 (success criterion 1.4.3)."""
    assert contrast(PALETTE[word][theme], PALETTE[ground][theme]) >= 4.5


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize(("mark", "ground"), MARKS)
def test_marks_are_visible(mark: str, ground: str, theme: str) -> None:
    """Lines, arrows and outlines stand out by at least 3:1 (success criterion 1.4.11)."""
    assert contrast(PALETTE[mark][theme], PALETTE[ground][theme]) >= 3.0


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("reader", READERS)
def test_lines_are_told_apart(reader: str, theme: str) -> None:
    """Any two of the four lines look at least five times as different as is just noticeable, to every reader."""
    for first, second in combinations(LINES, 2):
        assert difference(PALETTE[first][theme], PALETTE[second][theme], reader) > 5 * 2.3, (first, second)


def test_contrast_is_the_standard_s() -> None:
    """Black on white is 21:1, a colour on itself 1:1, and #767676 the lightest grey that is text on white."""
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)
    assert contrast("#123456", "#123456") == 1.0
    assert contrast("#767676", "#ffffff") > 4.5 > contrast("#777777", "#ffffff")
    assert luminance("#ffffff") == pytest.approx(1.0)
