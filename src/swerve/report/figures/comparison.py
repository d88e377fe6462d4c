"""Several controllers in one scenario: their paths from above, and the measures of each."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import cycle
from math import degrees
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, MaxNLocator, NullLocator, ScalarFormatter

from swerve.errors import one_line
from swerve.report.figures.body import bodies
from swerve.report.figures.strips import add_axes, cut
from swerve.report.figures.style import (
    BLACK,
    BLUE,
    CAPTION_HEIGHT,
    GREY,
    LONGEST_NAME,
    WIDTH,
    printable,
    put_text,
    styled,
)
from swerve.report.figures.top_view import LABELLED, draw_obstacles, draw_road, label_names, label_obstacles
from swerve.report.figures.view import View, view_of, view_of_all
from swerve.simulate import Outcome, Result, Run
from swerve.study.comparison import Entry, Group

LINES: Final[tuple[dict[str, Any], ...]] = (  # a controller's; orange is the obstacles'
    {"color": BLUE, "linestyle": "-"},
    {"color": "#009E73", "linestyle": (0, (6, 1.5))},
    {"color": "#CC79A7", "linestyle": (0, (3, 1))},
    {"color": BLACK, "linestyle": (0, (1, 1))},
    {"color": "#E69F00", "linestyle": (0, (6, 1.5, 1, 1.5))},
    {"color": GREY, "linestyle": "-"},
)
ROW: Final = 0.21  # of a controller in the panels [inch]
PANELS_HEAD: Final = 0.42  # above the panels, for their titles [inch]
PANELS_FOOT: Final = 0.28  # below them, for the numbers [inch]
NAMES: Final = 1.5  # beside them, for the controllers [inch]
BETWEEN: Final = 0.16  # two panels [inch]
RIGHT: Final = 0.15  # [inch]


@dataclass(frozen=True)
class Panel:
    """What a panel shows of each result; of two values the second is drawn hollow."""

    title: str
    values: Callable[[Result], tuple[float | None, ...]]
    is_logarithmic: bool = False


PANELS: Final = (
    Panel("clearance\n[m]", lambda result: (result.min_clearance,)),
    Panel("impact\n[km/h]", lambda result: (_times(result.impact_speed, 3.6),)),
    Panel("sideslip\n[deg]", lambda result: (degrees(result.max_sideslip),)),
    Panel("excursion\n[m]", lambda result: (result.lateral_excursion,)),
    Panel(
        "friction [%]\nmax, \N{WHITE CIRCLE} mean",
        lambda result: (_times(result.max_friction_use, 100), _times(result.mean_friction_use, 100)),
    ),
    Panel(
        "step [ms]\nmedian, \N{WHITE CIRCLE} 99 %",
        lambda result: (1e3 * result.step_time.median, 1e3 * result.step_time.p99),
        is_logarithmic=True,
    ),
)


@styled
def comparison(group: Group) -> Figure:
    """Top view of all runs, of which there is one at least, and below it a row of panels."""
    runs = [each.run for each in group.entries if each.run is not None]
    view = view_of_all(runs)
    strips = cut(view.x, view.y)
    below = PANELS_HEAD + ROW * len(group.entries) + PANELS_FOOT
    figure = Figure(figsize=(WIDTH, strips.figure_height + below))
    for axes in add_axes(figure, strips):
        draw_road(axes, group.scenario.road.to_world())
        draw_obstacles(axes, view)
        _draw_paths(axes, group, view)
        label_names(axes, view)
        for time in view.times[::LABELLED]:
            label_obstacles(axes, view, time)
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="upper center", ncols=len(labels), columnspacing=1.2, handlelength=2.4)
    _add_panels(figure, group)
    put_text(figure, _caption(runs[0]))
    return figure


def _draw_paths(axes: Axes, group: Group, view: View) -> None:
    """A line for each run, a dot at every whole second, and where it was closest what must keep clear."""
    for entry, line in zip(group.entries, cycle(LINES), strict=False):
        if entry.run is None:
            continue
        own, vehicle = view_of(entry.run), group.scenario.ego.to_vehicle()
        axes.plot(*own.path.T, linewidth=1.3, zorder=3, label=entry.controller, **line)
        seconds = own.poses[np.isclose(own.times % 1.0, 0.0)]
        axes.plot(*seconds[:, :2].T, "o", color=line["color"], markersize=2.4, zorder=3.5)
        if own.closest is None:
            continue
        if group.scenario.ego.footprint == "point":
            axes.plot(*own.path[[own.closest]].T, "D", mfc="white", mec=line["color"], markersize=4, zorder=4)
        else:
            pose = entry.run.log.motion.stack("X", "Y", "psi")[[own.closest]]
            axes.fill(*bodies(vehicle, pose)[0].T, facecolor="none", edgecolor=line["color"], linewidth=0.9, zorder=3)


def _add_panels(figure: Figure, group: Group) -> None:
    """Side by side at the foot of the figure, with a row for each entry."""
    height, whole = ROW * len(group.entries), figure.get_figheight()
    room = (WIDTH - NAMES - RIGHT - BETWEEN * (len(PANELS) - 1)) / len(PANELS)
    for i, panel in enumerate(PANELS):
        left, bottom = NAMES + i * (room + BETWEEN), CAPTION_HEIGHT + PANELS_FOOT
        axes = figure.add_axes((left / WIDTH, bottom / whole, room / WIDTH, height / whole))
        _draw_panel(axes, panel, group)
        if i == 0:
            axes.set_yticks(range(len(group.entries)), [_label(each) for each in group.entries])
        axes.tick_params(axis="y", length=0, pad=7, labelleft=i == 0)


def _draw_panel(axes: Axes, panel: Panel, group: Group) -> None:
    if panel.is_logarithmic:
        axes.set_xscale("log")
    is_empty = True
    for row, (entry, line) in enumerate(zip(group.entries, cycle(LINES), strict=False)):
        values = () if entry.result is None else panel.values(entry.result)
        numbers = [value for value in values if value is not None]
        is_empty = is_empty and not numbers
        axes.plot(numbers, [row] * len(numbers), color=line["color"], linewidth=1.0)
        for value, fill in zip(values, (line["color"], "white"), strict=False):
            if value is not None:
                axes.plot([value], [row], "o", mfc=fill, mec=line["color"], markersize=4.5, clip_on=False)
    axes.set_title(panel.title, fontsize=7.5)
    axes.set_ylim(len(group.entries) - 0.5, -0.5)
    axes.set_yticks(range(len(group.entries)), [""] * len(group.entries))
    if is_empty:
        axes.set(xlim=(0, 1), xticks=[])
        axes.text(0.5, 0.5, "none", color=GREY, ha="center", va="center", transform=axes.transAxes)
    elif panel.is_logarithmic:
        axes.margins(x=0.12)
        axes.xaxis.set_major_locator(LogLocator(subs=_ticks(axes.dataLim.x1 / axes.dataLim.x0)))
        axes.xaxis.set_major_formatter(ScalarFormatter())
        axes.xaxis.set_minor_locator(NullLocator())
    else:
        axes.set_xlim(0.0, max(1.12 * axes.dataLim.x1, 1e-3))
        axes.xaxis.set_major_locator(MaxNLocator(3))


def _ticks(span: float) -> tuple[float, ...]:
    """Which multiples of powers of ten are labelled where the largest number is `span` times the smallest."""
    return (1.0, 2.0, 5.0) if span < 5 else (1.0, 3.0) if span < 20 else (1.0,)


def _label(entry: Entry) -> str:
    if entry.result is None:
        return f"{entry.controller}: refused"
    mark = "" if entry.result.outcome is Outcome.AVOIDED else f": {entry.result.outcome.value.replace('_', ' ')}"
    return f"{entry.controller}{mark}"


def _times(value: float | None, factor: float) -> float | None:
    return None if value is None else value * factor


def _caption(run: Run) -> str:
    result = run.result
    name = printable(one_line(result.scenario, LONGEST_NAME))
    about = f"{name} on {result.plant}, seed {result.seed}, swerve {result.version}"
    nearest = "diamond where the centre of gravity" if run.scenario.ego.footprint == "point" else "body where it"
    return f"{about}. A dot each second, the {nearest} was closest."
