"""What is shown of limits: a table for people, JSON for programs, Markdown for the documentation."""

import json
from collections.abc import Sequence
from typing import Any

from swerve import __version__
from swerve.study.limit import Limits, Optimum


def limits_json(limits: Limits) -> str:
    """One JSON object on one line, in SI; a value that does not exist is null."""
    scene = limits.scene
    each = {
        limit.means.value: {
            "distance": limit.distance,
            "time_to_collision": limit.time_to_collision,
            "friction": limit.friction,
            "at_distance": _measured(limit.shortest),
            "at_friction": _measured(limit.slipperiest),
        }
        for limit in limits.limits
    }
    given = {"scenario": scene.name, "version": __version__, "distance": scene.distance, "friction": scene.friction}
    bound = {"distance": limits.least_distance, "friction": limits.least_friction}
    return json.dumps(given | {"limits": each, "point_mass": bound}, allow_nan=False)


def limits_table(limits: Limits) -> str:
    """A row for each means, and the bound from below."""
    scene = limits.scene
    head = f"{scene.name}: first obstacle at {scene.distance:.2f} m, {scene.speed:.2f} m/s, friction {scene.friction:g}"
    names = f"{'means':<12}{'distance':>10}{'TTC':>9}{'friction':>10}{'sqrt(rho)':>11}{'clearance':>11}{'agreeing':>10}"
    rows = [_row(*_cells(limits, i)) for i in range(len(limits.limits))]
    bound = _row("point mass", f"{limits.least_distance:.2f} m", "", f"{limits.least_friction:.3f}", "", "", "")
    legend = (
        "smallest values at which a control was found that avoids; sqrt(rho) and clearance of that one, driven again",
        "agreeing: starts within 1 % of the best, of all; point mass: below these nothing helps",
    )
    return "\n".join([head, "", names, *rows, bound, "", *legend])


def _cells(limits: Limits, index: int) -> Sequence[str]:
    limit = limits.limits[index]
    shortest = limit.shortest
    ratio = None if shortest is None else shortest.drive.ratio
    clear = None if shortest is None else shortest.drive.clearance
    agreeing = "none" if shortest is None else f"{shortest.n_agreeing} of {shortest.n_starts}"
    return (
        limit.means.value,
        _number(limit.distance, 2, " m"),
        _number(limit.time_to_collision, 3, " s"),
        _number(limit.friction, 3),
        _number(ratio, 4),
        _number(clear, 3, " m"),
        agreeing,
    )


def _row(*cells: str) -> str:
    widths = (12, 10, 9, 10, 11, 11, 10)
    first, *rest = cells
    return f"{first:<{widths[0]}}" + "".join(f"{cell:>{w}}" for cell, w in zip(rest, widths[1:], strict=True))


def _measured(optimum: Optimum | None) -> dict[str, Any] | None:
    if optimum is None:
        return None
    return {
        "distance_ratio": optimum.drive.ratio,
        "clearance": optimum.drive.clearance,
        "ending": optimum.trajectory.grid.ending.value,
        "starts": optimum.n_starts,
        "agreeing": optimum.n_agreeing,
    }


def _number(value: float | None, digits: int, unit: str = "") -> str:
    return "none" if value is None else f"{value:.{digits}f}{unit}"
