"""How a speed is held: proportional control of the acceleration, a = k (V - vx) within the largest acceleration.

With k = 5 / s drag, rolling resistance and the tyres' own resistance in a turn leave an error of about 0.1 m/s.
"""

from typing import Final

GAIN: Final = 5.0  # k [1/s]
LARGEST: Final = 3.0  # acceleration of a cruise control [m/s^2]


def cruise(vx: float, speed: float, largest: float = LARGEST) -> float:
    """Acceleration [m/s^2] that takes vx to a speed [m/s], with no more than `largest` either way."""
    return float(max(-largest, min(largest, GAIN * (speed - vx))))
