"""The linear vehicle's steady turn, in closed form.

    delta = ay (L / vx^2 + K),   K = m / L (lr / Cf - lf / Cr),   C = 2 mu Fz B C D  at the axle's static loads

K is the understeer gradient [rad s^2/m]; ay = vx r.
"""

from swerve.conventions import GRAVITY
from swerve.vehicle import Vehicle
from swerve.vehicle.tyre import factors


def cornering_stiffness(vehicle: Vehicle, friction: float) -> tuple[float, float]:
    """Cf and Cr, of an axle each [N/rad]."""
    v = vehicle
    arms = v.cg_to_rear_axle, v.cg_to_front_axle
    stiffnesses = []
    for arm in arms:
        load = v.mass * GRAVITY * arm / (2 * v.wheelbase)
        b, c, d = factors(v.tyre, load)
        stiffnesses.append(2 * friction * load * b * c * d)
    return stiffnesses[0], stiffnesses[1]


def understeer_gradient(vehicle: Vehicle, friction: float) -> float:
    """K [rad s^2/m] of small turns."""
    front, rear = cornering_stiffness(vehicle, friction)
    return vehicle.mass / vehicle.wheelbase * (vehicle.cg_to_rear_axle / front - vehicle.cg_to_front_axle / rear)


def steering_per_acceleration(vehicle: Vehicle, friction: float, speed: float) -> float:
    """delta / ay of small turns at a speed [m/s]: [rad s^2/m]."""
    return vehicle.wheelbase / speed**2 + understeer_gradient(vehicle, friction)
