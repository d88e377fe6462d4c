"""Limits to hold other things against: the smallest distance at which the paper's disc can be avoided, with a torque of
its own on every wheel, from `swerve map paper --controllers unified --plant planar` (docs/envelope.md).
"""

from typing import Final

SPEEDS: Final = (15.0, 20.0, 25.0, 30.0, 35.0)  # [m/s]
BY_FRICTION: Final = {  # [1]: for each speed, from the vehicle to the disc's centre [m]
    0.3: (18.75, 25.02, 31.29, 37.56, 43.83),
    0.5: (14.51, 19.37, 24.22, 29.08, 33.94),
    0.85: (11.08, 14.84, 18.56, 22.29, 26.01),
    1.0: (10.20, 13.67, 17.11, 20.54, 23.98),
}
LIMITS: Final = [
    (speed, friction, limit) for friction, row in BY_FRICTION.items() for speed, limit in zip(SPEEDS, row, strict=True)
]
