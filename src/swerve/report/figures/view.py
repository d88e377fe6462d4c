"""What a top view shows: instants of the manoeuvre, and the stretch of road that they are drawn on."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.report.figures.body import bodies
from swerve.simulate import Run
from swerve.world import Obstacle, Road, clearance

Array = NDArray[np.float64]

EVERY: Final = 0.25  # between two instants [s]
LONGEST: Final = 200.0  # stretch along X or Y; of a longer run, the one round the closest approach [m]
FARTHEST: Final = 1e6  # that a vehicle can come in a run [m]
NEAR: Final = 30.0  # from what the vehicle covered to an obstacle that is drawn [m]
MARGIN: Final = 1.0  # round all that is drawn [m]


@dataclass(frozen=True, eq=False)
class View:
    """The part of a run that is drawn.

    Attributes:
        times: of the instants (n,) [s].
        poses: of the vehicle at the instants (n, 3) [m, m, rad].
        steering: at the instants (n,) [rad].
        path: of the centre of gravity, at each step of the plant (m, 2) [m].
        obstacles: of the scenario.
        names: of the obstacles, None for one without.
        closest: row of `path` that is nearest to an obstacle, the first one in contact; None without obstacles.
        x: the stretch that is drawn [m].
        y: its lower and upper end [m].
    """

    times: Array
    poses: Array
    steering: Array
    path: Array
    obstacles: tuple[Obstacle, ...]
    names: tuple[str | None, ...]
    closest: int | None
    x: tuple[float, float]
    y: tuple[float, float]


def view_of(run: Run) -> View:
    """Choose what is drawn of a run."""
    motion = run.log.motion
    rows = motion.stack("time", "X", "Y", "psi", "delta")
    rows = rows[(np.abs(rows) < FARTHEST).all(axis=1)]  # a run that diverged ends in others, nan among them
    obstacles = tuple(obstacle.to_world() for obstacle in run.scenario.obstacles)
    instants = rows[_every(rows[:, 0])]
    poses, closest = instants[:, 1:4], _closest(run, rows, obstacles)
    covered = np.concatenate([bodies(run.scenario.ego.to_vehicle(), poses).reshape(-1, 2), rows[:, 1:3]])
    passed = np.concatenate([outline(obstacle, instants[:, 0]).reshape(-1, 2) for obstacle in obstacles] or [covered])
    near = within(passed[:, 0], covered[:, 0].min() - NEAR, covered[:, 0].max() + NEAR)
    points = np.concatenate([covered, passed[near]])
    middle = rows[0 if closest is None else closest]
    x = _stretch(points[:, 0], middle[1])
    y = _stretch(np.append(points[within(points[:, 0], *x), 1], _edges(run.scenario.road.to_world())), middle[2])
    names = tuple(obstacle.name for obstacle in run.scenario.obstacles)
    return View(instants[:, 0], poses, instants[:, 4], rows[:, 1:3], obstacles, names, closest, x, y)


def view_of_all(runs: Sequence[Run]) -> View:
    """What is drawn of runs in one scene: instants and path of the longest, a stretch of road that shows them all."""
    views = [view_of(run) for run in runs]
    longest = max(views, key=lambda view: view.times[-1])
    y = min(view.y[0] for view in views), max(view.y[1] for view in views)
    ends = np.array([view.x for view in views])
    middle = longest.path[0 if longest.closest is None else longest.closest, 0]
    return replace(longest, x=_stretch(ends + np.array([MARGIN, -MARGIN]), middle), y=y)


def outline(obstacle: Obstacle, times: Array) -> Array:
    """The obstacle's outline at each of the times (n,) [s]: (n, k, 2) [m]."""
    cos, sin = np.cos(obstacle.heading_at(times)), np.sin(obstacle.heading_at(times))
    turns = np.stack([np.stack([cos, sin], axis=-1), np.stack([-sin, cos], axis=-1)], axis=-2)
    placed: Array = obstacle.position_at(times)[:, np.newaxis] + obstacle.shape.outline() @ turns
    return placed


def is_moving(obstacle: Obstacle, times: Array) -> bool:
    """Whether it is anywhere else at any of the times (n,) [s] than at the first."""
    positions = obstacle.position_at(times)
    return bool((positions != positions[0]).any())


def within(values: Array, low: float, high: float) -> NDArray[np.bool_]:
    """Which values are from low to high."""
    inside: NDArray[np.bool_] = (low <= values) & (values <= high)
    return inside


def _every(times: Array) -> NDArray[np.intp]:
    """The rows at, or first after, every quarter of a second."""
    wanted = np.arange(0.0, times[-1] + EVERY / 2, EVERY)
    after = np.clip(np.searchsorted(times, wanted - 1e-9), 0, len(times) - 1)
    return np.unique(after)


def _closest(run: Run, rows: Array, obstacles: tuple[Obstacle, ...]) -> int | None:
    footprint = run.scenario.ego.to_footprint()
    gaps = [clearance(footprint, rows[:, 1:4], obstacle, rows[:, 0]) for obstacle in obstacles]
    return int(np.argmin(np.min(gaps, axis=0))) if gaps else None


def _edges(road: Road) -> list[float]:
    """Y of the road's edges, where there are any [m]."""
    return [edge for edge in (road.left_edge, road.right_edge) if edge is not None]


def _stretch(values: Array, middle: float) -> tuple[float, float]:
    """What holds all values (n,) [m], or as many of them round the middle as are drawn."""
    low, high = float(values.min()) - MARGIN, float(values.max()) + MARGIN
    if high - low <= LONGEST:
        return low, high
    start = float(np.clip(middle - LONGEST / 2, low, high - LONGEST))
    return start, start + LONGEST
