"""The steering angle of the front road wheels: Fig. 10 of the paper."""

import numpy as np
from matplotlib.figure import Figure

from swerve.report.figures.steps import mark_fallback, staircase
from swerve.report.figures.style import ACTING, COMMANDED, new_figure, styled, widen
from swerve.simulate import Run


@styled
def steering(run: Run) -> Figure:
    """Road-wheel angle, as commanded in each sample and as it acts."""
    motion, steps = run.log.motion, run.log.steps
    figure = new_figure(run, height=2.9)
    axes = figure.subplots()
    staircase(axes, run, np.degrees(steps["delta"]), label="commanded", **COMMANDED)
    axes.plot(motion["time"], np.degrees(motion["delta"]), label="acting", **ACTING)
    mark_fallback(axes, run)
    widen(axes, least=2.0)
    axes.set_xlabel("time [s]")
    axes.set_ylabel(r"road-wheel angle $\delta$ [deg]")
    figure.legend(*axes.get_legend_handles_labels(), loc="outside upper center", ncols=3)
    return figure
