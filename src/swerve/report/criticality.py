"""What is shown of criticality: a table and JSON."""

import json
from collections.abc import Mapping
from math import isfinite
from typing import Any, Final

from swerve import __version__
from swerve.study.criticality import UNITS, Criticality

MEANINGS: Final[Mapping[str, str]] = {
    "clearance": "distance to the nearest obstacle",
    "ttc": "time to collision, velocity and heading kept",
    "wttc": "worst time to collision, whatever both do within their friction",
    "ttb": "time to brake: the last start of full braking that avoids",
    "tts_left": "time to steer: the last start of a swerve to the left that avoids",
    "tts_right": "the same to the right",
    "ttr": "time to react: the largest of the three",
    "ttb_point_mass": "time to brake of a point mass",
    "tts_left_point_mass": "time to steer of a point mass, to the left",
    "tts_right_point_mass": "the same to the right",
    "required_deceleration": "constant, that stays behind",
    "required_lateral_acceleration_left": "constant, that passes on the left",
    "required_lateral_acceleration_right": "the same on the right",
    "btn": "brake threat number: required over available",
    "stn": "steer threat number: required over available, the easier side",
    "impact_speed": "of full braking from here on, relative to what is met",
}


def criticality_json(found: Criticality) -> str:
    """All of it as one JSON object on one line, in SI; what is not finite is the string "Infinity" or "-Infinity"."""
    worst = {name: {"value": _plain(each.value), "time": each.time} for name, each in found.worst.items()}
    measures = {
        name: {"unit": UNITS[name], "worst": worst[name], "values": [_plain(value) for value in values.tolist()]}
        for name, values in found.measures.items()
    }
    whole: dict[str, Any] = {
        "scenario": found.scenario.name,
        "plant": found.plant,
        "version": __version__,
        "pet": _plain(found.pet),
        "point_of_no_return": found.point_of_no_return,
        "time": found.times.tolist(),
        "measures": measures,
    }
    return json.dumps(whole, allow_nan=False)


def criticality_table(found: Criticality) -> str:
    """The criticality for people: the values of the only instant, or the worst ones and when they were."""
    n, last = len(found.times), found.point_of_no_return
    where = "at its start" if n == 1 else f"worst of {n} instants"
    width = max(map(len, UNITS))
    lines = [f"{found.scenario.name} on {found.plant}, {where}", ""]
    for name, each in found.worst.items():
        time = "" if n == 1 else f"at {each.time:5.2f} s  "
        lines.append(f"{name:<{width}}  {_shown(each.value):>8} {UNITS[name]:<6} {time}{MEANINGS[name]}")
    if n > 1:
        lines.append(f"{'pet':<{width}}  {_shown(found.pet):>8} s      {'':12}post-encroachment time")
    lost = "none: there was always a way out" if last is None else f"{last:.2f} s: neither braking nor a swerve helps"
    return "\n".join([*lines, "", f"point of no return  {lost}"])


def _plain(value: float) -> float | str:
    return value if isfinite(value) else "Infinity" if value > 0 else "-Infinity"


def _shown(value: float) -> str:
    return f"{value:.3f}" if isfinite(value) else "inf" if value > 0 else "too late"
