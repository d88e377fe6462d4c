"""Maps in closed form, to report about: every boundary is a formula of its condition, so that every number is known."""

from functools import cache
from itertools import product

from swerve.report.map.commands import Source
from swerve.study.map.boundary import Boundary, Condition, Map, RunRecord
from swerve.study.map.closed_form import braking_distance, swerving_distance

SPEEDS = (10.0, 15.0, 20.0, 25.0, 30.0, 35.0)  # [m/s]
FRICTIONS = (0.3, 0.5, 0.85, 1.0)
SHARES = {"unified": 1.04, "nonlinear": 1.02, "hierarchical": 1.18, "brake": 0.0}  # of the limit; brake has its own
LIMITS = {
    "limit: individual": 1.0,
    "limit: both": 1.03,
    "limit: steering": 1.1,
    "limit: braking": 0.0,
    "limit: point-mass": 0.85,
}
HALF_WIDTH, EXTENT = 2.0, 2.0  # [m]
TOLERANCE = 0.25  # [m]
AWAY = (-4, -1, 0, 2, 8, 20)  # of a run from the boundary [tolerance]
SOURCE = Source("paper")


def nearest(condition: Condition) -> float:
    """The limit: as soon as braking suffices, or swerving [m]."""
    braking = braking_distance(condition.speed, condition.friction) + EXTENT
    width = HALF_WIDTH - abs(condition.offset)
    return min(braking, 1.1 * swerving_distance(condition.speed, condition.friction, width))


def reached(who: str, condition: Condition) -> float:
    """The last avoided distance of a controller [m]."""
    if who == "brake":
        return 1.05 * (braking_distance(condition.speed, condition.friction) + EXTENT)
    return SHARES[who] * nearest(condition)


def turning(who: str, condition: Condition) -> float | None:
    """Where a controller's decision turns: braking suffices beyond [m]."""
    braking = 1.1 * (braking_distance(condition.speed, condition.friction) + EXTENT)
    return braking if who in ("unified", "nonlinear") and braking > reached(who, condition) else None


@cache
def made(
    speeds: tuple[float, ...] = SPEEDS,
    frictions: tuple[float, ...] = FRICTIONS,
    offsets: tuple[float, ...] = (0.0,),
    controllers: tuple[str, ...] = tuple(SHARES),
    limits: tuple[str, ...] = tuple(LIMITS),
) -> Map:
    """A map; of `hierarchical` nothing is avoided at the largest speed on the least friction."""
    conditions = tuple(Condition(v, mu, y) for mu, v, y in product(frictions, speeds, offsets))
    own = [(who, each) for who in controllers for each in conditions]
    runs = [run for who, each in own for run in _runs(who, each)]
    boundaries = [_boundary(who, each) for who, each in own]
    boundaries += [_limit(who, each) for who in limits for each in conditions]
    numbers = ("paper", "planar", 0, TOLERANCE, HALF_WIDTH, EXTENT)
    return Map(*numbers, controllers, limits, conditions, tuple(boundaries), tuple(runs))


def _fails(who: str, condition: Condition) -> bool:
    return who == "hierarchical" and (condition.speed, condition.friction) == (35.0, 0.3)


def _runs(who: str, condition: Condition) -> list[RunRecord]:
    turn = turning(who, condition)
    distances = [reached(who, condition) + away * TOLERANCE for away in AWAY]
    return [_run(who, condition, each, turn is None or each < turn) for each in distances]


def _run(who: str, condition: Condition, distance: float, steers: bool) -> RunRecord:
    decision = "brake" if who == "brake" or not steers else "brake+steer-left"
    gap = distance - reached(who, condition)
    if gap < 0 or _fails(who, condition):
        return RunRecord(who, condition, distance, "collided", decision, 0.0, 0.3 * condition.speed, 0.98, 0.05)
    return RunRecord(who, condition, distance, "avoided", decision, 0.01 + gap / 10, None, 1.01, 0.04)


def _boundary(who: str, condition: Condition) -> Boundary:
    last = reached(who, condition)
    if _fails(who, condition):
        furthest = last + AWAY[-1] * TOLERANCE
        return Boundary(who, condition, None, furthest, None, "collided", len(AWAY), None)
    decision = next(run.decision for run in _runs(who, condition) if run.distance == last)
    turn = turning(who, condition)
    return Boundary(who, condition, last, last - TOLERANCE, decision, "collided", len(AWAY), turn)


def allowed(who: str, condition: Condition) -> float:
    """The limit of a series; braking has its own [m]."""
    if who == "limit: braking":
        return braking_distance(condition.speed, condition.friction) + EXTENT
    return LIMITS[who] * nearest(condition)


def _limit(who: str, condition: Condition) -> Boundary:
    return Boundary(who, condition, allowed(who, condition), None, None, None, 1, None)
