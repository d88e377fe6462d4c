"""The times to brake and to steer of a point mass, in closed form: a cross check of the two-track model's.

    TTB = TTC - (v - w) / (2 a)                 straight behind an obstacle: at d = (v - w) TTC, 2 a d = (v - w)^2
    TTS = min over s of s - sqrt(2 y(s) / a)    a constant lateral acceleration a, there at once, that has shifted it
                                                by y(s) at every s; beside a rectangle TTC - sqrt(2 y / a)

Hillenbrand et al. (2006). The first holds while the obstacle is left behind at w >= 0 or stands.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


def time_to_brake(ttc: ArrayLike, closing_speed: ArrayLike, deceleration: ArrayLike) -> Array:
    """TTB [s] of times to collision [s], closing speeds [m/s] and decelerations [m/s^2]; -inf where it is too late."""
    return _or_too_late(np.asarray(ttc) - np.asarray(closing_speed) / (2 * np.asarray(deceleration)))


def time_to_steer(s: ArrayLike, shift: ArrayLike, lateral_acceleration: ArrayLike) -> Array:
    """TTS (n,) [s] of shifts [m] needed at times s [s], both (n, m), and accelerations (n,) [m/s^2]; -inf as above."""
    shift, lateral_acceleration = np.asarray(shift), np.asarray(lateral_acceleration)[..., np.newaxis]
    latest = np.where(shift > 0, s - np.sqrt(2 * shift / lateral_acceleration), np.inf)
    return _or_too_late(latest.min(axis=-1))


def _or_too_late(times: Array) -> Array:
    return np.where(times >= 0, times, -np.inf)
