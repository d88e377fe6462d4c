"""The printed Jacobians, term by term as sec. 4.2 prints them, and where they are right and where not."""

import math
from itertools import product

import casadi as ca
import numpy as np
import pytest
from hypothesis import assume, given

from swerve.control.as_printed.linearisation import kernel_function
from swerve.vehicle.two_track import Parameters, symbols, two_track
from swerve.vehicle.tyre import magic_formula
from tests.vehicle.motions import DRY, STATIC, move, situations

PRINTED = kernel_function(full=False, with_mass=False)
WITH_MASS = kernel_function(full=False, with_mass=True)
FULL = kernel_function(full=True, with_mass=True)


def evaluate(function: ca.Function, xi: np.ndarray, u: np.ndarray, fz: np.ndarray, p: Parameters) -> tuple:
    """f (6,), A (6, 6), B (6, 5)."""
    f, A, B = (np.array(each) for each in function(xi, u, fz, p.as_array()))
    return f[:, 0], A, B


def frozen_lateral_forces() -> ca.Function:
    """The Jacobians of eq. (1), by differentiation, with tyres whose slip angles are numbers that do not change."""
    xi, u, fz, p = symbols()
    alpha = ca.SX.sym("alpha", 4)
    loads = [fz[i] for i in range(4)]
    lateral = [magic_formula(p, alpha[i], loads[i]) * ca.sqrt((p.mu * loads[i]) ** 2 - u[1 + i] ** 2) for i in range(4)]
    sin, cos = ca.sin(u[0]), ca.cos(u[0])
    steer = [(cos, sin), (cos, sin), (1, 0), (1, 0)]
    x = [u[1 + i] * steer[i][0] - lateral[i] * steer[i][1] for i in range(4)]
    y = [u[1 + i] * steer[i][1] + lateral[i] * steer[i][0] for i in range(4)]
    moment = p.lt * (x[1] + x[3] - x[0] - x[2]) + p.lf * (y[0] + y[1]) - p.lr * (y[2] + y[3])
    vx, vy, r, psi = xi[0], xi[1], xi[2], xi[3]
    f = ca.vertcat(
        sum(x) / p.m + vy * r,
        sum(y) / p.m - vx * r,
        moment / p.Izz,
        r,
        vx * ca.cos(psi) - vy * ca.sin(psi),
        vx * ca.sin(psi) + vy * ca.cos(psi),
    )
    jacobians = [ca.densify(ca.jacobian(f, each)) for each in (xi, u)]
    return ca.Function("frozen", [xi, u, fz, ca.vertcat(*p), alpha], jacobians)


FROZEN = frozen_lateral_forces()


def test_the_printed_entries_at_one_state() -> None:
    """A_k and b11 to b35 as they stand in the paper, evaluated by hand at one state, misprints included."""
    xi, u = np.array([18.0, 0.7, 0.2, 0.15, 4.0, 1.0]), np.array([0.06, -900.0, 400.0, 250.0, -600.0])
    fz = np.array([4300.0, 4700.0, 2800.0, 3200.0])
    _, A, B = evaluate(PRINTED, xi, u, fz, DRY)
    motion = move(xi, u, fz)
    vx, vy, r, psi = xi[:4]
    cos, sin, c, s = math.cos(u[0]), math.sin(u[0]), math.cos(psi), math.sin(psi)
    m, izz, lf, lr, lt = 1530.0, 2315.3, 1.11, 1.67, 0.775
    fx, fy = u[1:], motion.lateral
    root = np.sqrt((0.85 * fz) ** 2 - fx**2)
    M = fy / root
    k = M * fx / root
    expected_A = [
        [0, r, vy, 0, 0, 0],
        [-r, 0, -vx, 0, 0, 0],
        [0, 0, 0, 0, 0, 0],
        [0, 0, 1, 0, 0, 0],
        [c, -s, 0, -vx * s - vy * c, 0, 0],
        [s, c, 0, vx * c - vy * s, 0, 0],
    ]
    expected_B = [
        [
            -fx[0] * sin - fy[0] * cos - fx[1] * sin - fy[1] * cos,
            cos / m + k[0] * sin / m,
            cos / m + k[1] * sin / m,
            1 / m,
            1 / m,
        ],
        [
            fx[0] * cos - fy[0] * sin + fx[1] * cos - fy[1] * sin,
            sin / m - k[0] * cos / m,
            sin / m - k[1] * cos / m,
            -k[2] / m,
            -k[3] / m,
        ],
        [
            (fx[0] * sin + fy[0] * cos - fx[1] * sin - fy[1] * cos) * lt
            + (fx[0] * cos - fy[0] * sin + fx[1] * cos - fy[1] * sin) * lf,
            lf * sin / izz - lf * k[0] * cos / izz - lt * cos / izz - lt * k[0] * sin / izz,
            lf * sin / izz - lf * k[1] * cos / izz + lt * cos / izz + lt * k[1] * sin / izz,
            -lt / izz + lr * k[2] / izz,
            lt / izz + lr * k[3] / izz,
        ],
    ]
    np.testing.assert_allclose(A, expected_A, atol=1e-12)
    np.testing.assert_allclose(B[:3], expected_B, rtol=1e-9)
    assert (B[3:] == 0).all()


@given(situations())
def test_with_mass_they_are_the_jacobians_of_frozen_tyres(situation: tuple) -> None:
    """With 1/m and 1/Izz put right, the printed Jacobians are those of eq. (1) with slip angles that do not change."""
    xi, u, fz, p = situation
    _, A, B = evaluate(WITH_MASS, xi, u, fz, p)
    alpha = move(xi, u, fz, p).slip_angles
    frozen_A, frozen_B = (np.array(each) for each in FROZEN(xi, u, fz, p.as_array(), alpha))
    np.testing.assert_allclose(A, frozen_A, atol=1e-10)
    np.testing.assert_allclose(B, frozen_B, rtol=1e-8, atol=1e-10)


@given(situations())
def test_as_printed_the_steering_column_lacks_mass_and_inertia(situation: tuple) -> None:
    """b11 and b21 are too large by m, b31 by Izz; nothing else differs."""
    xi, u, fz, p = situation
    f, A, printed = evaluate(PRINTED, xi, u, fz, p)
    f_mass, A_mass, with_mass = evaluate(WITH_MASS, xi, u, fz, p)
    np.testing.assert_allclose(printed[:3, 0], with_mass[:3, 0] * [p.m, p.m, p.Izz], rtol=1e-12)
    np.testing.assert_array_equal(printed[:, 1:], with_mass[:, 1:])
    np.testing.assert_array_equal(A, A_mass)
    np.testing.assert_array_equal(f, f_mass)


def test_running_straight_the_printed_steering_column_is_dead() -> None:
    """With Fx = 0, straight on, the paper's model does not know that the front wheels steer; the full one does."""
    running, nothing = np.array([20.0, 0, 0, 0, 0, 0]), np.zeros(5)
    for function in (PRINTED, WITH_MASS):
        assert (evaluate(function, running, nothing, STATIC, DRY)[2][:, 0] == 0).all()
    full = evaluate(FULL, running, nothing, STATIC, DRY)[2][:, 0]
    np.testing.assert_allclose(full, [0, 87.7, 64.3, 0, 0, 0], atol=0.05)


@given(situations())
def test_wheel_force_columns_are_right_as_printed(situation: tuple) -> None:
    """The columns of the wheel forces, b12 to b35, are those of the full Jacobian: the misprints are elsewhere."""
    xi, u, fz, p = situation
    assume((np.abs(u[1:]) < 0.94 * p.mu * fz).all())
    np.testing.assert_allclose(
        evaluate(PRINTED, xi, u, fz, p)[2][:, 1:], evaluate(FULL, xi, u, fz, p)[2][:, 1:], rtol=1e-8, atol=1e-12
    )


@pytest.mark.parametrize(("full", "with_mass"), list(product([False, True], repeat=2)))
def test_the_drift_is_always_the_models(full: bool, with_mass: bool) -> None:
    """f is eq. (1) itself, whatever Jacobians stand beside it."""
    xi, u = np.array([20.0, 0.4, 0.1, 0.2, 0, 0]), np.array([0.02, 100.0, 0, 0, -100.0])
    f, _, _ = evaluate(kernel_function(full=full, with_mass=with_mass), xi, u, STATIC, DRY)
    np.testing.assert_array_equal(f, move(xi, u).derivative)
    assert two_track(list(xi), list(u), list(STATIC), DRY).derivative[3] == xi[2]
