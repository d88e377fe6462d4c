"""A long, narrow map on a page: cut into strips of one scale, one below the other."""

from dataclasses import dataclass
from typing import Final

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swerve.report.figures.style import CAPTION_HEIGHT, WIDTH

LEFT: Final = 0.55  # of the axes, for the labels of Y [inch]
RIGHT: Final = 0.15  # [inch]
HEAD: Final = 0.38  # above the first strip, for the legend [inch]
FOOT: Final = 0.40  # below the last strip, for the label of X, without the caption [inch]
GAP: Final = 0.30  # between strips, for the labels of ticks [inch]
TALLEST: Final = 6.4  # all strips and the gaps between them [inch]
MOST: Final = 5  # strips
LARGEST_SCALE: Final = 0.2  # of the page to the world [inch/m]
ENOUGH: Final = 0.8  # of the largest scale that there is, for fewer strips and less of the last one empty [1]


@dataclass(frozen=True)
class Strips:
    """How a map is cut.

    Attributes:
        x: left end of each strip, and the right end of the last [m].
        y: lower and upper end of all of them [m].
        scale: of the page to the world, along both axes [inch/m].
    """

    x: tuple[float, ...]
    y: tuple[float, float]
    scale: float

    @property
    def height(self) -> float:
        """Of one strip on the page [inch]."""
        return self.scale * (self.y[1] - self.y[0])

    @property
    def figure_height(self) -> float:
        """Of all strips with what is round them, the caption too [inch]."""
        n = len(self.x) - 1
        return HEAD + n * self.height + (n - 1) * GAP + FOOT + CAPTION_HEIGHT


def cut(x: tuple[float, float], y: tuple[float, float]) -> Strips:
    """The cut of a map from x[0] to x[1] and from y[0] to y[1] [m] into as few strips as leave it large."""
    width, length, height = WIDTH - LEFT - RIGHT, x[1] - x[0], y[1] - y[0]

    def scale(n: int) -> float:
        return min(LARGEST_SCALE, n * width / length, (TALLEST - (n - 1) * GAP) / (n * height))

    largest = max(map(scale, range(1, MOST + 1)))
    n = next(n for n in range(1, MOST + 1) if scale(n) >= ENOUGH * largest)
    strip = width / scale(n)  # what fits in one [m]
    start = x[0] if n > 1 else (x[0] + x[1] - strip) / 2  # room that is left over is at the end, or on both sides
    return Strips(tuple(start + i * strip for i in range(n + 1)), y, scale(n))


def add_axes(figure: Figure, strips: Strips) -> list[Axes]:
    """Axes for each strip, from the top down, in a figure of at least the strips' height."""
    whole, panels = figure.get_figheight(), []
    for i, (left, right) in enumerate(zip(strips.x[:-1], strips.x[1:], strict=True)):
        top = HEAD + i * (strips.height + GAP)
        bottom = whole - top - strips.height
        axes = figure.add_axes((LEFT / WIDTH, bottom / whole, 1 - (LEFT + RIGHT) / WIDTH, strips.height / whole))
        axes.set(xlim=(left, right), ylim=strips.y, aspect="equal", ylabel="$Y$ [m]")
        panels.append(axes)
    panels[-1].set_xlabel("$X$ [m]")
    return panels
