"""The manoeuvre from above: Fig. 7 of the paper.

The vehicle's body every quarter of a second, the path of its centre of gravity, the obstacles at the same instants, and
the lanes where the road has any.
"""

from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from numpy.typing import NDArray

from swerve.report.figures.body import bodies, wheels
from swerve.report.figures.strips import add_axes, cut
from swerve.report.figures.style import BLACK, BLUE, GREY, ORANGE, WIDTH, put_caption, styled
from swerve.report.figures.view import View, outline, view_of
from swerve.simulate import Run
from swerve.vehicle import Vehicle
from swerve.world import Road

Array = NDArray[np.float64]

LABELLED: Final = 4  # one instant in so many
LABEL_ROOM: Final = 0.35  # between two labels [inch]
POINT: Final = 1 / 72  # [inch]


@styled
def top_view(run: Run) -> Figure:
    """The manoeuvre from above, to one scale along X and Y."""
    view, vehicle = view_of(run), run.scenario.ego.to_vehicle()
    strips = cut(view.x, view.y)
    figure = Figure(figsize=(WIDTH, strips.figure_height))
    panels = add_axes(figure, strips)
    for axes in panels:
        _draw_road(axes, run.scenario.road.to_world())
        _draw_obstacles(axes, view)
        _draw_vehicle(axes, view, vehicle, is_point=run.scenario.ego.footprint == "point")
        _label(axes, view, strips.scale, above=vehicle.width / 2)
    figure.legend(*panels[0].get_legend_handles_labels(), loc="upper center", ncols=4)
    put_caption(figure, run)
    return figure


def _draw_road(axes: Axes, road: Road) -> None:
    if road.lane_width is None:
        return
    for k in range(-road.lanes_right - 1, road.lanes_left + 1):
        is_edge = k in (-road.lanes_right - 1, road.lanes_left)
        style = {"color": BLACK, "linewidth": 1.4} if is_edge else {"color": GREY, "linewidth": 0.8, "dashes": (8, 6)}
        axes.axhline((k + 0.5) * road.lane_width, zorder=1, **style)


def _draw_obstacles(axes: Axes, view: View) -> None:
    for i, obstacle in enumerate(view.obstacles):
        moves = any(obstacle.velocity)
        times = view.times if moves else view.times[:1]
        axes.add_collection(
            PolyCollection(
                outline(obstacle, times),
                facecolors="none" if moves else "#F6D5C3",
                edgecolors=ORANGE,
                hatch=None if moves else "////",
                linewidths=0.8,
                zorder=2,
                label="obstacle" if i == 0 else None,
            ),
            autolim=False,
        )


def _draw_vehicle(axes: Axes, view: View, vehicle: Vehicle, *, is_point: bool) -> None:
    outlines = bodies(vehicle, view.poses)
    axes.add_collection(
        PolyCollection(
            outlines, facecolors=(0, 0.45, 0.70, 0.10), edgecolors=BLUE, linewidths=0.7, zorder=3, label="body"
        ),
        autolim=False,
    )
    turned = wheels(vehicle, view.poses, view.steering)
    axes.add_collection(PolyCollection(turned, facecolors=BLACK, linewidths=0, zorder=4), autolim=False)
    footprint = " (the footprint)" if is_point else ""
    axes.plot(*view.path.T, color=BLACK, linewidth=1.0, zorder=5, label=f"centre of gravity{footprint}")
    if view.closest is not None:
        x, y = view.path[view.closest]
        axes.plot([x], [y], "D", markersize=3.5, mfc="white", mec=BLACK, mew=0.9, zorder=6, ls="", label="closest")


def _label(axes: Axes, view: View, scale: float, above: float) -> None:
    """The time beside every whole second's vehicle, and in the obstacles that move, where there is room for it."""
    style = {"ha": "center", "annotation_clip": True, "fontsize": 6.5, "zorder": 7}
    last = np.full(2, np.inf)
    for time, pose in zip(view.times[::LABELLED], view.poses[::LABELLED], strict=True):
        if np.hypot(*(pose[:2] - last)) * scale < LABEL_ROOM:
            continue
        last = pose[:2]
        lift = above * scale / POINT + 2
        axes.annotate(
            f"{time:.0f} s", pose[:2], (0, lift), textcoords="offset points", va="bottom", color=BLUE, **style
        )
        for obstacle in view.obstacles:
            if any(obstacle.velocity):
                axes.annotate(f"{time:.0f} s", obstacle.position_at(time), va="center", color=ORANGE, **style)
