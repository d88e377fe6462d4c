"""The program with a scene's numbers in it: from a guess to the local optimum that is near it."""

from dataclasses import dataclass, replace
from enum import Enum
from math import inf, isfinite, pi
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import DELTA, PSI, VX, R
from swerve.study.limit import point_mass
from swerve.study.limit.dynamics import slip_speed_floor
from swerve.study.limit.grid import Ending, Grid
from swerve.study.limit.means import Means
from swerve.study.limit.program import (
    CREEP,
    DISTANCE_SCALE,
    END_YAW_RATE,
    EPSILON,
    LOCK_SCALE,
    STATE_SCALE,
    Layout,
    Structure,
    given,
    program,
)
from swerve.study.limit.scene import AHEAD, Scene, reach
from swerve.study.limit.separation import best_lines, extents
from swerve.world import Ellipse, Obstacle

Array = NDArray[np.float64]

STRIDE: Final = 0.95  # [1] times the guess's distance or friction: no solve goes further, see `limit.descend`
LONGEST: Final = 1.02  # [1] times the guess's distance or friction, which can be avoided already
WIDEST_TURN: Final = pi / 2  # [rad] from the heading at the start
SOLVED: Final = ("Solve_Succeeded", "Solved_To_Acceptable_Level")


class Sought(Enum):
    """What is minimised, in the order of the program's variables D, mu, s."""

    DISTANCE = 0
    FRICTION = 1
    VIOLATION = 2


@dataclass(frozen=True, eq=False)
class Trajectory:
    """A guess, or a solution.

    Attributes:
        grid: on which it is.
        states: (N + 1, 6).
        shares: (N, 5) w of `means`.
        distance: D [m].
        friction: mu [1].
        violation: s [m].
        is_solved: whether a solver says that it is a local optimum.
    """

    grid: Grid
    states: Array
    shares: Array
    distance: float
    friction: float
    violation: float = 0.0
    is_solved: bool = False

    def value(self, sought: Sought) -> float:
        """What was minimised."""
        return (self.distance, self.friction, self.violation)[sought.value]


def solve(scene: Scene, means: Means, sought: Sought, guess: Trajectory, epsilon: float = EPSILON) -> Trajectory:
    """The local optimum that is found from a guess; `is_solved` says whether it is one."""
    structure = Structure(
        scene.vehicle,
        means,
        tuple(isinstance(each.shape, Ellipse) for each in scene.obstacles),
        len(scene.footprint.outline()),
    )
    made = program(structure)
    start = _variables(made.layout, scene, means, guess)
    lower, upper = _bounds(made.layout, scene, means, sought, guess)
    low, high = _rows(made.layout, scene, guess.grid)
    p = _numbers(structure, scene, sought, guess, epsilon)
    out = made.solver(x0=start, p=p, lbx=lower, ubx=upper, lbg=low, ubg=high)
    x = np.array(out["x"]).ravel()
    shares = x[made.layout.inputs] @ means.directions.T
    shares[:, DELTA] /= LOCK_SCALE
    distance, friction, violation = x[made.layout.globals]
    return replace(
        guess,
        states=np.vstack([scene.start, x[made.layout.states] * STATE_SCALE]),
        shares=shares,
        distance=float(distance * DISTANCE_SCALE),
        friction=float(friction),
        violation=float(violation),
        is_solved=made.solver.stats()["return_status"] in SOLVED,
    )


def seen_from(obstacle: Obstacle, scene: Scene, states: Array, times: Array) -> Array:
    """The footprint's vertices (n, k, 2) at each of n states in the frame of an obstacle of the scene [m]."""
    vertices, psi = scene.footprint.outline(), states[:, PSI, np.newaxis]
    in_world = states[:, np.newaxis, 4:] + _turned(vertices, psi)
    return _turned(in_world - obstacle.position_at(times)[:, np.newaxis], np.full_like(psi, -obstacle.heading))


def gaps(obstacle: Obstacle, scene: Scene, states: Array, times: Array) -> tuple[Array, Array]:
    """The best line (n - 1, 2) of each interval, and how far it parts both bodies [m], negative where it does not."""
    seen = seen_from(obstacle, scene, states, times)
    both = np.concatenate([seen[:-1], seen[1:]], axis=1)
    lines = best_lines(obstacle.shape, both)
    normals = np.column_stack((np.cos(lines[:, 0]), np.sin(lines[:, 0])))
    nearest = np.einsum("nki,ni->nk", both, normals).min(axis=1)
    return lines, nearest - obstacle.shape.support(normals)


def _turned(vectors: Array, angle: Array) -> Array:
    cos, sin = np.cos(angle), np.sin(angle)
    x, y = vectors[..., 0], vectors[..., 1]
    return np.stack((cos * x - sin * y, sin * x + cos * y), axis=-1)


def _variables(layout: Layout, scene: Scene, means: Means, guess: Trajectory) -> Array:
    """The guess as the program's variables."""
    x = np.zeros(layout.n)
    x[layout.states] = guess.states[1:] / STATE_SCALE
    x[layout.inputs] = means.free(guess.shares).T * _scale(means)
    for i, obstacle in enumerate(scene.at(guess.distance).obstacles):
        x[layout.lines[i]] = gaps(obstacle, scene, guess.states, guess.grid.times)[0]
    x[layout.globals] = guess.distance / DISTANCE_SCALE, guess.friction, guess.violation
    return x


def _scale(means: Means) -> Array:
    """Units of each input's variable in a share of it."""
    scale: Array = np.where(means.directions[DELTA] > 0, LOCK_SCALE, 1.0)
    return scale


def _bounds(layout: Layout, scene: Scene, means: Means, sought: Sought, guess: Trajectory) -> tuple[Array, Array]:
    """Smallest and largest value of each variable."""
    upper = np.full(layout.n, inf)
    lower = -upper
    scale = _scale(means)
    lower[layout.inputs], upper[layout.inputs] = means.lower * scale, means.upper * scale
    lower[layout.states[:, VX]] = 0.0
    turn = scene.start[PSI] + WIDEST_TURN * np.array([-1, 1])
    lower[layout.states[:, PSI]], upper[layout.states[:, PSI]] = turn / STATE_SCALE[PSI]
    lower[layout.states[-1, R]], upper[layout.states[-1, R]] = np.array([-1, 1]) * END_YAW_RATE / STATE_SCALE[R]
    if guess.grid.ending is Ending.BEHIND:
        upper[layout.states[-1, VX]] = (scene.slowest + CREEP) / STATE_SCALE[VX]
    known = [guess.distance / DISTANCE_SCALE, guess.friction, 0.0]
    lower[layout.globals] = upper[layout.globals] = known
    free = layout.globals[sought.value]
    lower[free] = max(_least(scene, sought), STRIDE * known[sought.value])
    upper[free] = inf if sought is Sought.VIOLATION else LONGEST * known[sought.value]
    return lower, upper


def _least(scene: Scene, sought: Sought) -> float:
    """What is certain not to be undercut, in units of the variable: it keeps the search where solutions are."""
    if sought is Sought.DISTANCE:
        return point_mass.smallest_distance(scene) / DISTANCE_SCALE
    return point_mass.smallest_friction(scene) if sought is Sought.FRICTION else 0.0


def _rows(layout: Layout, scene: Scene, grid: Grid) -> tuple[Array, Array]:
    """Smallest and largest value of each row."""
    n_rows = max(each.stop for each in layout.rows.values())
    lower, upper = np.zeros(n_rows), np.full(n_rows, inf)
    upper[layout.rows["dynamics"]] = 0.0
    edges = scene.road.right_edge, scene.road.left_edge
    lower[layout.rows["edges"]] = -inf if edges[0] is None else edges[0]
    upper[layout.rows["edges"]] = inf if edges[1] is None else edges[1]
    change = scene.vehicle.steering_rate_limit * grid.step / scene.vehicle.steering_limit
    lower[layout.rows["rate"]], upper[layout.rows["rate"]] = -change, change
    if isfinite(change):  # the staircase of held inputs goes through the middle of a ramp
        first = layout.rows["rate"].start
        lower[first], upper[first] = -change / 2, change / 2
    own = float(scene.footprint.support(AHEAD)[1])
    ends = [own + reach(each, AHEAD)[0] for each in scene.obstacles]
    lower[layout.rows["past"]] = ends if grid.ending is Ending.PAST else -inf
    return lower, upper


def _numbers(structure: Structure, scene: Scene, sought: Sought, guess: Trajectory, epsilon: float) -> Array:
    """The vector of parameters: those of `program.given`, in its order."""
    times = guess.grid.times
    values: dict[str, Any] = {
        "start": scene.start,
        "step": guess.grid.step,
        "slip_speed_floor": slip_speed_floor(guess.grid.step, guess.friction),
        "cost": [*np.eye(3)[sought.value], epsilon],
        "vertices": scene.footprint.outline().T,
    }
    for i, obstacle in enumerate(scene.at(0.0).obstacles):
        where = obstacle.position_at(times)
        values[f"poses{i}"] = np.vstack([where.T, np.full(len(times), obstacle.heading)])
        values[f"lines{i}"] = gaps(scene.at(guess.distance).obstacles[i], scene, guess.states, times)[0].T
        values[f"half{i}"] = np.array(extents(obstacle.shape))
    return np.concatenate([np.ravel(values[name], order="F") for name in given(structure)])
