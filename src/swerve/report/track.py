"""The manoeuvre from above in a few lines of text: lanes, obstacles, the path of the centre of gravity.

X goes along the terminal's line. Y is stretched, so that a lane is a few lines high; its scale stands at the left. An
obstacle that moves is where it was when the vehicle was nearest to it.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import groupby
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.report.track_grid import LABEL, Grid, Seen, grid_over
from swerve.simulate import Run
from swerve.simulate.outcome import ABSURD
from swerve.world import Rectangle, Road, clearance

Array = NDArray[np.float64]
Paint = Callable[[str, str], str]  # what a part of the drawing is, and its characters -> the characters in colour
Place = tuple[str, str]  # what is in a place: the part's name, "" for nothing, and its character

NARROWEST: Final = 45  # drawing; in less room there is none [character]
WIDEST: Final = 110  # [character]
SHORTEST: Final = 1.0  # path along X that is drawn [m]
BRAILLE: Final = 0x2800  # the character without a dot; each dot adds a bit
BITS: Final = ((0x01, 0x02, 0x04, 0x40), (0x08, 0x10, 0x20, 0x80))  # of the dots of its two columns, from above


@dataclass(frozen=True)
class Charset:
    """What a drawing is made of.

    Attributes:
        edge: of the road.
        lane: between lanes.
        oncoming: between the lanes of both directions.
        obstacle: a part of one.
        path: a part of the path.
        axis: of Y.
        is_fine: whether the path is made of Braille dots in place of `path`.
    """

    edge: str
    lane: str
    oncoming: str
    obstacle: str
    path: str
    axis: str
    is_fine: bool


ASCII: Final = Charset("=", "-", ":", "#", "*", "|", is_fine=False)
UNICODE: Final = Charset(
    "\N{BOX DRAWINGS HEAVY HORIZONTAL}",
    "-",
    "\N{BOX DRAWINGS DOUBLE HORIZONTAL}",
    "\N{FULL BLOCK}",
    "\u2812",
    "\u2502",
    is_fine=True,
)


def track(run: Run, width: int, charset: Charset, paint: Paint = lambda part, text: text) -> str:
    """The drawing, with a line of X and a legend below it.

    Args:
        run: that is over.
        width: of the terminal [character].
        charset: what it is made of.
        paint: what colours a part's characters: "edge", "lane", "oncoming", "obstacle" or "path".

    Returns:
        The lines; "" where there is no room, or the vehicle went nowhere along X.
    """
    motion, road = run.log.motion, run.scenario.road.to_world()
    rows = motion.stack("time", "X", "Y", "psi")
    rows = rows[(np.abs(rows) < ABSURD).all(axis=1)]  # a run that diverged ends in others
    room = min(width, WIDEST) - LABEL - 3
    if room + LABEL + 3 < NARROWEST or np.ptp(rows[:, 1]) < SHORTEST:
        return ""
    seen = _seen(run, rows)
    grid = grid_over(road, rows, seen, room)
    lines = [_painted(line, paint) for line in _places(grid, road, rows, seen, charset)]
    obstacle = f"{paint('obstacle', charset.obstacle)} obstacle, " if seen else ""
    below = [grid.ruler, f"{obstacle}{paint('path', charset.path)} centre of gravity"]
    return "\n".join(
        [f"{label} {charset.axis}{line}".rstrip() for label, line in zip(grid.labels, lines, strict=True)]
        + [" " * (LABEL + 2) + each for each in below]
    )


def _seen(run: Run, rows: Array) -> list[Seen]:
    footprint, seen = run.scenario.ego.to_footprint(), []
    for settings in run.scenario.obstacles:
        obstacle = settings.to_world()
        gaps = clearance(footprint, rows[:, 1:4], obstacle, rows[:, 0])
        seen.append((obstacle, float(rows[gaps.argmin(), 0]), float(gaps.min())))
    return seen


def _places(grid: Grid, road: Road, rows: Array, seen: list[Seen], charset: Charset) -> list[list[Place]]:
    """What is in each place, by lines; what is drawn last counts."""
    n, m = grid.shape
    places = [[("", " ")] * m for _ in range(n)]
    characters = {"edge": charset.edge, "lane": charset.lane, "oncoming": charset.oncoming}
    for y, name in _road_lines(road):
        i = grid.line(y)
        if i is not None:
            places[i] = [(name, characters[name])] * m
    poses = np.column_stack([grid.centres.reshape(-1, 2), np.zeros(n * m)])
    for obstacle, time, _ in seen:
        is_touched = clearance(Rectangle(*grid.cell), poses, obstacle, np.full(n * m, time)) <= 0
        for i, j in np.argwhere(is_touched.reshape(n, m)):
            places[i][j] = ("obstacle", charset.obstacle)
    for (i, j), character in _path(grid, rows, charset).items():
        places[i][j] = ("path", character)
    return places


def _road_lines(road: Road) -> list[tuple[float, str]]:
    """Y [m] and kind of each line along the road."""
    if road.lane_width is None or road.left_edge is None or road.right_edge is None:
        return []
    n = road.lanes_left + road.lanes_right + 1
    kinds = {n - road.lanes_oncoming: "oncoming", 0: "edge", n: "edge"}
    return [(road.right_edge + k * road.lane_width, kinds.get(k, "lane")) for k in range(n + 1)]


def _path(grid: Grid, rows: Array, charset: Charset) -> Mapping[tuple[int, int], str]:
    """The characters of the path, by line and place."""
    across, down = (2, 4) if charset.is_fine else (1, 1)
    n, m = grid.shape
    columns = np.floor((rows[:, 1] - grid.x) / grid.cell[0] * across).astype(int)
    lines = np.floor((grid.y - rows[:, 2]) / grid.cell[1] * down).astype(int)
    is_inside = (columns >= 0) & (columns < m * across) & (lines >= 0) & (lines < n * down)
    bits: dict[tuple[int, int], int] = {}
    for i, j in np.unique(np.column_stack([lines, columns])[is_inside], axis=0).tolist():
        place = (i // down, j // across)
        bits[place] = bits.get(place, 0) | BITS[j % across][i % down]
    return {place: chr(BRAILLE + dots) if charset.is_fine else charset.path for place, dots in bits.items()}


def _painted(line: list[Place], paint: Paint) -> str:
    """The characters of a line, neighbours of one part painted together."""
    pieces = [(part, "".join(each[1] for each in places)) for part, places in groupby(line, key=lambda each: each[0])]
    return "".join(paint(part, text) if part else text for part, text in pieces)
