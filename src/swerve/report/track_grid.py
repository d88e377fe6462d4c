"""The places of characters that a drawing of text is made of, over a stretch of road."""

from dataclasses import dataclass
from math import ceil, floor, log10
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.world import Obstacle, Road

Array = NDArray[np.float64]
Seen = tuple[Obstacle, float, float]  # an obstacle, the time [s] at which the vehicle was nearest, how near [m]

TALLEST: Final = 11  # [line]
LINE: Final = 0.5  # least height of a line [m]
LONGEST: Final = 200.0  # stretch of road; of a longer run, the one round the closest approach [m]
NEAR: Final = 10.0  # to the vehicle, of obstacles for which there is made room [m]
LABEL: Final = 7  # width of a line's label [character]
TICK: Final = 12  # least distance of labels along X [character]


@dataclass(frozen=True)
class Grid:
    """Places over a stretch of road.

    Attributes:
        x: left end of it [m].
        y: upper end of it [m].
        cell: width and height of a place [m].
        shape: number of lines, and of places in each.
    """

    x: float
    y: float
    cell: tuple[float, float]
    shape: tuple[int, int]

    @property
    def centres(self) -> Array:
        """Of each place, (lines, places, 2) [m]."""
        n, m = self.shape
        x, y = self.x + (np.arange(m) + 0.5) * self.cell[0], self.y - (np.arange(n) + 0.5) * self.cell[1]
        return np.stack(np.meshgrid(x, y), axis=-1)

    @property
    def labels(self) -> list[str]:
        """Y of the middle of every other line, that of Y = 0 among them, and blanks for the others."""
        middles = self.centres[:, 0, 1]
        zero = int(np.abs(middles).argmin())
        texts = [f"{round(y, 1) + 0.0:.1f} m" if (i - zero) % 2 == 0 else "" for i, y in enumerate(middles.tolist())]
        return [text.rjust(LABEL) for text in texts]

    @property
    def ruler(self) -> str:
        """X at round numbers, each beginning at its place."""
        step = _round_step(self.cell[0] * TICK)
        text = ""
        for k in range(ceil(self.x / step), floor((self.x + self.cell[0] * self.shape[1]) / step) + 1):
            at, label = int((k * step - self.x) / self.cell[0]), f"{k * step:g} m"
            if at + len(label) <= self.shape[1]:
                text = text.ljust(at) + label
        return text

    def line(self, y: float) -> int | None:
        """The line in which Y = y is; None outside."""
        i = floor((self.y - y) / self.cell[1])
        return i if 0 <= i < self.shape[0] else None


def grid_over(road: Road, rows: Array, seen: list[Seen], width: int) -> Grid:
    """The grid that holds the path, the road's edges, and obstacles that came near.

    Args:
        road: with edges or without.
        rows: of the motion, (n, 4): time [s], X [m], Y [m], psi [rad].
        seen: the obstacles.
        width: of the grid [character].
    """
    left, right = _stretch(rows, seen)
    values = [*_edges(road), -LINE, LINE, *rows[(left <= rows[:, 1]) & (rows[:, 1] <= right), 2]]
    for obstacle, time, gap in seen:
        if gap < NEAR:
            y = obstacle.position_at(time)[1]
            heading = obstacle.heading_at(time)
            leftwards = np.array([[np.sin(heading), np.cos(heading)]])  # as the obstacle sees it
            values += [y + obstacle.shape.support(leftwards)[0], y - obstacle.shape.support(-leftwards)[0]]
    low, high = float(min(values)), float(max(values))
    height = max(LINE, (high - low) / (TALLEST - 1))
    below, above = ceil(low / height - 0.5), floor(high / height + 0.5)  # Y = 0 is the middle of a line
    return Grid(left, (above + 0.5) * height, ((right - left) / width, height), (above - below + 1, width))


def _stretch(rows: Array, seen: list[Seen]) -> tuple[float, float]:
    """The stretch of X that the path covers [m], or as much of it round the closest approach as is drawn."""
    left, right = float(rows[:, 1].min()), float(rows[:, 1].max())
    if right - left <= LONGEST:
        return left, right
    time = min(seen, key=lambda each: each[2])[1] if seen else rows[0, 0]
    middle = float(rows[rows[:, 0] == time, 1][0])
    start = float(np.clip(middle - LONGEST / 2, left, right - LONGEST))
    return start, start + LONGEST


def _edges(road: Road) -> list[float]:
    return [edge for edge in (road.left_edge, road.right_edge) if edge is not None]


def _round_step(least: float) -> float:
    """1, 2, 5 or 10 times a power of ten, not below `least`."""
    power = 10.0 ** floor(log10(least))
    return next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if factor * power >= least)
