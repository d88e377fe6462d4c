"""Lateral force of each wheel in a double lane change, the plant's tyre against eq. (4): Fig. 5 of the paper."""

from matplotlib.figure import Figure

from swerve import __version__
from swerve.report.figures.style import ACTING, COMMANDED, captioned_figure, styled
from swerve.report.figures.wheel_forces import NAMES
from swerve.study.tyre_comparison import TyreComparison

KILO = 1e-3  # [kN] in 1 N
KM_H = 3.6  # [km/h] in 1 m/s


@styled
def lateral_forces(comparison: TyreComparison) -> Figure:
    """Both forces of each wheel over time, with the error between them; panels lie as the wheels do."""
    run = comparison.run
    where = f"{run.manoeuvre.name}: {run.car.vehicle.name} on {run.car.plant}"
    what = f"{run.manoeuvre.speed * KM_H:.4g} km/h, \N{GREEK SMALL LETTER MU} = {run.manoeuvre.friction:g}"
    figure = captioned_figure(f"{where}, {what}, swerve {__version__}. Errors are root mean squares.", height=4.6)
    panels = figure.subplots(2, 2, sharex=True, sharey=True)
    for axes, each in zip(panels.flat, comparison.wheels, strict=True):
        time = run.motion["time"]
        axes.plot(time, each.reduced * KILO, label="eq. (4)", **COMMANDED)
        axes.plot(time, each.full * KILO, label=f"tyre of the {run.car.plant} plant", **ACTING)
        error = f"error {each.rms_error:.0f} N, {100 * each.relative_error:.1f} % of the peak"
        axes.set_title(f"{NAMES[each.wheel]}: {error}", fontsize=8.0)
    for axes in panels[:, 0]:
        axes.set_ylabel("lateral force $F_y$ [kN]")
    for axes in panels[1]:
        axes.set_xlabel("time [s]")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="outside upper center", ncols=2)
    return figure
