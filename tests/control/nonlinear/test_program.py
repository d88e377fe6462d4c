"""The program's solutions are solutions: by its own derivatives, by CasADi's, by the other solver, and by the plant."""

from collections.abc import Callable
from dataclasses import fields

import casadi as ca
import numpy as np
import pytest
from numpy.typing import NDArray

from swerve.control import Goal, Horizon, Side, Weights
from swerve.control.actuation import EVERYTHING
from swerve.control.nonlinear import SOLVERS, Answer, Guess, NonlinearProgram, NonlinearSettings, Question
from swerve.control.nonlinear.formulation import formulate
from swerve.control.nonlinear.functions import functions
from swerve.control.nonlinear.layout import Layout
from swerve.control.nonlinear.stage import stage
from swerve.control.plan import Passing
from swerve.control.unified.seeds import seeds
from swerve.control.unified.way import Way
from swerve.plant import PlanarPlant
from swerve.scenario import load
from swerve.signals import Command
from swerve.vehicle import vehicle_named
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters
from swerve.world import Ellipse, Obstacle, Point, Steady, distance_ratio

Array = NDArray[np.float64]

SEDAN, FRICTION = vehicle_named("d-class-sedan"), 0.85
LOADS = np.array(wheel_loads(Parameters.of(SEDAN, FRICTION)))
OBSTACLE = Obstacle(Ellipse((2.0, 2.0)), Steady((17.0, 0.0)))
QUESTION = Question(np.array([20.0, 0, 0, 0, 0, 0]), np.zeros(5), LOADS, (OBSTACLE,))
HORIZON = Horizon(20, 15, 0.05)
UNIFIED = load("paper").controller.unified.model_dump()

PAIR = [1.5, 0.2, 17, 1, -3, 1, 4, 2, 0.3]

Solved = Callable[[str, Side], tuple[NonlinearProgram, Answer]]


def program(solver: str) -> NonlinearProgram:
    """The paper's program."""
    shared = {each.name: UNIFIED[each.name] for each in fields(NonlinearSettings) if each.name in UNIFIED}
    settings = NonlinearSettings(**shared, tail=0, solver=solver)
    weights = Weights(speed=1.0, lateral_speed=1.0, lateral_offset=10.0, steering_rate=1e2, force_rate=1e-6)
    goal, inputs = Goal(20.0, 0.0), EVERYTHING
    return NonlinearProgram(SEDAN, Point(), FRICTION, goal, HORIZON, weights, settings, [OBSTACLE.shape], inputs)


def pulse(asked: NonlinearProgram, side: Side) -> Guess:
    """The cheapest first guess that turns to a side."""
    way, limit = Way((Passing(side.value),), (0,)), UNIFIED["slip_limit"]
    pulses = seeds(SEDAN, FRICTION, limit, 20.0, way, asked.largest(QUESTION), HORIZON.prediction)
    return min((asked.guess(QUESTION, inputs) for inputs in pulses), key=lambda guess: guess.cost)


@pytest.fixture(scope="module")
def solved() -> Solved:
    """The program of a solver and its answer for a side, both once for all tests."""
    programs = {solver: program(solver) for solver in SOLVERS}
    answers = {
        (solver, side): asked.solve(QUESTION, pulse(asked, side)) for solver, asked in programs.items() for side in Side
    }
    return lambda solver, side: (programs[solver], answers[solver, side])


@pytest.mark.slow
@pytest.mark.parametrize("side", Side)
@pytest.mark.parametrize("solver", SOLVERS)
class TestSolution:
    """What holds for each solver, on each side."""

    def test_the_plant_goes_where_it_says(self, solved: Solved, solver: str, side: Side) -> None:
        """Its inputs, given to the plant, lead through its states, round the obstacle on the side of the guess."""
        _, answer = solved(solver, side)
        plant = PlanarPlant(SEDAN, FRICTION, step=1e-3, n_substeps=50)
        state, path = plant.start(QUESTION.state), []
        for inputs, expected in zip(answer.inputs, answer.states[1:], strict=True):
            state, trace = plant.advance(state, Command.from_input(inputs))
            path.append(trace.states)
            np.testing.assert_allclose(state.vehicle, expected, atol=2e-3)
        poses = np.vstack(path)[:, [4, 5, 3]]
        assert distance_ratio(Point(), poses, OBSTACLE, np.zeros(len(poses))).min() >= 1
        assert np.sign(poses[np.argmin(np.abs(poses[:, 0] - 17)), 1]) == side.value

    def test_it_keeps_the_limits(self, solved: Solved, solver: str, side: Side) -> None:
        """Inputs are within their bounds, the last free one held, and no margin is missed by more than a tolerance."""
        asked, answer = solved(solver, side)
        lower, upper = asked.bounds(QUESTION)
        assert answer.is_solved
        assert (answer.x >= lower - 1e-6).all()
        assert (answer.x <= upper + 1e-6).all()
        assert (answer.rows >= asked.formulation.lower - 1e-6).all()
        assert (answer.rows <= asked.formulation.upper + 1e-6).all()
        assert answer.missed_clearance <= 1e-5
        assert (answer.inputs[HORIZON.control :] == answer.inputs[HORIZON.control - 1]).all()

    def test_it_is_stationary(self, solved: Solved, solver: str, side: Side) -> None:
        """With its multipliers it meets the conditions of Karush, Kuhn and Tucker, gradients being CasADi's own."""
        asked, answer = solved(solver, side)
        x, p, f, g = whole(asked.layout, 1)
        lagrangian = (
            asked.cost_unit * ca.gradient(f, x)
            + ca.jtimes(g, x, ca.DM(answer.row_multipliers), True)
            + answer.bound_multipliers
        )
        residual = np.array(ca.Function("residual", [x, p], [lagrangian])(answer.x, asked.parameters(QUESTION)))
        assert np.abs(residual).max() <= 1e-4 * np.abs(answer.row_multipliers).max()
        lower, upper = asked.bounds(QUESTION)
        assert_complementary(lower, upper, answer.x, answer.bound_multipliers)
        rows = asked.formulation
        assert_complementary(rows.lower, rows.upper, answer.rows, answer.row_multipliers)


def assert_complementary(lower: Array, upper: Array, values: Array, multipliers: Array) -> None:
    """A multiplier of some size is positive at the upper limit, negative at the lower one."""
    distance = np.where(multipliers > 0, upper - values, values - lower)
    assert (np.abs(multipliers) * np.minimum(distance, 1.0) <= 1e-4).all()


@pytest.mark.slow
def test_both_solvers_and_both_sides_cost_the_same(solved: Solved) -> None:
    """Two solvers with two layouts agree, and ahead of a centred obstacle left is the mirror of right."""
    costs = [solved(solver, side)[1].cost for solver in SOLVERS for side in Side]
    np.testing.assert_allclose(costs, costs[0], rtol=1e-5)
    left, right = (solved("fatrop", side)[1].states[:, 5] for side in Side)
    np.testing.assert_allclose(left, -right, atol=1e-4)


def whole(layout: Layout, n_pairs: int) -> tuple[ca.MX, ca.MX, ca.MX, ca.MX]:
    """Symbols x and p, and f and g of them, as CasADi can differentiate them."""
    formulation = formulate(layout, layout.n_samples, 1, n_pairs)
    x, p = formulation.x, ca.vertcat(*formulation.p)
    nlp = functions(formulation, stage(n_pairs), "ipopt")[0]
    return x, p, *nlp(x, p)


@pytest.mark.parametrize(("solver", "arrange"), [("fatrop", Layout.stages), ("ipopt", Layout.shared)])
def test_derivatives_are_those_of_the_whole(solver: str, arrange: Callable[[Horizon, int], Layout]) -> None:
    """What is put together from samples is what CasADi finds by differentiating the whole program."""
    layout = arrange(Horizon(4, 2, 0.05), 2)
    made = {each.name(): each for each in functions(formulate(layout, layout.n_samples, 1, 2), stage(2), solver)}
    x, p, f, g = whole(layout, 2)
    weight, weights = ca.MX.sym("weight"), ca.MX.sym("weights", g.numel())
    expected = [*ca.hessian(weight * f + ca.dot(weights, g), x), ca.jacobian(g, x), ca.gradient(f, x)]
    generator = np.random.default_rng(1)
    at_x = generator.uniform(0.1, 1.0, layout.n)
    at_x[layout.states[:, 0]] += 20
    at_p = np.concatenate([[20, 1, 0.1, 0.1, 0, 0], generator.uniform(0.1, 1, 5), LOADS])
    at_p = np.concatenate([at_p, Parameters.of(SEDAN, FRICTION).as_array(), [0.05, *PAIR, *PAIR[::-1]]])
    at_p = np.concatenate([at_p, generator.uniform(0.1, 1, p.numel() - at_p.size)])
    at_weights = generator.normal(size=g.numel())
    at = ca.Function("expected", [x, p, weight, weights], expected)(at_x, at_p, 0.7, at_weights)
    hessian, gradient, jacobian, gradient_f = at
    of_lagrangian = made["nlp_hess_l"].call([at_x, at_p, 0.7, at_weights])
    if solver == "fatrop":
        assert_near(of_lagrangian[0], gradient)
    assert_near(ca.triu(of_lagrangian[-1]), ca.triu(hessian))
    assert_near(made["nlp_jac_g"].call([at_x, at_p])[-1], jacobian)
    assert_near(made["nlp_grad_f"].call([at_x, at_p])[-1], gradient_f)


def test_nothing_is_tracked_after_the_horizon() -> None:
    """The cost depends on every state of the horizon and on none of the tail, in which the limits go on."""
    layout = Layout.stages(Horizon(5, 4, 0.05), 2)
    tracked, entire = formulate(layout, 3, 1, 1), formulate(layout, 5, 1, 1)
    depends = np.array(ca.DM(ca.jacobian_sparsity(tracked.cost, tracked.x), 1)).ravel() > 0
    assert depends[layout.states[:3][:, [0, 1, 5]]].all()
    assert not depends[layout.states[3:]].any()
    assert tracked.rows.shape == entire.rows.shape


def assert_near(found: ca.DM, expected: ca.DM) -> None:
    """Equal up to rounding."""
    values = np.array(expected)
    np.testing.assert_allclose(np.array(found), values, rtol=1e-9, atol=1e-9 * np.abs(values).max())
