"""Modes of actuation: what is commanded exists, and a program in a mode is the program of all inputs held to it."""

from dataclasses import fields
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from swerve.control import Horizon
from swerve.control.actuation import EVERYTHING, FIXED_DISTRIBUTION, MODES, VECTORING, Actuation
from swerve.control.unified.condensing import Blocking, condense
from swerve.control.unified.limits import InputBox, Penalty, SlipLimit, SteeringRateLimit
from swerve.control.unified.prediction import PredictionModel, Trajectory
from swerve.control.unified.program import Program
from swerve.control.unified.terms import InputRate, Tracking, WheelForce
from swerve.conventions import FORCES, VX, Y
from swerve.qp import Problem, solve
from swerve.scenario import MODES as SCENARIO_MODES
from tests.vehicle.motions import SEDAN, STATIC

Array = NDArray[np.float64]

HORIZON = Horizon(8, 6, 0.05)
LARGEST = np.array([0.5, 3600.0, 3700.0, 2400.0, 2500.0])
TRUST = np.array([0.08, 4e3, 4e3, 4e3, 4e3])
STUCK = 0.03  # [rad]


@st.composite
def actuations(draw: st.DrawFn) -> Actuation:
    """Any mode with any failures that leave something."""
    mode = draw(st.sampled_from(sorted(MODES)))
    failed = tuple(sorted(draw(st.sets(st.integers(0, 3), max_size=3))))
    stuck = draw(st.none() | st.floats(-0.4, 0.4)) if mode != "steer-only" else None
    return Actuation.of(SEDAN, mode, failed, stuck)


inputs = st.lists(st.floats(-2.0, 2.0), min_size=5, max_size=5).map(lambda shares: np.array(shares) * LARGEST)


def test_modes_of_a_scenario_are_those_of_a_controller() -> None:
    """A scenario's names of modes are the controllers', in their order."""
    assert tuple(MODES) == SCENARIO_MODES


def test_without_a_mode_there_is_everything() -> None:
    """The mode "all" without a failure is what a controller has that is told nothing."""
    made = Actuation.of(SEDAN, "all")
    for field in fields(Actuation):
        np.testing.assert_array_equal(getattr(made, field.name), getattr(EVERYTHING, field.name))


@given(actuations(), inputs)
def test_what_is_commanded_exists(actuation: Actuation, u: Array) -> None:
    """Any wish ends within lock, forces and mode; what is possible already stays as it is, and a second look agrees."""
    found = actuation.within(u, LARGEST)
    assert (np.abs(found) <= LARGEST * (1 + 1e-12)).all()
    assert (found <= actuation.upper * LARGEST + np.abs(actuation.fixed)).all()
    np.testing.assert_allclose(actuation.within(found, LARGEST), found, rtol=1e-12, atol=1e-9)
    is_free = actuation.basis.any(axis=1)
    np.testing.assert_array_equal(found[~is_free], actuation.fixed[~is_free])
    if np.count_nonzero(actuation.basis) == actuation.n_free:  # each column is one input: bounds are independent
        possible = np.clip(u, actuation.lower * LARGEST, actuation.upper * LARGEST)
        np.testing.assert_array_equal(found[is_free], possible[is_free])


@given(inputs, st.floats(0.1, 1.0))
def test_friction_brakes_are_one_demand(u: Array, weak: float) -> None:
    """Left and right are the same, front to rear is lr to lf with h = 0; the weakest wheel limits all of them."""
    largest = LARGEST * np.array([1, 1, weak, 1, 1])
    front_left, front_right, rear_left, rear_right = Actuation.of(SEDAN, "steer+friction-brakes").within(u, largest)[1:]
    assert front_left == front_right
    assert rear_left == rear_right
    assert front_left * SEDAN.cg_to_front_axle == pytest.approx(rear_left * SEDAN.cg_to_rear_axle)
    arms = np.array([SEDAN.cg_to_rear_axle] * 2 + [SEDAN.cg_to_front_axle] * 2)
    most = float((-largest[FORCES] / arms).max() * SEDAN.cg_to_rear_axle)
    assert most - 1e-9 <= front_left <= 0
    everything = Actuation.of(SEDAN, "steer+friction-brakes").within(-10 * LARGEST, largest)
    assert everything[1] == pytest.approx(most)


def test_friction_brakes_use_all_wheels_alike_in_a_hard_stop() -> None:
    """With a centre of gravity at 0.5 m each force is the same share of the load that the wheel has at 0.8 g."""
    vehicle = SEDAN.with_changes({"cg_height": 0.5})
    forces = Actuation.of(vehicle, "steer+friction-brakes").within(np.full(5, -100.0), LARGEST)[FORCES]
    moved = 0.8 * 0.5 / vehicle.wheelbase
    front, rear = (
        vehicle.cg_to_rear_axle / vehicle.wheelbase + moved,
        vehicle.cg_to_front_axle / vehicle.wheelbase - moved,
    )
    np.testing.assert_allclose(forces / forces.sum(), [front / 2, front / 2, rear / 2, rear / 2])


@pytest.mark.parametrize(
    ("mode", "failed", "stuck", "braking", "turning"),
    [
        ("all", (), None, 1.0, 1.0),
        ("steer-only", (), None, 0.0, 1.0),
        ("brakes-only", (), None, 1.0, VECTORING),
        ("steer+friction-brakes", (), 0.0, FIXED_DISTRIBUTION, 0.0),
        ("no-drive", (0, 2), None, 0.5, 1.0),
        ("no-drive", (0, 2), 0.0, 0.5, 0.0),
    ],
)
def test_what_a_mode_can_do(mode: str, failed: Any, stuck: float | None, braking: float, turning: float) -> None:
    """Wheels that brake carry this share of the load; without steering only forces left and right can turn."""
    found = Actuation.of(SEDAN, mode, failed, stuck)
    assert found.braking == pytest.approx(braking)
    assert found.turning == turning


@pytest.mark.parametrize(("mode", "failed"), [("steer-only", ()), ("brakes-only", (0, 1, 2, 3)), ("all", (0, 1, 2, 3))])
def test_nothing_left_is_refused(mode: str, failed: tuple[int, ...]) -> None:
    """A stuck steering and no wheel with a force is no vehicle to control."""
    with pytest.raises(ValueError, match="nothing is left"):
        Actuation.of(SEDAN, mode, failed, steering_stuck=0.0)


CASES = {
    **{mode: (mode, (), None) for mode in MODES},
    "a wheel failed": ("all", (2,), None),
    "a friction brake failed": ("steer+friction-brakes", (0,), None),
    "steering stuck": ("all", (), STUCK),
    "all but one": ("no-drive", (0, 1, 3), STUCK),
}


def program(blocking: Blocking, previous: Array) -> Program:
    """Tracking, input rates, wheel forces and slip; a rate limit where the steering is free."""
    terms = (
        Tracking(VX, 15.0, 1.0),
        Tracking(Y, 2.0, 10.0),
        InputRate.of(np.array([1e2, 1e-6, 1e-6, 1e-6, 1e-6]), blocking).after(previous),
        WheelForce(1e-8, blocking),
    )
    hard = [SteeringRateLimit(0.02, float(previous[0]), blocking)] if blocking.actuation.steers else []
    return Program(terms, InputBox.of(SEDAN, 0.85, STATIC, blocking), hard, [SlipLimit(0.12, Penalty(1e3, 1e5))])


def situation(actuation: Actuation, seed: int) -> tuple[Program, Trajectory, PredictionModel]:
    """A program of a mode, and a random roll-out in that mode."""
    random = np.random.default_rng(seed)
    model = PredictionModel(SEDAN, 0.85, HORIZON)
    made = program(Blocking(HORIZON, actuation), actuation.fixed)
    wished = random.normal(0.0, [0.03, 900, 900, 600, 600], (HORIZON.prediction, 5))
    start = random.normal([18, 0, 0, 0, 0, 0], [3, 0.3, 0.2, 0.1, 3, 1])
    return made, model.roll_out(start, made.clip(wished), STATIC), model


@pytest.mark.parametrize("case", CASES)
@settings(max_examples=4)
@given(seed=st.integers(0, 2**32 - 1))
def test_a_program_in_a_mode_is_that_of_all_inputs_held_to_it(case: str, seed: int) -> None:
    """The same changes and the same cost come of all 5 Nc inputs with equality constraints for what does not exist."""
    actuation = Actuation.of(SEDAN, *CASES[case])
    reduced, trajectory, model = situation(actuation, seed)
    jacobians = model.linearise(trajectory, STATIC)
    own = Blocking(HORIZON, actuation)
    small = solve(reduced.convex(trajectory, condense(jacobians, own), TRUST))

    everything = Blocking(HORIZON, Actuation(np.eye(5), actuation.fixed, actuation.lower, actuation.upper, 1.0))
    full = program(everything, actuation.fixed)
    full = Program(full.terms, full.box, reduced.hard and full.hard, full.soft)
    free = full.convex(trajectory, condense(jacobians, everything), TRUST)
    outside = np.eye(5) - actuation.basis @ np.linalg.pinv(actuation.basis)  # what the basis can't reach
    ties = np.kron(np.eye(HORIZON.control), outside)
    ties = np.column_stack([ties, np.zeros((len(ties), free.hessian.shape[0] - ties.shape[1]))])
    stays = ~actuation.basis.any(axis=1)
    bounds = [
        np.where(np.append(np.tile(stays, HORIZON.control), False), 0.0, each) for each in (free.lower, free.upper)
    ]
    large = solve(
        Problem(
            hessian=free.hessian,
            gradient=free.gradient,
            lower=bounds[0],
            upper=bounds[1],
            rows=np.vstack([free.rows, ties]),
            row_lower=np.append(free.row_lower, np.zeros(len(ties))),
            row_upper=np.append(free.row_upper, np.zeros(len(ties))),
        )
    )
    assert small.is_solved
    assert large.is_solved
    assert small.cost == pytest.approx(large.cost, rel=1e-6, abs=1e-6)
    changes = own.spread(small.x[: own.n]), everything.spread(large.x[: everything.n])
    np.testing.assert_allclose(changes[0] / TRUST, changes[1] / TRUST, atol=1e-4)


@pytest.mark.parametrize("case", CASES)
def test_a_solution_stays_in_its_mode(case: str) -> None:
    """The inputs that a program proposes exist, without any clipping afterwards."""
    actuation = Actuation.of(SEDAN, *CASES[case])
    made, trajectory, model = situation(actuation, 7)
    own = Blocking(HORIZON, actuation)
    solution = solve(made.convex(trajectory, condense(model.linearise(trajectory, STATIC), own), TRUST))
    proposed = trajectory.inputs + own.spread(solution.x[: own.n])
    np.testing.assert_allclose(actuation.within(proposed, made.box.largest), proposed, rtol=1e-9, atol=1e-6)
    if not MODES[CASES[case][0]].drives:
        assert proposed[:, FORCES].max() <= 1e-6
