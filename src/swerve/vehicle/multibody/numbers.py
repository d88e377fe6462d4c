"""The full vehicle as one vector of numbers, which its kernels take: nothing recompiles when one changes."""

from math import inf
from typing import Any, NamedTuple

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import GRAVITY
from swerve.vehicle.multibody.chassis import Chassis
from swerve.vehicle.parameters import Vehicle

AIR_DENSITY = 1.2  # [kg/m^3] at 20 degrees Celsius and sea level


class Numbers(NamedTuple):
    """Letters as in the equations; f is the front, r the rear axle.

    Attributes:
        ms, muf, mur: sprung mass, unsprung mass of a wheel [kg].
        Ixx, Iyy, Izz: of the sprung body about its own centre of gravity [kg m^2].
        xs, zs: that centre of gravity, from the whole vehicle's [m].
        lf, lr, lt, h, R: axles, half track, height of the whole vehicle's centre of gravity, rolling radius [m].
        kf, kr, cf, cr: springs [N/m] and dampers [N s/m] at the wheel.
        bf, br: anti-roll bars: force at a wheel over the difference of travel [N/m].
        ef, er: lean of the guides, roll centre height over half track [1].
        Ff, Fr: static wheel load [N].
        kz, cz: the tyre's vertical spring [N/m] and damper [N s/m].
        Iw: of a wheel about its axle [kg m^2].
        drag: force over speed squared [N s^2/m^2].
        rolling: resistance torque over load and radius [1].
        b0 b1 c0 c1 d0 d1, Bx, Cx: the tyre's curves.
        sx, sy: relaxation lengths [m].
    """

    ms: Any
    muf: Any
    mur: Any
    Ixx: Any
    Iyy: Any
    Izz: Any
    xs: Any
    zs: Any
    lf: Any
    lr: Any
    lt: Any
    h: Any
    R: Any
    kf: Any
    kr: Any
    cf: Any
    cr: Any
    bf: Any
    br: Any
    ef: Any
    er: Any
    Ff: Any
    Fr: Any
    kz: Any
    cz: Any
    Iw: Any
    drag: Any
    rolling: Any
    b0: Any
    b1: Any
    c0: Any
    c1: Any
    d0: Any
    d1: Any
    Bx: Any
    Cx: Any
    sx: Any
    sy: Any

    @classmethod
    def of(cls, vehicle: Vehicle, chassis: Chassis) -> "Numbers":
        """The numbers of a vehicle completed by a chassis.

        Raises:
            ValueError: the wheels alone have more mass, or more yaw inertia, than the whole vehicle.
        """
        v, t, dynamics = vehicle, vehicle.tyre, chassis.tyre
        muf, mur = chassis.unsprung_mass
        lf, lr, lt, radius = v.cg_to_front_axle, v.cg_to_rear_axle, v.half_track, v.wheel_radius
        height = v.cg_height or chassis.cg_height
        ms = _left("mass", v.mass, 2 * (muf + mur))
        xs = -2 * (muf * lf - mur * lr) / ms
        zs = -2 * (muf + mur) * (radius - height) / ms
        far = 2 * muf * (lf**2 + lt**2) + 2 * mur * (lr**2 + lt**2) + ms * xs**2
        weight = v.mass * GRAVITY / (2 * v.wheelbase)
        bf, br = (stiffness / (2 * lt) ** 2 for stiffness in chassis.anti_roll_stiffness)
        ef, er = (roll_centre / lt for roll_centre in chassis.roll_centre_height)
        (kf, kr), (cf, cr) = chassis.spring_rate, chassis.damping_rate
        return cls(
            ms=ms,
            muf=muf,
            mur=mur,
            Ixx=chassis.roll_inertia,
            Iyy=chassis.pitch_inertia,
            Izz=_left("yaw_inertia", v.yaw_inertia, far),
            xs=xs,
            zs=zs,
            lf=lf,
            lr=lr,
            lt=lt,
            h=height,
            R=radius,
            kf=kf,
            kr=kr,
            cf=cf,
            cr=cr,
            bf=bf,
            br=br,
            ef=ef,
            er=er,
            Ff=weight * lr,
            Fr=weight * lf,
            kz=dynamics.vertical_stiffness,
            cz=dynamics.vertical_damping,
            Iw=chassis.wheel_inertia,
            drag=AIR_DENSITY / 2 * chassis.drag_area,
            rolling=dynamics.rolling_resistance,
            b0=t.b0,
            b1=t.b1,
            c0=t.c0,
            c1=t.c1,
            d0=t.d0,
            d1=t.d1,
            Bx=dynamics.longitudinal_stiffness,
            Cx=dynamics.longitudinal_shape,
            sx=dynamics.longitudinal_relaxation,
            sy=dynamics.lateral_relaxation,
        )

    @classmethod
    def symbolic(cls) -> "Numbers":
        """A CasADi symbol for each."""
        return cls(*(ca.SX.sym(name) for name in cls._fields))

    def as_array(self) -> NDArray[np.float64]:
        """The vector that kernels take."""
        return np.array(self, dtype=float)


def _left(name: str, whole: float, wheels: float) -> float:
    """What is the sprung body's own."""
    if not 0 < whole - wheels < inf:
        raise ValueError(f"{name} must be more than {wheels:.4g}, that of the wheels alone, got {whole:g}")
    return whole - wheels
