"""The rows that every interval has: the dynamics, the lines between vehicle and obstacles, and the road's edges."""

from typing import Final

import casadi as ca
import numpy as np

from swerve.conventions import DELTA, PSI, X, Y
from swerve.study.limit.blocks import FIXED, Block, Indices
from swerve.study.limit.dynamics import dynamics
from swerve.study.limit.layout import DISTANCE_SCALE, LOCK_SCALE, STATE_SCALE, Given, Layout, Structure
from swerve.study.limit.separation import heights, separation

POSE: Final = [X, Y, PSI]


def blocks_of(structure: Structure, layout: Layout, x: ca.MX, p: Given) -> dict[str, list[Block]]:
    """The blocks by the name of what they ask, in the order of the rows."""
    blocks = {
        "dynamics": [_dynamics(structure, layout, x, p)],
        "separation": [_separation(structure, layout, x, p, i) for i in range(len(structure.ellipses))],
    }
    return blocks | {"edges": [_edges(structure, layout, x, p)]} if structure.has_edges else blocks


def _starts(layout: Layout) -> Indices:
    """(6, N) of the states at the start of the intervals; the first is given."""
    return np.vstack([np.full((1, layout.states.shape[1]), FIXED), layout.states[:-1]]).T


def _dynamics(structure: Structure, layout: Layout, x: ca.MX, p: Given) -> Block:
    directions, n = structure.means.directions, structure.n_intervals
    by, is_free = directions.argmax(axis=1), directions.max(axis=1, keepdims=True) > 0
    shares = np.where(is_free, layout.inputs.T[by], FIXED)
    index = np.vstack([_starts(layout), shares, np.full((1, n), layout.globals[1])])
    scale = np.concatenate([STATE_SCALE, np.ones(len(shares) + 1)])
    scale[len(STATE_SCALE) + DELTA] = 1 / LOCK_SCALE
    first = ca.vertcat(p["start"], ca.MX(len(shares) + 1, 1))
    fixed = ca.horzcat(first, ca.MX(len(index), n - 1))
    return Block(dynamics(), index, scale, fixed, ca.repmat(p["model"], 1, n), x)


def _separation(structure: Structure, layout: Layout, x: ca.MX, p: Given, i: int) -> Block:
    n = structure.n_intervals
    distance, _, slack = (np.full((1, n), each) for each in layout.globals)
    index = np.vstack([_starts(layout)[POSE], layout.states.T[POSE], layout.lines[i].T, distance, slack])
    scale = np.concatenate([STATE_SCALE[POSE], STATE_SCALE[POSE], [1.0, 1.0, DISTANCE_SCALE, 1.0]])
    first = ca.vertcat(p["start"][POSE], ca.MX(len(index) - len(POSE), 1))
    poses = p[f"poses{i}"]
    constant = ca.repmat(ca.vertcat(p[f"half{i}"], ca.vec(p["vertices"])), 1, n)
    data = ca.vertcat(poses[:, :-1], poses[:, 1:], constant)
    kernels = separation(structure.ellipses[i], structure.n_vertices)
    return Block(kernels, index, scale, ca.horzcat(first, ca.MX(len(index), n - 1)), data, x)


def _edges(structure: Structure, layout: Layout, x: ca.MX, p: Given) -> Block:
    index = layout.states.T[[PSI, Y]]
    data = ca.repmat(ca.vec(p["vertices"]), 1, structure.n_intervals)
    return Block(heights(structure.n_vertices), index, STATE_SCALE[[PSI, Y]], ca.MX(*index.shape), data, x)
