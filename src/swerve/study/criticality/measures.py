"""All measures of criticality of the instants of a scene.

Times are inf where nothing would be met and -inf where it is too late, the scale {-inf} and [0, inf] of Westhofen et
al., Criticality metrics for automated vehicles, Archives of Computational Methods in Engineering (2022). Nothing is
ever nan.
"""

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.study.criticality import point_mass
from swerve.study.criticality.impact import impact_speed
from swerve.study.criticality.manoeuvre import (
    available_deceleration,
    available_lateral_acceleration,
    full_braking,
)
from swerve.study.criticality.required import (
    along_course,
    lateral_shift,
    looked_at,
    required_deceleration,
    required_lateral_acceleration,
)
from swerve.study.criticality.roll_out import roll_out
from swerve.study.criticality.scene import Scene
from swerve.study.criticality.threat import brake_threat_number, steer_threat_number
from swerve.study.criticality.time_to_brake import time_to_brake
from swerve.study.criticality.time_to_collision import time_to, time_to_collision
from swerve.study.criticality.time_to_react import time_to_react
from swerve.study.criticality.time_to_steer import time_to_steer
from swerve.study.criticality.worst_time_to_collision import gap_after, worst_time_to_collision

Array = NDArray[np.float64]
Measures = Mapping[str, Array]

_SIDES: Final = {"tts_left_point_mass": 1, "tts_right_point_mass": -1}

UNITS: Final = {
    "clearance": "m",
    "ttc": "s",
    "wttc": "s",
    "ttb": "s",
    "tts_left": "s",
    "tts_right": "s",
    "ttr": "s",
    "ttb_point_mass": "s",
    "tts_left_point_mass": "s",
    "tts_right_point_mass": "s",
    "required_deceleration": "m/s^2",
    "required_lateral_acceleration_left": "m/s^2",
    "required_lateral_acceleration_right": "m/s^2",
    "btn": "1",
    "stn": "1",
    "impact_speed": "m/s",
}


def measure(scene: Scene) -> Measures:
    """Values (n,) by name, in the order and units of `UNITS`."""
    ttc = time_to_collision(scene)
    deceleration = required_deceleration(scene)
    left, right = (required_lateral_acceleration(scene, side) for side in (1, -1))
    values = {
        "clearance": _clearance(scene),
        "ttc": ttc,
        "wttc": worst_time_to_collision(scene),
        "required_deceleration": deceleration,
        "required_lateral_acceleration_left": left,
        "required_lateral_acceleration_right": right,
        "btn": brake_threat_number(scene, deceleration),
        "stn": steer_threat_number(scene, left, right),
        **_of_manoeuvres(scene, ttc),
    }
    return {name: values[name] for name in UNITS}


def _clearance(scene: Scene) -> Array:
    now = np.zeros(len(scene.times))
    return np.asarray(np.minimum.reduce([now + np.inf, *(gap_after(scene, each, now) for each in scene.obstacles)]))


def _of_manoeuvres(scene: Scene, ttc: Array) -> dict[str, Array]:
    """What manoeuvres of last resort yield, where there is something to avoid."""
    met = np.isfinite(ttc)
    values = {name: np.full(len(ttc), np.inf) for name in UNITS if name.startswith("tt")}
    values["impact_speed"] = np.zeros(len(ttc))
    del values["ttc"]
    if not met.any():
        return values
    for name, found in _of_last_resort(scene.of_rows(met), ttc[met]).items():
        values[name][met] = found
    return values


def _of_last_resort(scene: Scene, ttc: Array) -> dict[str, Array]:
    braking = roll_out(scene, full_braking(scene))
    ttb, left, right = time_to_brake(scene, braking, ttc), *(time_to_steer(scene, side, ttc) for side in (1, -1))
    return {
        "ttb": ttb,
        "tts_left": left,
        "tts_right": right,
        "ttr": time_to_react(ttb, left, right),
        "impact_speed": impact_speed(scene, braking),
        **_of_point_mass(scene, ttc),
    }


def _of_point_mass(scene: Scene, ttc: Array) -> dict[str, Array]:
    """With the obstacle that would be met first."""
    first = np.array([time_to(scene, seen) for seen in scene.obstacles]).argmin(axis=0)
    times = {name: np.full(len(ttc), -np.inf) for name in ("ttb_point_mass", *_SIDES)}
    for i, seen in enumerate(scene.obstacles):
        rows = first == i
        closing = np.einsum("ni,ni->n", scene.velocity - seen.velocity, along_course(scene))
        braking = point_mass.time_to_brake(ttc, closing, available_deceleration(scene))
        times["ttb_point_mass"][rows] = braking[rows]
        for name, side in _SIDES.items():
            s = looked_at(scene, seen, ttc, across=True)
            shifts = lateral_shift(scene, seen, s, side)
            steering = point_mass.time_to_steer(s, shifts, available_lateral_acceleration(scene))
            times[name][rows] = np.minimum(steering, ttc)[rows]
    return times
