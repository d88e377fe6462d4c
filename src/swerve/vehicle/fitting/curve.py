"""The least-squares fit of eq. (3) to the points of one load.

    F = Fz [M(alpha + SH) + SV],   M(alpha) = D sin(C atan(B alpha - E (B alpha - atan B alpha)))

with mu = 1 for the surface of the data, each point at its own load, and E free or 0. The shifts SH and SV, of a tyre
that is not the same to both sides, are fitted beside B, C, D and E where there are points on both sides of zero slip,
and are 0 where there are not. They stay out of the reduced tyre, which is symmetric.
"""

from dataclasses import dataclass
from math import degrees, pi
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import least_squares

from swerve.errors import InputError
from swerve.vehicle.fitting.data import LoadBlock

Array = NDArray[np.float64]
Number = float | Array

#           B [1/rad]    C: from a force that levels off to one that falls to nothing    D    E    SH [rad]    SV
LOWER: Final = np.array([0.1, 1.0, 0.01, -20.0, -0.1, -0.5])
UPPER: Final = np.array([500.0, 2.0, 5.0, 1.0, 0.1, 0.5])
FIRST_SHAPES: Final = (1.2, 1.6)  # C to start from [1]; the better fit of the two is taken
LINEAR: Final = 0.5  # of the largest force: points up to it tell the slope to start from [1]
FEWEST_SHARE: Final = 0.8  # of the peak that the points must reach, or C and D are anybody's guess [1]
WORST_MISFIT: Final = 0.2  # root mean square over the peak of what may pass for a tyre [1]
CONVERGED: Final = 1e-14  # tolerance on cost, step and gradient [1]


@dataclass(frozen=True)
class Curve:
    """Eq. (3) fitted to one load.

    Attributes:
        load: mean of the points' [N].
        n_points: that were fitted.
        B: stiffness factor [1/rad].
        C: shape factor [1].
        D: peak factor, peak force over load [1].
        E: curvature factor [1].
        horizontal_shift: SH [rad]; None where it was not fitted.
        vertical_shift: SV, force over load [1]; None where it was not fitted.
        rms_error: root mean square of what is left over [N].
    """

    load: float
    n_points: int
    B: float
    C: float
    D: float
    E: float
    horizontal_shift: float | None
    vertical_shift: float | None
    rms_error: float


def magic_formula(slip_angle: ArrayLike, B: Number, C: Number, D: Number, E: Number = 0.0) -> Array:
    """M(alpha) of eq. (3) [1] at slip angles [rad]."""
    x = np.multiply(B, slip_angle)
    share: Array = D * np.sin(C * np.arctan(x - E * (x - np.arctan(x))))
    return share


def fit_curve(block: LoadBlock, file: str, *, curvature: bool) -> Curve:
    """The curve of least squares through the points of one load.

    Args:
        block: the points.
        file: what messages call their file.
        curvature: whether E is free; it is 0 otherwise.

    Raises:
        InputError: the points do not tell the curve, or are not on one.
    """
    is_free = np.array([True, True, True, curvature, block.is_two_sided, block.is_two_sided])
    share = block.forces / block.loads

    def parameters(free: Array) -> Array:
        values = np.zeros(len(is_free))
        values[is_free] = free
        return values

    def residuals(free: Array) -> Array:
        B, C, D, E, horizontal, vertical = parameters(free)
        rest: Array = magic_formula(block.slip_angles + horizontal, B, C, D, E) + vertical - share
        return rest * block.loads / block.load

    fits = [
        least_squares(
            residuals,
            _start(block.slip_angles, share, shape)[is_free],
            jac="3-point",
            bounds=(LOWER[is_free], UPPER[is_free]),
            x_scale=np.array([10.0, 1.0, 1.0, 1.0, 0.01, 0.01])[is_free],
            ftol=CONVERGED,
            xtol=CONVERGED,
            gtol=CONVERGED,
        )
        for shape in FIRST_SHAPES
    ]
    best = min(fits, key=lambda fit: float(fit.cost))
    B, C, D, E, horizontal, vertical = map(float, parameters(best.x))
    curve = Curve(
        load=block.load,
        n_points=len(block.forces),
        B=B,
        C=C,
        D=D,
        E=E,
        horizontal_shift=horizontal if block.is_two_sided else None,
        vertical_shift=vertical if block.is_two_sided else None,
        rms_error=float(np.sqrt(np.mean(best.fun**2))) * block.load,
    )
    _check(curve, block, f"{file}: {block.place}")
    return curve


def _start(slip_angles: Array, share: Array, shape: float) -> Array:
    """B, C, D, E, SH, SV to start from."""
    peak = float(np.abs(share).max())
    near = np.abs(share) <= LINEAR * peak
    if not (slip_angles[near] @ share[near] > 0):
        near[:] = True
    slope = float(slip_angles[near] @ share[near] / (slip_angles[near] @ slip_angles[near]))
    start = np.array([slope / (shape * peak), shape, peak, 0.0, 0.0, 0.0])
    inside: Array = np.clip(start, LOWER + 1e-3, UPPER - 1e-3)
    return inside


def _check(curve: Curve, block: LoadBlock, place: str) -> None:
    if curve.rms_error > WORST_MISFIT * curve.D * curve.load:
        fault = f"the best curve leaves {curve.rms_error:.4g} N (root mean square) at load {curve.load:.6g} N"
        raise InputError(f"{place}: {fault}, over {WORST_MISFIT:.0%} of its peak; mend the columns or their units")
    widest = float(np.abs(block.slip_angles).max())
    x = curve.B * widest
    angle = curve.C * np.arctan(x - curve.E * (x - np.arctan(x)))  # pi/2 at the peak
    reached = float(np.sin(min(angle, pi / 2)))
    if reached < FEWEST_SHARE:
        fault = f"slip angles reach {degrees(widest):.3g} deg, {reached:.0%} of the peak at load {curve.load:.6g} N"
        raise InputError(f"{place}: {fault}; add larger ones, to {FEWEST_SHARE:.0%} of the peak at least")
