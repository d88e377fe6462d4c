"""The two lines that a point mass draws through the map, against an obstacle at rest in its line:

    d_brake = v^2 / (2 mu g)            it stops, with all of the friction against the motion
    d_swerve = v sqrt(2 w / (mu g))     it goes aside by w, with all of the friction across the motion

v is the speed at which the obstacle is neared. Braking ends bumper to bumper: to come to the distance between centres,
`Map.extent` is added to d_brake. Swerving ends abreast of the obstacle's centre, where it is widest: there w is
`Map.half_width`, less what the obstacle lies aside. Where d_brake + extent = d_swerve the better decision turns.
"""

from math import sqrt

from swerve.conventions import GRAVITY


def braking_distance(speed: float, friction: float) -> float:
    """v^2 / (2 mu g) [m] of a speed [m/s] on a friction [1]."""
    return speed**2 / (2 * friction * GRAVITY)


def swerving_distance(speed: float, friction: float, width: float) -> float:
    """v sqrt(2 w / (mu g)) [m] of a speed [m/s] on a friction [1], for a width w [m]; 0 where none is needed."""
    return speed * sqrt(2 * max(width, 0.0) / (friction * GRAVITY))


def turning_speed(friction: float, width: float, extent: float = 0.0) -> float | None:
    """The speed [m/s] above which swerving needs less distance than braking does; None where it always does.

    The larger root of v^2 / (2 a) - v sqrt(2 w / a) + extent = 0 with a = mu g, which is
    sqrt(2 a) (sqrt(w) + sqrt(w - extent)).
    """
    if extent > width:
        return None
    return sqrt(2 * friction * GRAVITY) * (sqrt(width) + sqrt(width - extent))
