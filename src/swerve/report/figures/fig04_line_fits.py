"""Line fits: Fig. 4 of the paper. B, C and D over the load, and the lateral force that follows from their lines."""

from collections.abc import Sequence
from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swerve import __version__
from swerve.report.figures.style import ACTING, BLACK, COMMANDED, captioned_figure, styled
from swerve.study.tyre_work import TyreWork
from swerve.vehicle.fitting.figures import Figure4, ForceComparison

KILO: Final = 1e-3  # [kN] in 1 N
NAMES: Final = {"B": "$B$ [1/rad]", "C": "$C$ [1]", "D": "$D$ [1]"}
DASHES: Final = (0, (5, 3))
PERCENT: Final = 100.0
ROOM: Final = 1.18  # of the force's axis over the largest force, for the legend [1]


@styled
def line_fits(work: TyreWork) -> Figure:
    """On the left the three lines, on the right the force at each load of Table 1 and what the lines miss of it."""
    worst = max(force.relative_error for force in work.figure_4.forces)
    figure = captioned_figure(
        f"Tyre 215/55 R17, Table 1 and the printed lines, \N{GREEK SMALL LETTER MU} = 1, swerve {__version__}. "
        f"Largest error of the force {worst:.2%} of its peak.",
        height=5.0,
    )
    panels = figure.subplot_mosaic(
        [["B", "force"], ["C", "force"], ["D", "error"]], width_ratios=[1.0, 1.6], height_ratios=[1.0, 1.0, 1.0]
    )
    _draw_lines(panels, work.figure_4)
    _draw_forces(panels["force"], panels["error"], work.figure_4.forces)
    return figure


def _draw_lines(panels: dict[str, Axes], values: Figure4) -> None:
    for letter, name in NAMES.items():
        axes = panels[letter]
        axes.plot(values.loads * KILO, values.on_lines[letter], color=BLACK, linewidth=1.0, label="printed line")
        axes.plot(
            values.loads * KILO, values.values[letter], "o", color=BLACK, mfc="white", markersize=4.0, label="Table 1"
        )
        axes.margins(0.06)
        axes.set_ylabel(name)
        axes.ticklabel_format(useOffset=False)
    panels["B"].legend(loc="upper right")
    panels["D"].set_xlabel("vertical load $F_z$ [kN]")


def _draw_forces(axes: Axes, below: Axes, forces: Sequence[ForceComparison]) -> None:
    shares = []
    for i, force in enumerate(forces):
        right = force.slip_angles >= 0  # the left is its mirror image
        angles = np.degrees(force.slip_angles[right])
        data, reduced = force.data[right] * KILO, force.reduced[right] * KILO
        names = ("eq. (3), Table 1", "eq. (4), printed lines") if i == 0 else ("", "")
        axes.plot(angles, data, label=names[0], **COMMANDED)
        axes.plot(angles, reduced, label=names[1], **{**ACTING, "linestyle": DASHES})
        shares.append(PERCENT * (reduced - data) / data.max())
        below.plot(angles, shares[-1], color=BLACK, linewidth=0.9)
    axes.set_ylabel("pure lateral force $F_y$ [kN]")
    axes.set_ylim(0.0, max(force.data.max() for force in forces) * KILO * ROOM)
    axes.legend(loc="upper left", ncols=2)
    axes.sharex(below)
    axes.tick_params(labelbottom=False)
    _label(axes, forces, [force.reduced[-1] * KILO for force in forces], gap=0.05)
    _label(below, forces, [float(share[-1]) for share in shares], gap=0.105)
    below.set_ylabel("error of $F_y$\n[% of its peak]")
    below.set_xlabel(r"slip angle $\alpha$ [deg]")


def _label(axes: Axes, forces: Sequence[ForceComparison], ends: Sequence[float], gap: float) -> None:
    """The load beside the end of each line, in the order of the lines, `gap` of the axis apart at the least [1]."""
    gap *= float(np.ptp(axes.get_ylim()))
    order = np.argsort(ends)
    places = np.array(ends)[order]
    for i in range(1, len(places)):
        places[i] = max(places[i], places[i - 1] + gap)
    places -= max(0.0, (places - np.array(ends)[order]).max() / 2)
    for k, place in zip(order, places, strict=True):
        axes.annotate(
            f"{forces[k].load * KILO:.2f} kN",
            (1.0, ends[k]),
            (1.035, place),
            xycoords=axes.get_yaxis_transform(),
            textcoords=axes.get_yaxis_transform(),
            va="center",
            fontsize=6.5,
            arrowprops={"arrowstyle": "-", "linewidth": 0.4, "shrinkA": 0.0, "shrinkB": 0.0, "relpos": (0.0, 0.5)},
        )
