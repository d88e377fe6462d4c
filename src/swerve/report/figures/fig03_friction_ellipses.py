"""Friction ellipses: Fig. 3 of the paper. Eq. (4) at several slip angles, and eq. (2), which it is solved from."""

from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from swerve import __version__
from swerve.report.figures.style import BLACK, BLUE, LIMIT, captioned_figure, styled
from swerve.study.tyre_work import TyreWork
from swerve.vehicle.fitting.figures import FIG_3_FRICTION, FIG_3_LOAD, FrictionEllipse

KILO: Final = 1e-3  # [kN] in 1 N
BELOW, ABOVE = (0.0, -8.0), (42.0, 19.0)  # of a label: the topmost curve has room only beyond the circle [point]
ROOM: Final = 1.12  # of the vertical axis over the circle [1]
N_MARKS: Final = 13  # of eq. (2) on each ellipse
MARK: Final[dict[str, Any]] = {"color": BLACK, "marker": "o", "mfc": "white", "markersize": 3.2, "linestyle": "none"}


@styled
def friction_ellipses(work: TyreWork) -> Figure:
    """Lateral over longitudinal force at each slip angle, inside the friction circle; to one scale."""
    error = max(ellipse.error for ellipse in work.figure_3)
    where = f"Tyre 215/55 R17 at Fz = {FIG_3_LOAD:.0f} N, \N{GREEK SMALL LETTER MU} = {FIG_3_FRICTION:g}"
    figure = captioned_figure(
        f"{where}, swerve {__version__}. Eq. (2) holds along eq. (4) to within {error:.0e}.", height=4.4
    )
    axes = figure.subplots()
    for i, ellipse in enumerate(work.figure_3):
        is_last = i == len(work.figure_3) - 1
        _draw(axes, ellipse, names=("eq. (4)", "eq. (2)") if i == 0 else ("", ""))
        _label(axes, ellipse, ABOVE if is_last else BELOW)
    around = FIG_3_FRICTION * FIG_3_LOAD * KILO * np.exp(1j * np.linspace(0.0, np.pi, 181))
    axes.plot(around.real, around.imag, label=r"friction circle $\mu F_z$", **LIMIT)
    axes.set_aspect("equal")
    axes.margins(0.03)
    axes.set_ylim(0.0, around.imag.max() * ROOM)
    axes.set_xlabel("longitudinal force $F_x$ [kN]")
    axes.set_ylabel("lateral force $F_y$ [kN]")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside upper center", ncols=3)
    return figure


def _draw(axes: Axes, ellipse: FrictionEllipse, names: tuple[str, str]) -> None:
    """One curve, and points of eq. (2) with the curve's own semi-axes."""
    x, y = ellipse.longitudinal * KILO, ellipse.lateral * KILO
    angles = np.linspace(0.0, np.pi, N_MARKS)
    axes.plot(x, y, color=BLUE, label=names[0])
    axes.plot(x.max() * np.cos(angles), y.max() * np.sin(angles), label=names[1], clip_on=False, **MARK)


def _label(axes: Axes, ellipse: FrictionEllipse, offset: tuple[float, float]) -> None:
    """The slip angle, so far [point] from the top of its curve."""
    axes.annotate(
        rf"$\alpha = {np.degrees(ellipse.slip_angle):g}$ deg",
        (0.0, ellipse.lateral.max() * KILO),
        offset,
        textcoords="offset points",
        ha="center",
        va="center",
        fontsize=7.0,
        arrowprops={"arrowstyle": "-", "linewidth": 0.5, "shrinkA": 0.0} if offset is ABOVE else None,
        path_effects=[withStroke(linewidth=2.0, foreground="white")],
    )
