"""A scene's numbers for the program: the guess as its variables, bounds, rows, and parameters."""

from math import inf, isfinite, pi
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import PSI, VX, R
from swerve.study.limit import point_mass
from swerve.study.limit.dynamics import N_NUMBERS, model_numbers
from swerve.study.limit.grid import Ending, Grid
from swerve.study.limit.layout import DISTANCE_SCALE, STATE_SCALE, Layout, Structure, given
from swerve.study.limit.program import CREEP, END_YAW_RATE
from swerve.study.limit.scene import AHEAD, Scene, reach
from swerve.study.limit.separation import extents, gaps
from swerve.study.limit.trajectory import Sought, Trajectory

Array = NDArray[np.float64]

WIDEST_TURN: Final = pi / 2  # [rad] from the heading at the start
FURTHEST: Final = 0.8  # [1] of the guess's value: what is sought goes no further in one solve
COST: Final = np.array([1.0, 10.0, 1.0])  # c of D [m], mu [1] (so much are they worth of each other), s [m]


def variables(layout: Layout, structure: Structure, scene: Scene, guess: Trajectory) -> Array:
    """The guess as the program's variables."""
    x = np.zeros(layout.n)
    x[layout.states] = guess.states[1:] / STATE_SCALE
    x[layout.inputs] = structure.means.free(guess.shares).T * structure.input_scale
    for i, obstacle in enumerate(scene.at(guess.distance).obstacles):
        x[layout.lines[i]] = gaps(obstacle, scene.footprint, guess.states, guess.grid.times)[0]
    x[layout.globals] = guess.distance / DISTANCE_SCALE, guess.friction, guess.violation
    return x


def bounds(
    layout: Layout, structure: Structure, scene: Scene, sought: Sought, guess: Trajectory
) -> tuple[Array, Array]:
    """Smallest and largest value of each variable."""
    upper = np.full(layout.n, inf)
    lower = -upper
    scale, means = structure.input_scale, structure.means
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
    lower[free], upper[free] = max(_least(scene, sought), FURTHEST * known[sought.value]), inf
    return lower, upper


def _least(scene: Scene, sought: Sought) -> float:
    """What is certain not to be undercut, in units of the variable: it keeps the search where solutions are."""
    if sought is Sought.DISTANCE:
        return point_mass.smallest_distance(scene) / DISTANCE_SCALE
    return point_mass.smallest_friction(scene) if sought is Sought.FRICTION else 0.0


def rows(groups: dict[str, slice], scene: Scene, grid: Grid) -> tuple[Array, Array]:
    """Smallest and largest value of each row."""
    n_rows = max(each.stop for each in groups.values())
    lower, upper = np.zeros(n_rows), np.full(n_rows, inf)
    upper[groups["dynamics"]] = 0.0
    if "edges" in groups:
        lower[groups["edges"]], upper[groups["edges"]] = scene.road.right_edge, scene.road.left_edge
    change = scene.vehicle.steering_rate_limit * grid.step / scene.vehicle.steering_limit
    lower[groups["rate"]], upper[groups["rate"]] = -change, change
    if isfinite(change):  # the staircase of held inputs goes through the middle of a ramp
        first = groups["rate"].start
        lower[first], upper[first] = -change / 2, change / 2
    own = float(scene.footprint.support(AHEAD)[1])
    ends = [own + reach(each, AHEAD, grid.times[-1])[0] if scene.is_passed(each) else -inf for each in scene.obstacles]
    lower[groups["past"]] = ends if grid.ending is Ending.PAST else -inf
    return lower, upper


def parameters(structure: Structure, scene: Scene, sought: Sought, guess: Trajectory, proximity: float) -> Array:
    """The vector of parameters: those of `layout.given`, in its order."""
    times = guess.grid.times
    values: dict[str, Any] = {
        "start": scene.start,
        "step": guess.grid.step,
        "model": model_numbers(scene.vehicle, guess.grid.step, guess.friction),
        "cost": COST * np.eye(3)[sought.value],
        "proximity": proximity,
        "vertices": scene.footprint.outline().T,
        "inputs": structure.means.free(guess.shares) * structure.input_scale[:, np.newaxis],
    }
    for i, obstacle in enumerate(scene.at(0.0).obstacles):
        values[f"poses{i}"] = np.vstack([obstacle.position_at(times).T, obstacle.heading_at(times)])
        values[f"half{i}"] = np.array(extents(obstacle.shape))
    for i, obstacle in enumerate(scene.at(guess.distance).obstacles):
        values[f"lines{i}"] = gaps(obstacle, scene.footprint, guess.states, times)[0].T
    return np.concatenate([np.ravel(values[name], order="F") for name in given(structure, N_NUMBERS)])
