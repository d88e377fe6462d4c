"""Steering that keeps a lateral offset: a linear-quadratic regulator of the prediction model, scheduled by speed.

    delta = -K(vx) [vy, r, psi, Y - y_d]

K solves the discrete algebraic Riccati equation of the model (1) linearised straight on at that speed, for

    J = sum (Y / Y_SCALE)^2 + (psi / PSI_SCALE)^2 + (delta / DELTA_SCALE)^2
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_discrete_are

from swerve.control.unified.prediction import PredictionModel
from swerve.conventions import DELTA, GRAVITY, N_INPUTS, N_STATES, PSI, VX, VY, R, Y
from swerve.vehicle import Vehicle
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters

Array = NDArray[np.float64]

LATERAL = [VY, R, PSI, Y]
SPEEDS = np.array([1.0, 2.0, 4.0, 7.0, 10.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0, 70.0])  # [m/s]
Y_SCALE = 0.3  # [m]
PSI_SCALE = 0.1  # [rad]
DELTA_SCALE = 0.05  # [rad]
FARTHEST = 0.5  # [m] of a deviation that is steered for; a lane change is a walk, not a jump
GENTLE = 0.5  # [1] share of mu g that lane keeping may take in a turn


@dataclass(frozen=True, eq=False)
class LaneKeeping:
    """The regulator of one vehicle, road and goal.

    Attributes:
        offset: y_d [m].
        gains: (n, 4) K at SPEEDS [s rad/m, s, 1, rad/m].
        vehicle: whose lock and wheelbase bound the angle.
        friction: mu [1].
        slip_limit: that a front tyre takes beside the turn itself [rad].
    """

    offset: float
    gains: Array
    vehicle: Vehicle
    friction: float
    slip_limit: float

    @classmethod
    def of(cls, model: PredictionModel, vehicle: Vehicle, friction: float, offset: float) -> "LaneKeeping":
        """The regulator for a vehicle on a road of known friction."""
        loads = np.array(wheel_loads(Parameters.of(vehicle, friction)))
        gains = np.array([_gain(model, loads, speed) for speed in SPEEDS])
        peak = float(vehicle.tyre.peak_slip(float(loads[0])))
        return cls(offset, gains, vehicle, friction, GENTLE * peak)

    def angle(self, state: Array) -> float:
        """The steering angle for a state (6,) [rad]."""
        deviation = state[LATERAL].copy()
        deviation[-1] = min(max(deviation[-1] - self.offset, -FARTHEST), FARTHEST)
        speed = float(state[VX])
        gain = self._gain_at(speed)
        turn = self.vehicle.wheelbase * GENTLE * self.friction * GRAVITY / max(speed, SPEEDS[0]) ** 2
        largest = min(self.vehicle.steering_limit, self.slip_limit + turn)
        return float(np.clip(-gain @ deviation, -largest, largest))

    def _gain_at(self, speed: float) -> Array:
        """K (4,) between its neighbours in speed [m/s]."""
        place = min(max(speed, SPEEDS[0]), SPEEDS[-1])
        i = min(int(np.searchsorted(SPEEDS, place, side="right")), len(SPEEDS) - 1)
        share = (place - SPEEDS[i - 1]) / (SPEEDS[i] - SPEEDS[i - 1])
        return np.asarray((1 - share) * self.gains[i - 1] + share * self.gains[i])


def _gain(model: PredictionModel, loads: Array, speed: float) -> Array:
    """K (4,) at a speed [m/s]."""
    straight = np.zeros(N_STATES)
    straight[VX] = speed
    inputs = np.zeros((model.horizon.prediction, N_INPUTS))
    linear = model.linearise(model.roll_out(straight, inputs, loads), loads)
    A, B = linear.A[0][np.ix_(LATERAL, LATERAL)], linear.B[0][LATERAL, DELTA : DELTA + 1]
    Q, weight = np.diag([0.0, 0.0, 1 / PSI_SCALE**2, 1 / Y_SCALE**2]), np.array([[1 / DELTA_SCALE**2]])
    P = solve_discrete_are(A, B, Q, weight)
    return np.asarray(np.linalg.solve(weight + B.T @ P @ B, B.T @ P @ A)[0])
