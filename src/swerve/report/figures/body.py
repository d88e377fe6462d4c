"""The outline of the vehicle, its wheels turned, for drawing."""

import numpy as np
from numpy.typing import NDArray

from swerve.vehicle import Vehicle
from swerve.world import Rectangle, place

Array = NDArray[np.float64]

TYRE_WIDTH = 0.215  # as it is drawn [m]


def bodies(vehicle: Vehicle, poses: Array) -> Array:
    """The body's rectangle at each pose, (n, 4, 2) [m]."""
    centre = (vehicle.cg_to_front_end - vehicle.length / 2, 0.0)
    return place(Rectangle(vehicle.length, vehicle.width, centre).outline(), poses)


def wheels(vehicle: Vehicle, poses: Array, steering: Array) -> Array:
    """The four wheels at each pose, the front ones turned by `steering` (n,) [rad]: (4 n, 4, 2) [m]."""
    outline = Rectangle(2 * vehicle.wheel_radius, TYRE_WIDTH).outline()
    placed = []
    for x, angle in ((vehicle.cg_to_front_axle, steering), (-vehicle.cg_to_rear_axle, np.zeros_like(steering))):
        for y in (vehicle.half_track, -vehicle.half_track):
            hub = place(np.array([[x, y]]), poses)[:, 0]
            placed.append(place(outline, np.column_stack([hub, poses[:, 2] + angle])))
    return np.concatenate(placed)
