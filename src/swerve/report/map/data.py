"""A map as one JSON document, which is all that its page knows.

    {"format": 1, "plant", "extent", "ends": of the speeds, "series": [{"name", "is_limit"}], "panels", "bought"}

    panels[]: {"name", "friction", "offset", "speeds", "lines": [distance by speed, of each series],
               "turns": [likewise, of each controller], "closed": {"speeds", "braking", "swerving"}, "points": [...]}
    points[]: {"kind": "run", "limit" or "turn", "series": its place, "speed", "distance", "command", ...}
    bought[]: {"name", "speeds", "distances", "points"}, one for each panel

Values are in SI and exact; a distance that there is none of is null.
"""

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from swerve.report.map.commands import Source, limit_command, run_command, studio_link
from swerve.report.map.replays import FOLDER, replay_name
from swerve.report.map.summary import BOTH, INDIVIDUAL, Panel, avoided, bought, conditions_of, panel_name, panels
from swerve.study.map.boundary import Boundary, Condition, Map, RunRecord
from swerve.study.map.closed_form import braking_distance, swerving_distance

FORMAT: Final = 1  # of the document; grows when a key changes its meaning
MARGIN: Final = 1.5  # of the charts beside the smallest and the largest speed [m/s]
N_SPEEDS: Final = 60  # of a closed form


def document(found: Map, source: Source, replays: Collection[Condition]) -> dict[str, Any]:
    """The document.

    Args:
        found: the map.
        source: what it was made of.
        replays: the conditions of which there is a page of all controllers' runs.
    """
    points, every = _Points(found, source, replays), panels(found)
    return {
        "format": FORMAT,
        "plant": found.plant,
        "extent": found.extent,
        "ends": ends(found),
        "series": [{"name": who, "is_limit": who in found.limits} for who in points.series],
        "panels": [_panel(found, points, each) for each in every],
        "bought": [_bought(found, points, each) for each in every] if {BOTH, INDIVIDUAL} <= {*found.limits} else [],
    }


def ends(found: Map) -> tuple[float, float]:
    """The speeds from which and to which charts go [m/s]."""
    speeds = [each.speed for each in found.conditions]
    return max(min(speeds) - MARGIN, 0.0), max(speeds) + MARGIN


def closed_forms(found: Map, panel: Panel) -> dict[str, list[float]]:
    """The distances v^2 / (2 mu g) before contact, and v sqrt(2 w / (mu g)) [m], over speeds [m/s]."""
    friction, offset = panel
    speeds: list[float] = np.linspace(*ends(found), N_SPEEDS).tolist()
    width = found.half_width - abs(offset)
    braking = [braking_distance(speed, friction) + found.extent for speed in speeds]
    return {"speeds": speeds, "braking": braking, "swerving": [swerving_distance(v, friction, width) for v in speeds]}


def _panel(found: Map, points: "_Points", panel: Panel) -> dict[str, Any]:
    cells = conditions_of(found, panel)
    boundaries = {who: [found.boundary(who, each) for each in cells] for who in points.series}
    return {
        "name": panel_name(found, panel),
        "friction": panel[0],
        "offset": panel[1],
        "speeds": [each.speed for each in cells],
        "lines": [[_avoided(each) for each in boundaries[who]] for who in points.series],
        "turns": [[_turns(each) for each in boundaries[who]] for who in found.controllers],
        "closed": closed_forms(found, panel),
        "points": [*points.runs(cells), *points.limits_and_turns(cells)],
    }


def _bought(found: Map, points: "_Points", panel: Panel) -> dict[str, Any]:
    cells = conditions_of(found, panel)
    return {
        "name": panel_name(found, panel),
        "speeds": [each.speed for each in cells],
        "distances": [bought(found, each) for each in cells],
        "points": [points.torques(each) for each in cells if bought(found, each) is not None],
    }


@dataclass(frozen=True)
class _Points:
    """What can be pointed at."""

    found: Map
    source: Source
    replays: Collection[Condition]

    @property
    def series(self) -> tuple[str, ...]:
        """Controllers, then limits."""
        return self.found.controllers + self.found.limits

    def runs(self, cells: Collection[Condition]) -> Iterator[dict[str, Any]]:
        for run in self.found.runs:
            if run.condition in cells:
                yield self._driven("run", run.who, run.condition, run.distance) | self._numbers(run)

    def limits_and_turns(self, cells: Collection[Condition]) -> Iterator[dict[str, Any]]:
        for each in self.found.boundaries:
            if each.condition in cells and each.who in self.found.limits and each.avoided is not None:
                again = limit_command(self.source, [each.who], each.condition)
                yield self._place("limit", each.who, each.condition, each.avoided) | {"command": again}
            if each.condition in cells and each.turns is not None:
                yield self._driven("turn", each.who, each.condition, each.turns)

    def torques(self, condition: Condition) -> dict[str, Any]:
        both, individual = (avoided(self.found, who, condition) for who in (BOTH, INDIVIDUAL))
        again = limit_command(self.source, [BOTH, INDIVIDUAL], condition)
        value = {"distance": bought(self.found, condition), "both": both, "individual": individual}
        return {"kind": "bought", "speed": condition.speed, **value, "command": again}

    def _place(self, kind: str, who: str, condition: Condition, distance: float) -> dict[str, Any]:
        limit = avoided(self.found, INDIVIDUAL, condition)
        return {
            "kind": kind,
            "series": self.series.index(who),
            "speed": condition.speed,
            "distance": distance,
            "of_limit": None if limit is None else distance / limit,
        }

    def _driven(self, kind: str, who: str, condition: Condition, distance: float) -> dict[str, Any]:
        place = (who, condition, distance)
        links = {
            "command": run_command(self.found, self.source, *place),
            "studio": studio_link(self.found, self.source, *place),
            "replay": f"{FOLDER}/{replay_name(condition)}" if condition in self.replays else None,
        }
        return self._place(kind, *place) | links

    def _numbers(self, run: RunRecord) -> dict[str, Any]:
        boundary = self.found.boundary(run.who, run.condition)
        return {
            "is_last": boundary is not None and run.distance == boundary.avoided,
            "outcome": run.outcome,
            "decision": run.decision,
            "clearance": run.min_clearance,
            "impact_speed": run.impact_speed,
        }


def _avoided(boundary: Boundary | None) -> float | None:
    return None if boundary is None else boundary.avoided


def _turns(boundary: Boundary | None) -> float | None:
    return None if boundary is None else boundary.turns
