"""The figure and the tables of a map: their numbers are the map's and the formulas'."""

from pathlib import Path

import numpy as np
import pytest

from swerve.report.map import as_markdown, write_figure
from swerve.report.map.figure import map_figure
from swerve.study.map.boundary import Condition
from tests.report.map.maps import EXTENT, FRICTIONS, HALF_WIDTH, LIMITS, SHARES, SPEEDS, allowed, made, reached

GRAVITY = 9.81  # [m/s^2]


def test_the_closed_forms_are_drawn() -> None:
    """Two lines of each panel are v^2 / (2 mu g) before contact, and v sqrt(2 w / (mu g))."""
    figure = map_figure(made())
    for axes, friction in zip(figure.axes, FRICTIONS, strict=False):
        lines = {line.get_label(): line.get_xydata() for line in axes.lines}
        speed, braking = lines[r"$v^2 / (2 \mu g)$"].T
        np.testing.assert_allclose(braking - EXTENT, speed**2 / (2 * friction * GRAVITY), rtol=2e-3)
        speed, swerving = lines[r"$v \sqrt{2 w / (\mu g)}$"].T
        np.testing.assert_allclose(swerving, speed * np.sqrt(2 * HALF_WIDTH / (friction * GRAVITY)), rtol=1e-3)


def test_every_boundary_is_drawn() -> None:
    """Each controller and each limit is a line through its boundaries; where there is none, the line has a gap."""
    figure = map_figure(made())
    assert [axes.get_title() for axes in figure.axes[:4]] == [f"friction {each:g}" for each in FRICTIONS]
    for axes, friction in zip(figure.axes, FRICTIONS, strict=False):
        lines = {line.get_label(): line.get_xydata() for line in axes.lines}
        cells = [Condition(speed, friction, 0.0) for speed in SPEEDS]
        for who in LIMITS:
            np.testing.assert_array_equal(lines[who], [(each.speed, allowed(who, each)) for each in cells])
        for who in SHARES:
            expected = [(each.speed, reached(who, each)) for each in cells]
            if (who, friction) == ("hierarchical", 0.3):
                expected[-1] = (35.0, np.nan)
            np.testing.assert_array_equal(lines[who], expected)


def test_the_torques_have_their_panel() -> None:
    """The last panel has for each friction both less individual; a map without these limits has no such panel."""
    axes = map_figure(made()).axes[4]
    for line, friction in zip(axes.lines, FRICTIONS, strict=True):
        cells = [Condition(speed, friction, 0.0) for speed in SPEEDS]
        expected = [allowed("limit: both", each) - allowed("limit: individual", each) for each in cells]
        np.testing.assert_allclose(line.get_ydata(), expected)
    assert len(map_figure(made(limits=())).axes) == 4


@pytest.mark.parametrize("suffix", ["png", "pdf"])
def test_files_are_the_same_each_time(suffix: str, tmp_path: Path) -> None:
    """PNG and PDF of the same map have the same bytes."""
    paths = [tmp_path / f"{name}.{suffix}" for name in ("first", "second")]
    for path in paths:
        write_figure(made(frictions=(0.5, 0.85)), path)
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_the_markdown_has_a_row_for_each_condition() -> None:
    """A row has friction and speed, the distances, the ratios and what the torques buy, rounded; a dash for none."""
    lines = as_markdown(made()).splitlines()
    table = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if line.startswith("|")]
    head, rows = table[0], [dict(zip(table[0], row, strict=True)) for row in table[2:]]
    assert len(rows) == len(SPEEDS) * len(FRICTIONS)
    assert {"unified [m]", "unified / limit", "limit: individual [m]", "four wheel torques buy [m]"} <= set(head)
    for row in rows:
        condition = Condition(float(row["speed [m/s]"]), float(row["friction"]), 0.0)
        assert row["unified [m]"] == f"{reached('unified', condition):.2f}"
        assert row["unified / limit"] == "1.040"
        assert row["limit: both [m]"] == f"{allowed('limit: both', condition):.2f}"
    assert [row["hierarchical [m]"] for row in rows if row["hierarchical / limit"] == "\N{EN DASH}"] == ["\N{EN DASH}"]
    assert "- `hierarchical`: median 1.180 times the limit, 1.180 to 1.180 times in 23 of 24 conditions" in lines


def test_without_limits_there_is_nothing_to_hold_against() -> None:
    """The Markdown of a map without limits is its table alone, with neither ratios nor what the torques buy."""
    text = as_markdown(made(limits=(), controllers=("unified",), frictions=(0.5,)))
    assert "limit" not in text
    assert text.count("\n| ") == 2 + len(SPEEDS)
