"""What is commanded when a step has no plan of its own.

First the last plan, as many samples further on as have passed; when there is none, or it has been used up, full braking
within the friction limit, of the wheels that can, with the wheels straight.
"""

import numpy as np
from numpy.typing import NDArray

from swerve.control.actuation import Actuation
from swerve.control.plan import Fallback, Plan
from swerve.conventions import DELTA, FORCES, N_INPUTS, N_STATES
from swerve.vehicle import Vehicle
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters

Array = NDArray[np.float64]


def shifted(inputs: Array, samples: int = 1) -> Array:
    """A plan's inputs (Np, 5) some samples later: its own from there on, the last one held."""
    return np.asarray(inputs[np.minimum(np.arange(len(inputs)) + samples, len(inputs) - 1)])


def fallback_plan(time: float, reason: Fallback, last: Plan | None, age: int, braking: Array) -> Plan:
    """The plan to follow instead.

    Args:
        time: of this step [s].
        reason: why it is needed.
        last: the last plan that was no fallback, None for none.
        age: samples since that plan [1].
        braking: (Np, 5) what is left when it is used up.
    """
    if last is not None and age < len(braking):
        inputs, states = shifted(last.inputs, age), last.states[age:]
        return Plan(time, inputs, states, last.side, last.name, last.is_shaped, fallback=reason)
    return Plan(time, braking, np.empty((0, N_STATES)), name="full braking", fallback=reason)


def full_braking(vehicle: Vehicle, friction: float, n_samples: int, actuation: Actuation) -> Array:
    """Inputs (Np, 5): each wheel's force limit on a road of `friction` [1] at static loads, wheels straight.

    Of that, what there is: without brakes nothing, and stuck steering as it is stuck.
    """
    largest = np.empty(N_INPUTS)
    largest[DELTA] = vehicle.steering_limit
    largest[FORCES] = vehicle.force_limit * friction * np.array(wheel_loads(Parameters.of(vehicle, friction)))
    braking = actuation.within(np.where(np.arange(N_INPUTS) == DELTA, 0.0, -largest), largest)
    return np.tile(braking, (n_samples, 1))
