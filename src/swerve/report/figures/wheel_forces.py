"""Driving and braking forces of the four wheels: Fig. 9 of the paper."""

from matplotlib.figure import Figure

from swerve.conventions import WHEELS
from swerve.report.figures.steps import mark_fallback, staircase
from swerve.report.figures.style import ACTING, COMMANDED, LIMIT, new_figure, styled
from swerve.simulate import Run

KILO = 1e-3  # [kN] in 1 N
NAMES = {"fl": "front left", "fr": "front right", "rl": "rear left", "rr": "rear right"}


@styled
def wheel_forces(run: Run) -> Figure:
    """Longitudinal force of each tyre, commanded and acting, and its friction circle; panels lie as the wheels do."""
    motion, steps, friction = run.log.motion, run.log.steps, run.scenario.road.friction
    figure = new_figure(run, height=4.6)
    panels = figure.subplots(2, 2, sharex=True, sharey=True)
    for axes, wheel in zip(panels.flat, WHEELS, strict=True):
        largest = friction * motion[f"Fz_{wheel}"] * KILO
        staircase(axes, run, steps[f"Fx_{wheel}"] * KILO, label="commanded", **COMMANDED)
        axes.plot(motion["time"], motion[f"Fx_{wheel}"] * KILO, label="acting", **ACTING)
        axes.plot(motion["time"], largest, label=r"friction circle $\pm\mu F_z$", **LIMIT)
        axes.plot(motion["time"], -largest, **LIMIT)
        mark_fallback(axes, run)
        axes.set_title(NAMES[wheel], fontsize=8.0)
    for axes in panels[:, 0]:
        axes.set_ylabel("longitudinal force $F_x$ [kN]")
    for axes in panels[1]:
        axes.set_xlabel("time [s]")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="outside upper center", ncols=4)
    return figure
