"""Eq. (1) against itself written out once more, against finite differences, and against what mechanics demands."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.optimize import fsolve

from swerve.control.as_printed.linearisation import kernel_function
from swerve.conventions import GRAVITY
from swerve.vehicle.two_track import SLIP_SPEED_FLOOR, Parameters
from swerve.vehicle.tyre import factors, lateral_force
from tests.vehicle.motions import DRY, MIRROR, MODEL, SEDAN, STATIC, SWAP, mirrored, move, situations

JACOBIANS = kernel_function(full=True, with_mass=True)
ARMS = np.array([[DRY.lf, DRY.lt], [DRY.lf, -DRY.lt], [-DRY.lr, DRY.lt], [-DRY.lr, -DRY.lt]])  # wheels (x, y) [m]
NOTHING = np.zeros(5)


def wheel_velocities(xi: np.ndarray) -> np.ndarray:
    """(4, 2) of the wheels' centres in body axes [m/s]."""
    return np.column_stack([xi[0] - ARMS[:, 1] * xi[2], xi[1] + ARMS[:, 0] * xi[2]])


def in_body_axes(longitudinal: np.ndarray, lateral: np.ndarray, delta: float) -> np.ndarray:
    """(4, 2) of tyre forces."""
    angle = np.array([delta, delta, 0.0, 0.0])
    cos, sin = np.cos(angle), np.sin(angle)
    return np.column_stack([longitudinal * cos - lateral * sin, longitudinal * sin + lateral * cos])


@given(situations())
def test_the_derivative_is_that_of_the_paper(situation: tuple) -> None:
    """Eq. (1), line by line, with the tyre forces that eq. (4) gives at the wheels' slip angles."""
    xi, u, fz, p = situation
    vx, vy, r, psi = xi[:4]
    assume((wheel_velocities(xi)[:, 0] > 1.0).all())
    delta, fx = u[0], u[1:]
    turned = np.array([delta, delta, 0.0, 0.0])
    alpha = turned - np.arctan2(vy + ARMS[:, 0] * r, vx - ARMS[:, 1] * r)
    assume((np.abs(alpha) < 1.2).all())
    fy = [lateral_force(p, alpha[i], fx[i], p.mu, fz[i]) for i in range(4)]
    sin, cos = math.sin(delta), math.cos(delta)
    m, izz, lf, lr, lt = p.m, p.Izz, p.lf, p.lr, p.lt
    expected = [
        (fx[0] * cos - fy[0] * sin + fx[1] * cos - fy[1] * sin + fx[2] + fx[3]) / m + vy * r,
        (fx[0] * sin + fy[0] * cos + fx[1] * sin + fy[1] * cos + fy[2] + fy[3]) / m - vx * r,
        (
            (fx[1] * cos - fy[1] * sin + fx[3] - fx[0] * cos + fy[0] * sin - fx[2]) * lt
            + (fx[0] * sin + fy[0] * cos + fx[1] * sin + fy[1] * cos) * lf
            - (fy[2] + fy[3]) * lr
        )
        / izz,
        r,
        vx * math.cos(psi) - vy * math.sin(psi),
        vx * math.sin(psi) + vy * math.cos(psi),
    ]
    motion = move(xi, u, fz, p)
    np.testing.assert_allclose(motion.slip_angles, alpha, atol=1e-9)
    np.testing.assert_allclose(motion.derivative, expected, rtol=1e-9, atol=1e-9)


def test_the_steering_angle_turns_the_vehicle() -> None:
    """Running straight at 20 m/s, d(vx', vy', r')/d(delta) is [0, 87.7, 64.3], where the paper prints zeros."""
    _, _, B = JACOBIANS([20.0, 0, 0, 0, 0, 0], NOTHING, STATIC, DRY.as_array())
    np.testing.assert_allclose(np.array(B)[:3, 0], [0.0, 87.7, 64.3], atol=0.05)


@given(situations())
def test_the_jacobians_are_the_slopes(situation: tuple) -> None:
    """df/dxi and df/du are what finite differences say, at any state, input and load."""
    xi, u, fz, p = situation
    assume((np.abs(wheel_velocities(xi)[:, 0]) > 1.0).all())
    f, A, B = (np.array(each) for each in JACOBIANS(xi, u, fz, p.as_array()))
    np.testing.assert_array_equal(f[:, 0], move(xi, u, fz, p).derivative)
    for J, at, step in ((A, xi, np.full(6, 1e-5)), (B, u, np.array([1e-6, 0.1, 0.1, 0.1, 0.1]))):
        for j, h in enumerate(step):
            d = np.zeros(len(at))
            d[j] = h
            ahead, behind = ((at + d, u), (at - d, u)) if J is A else ((xi, at + d), (xi, at - d))
            slope = (move(*ahead, fz, p).derivative - move(*behind, fz, p).derivative) / (2 * h)
            np.testing.assert_allclose(J[:, j], slope, rtol=2e-4, atol=2e-4 * (1 + np.abs(J[:, j]).max()))


@given(situations())
def test_left_and_right_are_mirror_images(situation: tuple) -> None:
    """With state, steering, wheels and loads mirrored, the motion is the mirror image, to the last bit."""
    xi, u, fz, p = situation
    here, there = move(xi, u, fz, p), move(xi * MIRROR, mirrored(u), fz[[1, 0, 3, 2]], p)
    np.testing.assert_allclose(there.derivative, here.derivative * MIRROR, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(there.slip_angles, -here.slip_angles[[1, 0, 3, 2]], atol=1e-15)
    assert SWAP[1:] == [2, 1, 4, 3]


@given(situations(), st.floats(-np.pi, np.pi), st.floats(-100.0, 100.0))
def test_nothing_depends_on_where_north_is(situation: tuple, angle: float, distance: float) -> None:
    """Turned and moved as a whole, the vehicle accelerates as before and travels in the turned direction."""
    xi, u, fz, p = situation
    here = move(xi, u, fz, p).derivative
    there = move(xi + np.array([0, 0, 0, angle, distance, -distance]), u, fz, p).derivative
    np.testing.assert_array_equal(there[:4], here[:4])
    turn = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    np.testing.assert_allclose(there[4:], turn @ here[4:], atol=1e-9)


@given(situations())
def test_momentum_changes_by_the_tyres_alone(situation: tuple) -> None:
    """Mass times acceleration in world axes, and the yaw momentum's change, are the sum of the four tyres' work."""
    xi, u, fz, p = situation
    motion = move(xi, u, fz, p)
    forces = in_body_axes(motion.longitudinal, motion.lateral, u[0])
    vx, vy, r, psi = xi[:4]
    # d/dt of [cos -sin; sin cos] (vx, vy)
    cos, sin = math.cos(psi), math.sin(psi)
    ax_body = motion.derivative[:2] + r * np.array([-vy, vx])
    in_world = np.array([[cos, -sin], [sin, cos]]) @ ax_body
    np.testing.assert_allclose(p.m * in_world, np.array([[cos, -sin], [sin, cos]]) @ forces.sum(axis=0), atol=1e-6)
    np.testing.assert_allclose(motion.acceleration, forces.sum(axis=0) / p.m, atol=1e-9)
    moment = np.sum(ARMS[:, 0] * forces[:, 1] - ARMS[:, 1] * forces[:, 0])
    assert p.Izz * motion.derivative[2] == pytest.approx(moment, abs=1e-6)


@given(situations())
def test_kinetic_energy_changes_by_the_tyres_power(situation: tuple) -> None:
    """d/dt of the kinetic energy is the sum of the tyre forces times the wheels' velocities."""
    xi, u, fz, p = situation
    motion = move(xi, u, fz, p)
    change = p.m * (xi[0] * motion.derivative[0] + xi[1] * motion.derivative[1]) + p.Izz * xi[2] * motion.derivative[2]
    power = np.sum(in_body_axes(motion.longitudinal, motion.lateral, u[0]) * wheel_velocities(xi))
    assert change == pytest.approx(power, rel=1e-9, abs=1e-6)


@given(situations())
def test_rolling_tyres_give_no_energy(situation: tuple) -> None:
    """Without wheel forces a vehicle that slides only loses energy."""
    xi, u, fz, p = situation
    u = np.array([u[0], 0, 0, 0, 0])
    motion = move(xi, u, fz, p)
    assert np.sum(in_body_axes(motion.longitudinal, motion.lateral, u[0]) * wheel_velocities(xi)) <= 1e-9


@given(situations())
def test_without_grip_nothing_acts(situation: tuple) -> None:
    """On a road of next to no friction energy and velocity in world axes stay as they are."""
    xi, u, fz, p = situation
    motion = move(xi, u, fz, p._replace(mu=1e-12))
    vx, vy, r = xi[:3]
    np.testing.assert_allclose(motion.derivative[:3], [vy * r, -vx * r, 0.0], atol=1e-9)


@pytest.mark.parametrize("speed", [5.0, 15.0, 20.0, 30.0, 40.0])
def test_steady_turn_is_that_of_the_linear_bicycle(speed: float) -> None:
    """At a small steering angle the yaw rate is v delta / (L + K v^2), K = m (lr / Cf - lf / Cr) / L."""
    delta, p = 1e-4, DRY
    stiffness = [math.prod(factors(p, load)) * p.mu * load for load in STATIC]
    front, rear = stiffness[0] + stiffness[1], stiffness[2] + stiffness[3]
    length = p.lf + p.lr
    gradient = p.m * (p.lr / front - p.lf / rear) / length  # K [s^2/m]

    def sideways(unknown: np.ndarray) -> np.ndarray:
        return move([speed, unknown[0], unknown[1], 0, 0, 0], [delta, 0, 0, 0, 0]).derivative[1:3]

    _, yaw_rate = fsolve(sideways, [0.0, speed * delta / length], xtol=1e-13)
    assert yaw_rate == pytest.approx(speed * delta / (length + gradient * speed**2), rel=1e-5)


def test_the_sedan_understeers() -> None:
    """With its centre of gravity ahead of the middle and one tyre for all wheels, load sensitivity makes K positive."""
    stiffness = [math.prod(factors(DRY, load)) * DRY.mu * load for load in STATIC]
    per_weight = [STATIC[i] / GRAVITY / stiffness[i] for i in (0, 2)]
    assert per_weight[0] > per_weight[1]


def test_at_rest_nothing_moves() -> None:
    """A vehicle that stands without wheel force stays, whatever its steering angle is."""
    for delta in (-0.5, 0.0, 0.3):
        assert (move(np.zeros(6), [delta, 0, 0, 0, 0]).derivative == 0).all()


@given(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0), st.floats(-2.0, 2.0), st.floats(-0.5, 0.5))
def test_standstill_is_no_singularity(vx: float, vy: float, r: float, delta: float) -> None:
    """Down to standstill and backwards, derivatives and Jacobians are finite, and forces within their limits."""
    xi, u = [vx, vy, r, 0.1, 0, 0], [delta, 500.0, -500.0, 0, 0]
    motion = move(xi, u)
    _, A, B = (np.array(each) for each in JACOBIANS(xi, u, STATIC, DRY.as_array()))
    assert np.isfinite(A).all()
    assert np.isfinite(B).all()
    assert (np.hypot(motion.longitudinal, motion.lateral) <= 1.02 * DRY.mu * STATIC).all()


@pytest.mark.parametrize("floor", [SLIP_SPEED_FLOOR, 5.0])
def test_the_floor_speed_is_crossed_smoothly(floor: float) -> None:
    """At the speed v0 where slip angles begin to be rounded off, value and slope are continuous; above, nothing
    changes.
    """
    p = Parameters.of(SEDAN, 0.85, floor)

    def at(speed: float) -> np.ndarray:
        return move([speed, 0.2, 0.0, 0, 0, 0], NOTHING, p=p).derivative

    h = 1e-6
    np.testing.assert_allclose(at(floor - h), at(floor + h), rtol=1e-4)
    before, after = (at(floor) - at(floor - h)) / h, (at(floor + h) - at(floor)) / h
    np.testing.assert_allclose(before, after, rtol=1e-3, atol=1e-3)
    other = Parameters.of(SEDAN, 0.85, floor / 2)
    np.testing.assert_array_equal(at(1.1 * floor), move([1.1 * floor, 0.2, 0, 0, 0, 0], NOTHING, p=other).derivative)


@pytest.mark.parametrize(("floor", "step"), [(SLIP_SPEED_FLOOR, 3.7e-3), (5.0, 25e-3)])
def test_the_floor_speed_holds_the_fastest_pole(floor: float, step: float) -> None:
    """At standstill the model's fastest pole is slow enough for the Runge-Kutta step that goes with the floor speed."""
    p = Parameters.of(SEDAN, 0.85, floor)
    _, A, _ = JACOBIANS(np.zeros(6), NOTHING, STATIC, p.as_array())
    assert np.abs(np.linalg.eigvals(np.array(A))).max() * step < 2.785


def test_parameters_are_the_vehicles_numbers() -> None:
    """Each letter of the paper is the vehicle's number of that meaning, and the vector has their order."""
    assert (DRY.m, DRY.Izz, DRY.lf, DRY.lr, DRY.lt, DRY.h, DRY.mu) == (1530.0, 2315.3, 1.11, 1.67, 0.775, 0.0, 0.85)
    assert dict(zip(Parameters._fields, DRY.as_array(), strict=True)) == DRY._asdict()
    assert MODEL.size_in(3) == (len(Parameters._fields), 1)
