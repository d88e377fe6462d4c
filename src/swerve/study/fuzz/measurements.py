"""Measurements far outside what a run comes to, all finite: each part is drawn on its own, from several regimes.

The vehicle may slide backwards, spin, stand still or do 70 m/s and more; it may be inside an obstacle, or far off the
road; its loads may be any; and there may be no obstacle or a dozen.
"""

from math import pi
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.signals import Measurement, Observation
from swerve.world import Ellipse, Rectangle, Shape

Array = NDArray[np.float64]
Random = np.random.Generator

MOST_OBSTACLES: Final = 12
LATEST: Final = 0.2  # age of a measurement [s]


def measurement(random: Random, time: float) -> Measurement:
    """One at the controller's `time` [s]; one in twenty is old."""
    state = _state(random)
    n = random.integers(MOST_OBSTACLES, endpoint=True) if random.random() < 0.2 else random.integers(4)
    stamp = time - (random.uniform(0.0, LATEST) if random.random() < 0.05 else 0.0)
    return Measurement(time, stamp, state, _loads(random), tuple(_seen(random, state) for _ in range(n)))


def _state(random: Random) -> Array:
    vx, vy, r = _velocity(random)
    offset = random.choice([0.0, random.normal(0.0, 3.0), random.uniform(-300.0, 300.0)])
    return np.array([vx, vy, r, random.uniform(-4 * pi, 4 * pi), random.normal(0.0, 100.0), offset])


def _velocity(random: Random) -> tuple[float, float, float]:
    """vx, vy [m/s] and r [rad/s]."""
    match random.integers(6):
        case 0:  # as in a run
            return random.uniform(5.0, 40.0), random.normal(0.0, 1.0), random.normal(0.0, 0.3)
        case 1:  # at rest, or nearly
            return random.choice([0.0, random.normal(0.0, 0.1)]), 0.0, 0.0
        case 2:  # backwards
            return random.uniform(-70.0, 0.0), random.normal(0.0, 5.0), random.normal(0.0, 1.0)
        case 3:  # in a spin
            return random.normal(0.0, 15.0), random.normal(0.0, 15.0), random.normal(0.0, 6.0)
        case 4:  # faster than any car
            return random.uniform(70.0, 200.0), random.normal(0.0, 3.0), random.normal(0.0, 0.5)
    return random.normal(0.0, 40.0), random.normal(0.0, 20.0), random.normal(0.0, 3.0)


def _loads(random: Random) -> Array:
    match random.integers(4):
        case 0:  # one or more wheels in the air
            return random.uniform(0.0, 8e3, 4) * (random.random(4) < 0.5)
        case 1:  # such as no tyre carries, or none at all
            return random.choice([-5e3, -1.0, 0.0, 1e-9, 1.0, 3e4, 9e4], 4)
    return random.uniform(1e3, 7e3, 4)


def _seen(random: Random, state: Array) -> Observation:
    """An obstacle around the vehicle, on it, or far away."""
    scale = random.choice([0.0, 1.0, 10.0, 60.0, 1e3])
    position = state[4:] + random.normal(0.0, 1.0, 2) * scale
    velocity = random.normal(0.0, random.choice([0.0, 5.0, 30.0, 300.0]), 2)
    return Observation(_shape(random), tuple(position), tuple(velocity), random.uniform(-2 * pi, 2 * pi))


def _shape(random: Random) -> Shape:
    sizes = 10 ** random.uniform(-2.0, 1.7, 2)
    return Ellipse(tuple(sizes)) if random.random() < 0.5 else Rectangle(*sizes)
