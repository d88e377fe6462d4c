"""What is commanded when this step has no plan of its own.

First the last plan, as many samples further on as have passed; when there is none, or it has been used up, full braking
within the friction limit with the wheels straight.
"""

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Fallback, Plan
from swerve.control.unified.memory import Memory, shifted
from swerve.conventions import FORCES

Array = NDArray[np.float64]


def fallback_plan(time: float, reason: Fallback, memory: Memory, largest: Array, n_samples: int) -> Plan:
    """The plan to follow instead.

    Args:
        time: of this step [s].
        reason: why it is needed.
        memory: of the last step.
        largest: (5,) largest magnitudes of the inputs [rad, N, N, N, N].
        n_samples: Np.
    """
    samples = memory.age + 1
    if memory.plan is not None and samples < n_samples:
        states = memory.plan.states[samples:]
        last = memory.plan
        return Plan(time, shifted(last.inputs, samples), states, last.side, last.name, last.is_shaped, fallback=reason)
    braking = np.zeros((n_samples, largest.size))
    braking[:, FORCES] = -largest[FORCES]
    return Plan(time, braking, np.empty((0, 6)), name="full braking", fallback=reason)
