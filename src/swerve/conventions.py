"""Names, order and units of the vectors that every part of swerve shares.

Axes are ISO 8855: x forward, y left, z up; yaw and steering are positive to the left. Everything is in SI and radians.

    state xi = [vx vy r psi X Y]                       (eq. 1 of the paper)
    input u  = [delta Fx_fl Fx_fr Fx_rl Fx_rr]
    wheels   = front left, front right, rear left, rear right
"""

from typing import Final

GRAVITY: Final = 9.81  # [m/s^2]

WHEELS: Final = ("fl", "fr", "rl", "rr")

STATES: Final = ("vx", "vy", "r", "psi", "X", "Y")
STATE_UNITS: Final = ("m/s", "m/s", "rad/s", "rad", "m", "m")
VX, VY, R, PSI, X, Y = range(6)

INPUTS: Final = ("delta", "Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr")
INPUT_UNITS: Final = ("rad", "N", "N", "N", "N")
POSE: Final = [X, Y, PSI]
DELTA: Final = 0
FORCES: Final = slice(1, 5)

N_STATES: Final = len(STATES)
N_INPUTS: Final = len(INPUTS)
N_WHEELS: Final = len(WHEELS)
