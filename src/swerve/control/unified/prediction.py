"""Prediction: eq. (1) rolled out over the horizon, and its Jacobians along the way.

Each sample, with its input held, is two Runge-Kutta steps, so that the pose half way is known too:

    x_mid = rk4(x_k, u_k, Ts/2),   x_k+1 = rk4(x_mid, u_k, Ts/2)
    dx_k+1 = A_k dx_k + B_k du_k,  dy_k = C_k dx_k + D_k du_k,
    y = [X_mid Y_mid psi_mid alpha_front(x_k, u_k) alpha_rear(x_k+1)]

by automatic differentiation of the whole step: lateral forces, load and friction included.
"""

from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.control.settings import Horizon
from swerve.conventions import N_INPUTS, N_STATES, POSE, PSI, X, Y
from swerve.kernel import Kernel
from swerve.vehicle import Vehicle
from swerve.vehicle.integrate import rk4
from swerve.vehicle.two_track import Parameters, axle_slip_angle, symbols, two_track
from swerve.vehicle.tyre import factors, magic_formula

Array = NDArray[np.float64]

N_OUTPUTS = 5  # y above
SLIP_SPEED_FLOOR = 5.0  # [m/s] keeps Runge-Kutta steps of 25 ms stable down to standstill; see two_track


@dataclass(frozen=True, eq=False)
class Trajectory:
    """A roll-out of inputs through the nonlinear model.

    Attributes:
        inputs: (Np, 5) [rad, N, N, N, N].
        states: (Np + 1, 6), the first of them given.
        poses: (2 Np + 1, 3) of X [m], Y [m], psi [rad] at every half sample; then those beyond the horizon.
        front_slip: (Np,) of the front axle's middle when each input sets in [rad].
        rear_slip: (Np,) of the rear axle's middle at the end of each sample [rad].
        lateral_demand: (Np, 4) |M(alpha)| / D of each wheel when each input sets in: 1 at its peak [1].
        speeds_beyond: along X at each pose beyond the horizon [m/s].
    """

    inputs: Array
    states: Array
    poses: Array
    front_slip: Array
    rear_slip: Array
    lateral_demand: Array
    speeds_beyond: Array = field(default_factory=lambda: np.empty(0))

    def extended(self, poses: Array, speeds: Array) -> "Trajectory":
        """The same with poses (n, 3) beyond the horizon, and the speeds (n,) there."""
        return replace(self, poses=np.concatenate([self.poses, poses]), speeds_beyond=speeds)

    @property
    def is_finite(self) -> bool:
        """Whether the model stayed finite all the way."""
        return bool(np.isfinite(self.states).all())


@dataclass(frozen=True, eq=False)
class Linearisation:
    """Jacobians along a trajectory: A (Np, 6, 6), B (Np, 6, 5), C (Np, 5, 6), D (Np, 5, 5), in SI."""

    A: Array
    B: Array
    C: Array
    D: Array


class PredictionModel:
    """The compiled roll-out and linearisation for one vehicle, friction and horizon."""

    def __init__(self, vehicle: Vehicle, friction: float, horizon: Horizon) -> None:
        """Compile, or take from the cache, the kernels of this number of samples."""
        self.horizon = horizon
        self._parameters = Parameters.of(vehicle, friction, SLIP_SPEED_FLOOR).as_array()
        self._advance = Kernel(_sample())
        self._roll_out = Kernel(_over_horizon(_sample(), horizon.prediction, "roll_out"))
        self._linearise = Kernel(_over_horizon(_sample_with_jacobians(), horizon.prediction, "linearise", skip=1))

    def advance(self, state: Array, u: Array, loads: Array, duration: float) -> Array:
        """The state (6,) after `duration` [s] with the input u (5,) held."""
        return self._advance(state, u, loads, self._parameters, duration)[0]

    def roll_out(self, start: Array, inputs: Array, loads: Array) -> Trajectory:
        """The motion from state `start` (6,) under `inputs` (Np, 5), with wheel loads (4,) [N] held."""
        answer = self._roll_out(start, inputs.T, loads, self._parameters, self.horizon.sample_time)
        states, outputs, demand = (rows.reshape(-1, len(inputs), order="F") for rows in answer)
        all_states = np.vstack([start, states.T])
        poses = np.empty((2 * len(inputs) + 1, 3))
        poses[0::2] = all_states[:, POSE]
        poses[1::2] = outputs[:3].T
        return Trajectory(inputs, all_states, poses, outputs[3], outputs[4], demand.T)

    def linearise(self, trajectory: Trajectory, loads: Array) -> Linearisation:
        """Jacobians along a roll-out with these wheel loads (4,) [N]."""
        start, inputs = trajectory.states[0], trajectory.inputs
        by_state, by_input = self._linearise(start, inputs.T, loads, self._parameters, self.horizon.sample_time)
        n = self.horizon.prediction
        # (rows, n * columns) in column-major order is (n, columns, rows) in memory
        f_x = by_state.T.reshape(n, N_STATES, N_STATES + N_OUTPUTS).transpose(0, 2, 1)
        f_u = by_input.T.reshape(n, N_INPUTS, N_STATES + N_OUTPUTS).transpose(0, 2, 1)
        return Linearisation(f_x[:, :N_STATES], f_u[:, :N_STATES], f_x[:, N_STATES:], f_u[:, N_STATES:])


@cache
def _sample() -> ca.Function:
    """(x, u, Fz, p, Ts) -> x_k+1, y, |M|/D."""
    x, u, loads, p = symbols()
    duration = ca.SX.sym("Ts")
    wheel_loads = [loads[i] for i in range(4)]
    now = two_track(x, u, wheel_loads, p)

    def derivative(state: ca.SX) -> Any:
        return ca.vertcat(*two_track(state, u, wheel_loads, p).derivative)

    mid = rk4(derivative, x, duration / 2)
    end = rk4(derivative, mid, duration / 2)
    slips = (axle_slip_angle(x, p.lf, u[0], p), axle_slip_angle(end, -p.lr, 0.0, p))
    y = ca.vertcat(mid[X], mid[Y], mid[PSI], *slips)
    demand = [ca.fabs(magic_formula(p, now.slip_angles[i], loads[i])) / factors(p, loads[i])[2] for i in range(4)]
    return ca.Function("sample", [x, u, loads, ca.vertcat(*p), duration], ca.cse([end, y, ca.vertcat(*demand)]))


@cache
def _sample_with_jacobians() -> ca.Function:
    """(x, u, Fz, p, Ts) -> x_k+1, d[x_k+1; y]/dx, d[x_k+1; y]/du."""
    sample = _sample()
    arguments = sample.sx_in()
    end, y, _ = sample.call(arguments)
    jacobians = [ca.densify(ca.jacobian(ca.vertcat(end, y), arguments[i])) for i in (0, 1)]
    return ca.Function("sample_with_jacobians", arguments, ca.cse([end, *jacobians]))


@cache
def _over_horizon(sample: ca.Function, n: int, name: str, skip: int = 0) -> ca.Function:
    """`sample` n times, each from where the last one ended; other arguments but the input are the same for all.

    The first `skip` results are left out.
    """
    x, inputs = ca.MX.sym("x", N_STATES), ca.MX.sym("U", N_INPUTS, n)
    held = [ca.MX.sym(f"held{i}", *sample.size_in(i)) for i in range(2, sample.n_in())]
    results = sample.mapaccum(name, n).call([x, inputs, *(ca.repmat(h, 1, n) for h in held)])
    return ca.Function(name, [x, inputs, *held], results[skip:])
