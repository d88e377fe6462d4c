"""Euro NCAP 2026 Crash Avoidance, Frontal: car-to-car rear, with a target that stands, moves slower or brakes.

The bumpers are apart, at the start [m]
    CCRs, CCRm   START_TTC (v - v_target)      own: late enough to matter, early enough for a straight approach
    CCRb         HEADWAY v
"""

from typing import Final

from swerve.scenario.families.family import BASE, BODY, Case, Family, Tables
from swerve.units import to_si

TARGET_LENGTH: Final[float] = BASE["obstacles"][0]["size"][0]

START_TTC: Final = 4.0  # [s] own
HEADWAY: Final = 1.0  # [s] protocol
BRAKING: Final = -4.0  # [m/s^2] protocol
FINAL_SPEED: Final = to_si("2 km/h", "speed")  # [m/s] protocol
BRAKES_AT: Final = 1.0  # [s] own
DURATION: Final = 8.0  # [s] own

IMPACTS: Final = (0, 25, 50, 75, 100)  # [%] protocol
MOVING: Final = {30: 20, 40: 20, 50: 20, 60: 20, 70: 20, 80: 20, 90: 30, 100: 40, 110: 50, 120: 60, 130: 70}  # [km/h]

PROTOCOL: Final = "Euro NCAP 2026 Crash Avoidance, Frontal"
OWN: Final = "own: friction, lanes, place of the centre of gravity"


def target(**motion: object) -> Tables:
    """The protocol's target with a motion."""
    (body,) = BASE["obstacles"]
    return {**body, **motion}


def middle(gap: float) -> float:
    """X of the target's middle when its rear bumper is `gap` before the front of the vehicle under test [m]."""
    return BODY["cg_to_front_end"] + gap + TARGET_LENGTH / 2


def ahead(gap: float, case: Case, **motion: object) -> Tables:
    """The target in the impact location, `gap` [m] before the front."""
    return target(position=[middle(gap), case.lateral_offset], velocity=[case.speeds[1], 0.0], **motion)


def at_speed(speed: float, obstacles: list[Tables], duration: float = DURATION) -> Tables:
    """A scene in which the vehicle under test starts with and is to hold a speed [m/s]."""
    return {"duration": duration, "ego": {"speed": speed}, "goal": {"speed": speed}, "obstacles": obstacles}


def _closing(case: Case) -> Tables:
    speed, lead = case.speeds
    return at_speed(speed, [ahead(START_TTC * (speed - lead), case)])


def _braking(case: Case) -> Tables:
    speed, _ = case.speeds
    brakes = {"acceleration": [BRAKING, 0.0], "accelerates_at": BRAKES_AT, "final_speed": FINAL_SPEED}
    return at_speed(speed, [ahead(HEADWAY * speed, case, **brakes)])


CCRS: Final = Family(
    name="ccrs",
    form="ccrs-{speed}-il{impact}",
    title="a stationary car",
    description="CCRs: {speed} km/h towards a stationary car, impact location {impact} %, from 4 s before",
    source=f"{PROTOCOL}, CCRs; {OWN}, start at a time to collision of 4 s",
    cases=[Case(speed, 0, impact) for speed in range(10, 90, 10) for impact in IMPACTS],
    scene=_closing,
)

CCRM: Final = Family(
    name="ccrm",
    form="ccrm-{speed}-il{impact}",
    title="a car at 20 to 70 km/h",
    description="CCRm: {speed} km/h towards a car at {target} km/h, impact location {impact} %, from 4 s before",
    source=f"{PROTOCOL}, CCRm; {OWN}, start at a time to collision of 4 s",
    cases=[Case(speed, target, impact) for speed, target in MOVING.items() for impact in IMPACTS],
    scene=_closing,
)

CCRB: Final = Family(
    name="ccrb",
    form="ccrb-{speed}-il{impact}",
    title="a car 1 s ahead that brakes",
    description="CCRb: a car 1 s ahead at {speed} km/h brakes with 4 m/s^2, impact location {impact} %",
    source=f"{PROTOCOL}, CCRb, to 2 km/h; impact locations [unverified]; {OWN}, braking begins after 1 s",
    cases=[Case(speed, speed, impact) for speed in range(30, 90, 10) for impact in IMPACTS],
    scene=_braking,
)
