"""The figures of a run, each a function from a run to a matplotlib `Figure`."""

from collections.abc import Callable, Mapping
from typing import Final

from matplotlib.figure import Figure

from swerve.report.figures.states import states
from swerve.report.figures.steering import steering
from swerve.report.figures.style import save
from swerve.report.figures.top_view import top_view
from swerve.report.figures.wheel_forces import wheel_forces
from swerve.simulate import Run

__all__ = ["FIGURES", "PAPER_FIGURES", "save", "states", "steering", "top_view", "wheel_forces"]

Draw = Callable[[Run], Figure]

FIGURES: Final[Mapping[str, Draw]] = {  # by file name
    "top_view": top_view,
    "states": states,
    "wheel_forces": wheel_forces,
    "steering": steering,
}

PAPER_FIGURES: Final[Mapping[str, Draw]] = {
    "fig07_top_view": top_view,
    "fig08_states": states,
    "fig09_wheel_forces": wheel_forces,
    "fig10_steering": steering,
}
