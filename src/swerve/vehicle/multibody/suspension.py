"""Springs, dampers, anti-roll bars, and the tyre's vertical spring.

At a wheel that is q up from its place at rest,  S = S0 + k q + c q' + b (q - q of the wheel across the axle),
with S0 the share of the weight that it carries, so that a vehicle at rest stays so. The tyre carries

    Fz = max(0, Fz0 - kz dz - cz dz')        dz: height of the wheel's centre over its place at rest

and nothing once the wheel has left the road.
"""

from typing import Any

import casadi as ca

from swerve.conventions import GRAVITY
from swerve.vehicle.multibody.numbers import Numbers

OPPOSITE = (1, 0, 3, 2)  # the wheel across the axle


def suspension_forces(travel: Any, speed: Any, p: Numbers) -> list[Any]:
    """S of the four wheels [N], for travel q (4,) [m] and its rate (4,) [m/s]."""
    static = (p.Ff - p.muf * GRAVITY, p.Fr - p.mur * GRAVITY)
    rates = ((p.kf, p.cf, p.bf), (p.kr, p.cr, p.br))
    forces = []
    for i, across in enumerate(OPPOSITE):
        spring, damper, bar = rates[i // 2]
        roll = travel[i] - travel[across]
        forces.append(static[i // 2] + spring * travel[i] + damper * speed[i] + bar * roll)
    return forces


def tyre_load(static: Any, rise: Any, rise_rate: Any, p: Numbers) -> Any:
    """Fz [N] of a wheel whose centre is `rise` [m] over its place at rest, where it is `static`."""
    return ca.fmax(static - p.kz * rise - p.cz * rise_rate, 0.0)
