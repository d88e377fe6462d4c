"""Table 1 as Markdown, CSV and JSON, and the figures beside it."""

import csv
import json
from collections.abc import Callable
from io import StringIO
from itertools import combinations

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

from swerve.report.figures import TYRE_FIGURES
from swerve.report.table1 import as_csv, as_json, as_markdown
from swerve.study.tyre_work import TyreWork, tyre_work

WORK = tyre_work()

LABELS = {
    "fig03_friction_ellipses": ({"longitudinal force $F_x$ [kN]"}, {"lateral force $F_y$ [kN]"}),
    "fig04_line_fits": (
        {"vertical load $F_z$ [kN]", r"slip angle $\alpha$ [deg]", ""},
        {"$B$ [1/rad]", "$C$ [1]", "$D$ [1]", "pure lateral force $F_y$ [kN]", "error of $F_y$\n[% of its peak]"},
    ),
}


def test_the_markdown_has_the_printed_numbers_beside_the_fitted_ones() -> None:
    """A column for each load, three rows for each letter; the fitted row has the printed digits, and E is 0."""
    rows = [line.strip("| ").split(" | ") for line in as_markdown(WORK).splitlines() if line.startswith("|")]
    assert {len(row) for row in rows[:18]} == {9}
    by_name = {row[0]: row[1:] for row in rows}
    assert by_name["$B$ [1/rad], printed"] == by_name["$B$, fitted"]
    assert by_name["$D$ [1], printed"][-1] == by_name["$D$, fitted"][-1] == "0.8982"
    assert by_name["$E$ [1], printed"][0] == "2.9e-17"
    assert set(by_name["$C$, error"]) == set(by_name["$E$, fitted"]) == {"< 1e-12"}
    assert by_name["LSE [N], printed"][0] == "5.0962"
    assert by_name["lines, largest over peak"][0] == "0.36%"


def test_the_markdown_has_the_three_lines() -> None:
    """Each with both numbers as printed and as fitted, error, the rounding that explains it, and R^2."""
    rows = [line.strip("| ").split(" | ") for line in as_markdown(WORK).splitlines() if "no load" in line]
    assert rows[0] == ["$B$ at no load [1/rad]", "13.0409", "13.0408", "-7.8e-05", "9.3e-05", "0.9976"]
    assert len(rows) == 3
    assert all(abs(float(row[3])) <= float(row[4]) for row in rows)


def test_the_csv_has_a_line_for_each_printed_number() -> None:
    """Four letters at eight loads and two numbers of three lines; an error is fitted less printed."""
    lines = list(csv.DictReader(StringIO(as_csv(WORK))))
    assert len(lines) == 4 * 8 + 3 * 2
    for line in lines:
        assert float(line["error"]) == pytest.approx(float(line["fitted"]) - float(line["printed"]), abs=1e-15)
    assert (lines[-1]["quantity"], lines[-1]["load"], lines[-1]["printed"]) == ("D_per_newton", "", "-9.0695e-06")


def test_the_json_has_every_error() -> None:
    """Of each load, each line and both figures."""
    whole = json.loads(as_json(WORK))
    assert whole["table_1"]["loads"][7]["lines"]["relative_error"] == pytest.approx(0.00326, abs=1e-5)
    assert abs(whole["lines"]["C"]["error"]["per_newton"]) <= whole["lines"]["C"]["rounding"]["per_newton"]
    assert [each["error"] < 2e-6 for each in whole["figure_3"]["ellipses"]] == [True] * len(WORK.figure_3)
    assert whole["figure_4"]["largest_error"]["B"] == pytest.approx(0.0454, abs=1e-4)


@pytest.mark.parametrize(("name", "draw"), TYRE_FIGURES.items())
def test_figures_are_whole(name: str, draw: Callable[[TyreWork], Figure]) -> None:
    """Axes have names and units, all is on the page, and no two labels of lines overlap."""
    figure = draw(WORK)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    assert ({axes.get_xlabel() for axes in figure.axes}, {axes.get_ylabel() for axes in figure.axes}) == LABELS[name]
    page, used = figure.get_size_inches(), figure.get_tightbbox()
    assert used.x0 >= 0 and used.y0 >= 0
    assert used.x1 <= page[0] and used.y1 <= page[1]
    for axes in figure.axes:
        boxes = [Text.get_window_extent(text) for text in axes.texts]  # an annotation's own has its arrow in it
        assert not any(a.padded(-1.0).overlaps(b.padded(-1.0)) for a, b in combinations(boxes, 2))  # [pixel]


def test_the_curves_of_figure_3_are_those_of_the_work() -> None:
    """In kN, one for each slip angle."""
    axes = TYRE_FIGURES["fig03_friction_ellipses"](WORK).axes[0]
    curves = [line.get_xydata() for line in axes.lines if len(line.get_xdata()) == len(WORK.figure_3[0].lateral)]
    for curve, ellipse in zip(curves, WORK.figure_3, strict=False):
        np.testing.assert_allclose(curve[:, 1] * 1e3, ellipse.lateral)
