"""The reduced tyre of sec. 3 of the paper: Magic Formula with E = 0 inside a friction ellipse.

    (3)  Fy0 = mu Fz M(alpha),  M(alpha) = D sin(C atan(B alpha)),   B, C, D linear in Fz
    (4)  Fy  = M(alpha) sqrt((mu Fz)^2 - Fx^2)

The same functions take numbers and CasADi symbols.
"""

from dataclasses import dataclass
from math import pi
from typing import Any

import casadi as ca

# The share of (mu Fz)^2 that the root of (4) keeps at the edge of the circle, so that derivatives stay finite.
ROOT_FLOOR = 1e-6  # [1]
LIFTED = 1e-14  # [N^2] that it keeps of a wheel without load, for the same reason


@dataclass(frozen=True)
class Tyre:
    """Line fits of the Magic Formula's parameters over the load: B = b0 + b1 Fz, and so C and D.

    Attributes:
        b0: stiffness factor at no load [1/rad].
        b1: its slope [1/(rad N)].
        c0: shape factor at no load [1].
        c1: its slope [1/N].
        d0: peak factor at no load [1].
        d1: its slope [1/N].
    """

    b0: float
    b1: float
    c0: float
    c1: float
    d0: float
    d1: float

    def peak_slip(self, load: Any) -> Any:
        """Slip angle of the largest lateral force: C atan(B alpha) = pi/2 [rad]."""
        stiffness, shape, _ = factors(self, load)
        return ca.tan(pi / (2 * shape)) / stiffness


# 215/55 R17, sec. 3: lines through Table 1.
PASSENGER_215_55_R17 = Tyre(
    b0=13.0409,  # [1/rad]
    b1=-1.4758e-4,  # [1/(rad N)]
    c0=1.4465,  # [1]
    c1=7.4666e-7,  # [1/N]
    d0=1.0161,  # [1]
    d1=-9.0695e-6,  # [1/N]
)


def factors(tyre: Any, load: Any) -> tuple[Any, Any, Any]:
    """B [1/rad], C [1] and D [1] at vertical load `load` [N]."""
    return tyre.b0 + tyre.b1 * load, tyre.c0 + tyre.c1 * load, tyre.d0 + tyre.d1 * load


def magic_formula(tyre: Any, slip_angle: Any, load: Any) -> Any:
    """M(alpha) of eq. (3), with E = 0 [1]; positive slip angle [rad] gives positive force."""
    stiffness, shape, peak = factors(tyre, load)
    return peak * ca.sin(shape * ca.atan(stiffness * slip_angle))


def longitudinal_force(demand: Any, friction: Any, load: Any) -> Any:
    """The demand [N], no more than the friction circle gives."""
    limit = friction * load
    return ca.fmax(-limit, ca.fmin(limit, demand))


def lateral_force(tyre: Any, slip_angle: Any, longitudinal: Any, friction: Any, load: Any) -> Any:
    """Fy of eq. (4) [N] at slip angle [rad] and longitudinal force [N], |longitudinal| <= friction * load."""
    circle = (friction * load) ** 2
    root = ca.sqrt(ca.fmax(circle - longitudinal**2, ROOT_FLOOR * circle + LIFTED))
    return magic_formula(tyre, slip_angle, load) * root
