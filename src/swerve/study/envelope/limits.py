"""The physical limit: the smallest distance at which any control could still avoid a disc of 2 m in the vehicle's line.

From a free-distance optimal control problem on the two-track model (1), solved offline: a point as footprint,
|delta| <= 0.5 rad without a rate limit, |Fx| <= 0.95 mu Fz, the best of three starts. A better optimum may exist, so a
limit may be too large, never too small.
"""

from typing import Final

RADIUS: Final = 2.0  # of the disc [m]
SPEEDS: Final = (15.0, 20.0, 25.0, 30.0, 35.0)  # [m/s]

# By friction [1], for each speed: from the vehicle to the disc's centre [m]; None where no optimum was found.
LIMITS: Final[dict[float, tuple[float | None, ...]]] = {
    0.3: (19.0, 25.4, 32.0, None, None),
    0.5: (14.9, 19.8, 24.7, 29.9, 34.8),
    0.85: (11.1, 14.8, 18.5, 22.2, 26.7),
    1.0: (10.2, 14.2, 17.1, 20.5, 24.4),
}
