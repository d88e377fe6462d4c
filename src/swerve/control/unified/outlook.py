"""What a way does beyond the horizon: it brakes to a stop, or steers past the next obstacle and then for the goal.

The lateral target while obstacle i is still to be passed: OVERSHOOT beyond what is just clear of it, as far as edges
and obstacles that are passed at the same time leave room.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Passing, Side
from swerve.control.unified.scene import Scene
from swerve.control.unified.tail import Outlook
from swerve.control.unified.way import Way
from swerve.conventions import X
from swerve.world import Shape

Array = NDArray[np.float64]

SWERVING = 0.6  # [1] share of mu g; the rest is the time that a yaw rate takes to build up
SWERVING_NARROW = 0.45  # [1] the same where the swerve has to be caught at once: the yaw rate has to turn round too
BRAKING = 0.8  # [1] share of mu g of a straight stop
BRAKING_IN_A_SWERVE = 0.6  # [1] share of mu g
GENTLE = 0.3  # [1] share of mu g with which a stop ends a lateral motion
STIFFNESS = 9.0  # [1/s^2] of the steering for a target
OVERSHOOT = 2.0  # [m]
GROWING = 0.15  # [s] smallest step of the second part
ROOM = 1.0  # [m] before and after an obstacle that counts as beside it
LOOK = 60  # instants at which obstacles and vehicle are compared


def outlook(scene: Scene, way: Way, sample_time: float, n_fine: int, n_coarse: int, ahead: float) -> Outlook:
    """The outlook of a way.

    Args:
        scene: of this step.
        way: through it.
        sample_time: of the first steps [s].
        n_fine: number of those.
        n_coarse: number of the larger ones.
        ahead: from the scene's start to where the outlook begins [s].
    """
    grip = scene.place.grip
    deceleration = scene.place.braking * (BRAKING if way.is_straight else BRAKING_IN_A_SWERVE) * grip
    braking = deceleration if way.brakes else 0.0
    stop = scene.speed / braking - n_fine * sample_time if braking else 0.0
    durations = np.full(n_fine + n_coarse, sample_time)
    durations[n_fine:] = max(GROWING, stop / n_coarse)
    times = ahead + np.cumsum(durations)
    if way.is_straight:
        return Outlook(durations, np.zeros_like(durations), 0.0, GENTLE * grip, braking)
    targets, room = _targets(scene, way, times)
    lateral = scene.place.turning * (SWERVING_NARROW if room < OVERSHOOT else SWERVING) * grip
    return Outlook(durations, targets, STIFFNESS, lateral, braking, is_blocked=room < -2 * scene.place.margin)


@dataclass(frozen=True)
class _Meeting:
    """When an obstacle is beside the vehicle [s], from the scene's start, and which Y are clear of it then [m]."""

    begins: float
    ends: float
    lowest: float
    highest: float
    is_threat: bool


def _targets(scene: Scene, way: Way, times: Array) -> tuple[Array, float]:
    """Lateral target (n,) [m] at times (n,) from the scene's start on, and the least room to overshoot it [m]."""
    goal = scene.place.lateral_offset
    meetings = _meetings(scene, way, float(times[-1]))
    targets, room = np.full(len(times), goal), np.inf
    for meeting in sorted(meetings, key=lambda each: each.ends, reverse=True):
        lowest, highest = _room(meeting, meetings, scene)
        targets[times <= meeting.ends] = _target(meeting, lowest, highest, goal)
        if meeting.is_threat:
            room = min(room, highest - lowest)
    return targets, float(room)


def _room(meeting: _Meeting, meetings: list[_Meeting], scene: Scene) -> tuple[float, float]:
    """Smallest and largest Y that are clear of an obstacle, of those met at the same time, and of the edges."""
    beside = [each for each in meetings if each.begins <= meeting.ends and meeting.begins <= each.ends]
    lowest, highest = scene.place.room()
    lowest = max(lowest, *(each.lowest for each in beside))
    highest = min(highest, *(each.highest for each in beside))
    return lowest, highest


def _target(meeting: _Meeting, lowest: float, highest: float, goal: float) -> float:
    """Where to be when an obstacle is met."""
    if lowest > highest:
        return (lowest + highest) / 2
    further = OVERSHOOT if meeting.is_threat else 0.0
    wanted = min(max(goal, meeting.lowest + further), meeting.highest - further)
    return min(max(wanted, lowest), highest)


def _meetings(scene: Scene, way: Way, duration: float) -> list[_Meeting]:
    found = []
    for i, (encounter, passing) in enumerate(zip(_encounters(scene, duration), way.passing, strict=True)):
        if encounter is not None and passing is not Passing.BEHIND:
            left, right = (encounter.left, np.inf), (-np.inf, encounter.right)
            room = left if passing is Passing.LEFT else right
            found.append(_Meeting(encounter.begins, encounter.ends, *room, i in way.threats))
    return found


@dataclass(frozen=True)
class _Encounter:
    """When an obstacle is beside the vehicle [s], and the Y that are just clear of it on either side then [m]."""

    begins: float
    ends: float
    left: float
    right: float


@lru_cache(maxsize=4)
def _encounters(scene: Scene, duration: float) -> tuple[_Encounter | None, ...]:
    """With each obstacle, for a vehicle that keeps its speed; the ways of a step ask for the same ones."""
    elapsed = np.linspace(0.0, duration, LOOK)
    x = scene.start[X] + scene.speed * elapsed
    place = scene.place
    ahead, back = place.footprint.support([[1.0, 0.0], [-1.0, 0.0]])
    found: list[_Encounter | None] = []
    for forecast in scene.forecasts:
        at = forecast.position_at(scene.time + elapsed)
        forwards, sideways = _reach(forecast.shape, forecast.heading)
        beside = np.flatnonzero((at[:, 0] - forwards - ROOM < x + ahead) & (x - back < at[:, 0] + forwards + ROOM))
        if len(beside) == 0:
            found.append(None)
            continue
        where, when = at[beside, 1], elapsed[beside]
        left = float(where.max()) + sideways + place.reach(Side.RIGHT) + place.margin
        right = float(where.min()) - sideways - place.reach(Side.LEFT) - place.margin
        found.append(_Encounter(float(when[0]), float(when[-1]), left, right))
    return tuple(found)


def _reach(shape: Shape, heading: float) -> tuple[float, float]:
    """How far a shape reaches along X and along Y [m]."""
    cos, sin = np.cos(heading), np.sin(heading)
    along, across = shape.support([[cos, -sin], [sin, cos]])
    return float(along), float(across)
