"""Terms of the cost against the sums that they stand for, and their models against the linear model."""

import numpy as np
import pytest
from hypothesis import given, settings

from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.terms import InputRate, Term, Tracking, WheelForce
from swerve.conventions import VX, Y
from tests.control.unified.situations import BLOCKING, along_the_linear_model, random_roll_out, seeds

WEIGHTS = np.array([1e2, 1e-6, 2e-6, 3e-6, 4e-6])
PREVIOUS = np.array([0.03, 100.0, -200.0, 300.0, -400.0])
TERMS = {
    "speed": Tracking(VX, 20.0, 1.5),
    "lateral offset": Tracking(Y, 3.5, 10.0),
    "input rate": InputRate.of(WEIGHTS, BLOCKING).after(PREVIOUS),
    "wheel force": WheelForce(1e-8, BLOCKING),
}


def by_hand(name: str, trajectory: Trajectory) -> float:
    """The sums of (10), one summand after the other."""
    total, before = 0.0, PREVIOUS
    if name == "speed":
        return sum(1.5 * (trajectory.states[i, 0] - 20.0) ** 2 for i in range(1, 21))
    if name == "lateral offset":
        return sum(10.0 * (trajectory.states[i, 5] - 3.5) ** 2 for i in range(1, 21))
    for j in range(15):
        u = trajectory.inputs[j]
        if name == "input rate":
            total += float(np.sum(WEIGHTS * (u - before) ** 2))
        else:
            total += 1e-8 * float(np.sum(u[1:] ** 2))
        before = u
    return total


@pytest.mark.parametrize("name", TERMS)
@settings(max_examples=15)
@given(seed=seeds)
def test_the_value_is_the_sum(name: str, seed: int) -> None:
    """The value of a term is the sum that its formula says, over its samples."""
    trajectory, _, _ = random_roll_out(seed)
    assert TERMS[name].value(trajectory) == pytest.approx(by_hand(name, trajectory), rel=1e-12)


@pytest.mark.parametrize("name", TERMS)
@settings(max_examples=15)
@given(seed=seeds)
def test_the_model_is_the_value_along_the_linear_model(name: str, seed: int) -> None:
    """value + gradient' z + 1/2 z' hessian z is the term's value where the linear model goes, for any change z."""
    trajectory, sensitivities, random = random_roll_out(seed)
    term: Term = TERMS[name]
    hessian, gradient = term.quadratic(trajectory, sensitivities)
    z = random.normal(size=BLOCKING.n)
    there = along_the_linear_model(trajectory, sensitivities, z)
    model = term.value(trajectory) + gradient @ z + z @ hessian @ z / 2
    assert model == pytest.approx(term.value(there), rel=1e-9, abs=1e-9)
    np.testing.assert_allclose(hessian, hessian.T, atol=1e-9 * np.abs(hessian).max())
    assert np.linalg.eigvalsh(hessian).min() >= -1e-9 * np.abs(hessian).max()


def test_the_first_change_is_from_what_acts_now() -> None:
    """Holding the input that acts costs no change; the first step away from it does."""
    held = np.tile(PREVIOUS, (20, 1))
    trajectory, _, _ = random_roll_out(0)
    still = Trajectory(held, *list(vars(trajectory).values())[1:])
    assert TERMS["input rate"].value(still) == 0.0
    assert InputRate.of(WEIGHTS, BLOCKING).value(still) == pytest.approx(float(WEIGHTS @ PREVIOUS**2))


def test_steering_is_no_wheel_force() -> None:
    """The weight on the wheel forces leaves the steering angle free."""
    hessian, _ = TERMS["wheel force"].quadratic(*random_roll_out(0)[:2])
    diagonal = np.diag(hessian).reshape(15, 5)
    assert (diagonal[:, 0] == 0).all()
    assert (diagonal[:, 1:] == 2 * 1e-8 * 1e6).all()
