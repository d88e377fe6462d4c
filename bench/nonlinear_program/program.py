"""The nonlinear program of one vehicle, compiled and bound to a solver: a question and a guess in, an answer out."""

from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from bench.nonlinear_program.buffered import Buffered
from bench.nonlinear_program.formulation import Parameters, formulate
from bench.nonlinear_program.functions import functions
from bench.nonlinear_program.layout import Layout
from bench.nonlinear_program.library import library
from bench.nonlinear_program.solver import Solver
from bench.nonlinear_program.stage import INPUT_SCALE, N_SLIPS, stage
from bench.nonlinear_program.values import Answer, Guess, Question
from swerve.control import Goal, Horizon, Weights
from swerve.control.unified import UnifiedSettings
from swerve.control.unified.prediction import SLIP_SPEED_FLOOR, PredictionModel
from swerve.conventions import DELTA, FORCES, VX, VY
from swerve.vehicle import Vehicle
from swerve.vehicle.two_track import Parameters as ModelParameters
from swerve.world import Ellipse, Obstacle

Array = NDArray[np.float64]

INTERIOR = 1e-2  # [m, rad] added to the slacks of a guess, so that an interior-point method starts inside


class NonlinearProgram:
    """The program for one vehicle, its centre of gravity as footprint, on a road of known friction, and one solver."""

    def __init__(
        self,
        vehicle: Vehicle,
        friction: float,
        goal: Goal,
        horizon: Horizon,
        weights: Weights,
        settings: UnifiedSettings,
        n_obstacles: int,
        solver: str,
    ) -> None:
        """Build and compile the program, or take it from the cache.

        Args:
            vehicle: without a limit on its steering rate.
            friction: mu [1].
            goal: where the cost pulls.
            horizon: Np, Nc, Ts.
            weights: of (10).
            settings: of which the penalties, the margin, the slip limit and the weight of wheel forces count.
            n_obstacles: at every solve.
            solver: a name in `SOLVERS`.

        Raises:
            ValueError: the vehicle has a limit on its steering rate, the program has none.
            SwerveError: it can't be compiled.
        """
        if np.isfinite(vehicle.steering_rate_limit):
            raise ValueError("the nonlinear program has no limit on the steering rate, the vehicle has one")
        arrange = Layout.stages if solver == "fatrop" else Layout.shared
        self.layout = arrange(horizon, n_obstacles + 1)
        self.formulation = formulate(self.layout, n_obstacles)
        compiled = library(f"nonlinear_program_{solver}", functions(self.formulation, stage(n_obstacles), solver))
        self._evaluate = Buffered(ca.external("nlp", str(compiled)))
        self._solver = Solver(solver, compiled, self.layout, self.formulation.n_rows)
        self._model = PredictionModel(vehicle, friction, horizon)
        self._vehicle, self._friction = vehicle, friction
        self._constants = _constants(goal, weights, settings, n_obstacles)
        self._margin, self._sample_time = settings.clearance_margin, horizon.sample_time
        self._data = np.append(ModelParameters.of(vehicle, friction, SLIP_SPEED_FLOOR).as_array(), horizon.sample_time)

    def guess(self, question: Question, inputs: Array) -> Guess:
        """A start at the roll-out of inputs (Np, 5), clipped to their bounds."""
        largest = self._largest(question)
        scaled = np.clip(self.layout.held(inputs) / INPUT_SCALE, -largest, largest)
        inputs = scaled * INPUT_SCALE
        states = self._model.roll_out(question.state, inputs, question.wheel_loads).states
        x = np.zeros(self.layout.n)
        x[self.layout.inputs], x[self.layout.previous] = scaled[: self.layout.n_free], scaled
        x[self.layout.states] = states[1:]
        p = self.parameters(question)
        missed = np.maximum(0.0, -self._by_sample(self._evaluate(x=x, p=p)["g"]).min(axis=0))
        violations = np.maximum.reduceat(missed, 2 * np.arange(self.layout.n_slacks))
        x[self.layout.slacks] = violations
        return Guess(inputs, states, x, violations, cost=float(self._evaluate(x=x, p=p)["f"][0]))

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
            cost=float(out["f"][0]),
            is_solved=is_solved,
            iterations=iterations,
            x=x,
            rows=out["g"],
            bound_multipliers=out["lam_x"],
            row_multipliers=out["lam_g"],
        )

    def bounds(self, question: Question) -> tuple[Array, Array]:
        """Smallest and largest value of each variable."""
        upper = np.full(self.layout.n, np.inf)
        upper[self.layout.inputs] = self._largest(question)
        lower = -upper
        lower[self.layout.slacks] = 0.0
        return lower, upper

    def parameters(self, question: Question) -> Array:
        """The vector p of all parameters."""
        seen = [
            (*each.position_at(0.0), *each.velocity_at(0.0), *_ellipse(each.shape).semi_axes, each.heading_at(0.0))
            for each in question.obstacles
        ]
        data = np.concatenate([question.wheel_loads, self._data, *seen])
        values = Parameters(
            state=question.state,
            command=question.command / INPUT_SCALE,
            data=data,
            margins=[self._margin + self._sagitta(question.state, each) for each in question.obstacles],
            **self._constants,
        )
        return np.concatenate([np.atleast_1d(np.asarray(value, dtype=float)) for value in values])

    def _sagitta(self, state: Array, obstacle: Obstacle) -> float:
        """How far a chord of half a sample's length cuts into the ellipse where it is roundest [m].

        What keeps clear by as much at both ends keeps clear between them, too.
        """
        chord = float(np.hypot(state[VX], state[VY])) * self._sample_time / 2
        semi_axes = _ellipse(obstacle.shape).semi_axes
        return chord**2 / (8 * min(semi_axes) ** 2 / max(semi_axes))

    def gap_multipliers(self, answer: Answer) -> Array:
        """Multipliers (Np, 2 n_obstacles) of the rows that keep clear of obstacles [1/m]."""
        return self._by_sample(answer.row_multipliers)[:, : -2 * N_SLIPS]

    def _by_sample(self, of_rows: Array) -> Array:
        """Of the rows' values, those of each sample beside the dynamics, (Np, n_rows)."""
        return np.asarray(of_rows.reshape(self.layout.n_samples, -1)[:, -self.formulation.n_rows :])

    def _largest(self, question: Question) -> Array:
        """(5,) largest magnitude of each input, in units of INPUT_SCALE."""
        share = self._vehicle.force_limit * self._friction
        return np.asarray(np.append(self._vehicle.steering_limit, share * question.wheel_loads) / INPUT_SCALE)


def _constants(goal: Goal, weights: Weights, settings: UnifiedSettings, n_obstacles: int) -> dict[str, Any]:
    """The parameters that stay the same from solve to solve."""
    rates = np.full(INPUT_SCALE.size, weights.force_rate)
    rates[DELTA] = weights.steering_rate
    of_obstacles = np.ones(n_obstacles)
    return {
        "goal": (goal.speed, 0.0, goal.lateral_offset),
        "tracking": (weights.speed, weights.lateral_speed, weights.lateral_offset),
        "rates": rates * INPUT_SCALE**2,
        "force": settings.force_weight * INPUT_SCALE[FORCES][0] ** 2,
        "slip_limit": settings.slip_limit,
        "linear": np.append(settings.clearance_penalty * of_obstacles, settings.slip_penalty),
        "quadratic": np.append(settings.clearance_penalty_quadratic * of_obstacles, settings.slip_penalty_quadratic),
    }


def _ellipse(shape: object) -> Ellipse:
    if not isinstance(shape, Ellipse):
        raise TypeError(f"the nonlinear program keeps clear of ellipses, not of a {type(shape).__name__}")
    return shape
