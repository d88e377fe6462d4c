"""The figures of a run and of the tyre work, each a function from its subject to a matplotlib `Figure`."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Final, TypeVar

from matplotlib.figure import Figure

from swerve.report.figures.fig03_friction_ellipses import friction_ellipses
from swerve.report.figures.fig04_line_fits import line_fits
from swerve.report.figures.fig05_lateral_forces import lateral_forces
from swerve.report.figures.states import states
from swerve.report.figures.steering import steering
from swerve.report.figures.style import save
from swerve.report.figures.top_view import top_view
from swerve.report.figures.wheel_forces import wheel_forces
from swerve.simulate import Run
from swerve.study.tyre_comparison import TyreComparison
from swerve.study.tyre_work import TyreWork

__all__ = [
    "FIGURES",
    "FORCE_FIGURES",
    "PAPER_FIGURES",
    "TYRE_FIGURES",
    "friction_ellipses",
    "lateral_forces",
    "line_fits",
    "states",
    "steering",
    "top_view",
    "wheel_forces",
    "writers",
]

Draw = Callable[[Run], Figure]
Subject = TypeVar("Subject")

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


TYRE_FIGURES: Final[Mapping[str, Callable[[TyreWork], Figure]]] = {
    "fig03_friction_ellipses": friction_ellipses,
    "fig04_line_fits": line_fits,
}


FORCE_FIGURES: Final[Mapping[str, Callable[[TyreComparison], Figure]]] = {"fig05_lateral_forces": lateral_forces}


def writers(figures: Mapping[str, Callable[[Subject], Figure]], subject: Subject) -> dict[str, Callable[[Path], None]]:
    """What writes the figures of a run, or of another subject, as PNG and as PDF, by file name."""

    def writer(draw: Callable[[Subject], Figure]) -> Callable[[Path], None]:
        return lambda path: save(draw(subject), path)

    return {f"{name}.{suffix}": writer(draw) for name, draw in figures.items() for suffix in ("png", "pdf")}
