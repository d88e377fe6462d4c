"""A vehicle as numbers: Table 2 of the paper, completed by the limits that the paper does not print."""

from dataclasses import dataclass, replace
from math import inf

from swerve.vehicle.quantities import check, quantity
from swerve.vehicle.tyre import PASSENGER_215_55_R17, Tyre


@dataclass(frozen=True, kw_only=True)
class Vehicle:
    """Parameters of the two-track model (Fig. 2), its actuators and its body.

    Attributes:
        name: how scenarios call it.
        mass: total mass m [kg].
        yaw_inertia: moment of inertia Izz about z [kg m^2].
        cg_to_front_axle: lf [m].
        cg_to_rear_axle: lr [m].
        half_track: lt [m].
        wheel_radius: effective rolling radius Rt [m].
        cg_height: of the centre of gravity, for load transfer [m]; 0 gives static loads.
        steering_limit: largest road-wheel angle [rad].
        steering_rate_limit: largest rate of it [rad/s]; inf for none.
        force_limit: largest wheel force as a share of mu Fz [1].
        length: of the body [m].
        width: of the body [m].
        cg_to_front_end: from the centre of gravity to the front bumper [m].
        tyre: of all four wheels.

    Raises:
        ValueError: a number is not finite, or has the wrong sign.
    """

    name: str
    mass: float = quantity("mass", "kg")
    yaw_inertia: float = quantity("moment of inertia", "kg m^2")
    cg_to_front_axle: float = quantity("length", "m")
    cg_to_rear_axle: float = quantity("length", "m")
    half_track: float = quantity("length", "m")
    wheel_radius: float = quantity("length", "m")
    cg_height: float = quantity("length", "m", sign="not negative", default=0.0)
    steering_limit: float = quantity("angle", "rad")
    steering_rate_limit: float = quantity("angular speed", "rad/s", default=inf)
    force_limit: float = quantity("dimensionless", "1")
    length: float = quantity("length", "m")
    width: float = quantity("length", "m")
    cg_to_front_end: float = quantity("length", "m")
    tyre: Tyre

    def __post_init__(self) -> None:
        check(self)
        if self.force_limit >= 1:
            raise ValueError(f"force_limit must be below 1, the friction circle, got {self.force_limit:g}")

    @property
    def wheelbase(self) -> float:
        """L = lf + lr [m]."""
        return self.cg_to_front_axle + self.cg_to_rear_axle

    def with_changes(self, changes: dict[str, float]) -> "Vehicle":
        """The same vehicle with some numbers replaced; ValueError as for a new one."""
        return replace(self, **changes)  # type: ignore[arg-type]


D_CLASS_SEDAN = Vehicle(
    name="d-class-sedan",
    mass=1370.0 + 2 * 80.0,  # [kg] Table 2: sprung, and two axles
    yaw_inertia=2315.3,  # [kg m^2] Table 2 (printed with the unit Nm)
    cg_to_front_axle=1.11,  # [m] Table 2
    cg_to_rear_axle=1.67,  # [m] Table 2
    half_track=0.775,  # [m] Table 2
    wheel_radius=0.325,  # [m] Table 2
    steering_limit=0.5,  # [rad] not in the paper: near 29 deg, a usual lock of a passenger car
    force_limit=0.95,  # [1] not in the paper: keeps the wheel from locking
    length=4.85,  # [m] not in the paper: a usual D-class body
    width=1.80,  # [m] not in the paper: track of 1.55 m and tyres of 0.215 m
    cg_to_front_end=2.02,  # [m] not in the paper: lf and a front overhang of 0.91 m
    tyre=PASSENGER_215_55_R17,
)
