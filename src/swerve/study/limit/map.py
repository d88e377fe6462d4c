"""The smallest distance over speed and friction."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from swerve.scenario import load
from swerve.study.limit import point_mass
from swerve.study.limit.best import best
from swerve.study.limit.limit import Progress
from swerve.study.limit.means import Means
from swerve.study.limit.scene import Scene
from swerve.study.limit.trajectory import Sought

SPEEDS: Final = (15.0, 20.0, 25.0, 30.0, 35.0)  # [m/s]
FRICTIONS: Final = (0.3, 0.5, 0.85, 1.0)  # [1]


@dataclass(frozen=True)
class Cell:
    """One speed and friction.

    Attributes:
        distance: smallest, re-simulated [m]; None where no start led to one.
        bound: by `point_mass` [m].
        ratio: smallest sqrt(rho) of the re-simulation [1]; None without one, or without an ellipse.
    """

    distance: float | None
    bound: float
    ratio: float | None


@dataclass(frozen=True)
class LimitMap:
    """Cells by friction, then speed."""

    scenario: str
    means: Means
    speeds: tuple[float, ...]
    frictions: tuple[float, ...]
    cells: tuple[tuple[Cell, ...], ...]


def limit_map(
    name: str,
    means: Means,
    overrides: Sequence[str] = (),
    speeds: Sequence[float] = SPEEDS,
    frictions: Sequence[float] = FRICTIONS,
    progress: Progress = lambda share: None,
) -> LimitMap:
    """The map of a scenario with overrides: its speed [m/s] and friction [1] replaced by each pair."""
    cells: list[list[Cell]] = []
    for i, friction in enumerate(frictions):
        cells.append([])
        for j, speed in enumerate(speeds):
            cells[-1].append(_cell(name, overrides, means, speed, friction))
            progress((i * len(speeds) + j + 1) / (len(frictions) * len(speeds)))
    return LimitMap(name, means, tuple(speeds), tuple(frictions), tuple(map(tuple, cells)))


def _cell(name: str, overrides: Sequence[str], means: Means, speed: float, friction: float) -> Cell:
    scene = Scene.of(load(name, [*overrides, f"ego.speed={speed}", f"road.friction={friction}"]))
    found, bound = best(scene, means, Sought.DISTANCE), point_mass.smallest_distance(scene)
    if found is None:
        return Cell(None, bound, None)
    return Cell(found.trajectory.distance, bound, found.drive.ratio)
