"""A family of manoeuvres that knows nothing of obstacles: two changes of the lateral offset, with brakes.

From t1 on the vehicle goes to the offset Y1, from t2 on to Y2, with no more than a share s of the friction's lateral
acceleration, as a mass that accelerates and then decelerates:

    v_ref = sign(e) (sqrt(2 a e + c^2) - c),    ay = clip(k (v_ref - Y'), -a, a),    e = Y_ref - Y

Its steering angle is the one whose front force gives that acceleration and the yaw rate ay / v that belongs to it, by
the inverse of eq. (4); its brakes take a share b1 of every wheel's friction until t2, and b2 after it. So every member
is an input within the limits, and its motion that of the two-track model (1).
"""

from functools import cache
from typing import Any, Final, NamedTuple

import casadi as ca
import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from swerve.conventions import GRAVITY, N_STATES, PSI, VX, VY, Y
from swerve.kernel import Kernel
from swerve.vehicle import Vehicle
from swerve.vehicle.integrate import rk4
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters, two_track
from swerve.vehicle.tyre import factors

Array = NDArray[np.float64]

STEP: Final = 0.01  # of the roll-out [s]
SLIP_SPEED_FLOOR: Final = 1.5  # [m/s] v0 of eq. (1), for steps of this length
BATCH: Final = 64  # members that one call rolls out
FASTER: Final = 6.0  # k, of the lateral speed [1/s]
YAWING: Final = 8.0  # of the yaw rate [1/s]
SOFT: Final = 0.5  # c [m/s]
PEAK: Final = 0.98  # share of the front axle's lateral force that is asked for at most [1]
SLOWEST: Final = 1.0  # [m/s] below, steering no longer follows the speed
STANDSTILL: Final = 0.1  # [m/s] below, a brake's force falls in proportion to the speed

N_DRAWN: Final = 1536  # members with two changes
RANGES: Final = {  # of a drawn member
    "t1": (0.0, 2.0),  # [s]
    "Y1": (-7.0, 7.0),  # [m]
    "t2": (0.5, 4.5),  # [s]
    "Y2": (-7.0, 7.0),  # [m]
    "s": (0.4, 0.97),  # [1]
    "b1": (-0.4, 0.95),  # [1]
    "b2": (-0.4, 0.95),  # [1]
}
BRAKES: Final = (0.0, 0.3, 0.6, 0.8)  # [1]
STARTS: Final = (0.0, 0.4, 0.8, 1.4)  # [s]
OFFSETS: Final = (0.0, *(sign * each for each in np.arange(0.5, 7.5, 0.5) for sign in (1, -1)))  # [m]
SHARES: Final = (0.6, 0.95)  # [1]
NEVER: Final = 1e3  # [s]


class Manoeuvre(NamedTuple):
    """One member: t1 [s], Y1 [m], t2 [s], Y2 [m], s, b1, b2 [1]; a share of brakes below 0 is none."""

    t1: Any
    Y1: Any
    t2: Any
    Y2: Any
    s: Any
    b1: Any
    b2: Any


@cache
def family() -> Array:
    """All members, the likely ones first: (n, 7) numbers of `Manoeuvre`."""
    braking = Manoeuvre(0.0, 0.0, NEVER, 0.0, 0.6, 0.95, 0.95)
    single = [
        Manoeuvre(t, offset, NEVER, offset, s, b, b)
        for s in reversed(SHARES)
        for t in STARTS
        for b in BRAKES
        for offset in OFFSETS
    ]
    low, high = zip(*RANGES.values(), strict=True)
    drawn = qmc.scale(qmc.Halton(len(RANGES), seed=0).random(N_DRAWN), low, high)
    drawn[:, 2] += drawn[:, 0]
    return np.vstack([braking, single, drawn])


class RollOut:
    """The family's motions, for a duration."""

    def __init__(self, duration: float) -> None:
        """Compile, or take from the cache, the roll-out over `duration` [s]."""
        self.times: Array = np.linspace(0.0, duration, round(duration / STEP) + 1)
        self._kernel = Kernel(_batch(len(self.times) - 1))

    def __call__(self, members: Array, start: Array, vehicle: Vehicle, friction: float) -> Array:
        """States (n, len(times), 6) of members (n, 7), n up to BATCH, from a state (6,) on a road of `friction` [1]."""
        filled = np.resize(members, (BATCH, members.shape[1]))
        p = Parameters.of(vehicle, friction, SLIP_SPEED_FLOOR).as_array()
        (states,) = self._kernel(filled.T, start, p, [vehicle.steering_limit])
        later = states.T.reshape(BATCH, -1, N_STATES)
        return np.concatenate([np.tile(start, (BATCH, 1, 1)), later], axis=1)[: len(members)]


def _batch(n_steps: int) -> ca.Function:
    """(members as columns, start, p, lock) -> states after each step, side by side, of each member in turn."""
    step = _step()
    m, start = ca.MX.sym("m", len(Manoeuvre._fields)), ca.MX.sym("start", N_STATES)
    held = [ca.MX.sym("p", step.size1_in(2)), ca.MX.sym("lock")]
    states = step.mapaccum("family", n_steps)(
        ca.vertcat(start, 0.0), *(ca.repmat(each, 1, n_steps) for each in (m, *held))
    )
    one = ca.Function("member", [m, start, *held], [states[:N_STATES, :]])
    members = ca.MX.sym("members", len(Manoeuvre._fields), BATCH)
    return ca.Function(
        "family",
        [members, start, *held],
        [one.map(BATCH)(members, *(ca.repmat(each, 1, BATCH) for each in (start, *held)))],
    )


def _step() -> ca.Function:
    """([state, time], member, p, lock) -> the same after STEP."""
    x, m, lock = ca.SX.sym("x", N_STATES + 1), Manoeuvre(*(ca.SX.sym(f) for f in Manoeuvre._fields)), ca.SX.sym("lock")
    p = Parameters.symbolic()
    loads = wheel_loads(p)
    u = _input(x[:N_STATES], x[N_STATES], m, p, loads, lock)
    end = rk4(lambda xi: ca.vertcat(*two_track(xi, u, loads, p).derivative), x[:N_STATES], STEP)
    return ca.Function("step", [x, ca.vertcat(*m), ca.vertcat(*p), lock], [ca.vertcat(end, x[N_STATES] + STEP)])


def _input(xi: Any, time: Any, m: Manoeuvre, p: Parameters, loads: tuple[Any, ...], lock: Any) -> Any:
    """The input [delta Fx_fl Fx_fr Fx_rl Fx_rr] of a member in a state."""
    brake = ca.fmax(0.0, ca.if_else(time < m.t2, m.b1, m.b2))
    ay = _lateral_acceleration(xi, time, m, m.s * p.mu * GRAVITY * ca.sqrt(1 - brake**2))
    braking = ca.fmax(-1, ca.fmin(1, xi[VX] / STANDSTILL)) * brake * p.mu
    return ca.vertcat(_steering(xi, ay, brake, p, loads[0], lock), *(-braking * load for load in loads))


def _lateral_acceleration(xi: Any, time: Any, m: Manoeuvre, most: Any) -> Any:
    """What is asked for [m/s^2]; nothing before t1."""
    error = ca.if_else(time < m.t2, m.Y1, m.Y2) - xi[Y]
    wanted = ca.sign(error) * (ca.sqrt(2 * most * ca.fabs(error) + SOFT**2) - SOFT)
    now = xi[VX] * ca.sin(xi[PSI]) + xi[VY] * ca.cos(xi[PSI])
    asked = ca.fmax(-most, ca.fmin(most, FASTER * (wanted - now)))
    return ca.if_else(time < m.t1, 0.0, asked)


def _steering(xi: Any, ay: Any, brake: Any, p: Parameters, load: Any, lock: Any) -> Any:
    """The angle [rad] whose front lateral force gives an acceleration and its yaw rate, by the inverse of eq. (4)."""
    speed, r = ca.fmax(xi[VX], SLOWEST), xi[2]
    force = (p.m * ay * p.lr + p.Izz * YAWING * (ay / speed - r)) / (p.lf + p.lr)
    stiffness, shape, peak = factors(p, load)
    most = 2 * p.mu * load * ca.sqrt(1 - brake**2) * peak
    share = ca.fmax(-PEAK, ca.fmin(PEAK, force / most))
    slip = ca.tan(ca.asin(share) / shape) / stiffness
    angle = slip + ca.atan((xi[VY] + p.lf * r) / speed)
    return ca.fmax(-lock, ca.fmin(lock, angle))
