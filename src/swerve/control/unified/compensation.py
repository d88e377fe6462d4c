"""Where the vehicle will be when this step's command begins to act.

A measurement is old when it comes, and a command acts later than it is given. Between the two the vehicle follows the
commands that were given before: the one of j steps ago acts from its time plus the actuation delay on, for one sample.
"""

from collections.abc import Sequence
from math import ceil

import numpy as np
from numpy.typing import NDArray

from swerve.control.settings import Latency
from swerve.control.unified.prediction import PredictionModel
from swerve.signals import Measurement

Array = NDArray[np.float64]

INSTANT = 1e-9  # [s] durations below this are rounding
OLDEST = 0.5  # [samples] by which a measurement may be older than it usually is


def n_commands(latency: Latency, sample_time: float) -> int:
    """How many past commands can still matter."""
    return ceil((latency.sensing + latency.effect(speed=0.0)) / sample_time + OLDEST) + 1


def is_late(measurement: Measurement, latency: Latency, sample_time: float) -> bool:
    """Whether a measurement is older than the known delay explains."""
    return measurement.time - measurement.stamp > latency.sensing + OLDEST * sample_time


def state_at_effect(measurement: Measurement, commands: Sequence[Array], delay: float, model: PredictionModel) -> Array:
    """The state (6,) at `measurement.time` plus `delay`.

    Args:
        measurement: at its stamp.
        commands: (5,) each, the last one given first.
        delay: from a command to its effect [s].
        model: of the vehicle.
    """
    sample_time, state = model.horizon.sample_time, measurement.state
    now = measurement.time + delay
    for j in reversed(range(len(commands))):
        begins, ends = now - (j + 1) * sample_time, now - j * sample_time
        duration = ends - max(begins, measurement.stamp)
        if duration > INSTANT:
            state = model.advance(state, commands[j], measurement.wheel_loads, min(duration, sample_time))
    return state
