"""The manoeuvre from above: Fig. 7 of the paper.

The vehicle's body every quarter of a second, the path of its centre of gravity, the obstacles at the same instants, and
the lanes where the road has any.
"""

from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

from swerve.errors import one_line
from swerve.report.figures.body import bodies, wheels
from swerve.report.figures.strips import add_axes, cut
from swerve.report.figures.style import BLACK, BLUE, GREY, ORANGE, WIDTH, printable, put_caption, styled
from swerve.report.figures.view import EVERY, View, is_moving, outline, view_of, within
from swerve.simulate import Run
from swerve.vehicle import Vehicle
from swerve.world import Road

Array = NDArray[np.float64]

LABELLED: Final = 4  # one instant in so many, which is a whole second: drawn in full, and labelled
LABEL_ROOM: Final = 0.35  # between two labels [inch]
LABEL_OFFSET: Final = 5.5  # from what is labelled to the middle of the label [point]

DOUBLE_LINE: Final = 0.3  # between the two lines that part the directions [m]
LONGEST_LABEL: Final = 20  # characters of an obstacle's name

PALE_BLUE: Final = (0.0, 0.45, 0.70, 0.18)  # lets those below show
PALE_ORANGE: Final = "#F6D5C3"
PALE_GREY: Final = "#9A9A9A"


@styled
def top_view(run: Run) -> Figure:
    """The manoeuvre from above, to one scale along X and Y."""
    view, vehicle = view_of(run), run.scenario.ego.to_vehicle()
    strips = cut(view.x, view.y)
    figure = Figure(figsize=(WIDTH, strips.figure_height))
    panels = add_axes(figure, strips)
    for axes in panels:
        draw_road(axes, run.scenario.road.to_world())
        draw_obstacles(axes, view)
        _draw_vehicle(axes, view, vehicle, is_point=run.scenario.ego.footprint == "point")
        _label_instants(axes, view, strips.scale, vehicle.width / 2)
        label_names(axes, view)
    figure.legend(*panels[0].get_legend_handles_labels(), loc="upper center", ncols=4)
    put_caption(figure, run)
    return figure


def draw_road(axes: Axes, road: Road) -> None:
    """Edges and lines between lanes, where the road has any."""
    if road.lane_width is None:
        return
    lines = [(k + 0.5) * road.lane_width for k in range(-road.lanes_right - 1, road.lanes_left + 1)]
    for edge in (lines[0], lines[-1]):
        axes.axhline(edge, color=BLACK, linewidth=1.4, zorder=1)
    for between in lines[1:-1]:
        if between == road.oncoming_edge:
            for half in (-DOUBLE_LINE / 2, DOUBLE_LINE / 2):
                axes.axhline(between + half, color=BLACK, linewidth=0.6, zorder=1)
        else:
            axes.axhline(between, color=GREY, linewidth=0.8, dashes=(8, 6), zorder=1)


def draw_obstacles(axes: Axes, view: View) -> None:
    """Every obstacle at each instant, at whole seconds in full."""
    label = "obstacle"
    for obstacle in view.obstacles:
        outlines = outline(obstacle, view.times if is_moving(obstacle, view.times) else view.times[:1])
        is_shown = within(outlines[..., 0], *view.x).any(axis=1)
        is_full = is_shown & (np.arange(len(outlines)) % LABELLED == 0)
        _add(axes, outlines[is_shown & ~is_full], facecolors="none", edgecolors=PALE_ORANGE, linewidths=0.6)
        if is_full.any():
            style = {"facecolors": PALE_ORANGE, "edgecolors": ORANGE, "hatch": "////", "linewidths": 0.8}
            _add(axes, outlines[is_full], label=label, **style)
            label = ""


def _draw_vehicle(axes: Axes, view: View, vehicle: Vehicle, *, is_point: bool) -> None:
    is_full = np.arange(len(view.times)) % LABELLED == 0
    brief = {"facecolors": "none", "edgecolors": BLUE, "linewidths": 0.5}
    full = {"facecolors": PALE_BLUE, "edgecolors": BLUE, "linewidths": 0.9, "label": f"vehicle, every {EVERY:g} s"}
    for rows, body_style, tyre_colour in ((~is_full, brief, PALE_GREY), (is_full, full, BLACK)):
        _add(axes, bodies(vehicle, view.poses[rows]), **body_style)
        _add(axes, wheels(vehicle, view.poses[rows], view.steering[rows]), facecolors=tyre_colour, linewidths=0)
    judged = ", which must keep clear" if is_point else ""
    axes.plot(*view.path.T, color=BLACK, linewidth=1.0, zorder=3, label=f"centre of gravity{judged}")
    if view.closest is not None:
        x, y = view.path[view.closest]
        axes.plot([x], [y], "D", mfc="white", mec=BLACK, markersize=3.5, zorder=4, label="closest")


def _add(axes: Axes, polygons: Array, **style: Any) -> None:
    """Add polygons (n, k, 2) [m] on top of those that are there."""
    axes.add_collection(PolyCollection(list(polygons), zorder=2, **style), autolim=False)


def _label_instants(axes: Axes, view: View, scale: float, half_width: float) -> None:
    """The time left of the vehicle at every whole second, and below obstacles that move, where there is room for it."""
    last = np.full(2, np.inf)
    for time, pose in zip(view.times[::LABELLED], view.poses[::LABELLED], strict=True):
        if np.hypot(*(pose[:2] - last)) * scale < LABEL_ROOM:
            continue
        last, left = pose[:2], np.array([-np.sin(pose[2]), np.cos(pose[2])])
        _label(axes, f"{time:g} s", last + half_width * left, left, BLUE)
        label_obstacles(axes, view, time)


def label_obstacles(axes: Axes, view: View, time: float) -> None:
    """The time [s] below each obstacle that moves, where it is then."""
    for obstacle in view.obstacles:
        if is_moving(obstacle, view.times):
            lowest = outline(obstacle, np.array([time]))[0, :, 1].min()
            centre = obstacle.position_at(time)[0]
            _label(axes, f"{time:g} s", np.array([centre, lowest]), np.array([0.0, -1.0]), ORANGE)


def label_names(axes: Axes, view: View) -> None:
    """The name of each obstacle that has one, above the first of its outlines that are drawn."""
    for obstacle, name in zip(view.obstacles, view.names, strict=True):
        outlines = outline(obstacle, view.times)
        shown = outlines[within(outlines[..., 0], *view.x).any(axis=1)]
        if name is not None and len(shown):
            middle = np.clip(shown[0, :, 0].mean(), *view.x)
            text = printable(one_line(name, LONGEST_LABEL))
            _label(axes, text, np.array([middle, shown[0, :, 1].max()]), np.array([0.0, 1.0]), ORANGE)


def _label(axes: Axes, text: str, position: Array, away: Array, color: str) -> None:
    """A text beside a position (2,) [m], in the direction `away` (2,) from it."""
    axes.annotate(
        text,
        (position[0], position[1]),
        (LABEL_OFFSET * away[0], LABEL_OFFSET * away[1]),
        textcoords="offset points",
        ha="center",
        va="center",
        color=color,
        fontsize=6.5,
        annotation_clip=True,
        parse_math=False,
        path_effects=[withStroke(linewidth=2.0, foreground="white")],
    )
