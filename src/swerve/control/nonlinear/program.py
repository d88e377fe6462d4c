"""The nonlinear program of one vehicle, compiled and bound to a solver: a question and a guess in, an answer out."""

from collections.abc import Sequence

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.control.actuation import Actuation
from swerve.control.nonlinear.buffered import Buffered
from swerve.control.nonlinear.compiled import compiled
from swerve.control.nonlinear.cover import n_parts
from swerve.control.nonlinear.formulation import N_TURNS, Parameters
from swerve.control.nonlinear.settings import NonlinearSettings
from swerve.control.nonlinear.solver import Solver
from swerve.control.nonlinear.stage import INPUT_SCALE, N_SLIPS
from swerve.control.nonlinear.surroundings import Surroundings
from swerve.control.nonlinear.values import Answer, Guess, Question
from swerve.control.settings import Goal, Horizon, Weights
from swerve.control.unified.prediction import SLIP_SPEED_FLOOR, PredictionModel
from swerve.conventions import DELTA, FORCES
from swerve.vehicle import Vehicle
from swerve.vehicle.two_track import Parameters as ModelParameters
from swerve.world import Footprint, Shape

Array = NDArray[np.float64]

INTERIOR = 1e-2  # [m, rad] added to the slacks of a guess, so that an interior-point method starts inside
LARGEST_PRICE = 100.0  # [1] of a unit of a slack, as IPOPT scales; Fatrop stalls where multipliers reach 1e4
LEAST_LOAD = 1.0  # [N] so that a lower bound stays below the upper one
UNLIMITED = 1e6  # [1] a turn in units of INPUT_SCALE that is none


class NonlinearProgram:
    """The program for one vehicle and footprint on a road of known friction, a number of obstacles, and one solver.

    Attributes:
        horizon: all samples of the program, the tail included.
        cost_unit: in which the solver sees costs [1].
        layout: of the variables.
        formulation: as expressions.
        model: eq. (1) over these samples.
    """

    def __init__(
        self,
        vehicle: Vehicle,
        footprint: Footprint,
        friction: float,
        goal: Goal,
        horizon: Horizon,
        weights: Weights,
        settings: NonlinearSettings,
        shapes: Sequence[Shape],
        actuation: Actuation,
    ) -> None:
        """Build and compile the program, or take it from the cache.

        Args:
            vehicle: what is driven.
            footprint: what keeps clear.
            friction: mu [1].
            goal: where the cost pulls.
            horizon: Np, Nc, Ts; the program goes on for the settings' tail, and so do its plans.
            weights: of (10).
            settings: penalties, limits and the solver's name.
            shapes: of the obstacles that there may be; of more obstacles the program keeps clear of the nearest.
            actuation: the inputs that there are, each of them free, if only in one direction.

        Raises:
            SwerveError: it can't be compiled.
        """
        solver, self._n_obstacles = settings.solver, len(shapes)
        self._n_pairs = n_parts(footprint) * max((n_parts(shape) for shape in shapes), default=1)
        size, margin = (self._n_obstacles, self._n_pairs), settings.clearance_margin
        self._surroundings = Surroundings(footprint, size, margin, horizon.sample_time)
        self.horizon = _longer(horizon, settings.tail)
        made = compiled(solver, self.horizon, horizon.prediction, *size)
        self.layout, self.formulation = made.layout, made.formulation
        self._evaluate = Buffered(ca.external("nlp", str(made.library)))
        self._solver = Solver(solver, made.library, self.layout, self.formulation.n_rows)
        self.model = PredictionModel(vehicle, friction, self.horizon)
        self._vehicle, self._friction, self._actuation = vehicle, friction, actuation
        turn = min(vehicle.steering_rate_limit * horizon.sample_time / INPUT_SCALE[DELTA], UNLIMITED)
        aim = (goal.speed, 0.0, goal.lateral_offset)
        self._constants = {"goal": aim, "slip_limit": settings.slip_limit, "turn": turn}
        costs = _costs(weights, settings, self._n_obstacles)
        self.cost_unit = max(1.0, float(costs["linear"].max()) / LARGEST_PRICE)
        self._costs = {name: cost / self.cost_unit for name, cost in costs.items()}
        self._data = np.append(ModelParameters.of(vehicle, friction, SLIP_SPEED_FLOOR).as_array(), horizon.sample_time)

    def guess(self, question: Question, inputs: Array) -> Guess:
        """A start at the roll-out of inputs (Np, 5), clipped to their bounds."""
        scaled = np.clip(self.layout.held(inputs) / INPUT_SCALE, *self._range(question))
        self._slow_down(scaled, question.command[DELTA] / INPUT_SCALE[DELTA])
        inputs = scaled * INPUT_SCALE
        states = self.model.roll_out(question.state, inputs, question.wheel_loads).states
        x = np.zeros(self.layout.n)
        x[self.layout.inputs], x[self.layout.previous] = scaled[: self.layout.n_free], scaled
        x[self.layout.states] = states[1:]
        p = self.parameters(question)
        missed = np.maximum(0.0, -self._by_sample(self._evaluate(x=x, p=p)["g"])[:, :-N_TURNS].min(axis=0))
        violations = np.maximum.reduceat(missed, 2 * self._n_pairs * np.arange(self.layout.n_slacks))
        x[self.layout.slacks] = violations
        return Guess(inputs, states, x, violations, cost=self.cost_unit * float(self._evaluate(x=x, p=p)["f"][0]))

    def solve(self, question: Question, guess: Guess) -> Answer:
        """The local minimum that the solver finds from a guess."""
        start = guess.x.copy()
        start[self.layout.slacks] += INTERIOR
        lower, upper = self.bounds(question)
        out, is_solved, iterations = self._solver(
            x0=start,
            p=self.parameters(question),
            lbx=lower,
            ubx=upper,
            lbg=self.formulation.lower,
            ubg=self.formulation.upper,
        )
        x = out["x"]
        return Answer(
            inputs=x[self.layout.previous] * INPUT_SCALE,
            states=np.vstack([question.state, x[self.layout.states]]),
            violations=x[self.layout.slacks[-1]],
            cost=self.cost_unit * float(out["f"][0]),
            is_solved=is_solved,
            iterations=iterations,
            x=x,
            rows=out["g"],
            bound_multipliers=self.cost_unit * out["lam_x"],
            row_multipliers=self.cost_unit * out["lam_g"],
        )

    def bounds(self, question: Question) -> tuple[Array, Array]:
        """Smallest and largest value of each variable."""
        lower, upper = np.full(self.layout.n, -np.inf), np.full(self.layout.n, np.inf)
        lower[self.layout.inputs], upper[self.layout.inputs] = self._range(question)
        lower[self.layout.slacks] = 0.0
        return lower, upper

    def parameters(self, question: Question) -> Array:
        """The vector p of all parameters, the costs in units of `cost_unit`."""
        seen, margins = self._surroundings.numbers(question)
        data = np.concatenate([question.wheel_loads, self._data, seen.ravel()])
        values = Parameters(
            state=question.state,
            command=question.command / INPUT_SCALE,
            data=data,
            margins=margins,
            **self._constants,
            **self._costs,
        )
        return np.concatenate([np.atleast_1d(np.asarray(value, dtype=float)) for value in values])

    def _slow_down(self, scaled: Array, reached: float) -> None:
        """Let the steering angles of `scaled` inputs (Np, 5) turn no faster than they can."""
        for u in scaled:
            reached += min(max(u[DELTA] - reached, -self._constants["turn"]), self._constants["turn"])
            u[DELTA] = reached

    def gap_multipliers(self, answer: Answer) -> Array:
        """Multipliers (Np, n_obstacles, 2 n_pairs) of the rows that keep each obstacle's pairs clear [1/m]."""
        of_gaps = self._by_sample(answer.row_multipliers)[:, : -2 * N_SLIPS - N_TURNS]
        return of_gaps.reshape(self.layout.n_samples, self._n_obstacles, 2 * self._n_pairs)

    def _by_sample(self, of_rows: Array) -> Array:
        """Of the rows' values, those of each sample beside the dynamics, (Np, n_rows)."""
        return np.asarray(of_rows.reshape(self.layout.n_samples, -1)[:, -self.formulation.n_rows :])

    def largest(self, question: Question) -> Array:
        """(5,) largest magnitude of each input [rad, N, N, N, N]."""
        share = self._vehicle.force_limit * self._friction
        loads = np.maximum(question.wheel_loads, LEAST_LOAD)
        return np.append(self._vehicle.steering_limit, share * loads)

    def _range(self, question: Question) -> tuple[Array, Array]:
        """(5,) smallest and largest value of each input, in units of INPUT_SCALE."""
        largest = self.largest(question) / INPUT_SCALE
        return self._actuation.lower * largest, self._actuation.upper * largest


def _longer(horizon: Horizon, tail: int) -> Horizon:
    """The horizon and `tail` samples."""
    return Horizon(horizon.prediction + tail, horizon.control + tail, horizon.sample_time)


def _costs(weights: Weights, settings: NonlinearSettings, n_obstacles: int) -> dict[str, Array]:
    """The parameters that are weights and penalties [1]."""
    rates = np.full(INPUT_SCALE.size, weights.force_rate)
    rates[DELTA] = weights.steering_rate
    of_obstacles = np.ones(n_obstacles)
    return {
        "tracking": np.array([weights.speed, weights.lateral_speed, weights.lateral_offset]),
        "rates": rates * INPUT_SCALE**2,
        "force": np.array([settings.force_weight * INPUT_SCALE[FORCES][0] ** 2]),
        "linear": np.append(settings.clearance_penalty * of_obstacles, settings.slip_penalty),
        "quadratic": np.append(settings.clearance_penalty_quadratic * of_obstacles, settings.slip_penalty_quadratic),
    }
