"""A manoeuvre: the path from above, and what was steered and answered over time."""

from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from swerve import __version__
from swerve.report.figures.body import bodies
from swerve.report.figures.style import ACTING, BLUE, ORANGE, captioned_figure, styled, widen
from swerve.study.manoeuvres import DoubleLaneChange, ManoeuvreRun

KM_H: Final = 3.6  # [km/h] in 1 m/s
EVERY: Final = 0.5  # between two bodies [s]
LEAST_WIDTH: Final = 12.0  # of the path's panel along Y [m]
MOST_BODIES: Final = 40


@styled
def manoeuvre(run: ManoeuvreRun) -> Figure:
    """Path with the car's body and the cones, steering angle, yaw rate, lateral acceleration and speed."""
    car, motion = run.car, run.motion
    where = f"{run.manoeuvre.name}: {car.vehicle.name} on {car.plant}"
    what = f"{run.manoeuvre.speed * KM_H:.4g} km/h, \N{GREEK SMALL LETTER MU} = {run.manoeuvre.friction:g}"
    figure = captioned_figure(f"{where}, {what}, swerve {__version__}.", height=6.4)
    grid = figure.add_gridspec(3, 2, height_ratios=(1.2, 1.0, 1.0))
    _draw_path(figure.add_subplot(grid[0, :]), run)
    speed = motion["vx"] * KM_H
    panels = (
        ("road-wheel angle $\\delta$ [deg]", np.degrees(motion["delta"]), 2.0),
        ("yaw rate $r$ [deg/s]", np.degrees(motion["r"]), 2.0),
        ("lateral acceleration $a_y$ [m/s$^2$]", motion["ay"], 1.0),
        ("longitudinal velocity $v_x$ [km/h]", speed, 2.0),
    )
    for i, (label, values, least) in enumerate(panels):
        axes = figure.add_subplot(grid[1 + i // 2, i % 2])
        axes.plot(motion["time"], values, **ACTING)
        axes.set(xlabel="time [s]", ylabel=label)
        widen(axes, least)
    return figure


def _draw_path(axes: Axes, run: ManoeuvreRun) -> None:
    """The path to one scale, the body every half second or less often, and the cones of a course."""
    motion, vehicle = run.motion, run.car.vehicle
    time, poses = motion["time"], motion.stack("X", "Y", "psi")
    every = max(EVERY, time[-1] / MOST_BODIES)
    rows = np.unique(np.searchsorted(time, np.arange(0.0, time[-1], every)))
    for body in bodies(vehicle, poses[rows]):
        axes.fill(*body.T, facecolor="none", edgecolor=BLUE, linewidth=0.6)
    axes.plot(poses[:, 0], poses[:, 1], **ACTING)
    if isinstance(run.manoeuvre, DoubleLaneChange):
        cones = run.manoeuvre.course(vehicle.width).cones()
        axes.plot(*cones.T, "^", color=ORANGE, markersize=3.0, linestyle="none")
    axes.set(xlabel="$X$ [m]", ylabel="$Y$ [m]", aspect="equal")
    axes.margins(0.02)
    widen(axes, LEAST_WIDTH)
