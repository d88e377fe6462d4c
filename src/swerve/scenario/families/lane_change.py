"""Euro NCAP Assisted Driving v1.1: a car cuts in, and a car ahead cuts out and reveals a stationary one.

The lane change is two arcs of one radius over the protocol's length s at constant speed v, T = s / v:
    y = 2 d (t / T)^2 up to T / 2, symmetrical after; |ay| = 4 d / T^2, R = s^2 / (4 d), d the lanes' offset
which is the protocol's ay of 0.5 and 1.5 m/s^2 and its R of 15, 250, 130 and 250 m, rounded. How its time to collision
is meant, when the cut-in is over or when the cut-out begins, is the reading that fits these [unverified].
"""

from typing import Any, Final

import numpy as np

from swerve.scenario.families.family import Case, Family, Tables
from swerve.scenario.families.rear import OWN, TARGET_LENGTH, at_speed, middle, target

LANE: Final = 3.5  # [m] protocol
CUT_INS: Final = {Case(50, 10): (14.5, 0.0), Case(120, 70): (60.0, 1.5)}  # length [m], time to collision [s]: protocol
CUT_OUTS: Final = {Case(70, 50): (44.0, 3.0), Case(90, 70): (60.0, 3.0)}  # likewise
BEGINS: Final = 1.0  # [s] own
AFTER: Final = 4.0  # [s] own: the run goes on after the lane change
FOLLOWING: Final = 1.5  # [s] own: headway to the car that cuts out
N_POINTS: Final = 9  # way-points of a lane change

PROTOCOL: Final = "Euro NCAP Assisted Driving v1.1"


def lane_change(x: float, speed: float, length: float, y_from: float, y_to: float) -> list[dict[str, Any]]:
    """Way-points of a car that is at `x` [m] at time zero and changes the lane from BEGINS on."""
    share = np.linspace(0.0, 1.0, N_POINTS)
    done = np.where(share < 0.5, 2 * share**2, 1 - 2 * (1 - share) ** 2)
    times = BEGINS + share * length / speed
    times = np.concatenate([[0.0], times, [times[-1] + 1.0]])  # in its lane before and after
    lateral = y_from + (y_to - y_from) * np.concatenate([[0.0], done, [1.0]])
    return [{"time": t, "position": [x + speed * t, y]} for t, y in zip(times.tolist(), lateral.tolist(), strict=True)]


def _cut_in(case: Case) -> Tables:
    """The gap closes from the start on, to the protocol's time to collision when the lane change is over."""
    (speed, other), (length, collision) = case.speeds, CUT_INS[case]
    over = BEGINS + length / other
    x = middle((speed - other) * (over + collision))
    return at_speed(speed, [target(waypoints=lane_change(x, other, length, LANE, 0.0))], over + AFTER)


def _cut_out(case: Case) -> Tables:
    """The vehicle under test has come down to the speed of the car before it, from the one that it was set to."""
    (_, speed), (length, collision) = case.speeds, CUT_OUTS[case]
    x = middle(FOLLOWING * speed)
    lead = target(name="lead", waypoints=lane_change(x, speed, length, 0.0, LANE))
    standing = target(position=[x + TARGET_LENGTH + speed * (BEGINS + collision), 0.0])
    return at_speed(speed, [lead, standing], BEGINS + length / speed + AFTER)


CUT_IN: Final = Family(
    name="cut-in",
    form="cut-in-{speed}-{target}",
    title="a car from the left lane",
    description="A car at {target} km/h cuts in from the left lane before {speed} km/h",
    source=f"{PROTOCOL}, cut-in; meaning of its time to collision [unverified]; {OWN}, from the left, after 1 s",
    cases=list(CUT_INS),
    scene=_cut_in,
)

CUT_OUT: Final = Family(
    name="cut-out",
    form="cut-out-{speed}-{target}",
    title="the car ahead reveals a stationary one",
    description="A car at {target} km/h cuts out and reveals a stationary one; following it, set to {speed} km/h",
    source=f"{PROTOCOL}, cut-out; meaning of its time to collision [unverified]; {OWN}, to the left, after 1 s, "
    "followed at its own speed with a headway of 1.5 s",
    cases=list(CUT_OUTS),
    scene=_cut_out,
)
