"""The full vehicle as numbers, and what it carries: energy and momentum, counted from positions and speeds alone."""

from typing import NamedTuple

import casadi as ca
import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.integrate import solve_ivp

from swerve.conventions import GRAVITY
from swerve.vehicle import vehicle_named
from swerve.vehicle.multibody import completion_of
from swerve.vehicle.multibody.model import N_MULTIBODY, multibody
from swerve.vehicle.multibody.numbers import Numbers

Array = NDArray[np.float64]

SEDAN = vehicle_named("d-class-sedan")
CHASSIS, ACTUATORS = completion_of("d-class-sedan")
NUMBERS = Numbers.of(SEDAN, CHASSIS)
LOSSLESS = NUMBERS._replace(cf=0.0, cr=0.0, cz=0.0, drag=0.0, rolling=0.0)
STATIC = np.array([NUMBERS.Ff, NUMBERS.Ff, NUMBERS.Fr, NUMBERS.Fr])


def _model() -> ca.Function:
    x, steering, step = ca.SX.sym("x", N_MULTIBODY), ca.SX.sym("steering"), ca.SX.sym("step")
    torques, brakes, friction = (ca.SX.sym(name, 4) for name in ("torques", "brakes", "friction"))
    p = Numbers.symbolic()
    motion = multibody(x, steering, torques, brakes, friction, p, step)
    inputs = [x, steering, torques, brakes, friction, ca.vertcat(*p), step]
    return ca.Function("multibody", inputs, [motion.derivative, *(ca.vertcat(*part) for part in motion[1:])])


MODEL = _model()


class Motion(NamedTuple):
    """`model.Motion` as arrays."""

    derivative: Array
    acceleration: Array
    loads: Array
    slip_angles: Array
    longitudinal: Array
    lateral: Array


def move(
    x: ArrayLike,
    steering: float = 0.0,
    torques: ArrayLike = (0, 0, 0, 0),
    brakes: ArrayLike = (0, 0, 0, 0),
    friction: float = 0.85,
    p: Numbers = NUMBERS,
) -> Motion:
    """The model at one point, in numbers."""
    outputs = MODEL(x, steering, torques, brakes, friction * np.ones(4), p.as_array(), 1e-3)
    return Motion(*(np.array(output)[:, 0] for output in outputs))


def glide(x: Array, seconds: float, p: Numbers) -> Array:
    """States (n, N_MULTIBODY) of a vehicle on ice, by another and tighter integrator."""
    found = solve_ivp(
        lambda _, y: move(y, friction=0.0, p=p).derivative, (0.0, seconds), x, "DOP853", rtol=1e-11, atol=1e-11
    )
    return np.array(found.y.T)


def wild_start(height: float = 0.0, seed: int = 1) -> Array:
    """A state in which everything moves."""
    rng = np.random.default_rng(seed)
    x = np.zeros(N_MULTIBODY)
    x[:12] = [20.0, 1.0, 0.5, 0.3, 0.0, 0.0, 0.05 + height, 0.3, 0.05, -0.03, 0.6, 0.4]
    x[12:16], x[16:20], x[20:24] = 0.02 * rng.normal(size=4), 0.3 * rng.normal(size=4), 60 + 5 * rng.normal(size=4)
    return x


class Carried(NamedTuple):
    """What a vehicle has at one instant, in world axes.

    Attributes:
        energy: [J].
        momentum: (3,) [N s].
        spin: (3,) angular momentum about the centre of gravity [N m s].
        turning: angular momentum about the world's Z axis [N m s].
    """

    energy: float
    momentum: Array
    spin: Array
    turning: float


def carried(x: Array, p: Numbers) -> Carried:
    """Of a state, with straight wheels."""
    psi, roll, pitch = x[3], x[8], x[9]
    body = turn_z(psi) @ turn_y(pitch) @ turn_x(roll)
    rates = np.array([x[10], 0, 0]) + turn_x(roll).T @ (np.array([0, x[11], 0]) + turn_y(pitch).T @ [0, 0, x[2]])
    omega, origin = body @ rates, np.array([x[4], x[5], x[6] + p.h])
    velocity = turn_z(psi) @ [x[0], x[1], x[7]]
    masses, places, speeds = [p.ms], [origin + body @ [p.xs, 0, p.zs]], []
    speeds.append(velocity + np.cross(omega, places[0] - origin))
    own = body @ (np.array([p.Ixx, p.Iyy, p.Izz]) * rates)
    energy = 0.5 * rates @ (np.array([p.Ixx, p.Iyy, p.Izz]) * rates)
    for i, (ahead, left) in enumerate(((p.lf, p.lt), (p.lf, -p.lt), (-p.lr, p.lt), (-p.lr, -p.lt))):
        lean, mass, static, spring = (p.ef, p.muf, p.Ff, p.kf) if i < 2 else (p.er, p.mur, p.Fr, p.kr)
        guide = body @ [0, np.sign(left) * lean, 1]
        places.append(origin + body @ [ahead, left, p.R - p.h] + guide * x[12 + i])
        speeds.append(velocity + np.cross(omega, places[-1] - origin) + guide * x[16 + i])
        masses.append(mass)
        own = own + body @ [0, p.Iw * x[20 + i], 0]
        pressed = max(static / p.kz - (places[-1][2] - p.R), 0.0)
        energy += 0.5 * (p.Iw * x[20 + i] ** 2 + spring * x[12 + i] ** 2 + p.kz * pressed**2)
        energy += (static - mass * GRAVITY) * x[12 + i]
    energy += 0.5 * p.bf * (x[12] - x[13]) ** 2 + 0.5 * p.br * (x[14] - x[15]) ** 2
    m, at, v = np.array(masses), np.array(places), np.array(speeds)
    energy += float(np.sum(m * (0.5 * (v**2).sum(axis=1) + GRAVITY * at[:, 2])))
    centre, momentum = m @ at / m.sum(), m @ v
    about_origin = own + (m[:, None] * np.cross(at, v)).sum(axis=0)
    return Carried(energy, momentum, about_origin - np.cross(centre, momentum), about_origin[2])


def turn_x(angle: float) -> Array:
    """Rotation about x by an angle [rad]."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def turn_y(angle: float) -> Array:
    """Rotation about y by an angle [rad]."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def turn_z(angle: float) -> Array:
    """Rotation about z by an angle [rad]."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
