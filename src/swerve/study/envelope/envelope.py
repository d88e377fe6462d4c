"""The envelope: at every speed and friction of the table of limits, how near to the limit the disc may be.

The disc comes nearer step by step, in shares of the limit, until it is hit; the last distance before that is the
smallest one that is avoided. What lies nearer is not looked at: a hit is a hit, whatever luck may do behind it.
"""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Final

from swerve.scenario import Scenario, load
from swerve.simulate import Outcome, run
from swerve.study.envelope.limits import LIMITS, RADIUS, SPEEDS

CONTROLLER: Final = "unified"
RATIOS: Final = (1.5, 1.3, 1.2, 1.15, 1.12, 1.1, 1.08, 1.06, 1.04, 1.03, 1.02, 1.01, 1.0, 0.99, 0.98)  # of the limit
REQUIRED: Final = {"planar": 1.04, "multibody": 1.15}  # by plant: at and above this ratio it is to be avoided
DURATION: Final = 4.0  # [s]

Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1


@dataclass(frozen=True)
class Condition:
    """One cell: speed [m/s], friction [1], and the smallest distance that physics allows [m]."""

    speed: float
    friction: float
    limit: float

    def scene(self, ratio: float) -> Scenario:
        """The paper's scenario at this speed and friction, with the disc at a ratio of the limit [1]."""
        overrides = (
            f"ego.speed={self.speed}",
            f"goal.speed={self.speed}",
            f"road.friction={self.friction}",
            f"obstacles=[{{position=[{ratio * self.limit}, 0], semi_axes=[{RADIUS}, {RADIUS}]}}]",
            f"duration={DURATION}",
        )
        return load("paper", overrides)


@dataclass(frozen=True)
class Cell:
    """What became of one condition.

    Attributes:
        condition: speed, friction and limit.
        ratio: the smallest ratio to the limit that is avoided with all larger ones; None where the largest is not [1].
        failed: the ratio after it; None where the smallest one is avoided [1].
        outcome: at that one.
    """

    condition: Condition
    ratio: float | None
    failed: float | None
    outcome: Outcome | None

    def reaches(self, required: float) -> bool:
        """Whether every distance down to a ratio is avoided."""
        return self.ratio is not None and self.ratio <= required


@dataclass(frozen=True)
class Envelope:
    """All conditions on one plant, friction by friction."""

    plant: str
    cells: tuple[Cell, ...]

    @property
    def short(self) -> tuple[Cell, ...]:
        """Those that do not reach what is required on this plant."""
        return tuple(cell for cell in self.cells if not cell.reaches(REQUIRED[self.plant]))


def conditions() -> Iterator[Condition]:
    """All that have a limit."""
    for friction, row in LIMITS.items():
        for speed, limit in zip(SPEEDS, row, strict=True):
            if limit is not None:
                yield Condition(speed, friction, limit)


def envelope(
    plant: str,
    progress: Progress,
    executor: Executor | None = None,
    chosen: Sequence[Condition] = tuple(conditions()),
    ratios: Sequence[float] = RATIOS,
) -> Envelope:
    """Find the smallest distances.

    Args:
        plant: by name.
        progress: called with the share that is done [1].
        executor: looks at conditions beside one another; without one they are looked at here.
        chosen: the conditions.
        ratios: of the limit, from the largest on.
    """
    apply = executor.map if executor else map
    cells: list[Cell] = []
    for cell in apply(approach, chosen, [plant] * len(chosen), [ratios] * len(chosen)):
        cells.append(cell)
        progress(len(cells) / len(chosen))
    return Envelope(plant, tuple(cells))


def approach(condition: Condition, plant: str, ratios: Sequence[float] = RATIOS) -> Cell:
    """Bring the disc nearer until it is not avoided."""
    last: float | None = None
    for ratio in ratios:
        outcome = run(condition.scene(ratio), CONTROLLER, plant).result.outcome
        if outcome is not Outcome.AVOIDED:
            return Cell(condition, last, ratio, outcome)
        last = ratio
    return Cell(condition, last, None, None)
