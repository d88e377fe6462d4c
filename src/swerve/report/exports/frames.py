"""The top view in motion: pictures of a stretch of road that goes with the vehicle, at equal times.

The picture has one scale along X and Y. It shows the vehicle with its wheels turned, the obstacles where they are at
that time, the lanes, and where the centre of gravity has been.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.ticker import MultipleLocator
from numpy.typing import NDArray

from swerve.report.figures.body import bodies, wheels
from swerve.report.figures.style import BLACK, BLUE, GREY, ORANGE, SKY, caption, styled
from swerve.report.figures.top_view import DOUBLE_LINE
from swerve.report.figures.view import FARTHEST, outline
from swerve.simulate import Run

Array = NDArray[np.float64]
Picture = NDArray[np.uint8]

RATE: Final = 20  # pictures for a second, at most
MOST: Final = 400  # pictures; a longer run has fewer for a second [1]
TICK: Final = 0.01  # of which the time between pictures is a multiple, as GIF has it [s]
SIZE: Final = (960, 320)  # of a picture [pixel]; even numbers, as video has it
DPI: Final = 100
PANEL: Final = (0.055, 0.2, 0.93, 0.68)  # of the picture: left, bottom, width, height [1]
STRETCH: Final = 60.0  # of road along X in a picture [m]
BEHIND: Final = 20.0  # of it that are behind the centre of gravity [m]


@dataclass(frozen=True, eq=False)
class Frames:
    """The pictures of a run.

    Attributes:
        run: what they show.
        interval: between two of them, in the run and when they are played [s].
        rows: of the log's motion, one for each picture (n,).
    """

    run: Run
    interval: float
    rows: NDArray[np.intp]

    @classmethod
    def of(cls, run: Run) -> "Frames":
        """The pictures of all that is a motion: not of what comes after a run diverged."""
        motion = run.log.motion
        n = int(np.append((np.abs(motion.stack("X", "Y", "psi", "delta")) < FARTHEST).all(axis=1), False).argmin())
        times = motion["time"][: max(n, 1)]
        ticks = max(round(1 / RATE / TICK), ceil(round((times[-1] - times[0]) / MOST / TICK, 6)))
        interval = ticks * TICK
        wanted = np.arange(times[0], times[-1] + interval / 2, interval)
        return cls(run, interval, np.clip(np.searchsorted(times, wanted - 1e-9), 0, len(times) - 1))

    def draw(self) -> Iterator[Picture]:
        """Each picture (height, width, 3), red, green and blue from 0 to 255."""
        stage = _Stage(self.run)
        for row in self.rows:
            yield stage.at(row)


class _Stage:
    """A figure that is drawn again and again, with what moves in other places."""

    @styled
    def __init__(self, run: Run) -> None:
        self._run, self._vehicle = run, run.scenario.ego.to_vehicle()
        self._obstacles = [obstacle.to_world() for obstacle in run.scenario.obstacles]
        figure = Figure(figsize=(SIZE[0] / DPI, SIZE[1] / DPI), dpi=DPI)
        self._canvas: Any = FigureCanvasAgg(figure)  # which has no types
        self._axes = figure.add_axes(PANEL)
        self._axes.set(xlabel="$X$ [m]", ylabel="$Y$ [m]")
        self._axes.xaxis.set_major_locator(MultipleLocator(10))
        self._height = STRETCH * PANEL[3] * SIZE[1] / (PANEL[2] * SIZE[0])  # [m]
        self._text = figure.text(0.055, 0.92, "", fontsize=9, fontweight="bold")
        figure.text(0.985, 0.92, caption(run), fontsize=7, color=GREY, ha="right", parse_math=False)
        if run.scenario.ego.footprint == "point":
            figure.text(0.985, 0.04, "the dot has to keep clear", fontsize=7, color=GREY, ha="right")
        _draw_road(self._axes, run)
        (self._path,) = self._axes.plot([], [], color=BLACK, linewidth=1.2, zorder=3)
        self._others = _add(self._axes, facecolors="#F6D5C3", edgecolors=ORANGE, hatch="////", linewidths=1)
        self._body = _add(self._axes, facecolors=SKY, edgecolors=BLUE, linewidths=1.2)
        self._wheels = _add(self._axes, facecolors=BLACK, linewidths=0)
        (self._dot,) = self._axes.plot([], [], "o", color=BLACK, markersize=4, zorder=4)

    @styled
    def at(self, row: int) -> Picture:
        """The picture at a row of the log's motion."""
        motion = self._run.log.motion
        poses = motion.stack("X", "Y", "psi")
        self._look_at(poses[row, 0], poses[row, 1])
        self._path.set_data(*poses[: row + 1, :2].T)
        self._dot.set_data(*poses[row : row + 1, :2].T)
        self._others.set_verts([outline(each, motion["time"][row : row + 1])[0] for each in self._obstacles])
        self._body.set_verts(list(bodies(self._vehicle, poses[row : row + 1])))
        self._wheels.set_verts(list(wheels(self._vehicle, poses[row : row + 1], motion["delta"][row : row + 1])))
        speed = np.hypot(motion["vx"][row], motion["vy"][row]) * 3.6
        self._text.set_text(f"{motion['time'][row]:.2f} s   {speed:.0f} km/h")
        self._canvas.draw()
        return np.array(self._canvas.buffer_rgba())[..., :3]

    def _look_at(self, x: float, y: float) -> None:
        """Move the window along X with the vehicle, and along Y where it would leave the window otherwise."""
        middle = float(np.sign(y) * max(abs(y) - self._height / 4, 0.0))
        self._axes.set_xlim(x - BEHIND, x - BEHIND + STRETCH)
        self._axes.set_ylim(middle - self._height / 2, middle + self._height / 2)


def _draw_road(axes: Axes, run: Run) -> None:
    road = run.scenario.road.to_world()
    if road.lane_width is None:
        return
    lines = [(k + 0.5) * road.lane_width for k in range(-road.lanes_right - 1, road.lanes_left + 1)]
    for y in lines:
        if y in (lines[0], lines[-1]):
            axes.axhline(y, color=BLACK, linewidth=1.8, zorder=1)
        elif y == road.oncoming_edge:
            for half in (-DOUBLE_LINE / 2, DOUBLE_LINE / 2):
                axes.axhline(y + half, color=BLACK, linewidth=0.9, zorder=1)
        else:
            axes.axhline(y, color=GREY, linewidth=1, dashes=(10, 8), zorder=1)


def _add(axes: Axes, **style: Any) -> PolyCollection:
    """A collection without polygons yet."""
    collection = PolyCollection([], zorder=2, **style)
    axes.add_collection(collection, autolim=False)
    return collection
