"""A map as a figure for print: boundaries by friction and offset, and what the four wheel torques buy.

The dashed grey lines are the closed forms v^2 / (2 mu g), before contact, and v sqrt(2 w / (mu g)); below the shaded
region's edge no control was found that avoids.
"""

from math import ceil
from pathlib import Path
from typing import Any, Final

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swerve import __version__
from swerve.report.figures.style import BLACK, BLUE, GREY, ORANGE, captioned_figure, printable, save, styled
from swerve.report.map.data import closed_forms, ends
from swerve.report.map.summary import (
    BOTH,
    INDIVIDUAL,
    Panel,
    avoided,
    bought,
    conditions_of,
    panel_name,
    panels,
)
from swerve.study.map.boundary import Condition, Map

GREEN: Final = "#009E73"
PURPLE: Final = "#AA4499"
COLOURS: Final = (BLUE, ORANGE, GREEN, PURPLE)
MARKERS: Final = ("o", "s", "^", "D")
DASHES: Final[tuple[Any, ...]] = ("-", (0, (6, 2)), (0, (4, 2)), (0, (6, 2, 1, 2)), (0, (1, 1.5)))
CLOSED: Final = {"braking": (0, (8, 3)), "swerving": (0, (8, 3, 1.5, 3, 1.5, 3))}
FORMULAS: Final = {"braking": r"$v^2 / (2 \mu g)$", "swerving": r"$v \sqrt{2 w / (\mu g)}$"}
TURN: Final[dict[str, Any]] = {"linestyle": ":", "linewidth": 0.8, "marker": "v", "markerfacecolor": "none"}
PANEL_HEIGHT: Final = 2.5  # [inch]
HEAD: Final = 0.9  # for the legend [inch]
LOWEST, HIGHEST = 0.75, 1.35  # of the limits, between which the axes go [1]


def write_figure(found: Map, path: Path) -> None:
    """Write the figure to a .png or .pdf file; OSError as the file system says."""
    save(map_figure(found), path)


@styled
def map_figure(found: Map) -> Figure:
    """A panel for each friction and offset, then one for the torques where both limits are known."""
    every, has_torques = panels(found), {BOTH, INDIVIDUAL} <= {*found.limits}
    n_rows = ceil((len(every) + has_torques) / 2)
    where = f"{printable(found.scenario)} on {found.plant}, seed {found.seed}"
    text = f"{where}: boundaries to within {found.tolerance:g} m, {len(found.runs)} runs, swerve {__version__}."
    figure = captioned_figure(text, HEAD + PANEL_HEIGHT * n_rows)
    places = list(figure.subplots(n_rows, 2, squeeze=False).flat)
    for axes, panel in zip(places, every, strict=False):
        _draw_panel(axes, found, panel)
    if has_torques:
        _draw_torques(places[len(every)], found, every)
    for axes in places[len(every) + has_torques :]:
        axes.remove()
    figure.legend(*places[0].get_legend_handles_labels(), loc="outside upper center", ncols=4)
    _settle(figure)
    return figure


def _settle(figure: Figure) -> None:
    """Keep the layout, rounded: its solver's last digit differs from time to time, and so would the files' bytes."""
    figure.draw_without_rendering()
    figure.set_layout_engine("none")
    for axes in figure.axes:
        left, bottom, width, height = (round(edge, 6) for edge in axes.get_position().bounds)
        axes.set_position((left, bottom, width, height))


def _draw_panel(axes: Axes, found: Map, panel: Panel) -> None:
    cells = conditions_of(found, panel)
    speeds = [each.speed for each in cells]
    closed = closed_forms(found, panel)
    for name, dashes in CLOSED.items():
        axes.plot(closed["speeds"], closed[name], color=GREY, linestyle=dashes, linewidth=1.0, label=FORMULAS[name])
    for i, who in enumerate(found.limits):
        line = {"color": BLACK, "linestyle": DASHES[i % len(DASHES)], "linewidth": 1.0, "marker": ".", "markersize": 3}
        axes.plot(speeds, _distances(found, who, cells), label=who, **line)
    for i, who in enumerate(found.controllers):
        look = _look(i)
        axes.plot(speeds, _distances(found, who, cells), label=who, **look)
        turns = [_number(boundary.turns if (boundary := found.boundary(who, each)) else None) for each in cells]
        axes.plot(speeds, turns, color=look["color"], **TURN)
    axes.plot([], [], color=GREY, label="braking turns to steering", **TURN)
    _set_range(axes, found, cells)
    axes.set_title(panel_name(found, panel), fontsize=8.0)
    axes.set(xlabel="speed $v$ [m/s]", ylabel="distance [m]")


def _draw_torques(axes: Axes, found: Map, every: list[Panel]) -> None:
    for i, panel in enumerate(every):
        cells = conditions_of(found, panel)
        metres = [_number(bought(found, each)) for each in cells]
        axes.plot([each.speed for each in cells], metres, label=panel_name(found, panel), **_look(i))
    axes.set_title("what the four wheel torques buy", fontsize=8.0)
    axes.set(xlabel="speed $v$ [m/s]", ylabel="both less individual [m]")
    axes.set_xlim(*ends(found))
    axes.set_ylim(bottom=min(0.0, axes.get_ylim()[0]))
    axes.legend()


def _look(index: int) -> dict[str, Any]:
    colour, marker = COLOURS[index % len(COLOURS)], MARKERS[(index + index // len(COLOURS)) % len(MARKERS)]
    return {"color": colour, "marker": marker, "markersize": 3.5}


def _set_range(axes: Axes, found: Map, cells: list[Condition]) -> None:
    """Round the limits of all means, where there are any: braking alone would lead far beyond."""
    axes.set_xlim(*ends(found))
    known = [value for who in (BOTH, INDIVIDUAL) for each in cells if (value := avoided(found, who, each)) is not None]
    if known:
        axes.set_ylim(LOWEST * min(known), HIGHEST * max(known))
    low = axes.get_ylim()[0]
    allowed = _distances(found, INDIVIDUAL, cells)
    shade: dict[str, Any] = {
        "color": ORANGE,
        "alpha": 0.12,
        "linewidth": 0,
        "label": "no control was found that avoids",
    }
    axes.fill_between([each.speed for each in cells], low, allowed, **shade)


def _distances(found: Map, who: str, cells: list[Condition]) -> list[float]:
    return [_number(avoided(found, who, each)) for each in cells]


def _number(value: float | None) -> float:
    """NaN, which leaves a gap in a line, for None."""
    return float("nan") if value is None else value
