"""What a map holds: for each series and condition the distance from which on it avoids, and the runs that say so.

A series is a controller, or one of the limits: what any control could avoid with some means (`study.limit`), and the
bound that a point mass cannot go below. The distance is that of `study.limit`: from the ego vehicle's centre of gravity
to the centre of the first obstacle ahead, along X; all obstacles are shifted alike.
"""

from dataclasses import dataclass
from typing import Final

AVOIDED: Final = "avoided"  # the outcome of a run that counts
LIMIT: Final = "limit: "  # begins the name of a series that is no controller


@dataclass(frozen=True, order=True)
class Condition:
    """One cell.

    Attributes:
        speed: of the ego vehicle, and of its goal [m/s].
        friction: of the road [1].
        offset: by which all obstacles are moved along Y [m].
    """

    speed: float
    friction: float
    offset: float


@dataclass(frozen=True)
class RunRecord:
    """What is kept of one run, which ends at its first contact; nothing of it depends on the machine or the clock.

    Attributes:
        who: the series.
        condition: the cell.
        distance: of the first obstacle ahead; of a limit the one that was found, infinite where none was [m].
        outcome: as in `simulate.Outcome`; of a limit `avoided`, or `none` where no distance was found.
        decision: as in `simulate.Result`; None for a limit.
        min_clearance: between footprint and obstacles [m].
        impact_speed: relative to the obstacle; None without contact [m/s].
        min_distance_ratio: smallest sqrt(rho), 1 is contact; None without an ellipse [1].
        max_sideslip: magnitude; None for a limit [rad].
    """

    who: str
    condition: Condition
    distance: float
    outcome: str
    decision: str | None = None
    min_clearance: float | None = None
    impact_speed: float | None = None
    min_distance_ratio: float | None = None
    max_sideslip: float | None = None

    @property
    def is_avoided(self) -> bool:
        """Whether nothing was touched and the vehicle stayed in hand and on the road."""
        return self.outcome == AVOIDED


@dataclass(frozen=True)
class Boundary:
    """One series in one condition.

    Attributes:
        who: name of a controller, or `limit: individual`, `limit: both`, `limit: braking`, `limit: point-mass`.
        condition: the cell.
        avoided: smallest distance tried that is avoided with all larger ones; None where none is [m].
        failed: the largest that is not, below it; None where all are avoided [m].
        decision: of the run at `avoided`; None for limits.
        outcome: of the run at `failed`.
        n_runs: how many runs it took.
        turns: distance at which the decision turns from braking (larger) to steering (smaller); None where it does
            not [m].
        holes: distances that were not avoided though a smaller one was [m].
    """

    who: str
    condition: Condition
    avoided: float | None
    failed: float | None
    decision: str | None
    outcome: str | None
    n_runs: int
    turns: float | None
    holes: tuple[float, ...] = ()


@dataclass(frozen=True)
class Map:
    """All of it.

    Attributes:
        scenario: its name.
        plant: its name.
        seed: of every run.
        tolerance: between `avoided` and `failed` [m].
        half_width: how far aside the vehicle has to go, half of obstacle and half of footprint, without offset [m].
        extent: from the centre of gravity to where the vehicle touches, less the gap, bumper to bumper [m].
        controllers: names.
        limits: names of the series that are no controllers.
        conditions: in ascending order of friction, speed and offset.
        boundaries: controllers before limits, each in the order of the conditions.
        runs: of the controllers, in the boundaries' order, by distance.
    """

    scenario: str
    plant: str
    seed: int
    tolerance: float
    half_width: float
    extent: float
    controllers: tuple[str, ...]
    limits: tuple[str, ...]
    conditions: tuple[Condition, ...]
    boundaries: tuple[Boundary, ...]
    runs: tuple[RunRecord, ...]

    def boundary(self, who: str, condition: Condition) -> Boundary | None:
        """That of one series in one condition; None where the map has none."""
        return next((each for each in self.boundaries if (each.who, each.condition) == (who, condition)), None)
