"""What a vehicle has besides the two-track model's numbers: bodies, springs and tyres, as frozen parameters.

A `Chassis` completes a `Vehicle`: mass, yaw inertia, axles, track and wheel radius stay the vehicle's own, so a
scenario that changes the mass changes it here too. Axle values are (front, rear); rates are those at the wheel.
"""

from dataclasses import dataclass, field
from math import isfinite

from swerve.vehicle.quantities import check, quantity

Pair = tuple[float, float]


@dataclass(frozen=True, kw_only=True)
class TyreDynamics:
    """What the tyre of the paper lacks: the longitudinal curve, transient slip, the vertical spring, resistance.

    Attributes:
        longitudinal_stiffness: factor Bx of the Magic Formula over longitudinal slip [1].
        longitudinal_shape: factor Cx of it [1]; the peak factor is that of the lateral curve.
        longitudinal_relaxation: relaxation length of the longitudinal slip [m].
        lateral_relaxation: relaxation length of the lateral slip [m].
        vertical_stiffness: of the tyre [N/m].
        vertical_damping: of the tyre [N s/m].
        rolling_resistance: torque over load and rolling radius [1].

    Raises:
        ValueError: a number is not finite, or has the wrong sign.
    """

    longitudinal_stiffness: float = quantity("dimensionless", "1")
    longitudinal_shape: float = quantity("dimensionless", "1")
    longitudinal_relaxation: float = quantity("length", "m")
    lateral_relaxation: float = quantity("length", "m")
    vertical_stiffness: float = quantity("stiffness", "N/m")
    vertical_damping: float = quantity("damping", "N s/m", sign="not negative")
    rolling_resistance: float = quantity("dimensionless", "1", sign="not negative")

    def __post_init__(self) -> None:
        check(self)


@dataclass(frozen=True, kw_only=True)
class Chassis:
    """The bodies of a vehicle and what joins them.

    Attributes:
        unsprung_mass: of one wheel of the axle, (front, rear) [kg].
        cg_height: of the whole vehicle's centre of gravity at rest; used where the vehicle's own is 0 [m].
        roll_inertia: of the sprung body about its own centre of gravity [kg m^2].
        pitch_inertia: of the sprung body about its own centre of gravity [kg m^2].
        spring_rate: at a wheel, (front, rear) [N/m].
        damping_rate: at a wheel, the same in bump and rebound, (front, rear) [N s/m].
        anti_roll_stiffness: moment of the bar over the axle's roll angle, (front, rear) [N m/rad].
        roll_centre_height: at rest, above the road, (front, rear) [m].
        wheel_inertia: of one wheel with all that turns with it, about its axle [kg m^2].
        drag_area: drag coefficient times frontal area [m^2].
        tyre: what the vehicle's tyre lacks.

    Raises:
        ValueError: a number is not finite, or has the wrong sign.
    """

    unsprung_mass: Pair = field(metadata={"unit": "kg"})
    cg_height: float = quantity("length", "m")
    roll_inertia: float = quantity("moment of inertia", "kg m^2")
    pitch_inertia: float = quantity("moment of inertia", "kg m^2")
    spring_rate: Pair = field(metadata={"unit": "N/m"})
    damping_rate: Pair = field(metadata={"unit": "N s/m"})
    anti_roll_stiffness: Pair = field(metadata={"unit": "N m/rad"})
    roll_centre_height: Pair = field(metadata={"unit": "m"})
    wheel_inertia: float = quantity("moment of inertia", "kg m^2")
    drag_area: float = quantity("area", "m^2", sign="not negative")
    tyre: TyreDynamics

    def __post_init__(self) -> None:
        check(self)
        for name, needs_more in (("unsprung_mass", True), ("spring_rate", True), ("damping_rate", False)):
            _check_pair(name, getattr(self, name), above_zero=needs_more)
        for name in ("anti_roll_stiffness", "roll_centre_height"):
            _check_pair(name, getattr(self, name), above_zero=False)


def _check_pair(name: str, pair: Pair, *, above_zero: bool) -> None:
    for axle, value in zip(("front", "rear"), pair, strict=True):
        if not isfinite(value) or value < 0 or (above_zero and value == 0):
            bound = "positive and finite" if above_zero else "finite and not negative"
            raise ValueError(f"{name} must be {bound}, got {value:g} at the {axle}")
