"""The controller's steps in a figure over time."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from swerve.report.figures.style import GREY
from swerve.simulate import Run

Array = NDArray[np.float64]


def staircase(axes: Axes, run: Run, values: Array, **style: Any) -> None:
    """What the controller commanded, (n_steps,), each value held until the next step."""
    axes.stairs(values, _edges(run), baseline=None, **style)


def mark_fallback(axes: Axes, run: Run) -> None:
    """Hatch the steps that were answered by the fallback."""
    failed = run.log.steps.columns["fallback"] != ""
    if failed.any():
        axes.fill_between(
            _edges(run),
            0,
            1,
            where=np.append(failed, failed[-1]),
            step="post",
            transform=axes.get_xaxis_transform(),
            facecolor="none",
            edgecolor=GREY,
            linewidth=0,
            hatch="////",
            label="answered by the fallback",
        )


def _edges(run: Run) -> Array:
    """Start of each step, and the end of the last (n_steps + 1,) [s]."""
    return np.append(run.log.steps["time"], run.log.motion["time"][-1])
