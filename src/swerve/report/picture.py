"""Runs of one scene from above, as a small SVG picture: road, obstacles where the first vehicle was nearest, paths."""

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.report.figures.view import outline, view_of
from swerve.simulate import Run
from swerve.world import Road

Array = NDArray[np.float64]

MOST_POINTS: Final = 120  # of a path
SIZE: Final = (75.0, 18.0)  # of what is drawn, along X and Y [m]
BEHIND: Final = 25.0  # of it that are behind the place where the first vehicle is nearest to an obstacle [m]


def picture(runs: Sequence[Run], style: str = "") -> str:
    """The picture; its parts are the classes road, lane, obstacle and, run by run, path-1, path-2 and so on.

    Args:
        runs: the first one's closest approach is in the picture.
        style: the picture's own CSS, for one that stands alone.
    """
    view = view_of(runs[0])
    row = 0 if view.closest is None else view.closest
    time, (x, y) = runs[0].log.motion["time"][row], view.path[row] - (BEHIND, -SIZE[1] / 2)
    shapes = [_closed(outline(obstacle, np.array([time]))[0]) for obstacle in view.obstacles]
    sheet = f"<style>{style}</style>" if style else ""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{x:.2f} {-y:.2f} {SIZE[0]} {SIZE[1]}">{sheet}'
        f'<rect class="road" x="{x:.2f}" y="{-y:.2f}" width="{SIZE[0]}" height="{SIZE[1]}"/>'
        f"{_lines(runs[0].scenario.road.to_world(), (x, x + SIZE[0]))}"
        f'<path class="obstacle" d="{"".join(shapes)}"/>'
        f"{''.join(_path(view_of(run).path, x, i) for i, run in enumerate(runs, start=1))}</svg>"
    )


def _path(path: Array, x: float, number: int) -> str:
    near = path[(x <= path[:, 0]) & (path[:, 0] <= x + SIZE[0])]
    if len(near) == 0:
        return ""
    thin = near[np.unique(np.linspace(0, len(near) - 1, MOST_POINTS).astype(int))]
    return f'<path class="path-{number}" fill="none" stroke-width=".6" stroke-linejoin="round" d="{_open(thin)}"/>'


def _lines(road: Road, x: tuple[float, float]) -> str:
    edges = [edge for edge in (road.left_edge, road.right_edge, road.oncoming_edge) if edge is not None]
    return "".join(f'<path class="lane" stroke-width=".25" d="M{x[0]:.2f} {-y:.2f}H{x[1]:.2f}"/>' for y in edges)


def _open(points: Array) -> str:
    """Points (n, 2) [m] as a path; on the picture y points down."""
    return "M" + "L".join(f"{x:.2f} {-y:.2f}" for x, y in points.tolist())


def _closed(points: Array) -> str:
    return f"{_open(points)}Z"
