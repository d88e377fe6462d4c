"""The figures of a run, each a function from a run to a matplotlib `Figure`."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Final

from matplotlib.figure import Figure

from swerve.report.figures.states import states
from swerve.report.figures.steering import steering
from swerve.report.figures.style import save
from swerve.report.figures.top_view import top_view
from swerve.report.figures.wheel_forces import wheel_forces
from swerve.simulate import Run

__all__ = ["FIGURES", "PAPER_FIGURES", "states", "steering", "top_view", "wheel_forces", "writers"]

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


def writers(figures: Mapping[str, Draw], run: Run) -> dict[str, Callable[[Path], None]]:
    """What writes the figures of a run, as PNG and as PDF, by file name."""

    def writer(draw: Draw) -> Callable[[Path], None]:
        return lambda path: save(draw(run), path)

    return {f"{name}.{suffix}": writer(draw) for name, draw in figures.items() for suffix in ("png", "pdf")}
