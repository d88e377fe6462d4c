"""A run from above as a small SVG picture: road, obstacles where the vehicle was nearest to them, and its path."""

from functools import lru_cache
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.report.exports.folder import read_run_folder
from swerve.report.figures.view import outline, view_of
from swerve.simulate import Run
from swerve.world import Road

Array = NDArray[np.float64]

MOST_POINTS: Final = 120  # of the path
SIZE: Final = (75.0, 18.0)  # of what is drawn, along X and Y [m]
BEHIND: Final = 25.0  # of it that are behind the place where the vehicle is nearest to an obstacle [m]
STYLE: Final = (
    "rect{fill:#e9ecf0}.o{fill:#b84a00}.p{stroke:#006fae}.l{stroke:#75808b}"
    "@media(prefers-color-scheme:dark){rect{fill:#20262d}.o{fill:#f0883e}.p{stroke:#56b4e9}.l{stroke:#84909c}}"
)


@lru_cache(maxsize=500)
def thumbnail(directory: Path, changed: float) -> str:
    """The picture of the run in a folder; `changed`, when it was written, is there to keep old ones from being shown.

    Raises:
        InputError: the folder cannot be read.
    """
    del changed
    return thumbnail_of(read_run_folder(directory))


def thumbnail_of(run: Run) -> str:
    """The picture of a run."""
    view = view_of(run)
    row = 0 if view.closest is None else view.closest
    time, (x, y) = run.log.motion["time"][row], view.path[row] - (BEHIND, -SIZE[1] / 2)
    near = view.path[(x <= view.path[:, 0]) & (view.path[:, 0] <= x + SIZE[0])]
    path = near[np.unique(np.linspace(0, len(near) - 1, MOST_POINTS).astype(int))]
    shapes = [_closed(outline(obstacle, np.array([time]))[0]) for obstacle in view.obstacles]
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{x:.2f} {-y:.2f} {SIZE[0]} {SIZE[1]}"><style>{STYLE}</style>'
        f'<rect x="{x:.2f}" y="{-y:.2f}" width="{SIZE[0]}" height="{SIZE[1]}"/>'
        f"{_lines(run.scenario.road.to_world(), (x, x + SIZE[0]))}"
        f'<path class="o" d="{"".join(shapes)}"/>'
        f'<path class="p" fill="none" stroke-width=".6" stroke-linejoin="round" d="{_open(path)}"/></svg>'
    )


def _lines(road: Road, x: tuple[float, float]) -> str:
    edges = [edge for edge in (road.left_edge, road.right_edge, road.oncoming_edge) if edge is not None]
    return "".join(f'<path class="l" stroke-width=".25" d="M{x[0]:.2f} {-y:.2f}H{x[1]:.2f}"/>' for y in edges)


def _open(points: Array) -> str:
    """Points (n, 2) [m] as a path; on the picture y points down."""
    return "M" + "L".join(f"{x:.2f} {-y:.2f}" for x, y in points.tolist())


def _closed(points: Array) -> str:
    return f"{_open(points)}Z"
