"""States, inputs and loads to try the two-track model at, and the model as numbers."""

from typing import NamedTuple

import casadi as ca
import numpy as np
from hypothesis import strategies as st
from numpy.typing import ArrayLike, NDArray

from swerve.vehicle import vehicle_named
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters, quasi_static_loads, symbols, two_track

Array = NDArray[np.float64]

SEDAN = vehicle_named("d-class-sedan")
DRY = Parameters.of(SEDAN, 0.85)
STATIC = np.array(wheel_loads(DRY))
MIRROR = np.array([1.0, -1.0, -1.0, -1.0, 1.0, -1.0])  # of a state: left for right
SWAP = [0, 2, 1, 4, 3]  # of an input: the wheels of an axle change places, the steering angle its sign

speeds = st.floats(2.0, 45.0)
states = st.builds(
    lambda *numbers: np.array(numbers),
    speeds,
    st.floats(-4.0, 4.0),
    st.floats(-1.5, 1.5),
    st.floats(-np.pi, np.pi),
    st.floats(-50.0, 50.0),
    st.floats(-50.0, 50.0),
)
steering_angles = st.floats(-0.5, 0.5)
shares = st.floats(-0.95, 0.95)  # of the friction circle
loads = st.builds(lambda *numbers: np.array(numbers), *4 * [st.floats(500.0, 8000.0)])
frictions = st.floats(0.1, 1.2)


@st.composite
def situations(draw: st.DrawFn) -> tuple[Array, Array, Array, Parameters]:
    """A state, an input within the friction circle, loads and parameters."""
    fz, friction = draw(loads), draw(frictions)
    forces = np.array([draw(shares) for _ in range(4)]) * friction * fz
    return draw(states), np.array([draw(steering_angles), *forces]), fz, Parameters.of(SEDAN, friction)


class Numbers(NamedTuple):
    """`two_track.Motion` as arrays."""

    derivative: Array
    acceleration: Array
    slip_angles: Array
    longitudinal: Array
    lateral: Array


def _model() -> ca.Function:
    xi, u, fz, p = symbols()
    motion = two_track(xi, u, [fz[i] for i in range(4)], p)
    return ca.Function("two_track", [xi, u, fz, ca.vertcat(*p)], [ca.vertcat(*part) for part in motion])


MODEL = _model()


def move(xi: ArrayLike, u: ArrayLike, fz: ArrayLike = STATIC, p: Parameters = DRY) -> Numbers:
    """The two-track model at one point, in numbers."""
    return Numbers(*(np.array(part)[:, 0] for part in MODEL(xi, u, fz, p.as_array())))


def _fitting_loads() -> ca.Function:
    xi, u, _, p = symbols()
    return ca.Function("loads", [xi, u, ca.vertcat(*p)], [ca.vertcat(*quasi_static_loads(xi, u, p))])


FITTING_LOADS = _fitting_loads()


def fitting_loads(xi: ArrayLike, u: ArrayLike, p: Parameters) -> Array:
    """The quasi-static loads (4,) at one point, in numbers."""
    return np.array(FITTING_LOADS(xi, u, p.as_array()))[:, 0]


def mirrored(u: Array) -> Array:
    """An input, left for right."""
    return u[SWAP] * [-1, 1, 1, 1, 1]
