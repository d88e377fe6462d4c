"""The full nonlinear program of the unified controller's problem, by multiple shooting.

minimise    sum_i |eta(k+i) - eta_ref|_Q^2 + sum_j |du(k+j)|_R^2 + w sum |Fx|^2 + sum_l (p_l s_l + q_l s_l^2)    (10)
over        inputs of Nc + M samples, states after each of Np + M samples, a slack s_l >= 0 for each soft limit
subject to  x_k+1 = F(x_k, u_k), the last free input held from there on                                            (1)
            gaps of obstacle l at every half sample >= margin_l - s_l                                            (15)
            |alpha_front(x_k, u_k)|, |alpha_rear(x_k+1)| <= limit + s_slip;  bounds on the inputs                (14)
            |delta_k - delta_k-1| <= turn

It needs no trust region, no limit that knows the lateral demand and no side: the friction ellipse and the obstacles are
in it as they are. In M samples after the horizon no state is tracked, but all limits hold, so that a plan has to be
able to go on: without them it stops short of an obstacle at the horizon's end, from where there is no way past it.
On which side of an obstacle a solution passes depends on the guess that the solver starts from.
"""

from dataclasses import dataclass
from typing import Any, NamedTuple

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.control.nonlinear.layout import Indices, Layout
from swerve.control.nonlinear.stage import N_SLIPS, n_data
from swerve.conventions import DELTA, FORCES, N_INPUTS, N_STATES, VX, VY, Y

Array = NDArray[np.float64]

N_TURNS = 1  # rows of a sample for the steering rate


class Parameters(NamedTuple):
    """What may change from solve to solve: numbers, or CasADi symbols. Inputs are in units of INPUT_SCALE.

    Attributes:
        state: x_0 (6,).
        command: u_-1 (5,).
        data: of the samples; see `stage.n_data`.
        goal: (3,) references of vx [m/s], vy [m/s] and Y [m].
        tracking: (3,) their weights.
        rates: (5,) diagonal of R.
        force: w.
        margins: (n_obstacles n_pairs,) [m].
        slip_limit: [rad].
        turn: largest change of the steering angle in a sample, in units of INPUT_SCALE.
        linear: (n_slacks,) p, the obstacles' first.
        quadratic: (n_slacks,) q.
    """

    state: Any
    command: Any
    data: Any
    goal: Any
    tracking: Any
    rates: Any
    force: Any
    margins: Any
    slip_limit: Any
    turn: Any
    linear: Any
    quadratic: Any

    @classmethod
    def symbolic(cls, n_obstacles: int, n_pairs: int) -> "Parameters":
        """A symbol for each."""
        n_slacks, n = n_obstacles + 1, n_obstacles * n_pairs
        sizes = (N_STATES, N_INPUTS, n_data(n), 3, 3, N_INPUTS, 1, n, 1, 1, n_slacks, n_slacks)
        return cls(*(ca.MX.sym(name, size) for name, size in zip(cls._fields, sizes, strict=True)))


@dataclass(frozen=True, eq=False)
class Formulation:
    """The program as expressions.

    Attributes:
        x: all variables.
        p: parameters.
        inputs: (5, Np) u_k of each sample, held ones too.
        starts: (6, Np) x_k in which each sample starts.
        c: (n_c, Np) what a sample yields, see `stage`: symbols, in which the rows are affine.
        cost: f.
        rows: g, stage by stage, the dynamics of each first.
        lower: of the rows.
        upper: of the rows.
        n_rows: of each sample, without the dynamics.
    """

    x: ca.MX
    p: Parameters
    inputs: ca.MX
    starts: ca.MX
    c: ca.MX
    cost: ca.MX
    rows: ca.MX
    lower: Array
    upper: Array
    n_rows: int


def formulate(layout: Layout, n_tracked: int, n_obstacles: int, n_pairs: int) -> Formulation:
    """The program for a layout, Np, a number of obstacles and a number of pairs for each of them."""
    x, p = ca.MX.sym("x", layout.n), Parameters.symbolic(n_obstacles, n_pairs)
    states: list[ca.MX] = [p.state, *_parts(x, layout.states)]
    previous: list[ca.MX] = [p.command, *_parts(x, layout.previous)]
    slacks, free = _parts(x, layout.slacks), _parts(x, layout.inputs)
    inputs: list[ca.MX] = free + previous[layout.n_free : layout.n_samples]
    n_gaps = 2 * n_obstacles * n_pairs
    c = ca.MX.sym("c", N_STATES + n_gaps + N_SLIPS, layout.n_samples)

    cost = ca.dot(p.linear, slacks[-1]) + ca.dot(p.quadratic, slacks[-1] ** 2)
    for state in states[1 : n_tracked + 1]:
        cost += ca.dot(p.tracking, (ca.vertcat(state[VX], state[VY], state[Y]) - p.goal) ** 2)
    for u, before in zip(free, previous, strict=False):
        cost += ca.dot(p.rates, (u - before) ** 2) + p.force * ca.sumsqr(u[FORCES])

    rows = []
    for k in range(layout.n_samples):
        end, gaps, slips = ca.vertsplit(c[:, k], np.cumsum([0, N_STATES, n_gaps, N_SLIPS]).tolist())
        rows.append(states[k + 1] - end)
        if layout.is_staged:
            rows += [previous[k + 1] - inputs[k], slacks[k + 1] - slacks[k]]
        rows += [gaps[2 * i : 2 * i + 2] + slacks[k][i // n_pairs] - p.margins[i] for i in range(n_gaps // 2)]
        limit = p.slip_limit + slacks[k][-1]
        rows += [limit - slips, limit + slips, (inputs[k][DELTA] - previous[k][DELTA]) / p.turn]
    n_rows = n_gaps + 2 * N_SLIPS + N_TURNS
    counts = [layout.n_dynamics, n_rows - N_TURNS, N_TURNS]
    lower = np.tile(np.repeat([0.0, 0.0, -1.0], counts), layout.n_samples)
    upper = np.tile(np.repeat([0.0, np.inf, 1.0], counts), layout.n_samples)
    return Formulation(
        x=x,
        p=p,
        inputs=ca.horzcat(*inputs),
        starts=ca.horzcat(*states[:-1]),
        c=c,
        cost=cost,
        rows=ca.vertcat(*rows),
        lower=lower,
        upper=upper,
        n_rows=n_rows,
    )


def _parts(x: ca.MX, indices: Indices) -> list[ca.MX]:
    """The parts of x with each row of indices."""
    return [x[each.tolist()] for each in indices]
