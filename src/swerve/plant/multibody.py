"""The multibody plant: fourteen degrees of freedom, actuators, and the road's friction under each wheel.

Each step is Heun's (of second order), the actuators' values those of its start in the first stage and of its end in the
second; friction is that under the wheels at its start. The model's fastest rates stay below 1 / ms from standstill to
50 m/s, so 1 ms is stable. A command reaches the actuators a whole number of steps late.
"""

from functools import cache
from itertools import pairwise

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import N_INPUTS, N_STATES, N_WHEELS
from swerve.kernel import Kernel
from swerve.plant.protocol import Plant, PlantState, Trace
from swerve.signals import Command
from swerve.vehicle import Vehicle
from swerve.vehicle.multibody import Actuators, Chassis
from swerve.vehicle.multibody.actuators import N_ACTUATORS, Limits, actuate
from swerve.vehicle.multibody.ground import PATCH, friction_at, wheel_positions
from swerve.vehicle.multibody.model import N_MULTIBODY, SPIN, multibody
from swerve.vehicle.multibody.numbers import Numbers
from swerve.world import MOST_PATCHES, Friction

Array = NDArray[np.float64]

N_RUNNING = N_MULTIBODY + N_ACTUATORS
N_OUTPUTS = 19  # of a step: steering; ax, ay; then of each wheel load, slip angle, Fx, Fy
AFTER = N_RUNNING + N_WHEELS  # of a sample: the state at its end, and the loads there
COLUMNS = tuple(slice(*ends) for ends in pairwise((0, 6, 7, 9, 13, 17, 21, 25)))  # of a step: vehicle state, outputs
DELAY_TOLERANCE = 1e-6  # of a delay over a step that stands for a whole number [1]


class MultibodyPlant(Plant):
    """The plant for one vehicle, road and pair of clocks.

    `PlantState.inner` holds the rest of the model's state, the actuators, and the commands that are on their way.
    """

    def __init__(
        self,
        vehicle: Vehicle,
        chassis: Chassis,
        actuators: Actuators,
        friction: Friction,
        step: float,
        n_substeps: int,
    ) -> None:
        """Compile, or take from the cache, the kernel of one controller sample: `n_substeps` of `step` [s].

        Raises:
            ValueError: the chassis does not fit the vehicle, or the delay is no whole number of steps.
        """
        self._numbers = Numbers.of(vehicle, chassis)
        self._n_substeps, self._n_delayed = n_substeps, _whole(actuators.delay, step)
        n_patches = MOST_PATCHES if friction.patches else 0
        limits = Limits.of(actuators, vehicle, step)
        parts = (self._numbers.as_array(), limits.as_array(), _as_vector(friction, n_patches), [step])
        self._held = np.concatenate(parts)
        self._advance = Kernel(_sample(n_substeps, n_patches))

    def start(self, vehicle: Array) -> PlantState:
        """In the vehicle state (6,): level, wheels straight and rolling, no force, nothing on its way."""
        p = self._numbers
        x = np.zeros(N_RUNNING)
        x[:N_STATES] = vehicle
        vx, _, r = vehicle[:3]
        x[SPIN] = (vx - r * p.lt * np.array([1, -1, 1, -1])) / p.R
        inner = np.append(x[N_STATES:], np.zeros(N_INPUTS * self._n_delayed))
        return PlantState(x[:N_STATES], np.array([p.Ff, p.Ff, p.Fr, p.Fr]), inner)

    def advance(self, state: PlantState, command: Command) -> tuple[PlantState, Trace]:
        """One controller sample with the command held."""
        n = self._n_substeps
        given = np.full((n, N_INPUTS), command.as_input()).ravel()
        x = np.concatenate((state.vehicle, state.inner, given))  # what waits is in inner, and arrives before `given`
        arrived = N_RUNNING + n * N_INPUTS
        (done,) = self._advance(x[:arrived], self._held)
        after, rows = done[:AFTER], done[AFTER:].reshape(n, N_STATES + N_OUTPUTS)
        end, loads_after = after[:N_RUNNING], after[N_RUNNING:]
        states, steering, acceleration, loads, slips, longitudinal, lateral = (rows[:, part] for part in COLUMNS)
        trace = Trace(states, steering[:, 0], acceleration, loads, slips, longitudinal, lateral)
        return PlantState(end[:N_STATES], loads_after, np.concatenate((end[N_STATES:], x[arrived:]))), trace


def _whole(delay: float, step: float) -> int:
    """The delay in steps."""
    n = round(delay / step)
    if abs(delay / step - n) > DELAY_TOLERANCE:
        raise ValueError(f"delay must be a whole number of plant steps of {step:g} s, got {delay:g} s")
    return n


def _as_vector(friction: Friction, n_patches: int) -> Array:
    """Base and patches; a place without a patch repeats one."""
    patches = [*friction.patches, *friction.patches[-1:] * (n_patches - len(friction.patches))]
    return np.array([friction.base, *(number for patch in patches for number in (*patch.x, *patch.y, patch.friction))])


@cache
def _sample(n_substeps: int, n_patches: int) -> ca.Function:
    """A sample: ([state, command of each step], [p, limits, road, h]) -> one vector, which costs one copy.

    It holds the state and the loads at the end, and a row [vehicle state, outputs] for the start of each step.
    """
    step, loads = _step(n_patches)
    parts = [step.size1_in(i) for i in range(2, step.n_in())]
    moving, held = ca.MX.sym("moving", N_RUNNING + n_substeps * N_INPUTS), ca.MX.sym("held", sum(parts))
    start, u = moving[:N_RUNNING], ca.reshape(moving[N_RUNNING:], N_INPUTS, n_substeps)
    fixed = ca.vertsplit(held, np.cumsum([0, *parts]).tolist())
    ends, outputs = step.mapaccum("multibody", n_substeps).call(
        [start, u, *(ca.repmat(each, 1, n_substeps) for each in fixed)]
    )
    states = ca.horzcat(start, ends[:, :-1])[:N_STATES, :]
    end = ends[:, -1]
    done = ca.vertcat(end, loads(end, *fixed), ca.vec(ca.vertcat(states, outputs)))
    return ca.Function("multibody", [moving, held], [done])


def _step(n_patches: int) -> tuple[ca.Function, ca.Function]:
    """One step, and the loads of a state.

    (state, u, p, limits, road, h) -> state after h; [steering, ax, ay, loads, slip angles, Fx, Fy] at its start.
    """
    state, u, h = ca.SX.sym("state", N_RUNNING), ca.SX.sym("u", N_INPUTS), ca.SX.sym("h")
    p, limits, road = Numbers.symbolic(), Limits.symbolic(), ca.SX.sym("road", 1 + PATCH * n_patches)
    x, before = state[:N_MULTIBODY], state[N_MULTIBODY:]
    after = actuate(before, u, x[SPIN], limits)
    mu = friction_at(*wheel_positions(x, p.lf, p.lr, p.lt), road[0], ca.reshape(road[1:], PATCH, n_patches))
    now = multibody(x, before[0], before[1:5], before[5:], mu, p, h)
    then = multibody(x + h * now.derivative, after[0], after[1:5], after[5:], mu, p, h)
    end = ca.vertcat(x + h / 2 * (now.derivative + then.derivative), after)
    outputs = ca.vertcat(before[0], *now.acceleration, *now.loads, *now.slip_angles, *now.longitudinal, *now.lateral)
    held = [ca.vertcat(*p), ca.vertcat(*limits), road, h]
    return (
        ca.Function("step", [state, u, *held], ca.cse([end, outputs])),
        ca.Function("loads", [state, *held], [ca.vertcat(*now.loads)]),
    )
