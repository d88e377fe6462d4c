"""From a guess to a local optimum: the program with a scene's numbers in it, solved again and again.

The proximal point method (Rockafellar, SIAM Journal on Control and Optimization 14, 1976): each solve pays p |z - z'|^2
for leaving the last one's inputs and lines z', so that it is well posed although many controls do equally well. What it
comes to rest at is an optimum without that term. Where a solve fails, the next one pays more for going far.
"""

from dataclasses import replace
from typing import Final

import numpy as np

from swerve.conventions import DELTA
from swerve.study.limit import numbers
from swerve.study.limit.layout import DISTANCE_SCALE, LOCK_SCALE, STATE_SCALE, Structure
from swerve.study.limit.means import Means
from swerve.study.limit.program import program
from swerve.study.limit.scene import Scene
from swerve.study.limit.trajectory import Sought, Trajectory
from swerve.world import Ellipse

PROXIMITY: Final = 0.3  # [m/s] p of the first solve
LEAST_PROXIMITY: Final = 0.03  # [m/s]
EASED: Final = 1 / 3  # [1] times p after a solve that succeeds and goes less far than it may
HELD: Final = numbers.FURTHEST * 1.001  # [1] of the last value: a solve that comes to less is held by that bound
TIGHTENED: Final = 4.0  # [1] times p after one that fails
MOST_SOLVES: Final = 24
MOST_FAILURES: Final = 4
RESTING: Final = 2e-4  # [1] of the value: a smaller gain is none, once p is small
SMALL: Final = 0.1  # [m/s] p
SOLVED: Final = ("Solve_Succeeded", "Solved_To_Acceptable_Level")


def descend(scene: Scene, means: Means, sought: Sought, guess: Trajectory) -> list[Trajectory]:
    """The local optimum near a guess, last of the solutions that led to it; none where the first solves all failed."""
    found: list[Trajectory] = []
    proximity, failures, last = PROXIMITY, 0, guess
    for _ in range(MOST_SOLVES):
        next_one = solve(scene, means, sought, last, proximity)
        if not next_one.is_solved:
            proximity, failures = proximity * TIGHTENED, failures + 1
            if failures == MOST_FAILURES:
                break
            continue
        found.append(next_one)
        gain = last.value(sought) - next_one.value(sought)
        if proximity <= SMALL and gain <= RESTING * last.value(sought):
            break
        if next_one.value(sought) > HELD * last.value(sought):
            proximity = max(EASED * proximity, LEAST_PROXIMITY)
        failures, last = 0, next_one
    return found


def solve(scene: Scene, means: Means, sought: Sought, guess: Trajectory, proximity: float) -> Trajectory:
    """The optimum that is near a guess; `is_solved` says whether it is one.

    Args:
        scene: with the distance and friction that are not sought.
        means: what may be used.
        sought: what is minimised.
        guess: where to start, and what not to leave far.
        proximity: p [m/s].
    """
    shapes = tuple(isinstance(each.shape, Ellipse) for each in scene.obstacles)
    has_edges = scene.road.left_edge is not None
    structure = Structure(means, shapes, len(scene.footprint.outline()), has_edges, guess.grid.n_intervals)
    made = program(structure)
    lower, upper = numbers.bounds(made.layout, structure, scene, sought, guess)
    low, high = numbers.rows(made.rows, scene, guess.grid)
    start = numbers.variables(made.layout, structure, scene, guess)
    p = numbers.parameters(structure, scene, sought, guess, proximity)
    x = np.array(made.solver(x0=start, p=p, lbx=lower, ubx=upper, lbg=low, ubg=high)["x"]).ravel()
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
