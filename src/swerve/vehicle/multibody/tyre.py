"""The tyre of the full vehicle: Magic Formula with combined slip, behind a relaxation length.

Pure slip (the lateral curve is eq. (3) of the paper, the longitudinal one has its peak):

    Fx0(k) = mu Fz D sin(Cx atan(Bx k)),      Fy0(a) = mu Fz D sin(C atan(B a)),      B, C, D linear in Fz

Combined slip by similarity (Pacejka, Tire and Vehicle Dynamics, 3rd ed., sec. 4.2): both curves are taken at the length
s of the slip vector (kappa, tan alpha), and each force is its own component's share of it:

    Fx = kappa / s Fx0(s),   Fy = tan(alpha) / s Fy0(atan s),   s^2 = kappa^2 + tan(alpha)^2

so pure slip is untouched, no force leaves the friction circle, and that of a locked wheel opposes its sliding.

Transient slip (ibid. ch. 7 and 8.6; Bernard and Clover, SAE 950311): each slip lags by its relaxation length,

    lx kappa' + V kappa = -Vsx,   ly tan(alpha)' + V tan(alpha) = -Vsy,   V = max(|Vx|, |w R|, |Vs| / S_MAX)

which has no singularity: at standstill it is a spring. The lengths fall as the force saturates, because what lags is
the carcass, bent by the force and not by the slip (Higuchi and Pacejka, Vehicle System Dynamics 27, 1997, supplement):

    lx = sigma_x / sqrt(1 + (Bx Cx s)^2),   ly = sigma_y / sqrt(1 + (B C s)^2)

near the curves' secants; without it a car on locked wheels would swing back by sigma when it stops. Below V_LOW a
slip in proportion to the sliding speed, fading with V, is added, which damps the spring; the floor on V bounds the slip
of a wheel that slides sideways.
"""

from typing import Any, NamedTuple

import casadi as ca

from swerve.vehicle.tyre import factors

S_MAX = 3.0  # [1] longest slip vector that lasts
V_LOW = 2.0  # [m/s] below, transient slip is damped
DAMPING = 0.1  # [s/m] slip for a sliding speed, at standstill; near 0.4 of critical for a car on its four tyres
QUICKEST = 2e-3  # [s] no slip settles faster, so that no step of 1 ms is too long
S_FLOOR = 1e-6  # [1] length that a slip vector keeps, so that its direction is a number


class Contact(NamedTuple):
    """What a tyre does at one instant.

    Attributes:
        rates: of kappa and tan alpha [1/s].
        forces: (Fx, Fy) in the wheel's axes [N].
    """

    rates: tuple[Any, Any]
    forces: tuple[Any, Any]


def contact(p: Any, slips: tuple[Any, Any], vx: Any, rolling: Any, vy: Any, friction: Any, load: Any) -> Contact:
    """The tyre on the road; positive slip gives positive force.

    Args:
        p: has the lateral line fits b0 b1 c0 c1 d0 d1, the longitudinal factors Bx, Cx, and sigma_x, sigma_y as sx, sy.
        slips: transient (kappa, tan alpha) [1].
        vx: speed of the wheel's centre along its plane [m/s].
        rolling: w R [m/s].
        vy: speed of the contact across the wheel's plane, Vsy [m/s].
        friction: mu [1].
        load: Fz [N].
    """
    sliding = (vx - rolling, vy)
    floor = (ca.fabs(sliding[0]) + ca.fabs(sliding[1])) / S_MAX
    speed = ca.fmax(ca.fmax(ca.fabs(vx), ca.fabs(rolling)), floor)
    stiffness, shape, peak = factors(p, load)
    slip2 = slips[0] ** 2 + slips[1] ** 2
    lengths = (length / ca.sqrt(1 + k**2 * slip2) for length, k in ((p.sx, p.Bx * p.Cx), (p.sy, stiffness * shape)))
    rates = (
        -(vs + speed * slip) / ca.fmax(length, QUICKEST * speed)
        for vs, slip, length in zip(sliding, slips, lengths, strict=True)
    )
    damping = DAMPING * ca.fmax(1 - speed / V_LOW, 0.0) ** 2
    kappa, tangent = (slip - damping * vs for slip, vs in zip(slips, sliding, strict=True))
    length = ca.sqrt(kappa**2 + tangent**2 + S_FLOOR**2)
    largest = friction * load * peak / length
    fx = largest * ca.sin(p.Cx * ca.atan(p.Bx * length)) * kappa
    fy = largest * ca.sin(shape * ca.atan(stiffness * ca.atan(length))) * tangent
    return Contact(tuple(rates), (fx, fy))
