"""The manoeuvre from above: Fig. 7 of the paper.

The vehicle's body every quarter of a second, the path of its centre of gravity, the obstacles at the same instants, and
the lanes where the road has any.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from numpy.typing import NDArray

from swerve.report.figures.body import bodies, place, wheels
from swerve.report.figures.strips import add_axes, cut
from swerve.report.figures.style import BLACK, BLUE, GREY, ORANGE, WIDTH, put_caption, styled
from swerve.simulate import Run
from swerve.world import Obstacle, Road, clearance

Array = NDArray[np.float64]

EVERY: Final = 0.25  # between two instants that are drawn [s]
LABELLED_EVERY: Final = 4  # instants
LABEL_ROOM: Final = 0.35  # between two labels on the page [inch]
LONGEST: Final = 200.0  # stretch of road that is drawn; of a longer run, that round the closest approach [m]
MARGIN: Final = 0.6  # round what is drawn [m]


@dataclass(frozen=True, eq=False)
class _View:
    """What is drawn.

    Attributes:
        times: of the instants (n,) [s].
        poses: of the vehicle at the instants (n, 3) [m, m, rad].
        steering: at the instants (n,) [rad].
        path: of the centre of gravity, at each step of the plant (m, 2) [m].
        obstacles: of the scenario.
        closest: row of the path nearest to an obstacle, the first in contact; None without obstacles.
    """

    times: Array
    poses: Array
    steering: Array
    path: Array
    obstacles: list[Obstacle]
    closest: int | None


@styled
def top_view(run: Run) -> Figure:
    """The manoeuvre from above, to one scale along X and Y."""
    view = _view(run)
    x, y = _extent(run, view)
    strips = cut(x, y)
    figure = Figure(figsize=(WIDTH, strips.figure_height))
    for axes in (panels := add_axes(figure, strips)):
        _draw_road(axes, run.scenario.road.to_world())
        _draw_obstacles(axes, view)
        _draw_vehicle(axes, run, view)
        _label_instants(axes, run, view, strips.scale)
    figure.legend(*panels[0].get_legend_handles_labels(), loc="upper center", ncols=5)
    put_caption(figure, run)
    return figure
