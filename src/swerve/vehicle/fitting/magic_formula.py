"""The Magic Formula of tyre property files, versions 5.2 and 6.x: lateral force at pure side slip.

    Fy = Dy sin(Cy atan(By ay - Ey (By ay - atan By ay))) + SVy,   ay = alpha + SHy
    Cy = PCY1 LCY,   Dy = mu_y Fz,   By = Ky / (Cy Dy),   Ey <= 1
    dfz = (Fz - Fz0') / Fz0',   Fz0' = LFZO FNOMIN,   dpi = (p - p0) / p0

Sources: H. B. Pacejka, Tire and Vehicle Dynamics, 3rd edition 2012, eq. (4.E19) to (4.E30), for 6.x; for 5.2 the same
with PHY3 in place of the camber stiffness, as in MF-Tyre 5.2 and PAC2002. Left out: turn slip, and tan(alpha) for
alpha and sin(gamma) for the camber gamma, which matter at slip angles far beyond the peak and on motorcycles.

Signs are those of the file, as a rule the W axes of ISO and TYDEX, where Ky < 0: a positive slip angle, to the left,
gives a negative force. Camber is to the same axes.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

DEGRESSION: Final = 10.0  # A_mu of (4.E8): how slowly a low LMUY takes the shifts away [1]


@dataclass(frozen=True, kw_only=True)
class LateralCoefficients:
    """Coefficients of the lateral force, by the names that a property file gives them.

    FNOMIN is the nominal load [N]; P... are coefficients, of angles in radians, L... factors that scale [1].
    """

    FNOMIN: float
    PCY1: float
    PDY1: float
    PKY1: float
    PKY2: float
    PDY2: float = 0.0
    PDY3: float = 0.0
    PEY1: float = 0.0
    PEY2: float = 0.0
    PEY3: float = 0.0
    PEY4: float = 0.0
    PEY5: float = 0.0
    PKY3: float = 0.0
    PKY4: float = 2.0
    PKY5: float = 0.0
    PKY6: float = 0.0
    PKY7: float = 0.0
    PHY1: float = 0.0
    PHY2: float = 0.0
    PHY3: float = 0.0
    PVY1: float = 0.0
    PVY2: float = 0.0
    PVY3: float = 0.0
    PVY4: float = 0.0
    PPY1: float = 0.0
    PPY2: float = 0.0
    PPY3: float = 0.0
    PPY4: float = 0.0
    PPY5: float = 0.0
    LFZO: float = 1.0
    LCY: float = 1.0
    LMUY: float = 1.0
    LEY: float = 1.0
    LKY: float = 1.0
    LHY: float = 1.0
    LVY: float = 1.0
    LKYC: float = 1.0  # 6.x: camber stiffness
    LGAY: float = 1.0  # 5.2: camber


def cornering_stiffness(c: LateralCoefficients, load: ArrayLike, camber: float = 0.0, dpi: float = 0.0) -> Array:
    """Ky of (4.E25) [N/rad] at vertical load [N], camber [rad] and relative change of pressure `dpi` [1]."""
    nominal = c.LFZO * c.FNOMIN
    peak_at = (c.PKY2 + c.PKY5 * camber**2) * (1 + c.PPY2 * dpi)
    curve = np.sin(c.PKY4 * np.arctan(np.asarray(load, dtype=float) / nominal / peak_at))
    return c.PKY1 * nominal * (1 + c.PPY1 * dpi) * (1 - c.PKY3 * abs(camber)) * curve * c.LKY


def lateral_force(
    c: LateralCoefficients,
    load: ArrayLike,
    slip_angle: ArrayLike,
    *,
    version: str,
    camber: float = 0.0,
    dpi: float = 0.0,
) -> Array:
    """Fy of (4.E19) [N], in the signs of the file.

    Args:
        c: the coefficients.
        load: vertical, above 0 [N].
        slip_angle: broadcast with the load [rad].
        version: "5.2" or "6.x", which differ in what camber does.
        camber: inclination angle [rad].
        dpi: relative change of the inflation pressure from the nominal one [1].
    """
    if version == "5.2":
        camber = camber * c.LGAY
    fz = np.asarray(load, dtype=float)
    dfz = fz / (c.LFZO * c.FNOMIN) - 1
    stiffness = cornering_stiffness(c, fz, camber, dpi)
    horizontal, vertical = _shifts(c, fz, dfz, stiffness, version, camber, dpi)
    slip = np.asarray(slip_angle, dtype=float) + horizontal
    friction = (c.PDY1 + c.PDY2 * dfz) * (1 + c.PPY3 * dpi + c.PPY4 * dpi**2) * (1 - c.PDY3 * camber**2) * c.LMUY
    side = (c.PEY3 + c.PEY4 * camber) * np.sign(slip)
    curvature = np.minimum((c.PEY1 + c.PEY2 * dfz) * (1 + c.PEY5 * camber**2 - side) * c.LEY, 1.0)
    shape, peak = c.PCY1 * c.LCY, friction * fz
    x = stiffness / (shape * peak) * slip
    force: Array = peak * np.sin(shape * np.arctan(x - curvature * (x - np.arctan(x)))) + vertical
    return force


def _shifts(
    c: LateralCoefficients, fz: Array, dfz: Array, stiffness: Array, version: str, camber: float, dpi: float
) -> tuple[Array, Array]:
    """SHy [rad] and SVy [N]: (4.E27) and (4.E29)."""
    horizontal, vertical = (c.PHY1 + c.PHY2 * dfz) * c.LHY, fz * (c.PVY1 + c.PVY2 * dfz) * c.LVY
    by_camber = fz * (c.PVY3 + c.PVY4 * dfz) * camber
    if version == "5.2":
        return horizontal + c.PHY3 * camber, (vertical + by_camber) * c.LMUY
    grip = DEGRESSION * c.LMUY / (1 + (DEGRESSION - 1) * c.LMUY)
    by_camber = by_camber * c.LKYC * grip
    camber_stiffness = fz * (c.PKY6 + c.PKY7 * dfz) * (1 + c.PPY5 * dpi) * c.LKYC
    return horizontal + (camber_stiffness * camber - by_camber) / stiffness, vertical * grip + by_camber
