"""The vehicle's states over time, and its path: Fig. 8 of the paper."""

import numpy as np
from matplotlib.figure import Figure

from swerve.report.figures.style import ACTING, GOAL, new_figure, styled, widen
from swerve.simulate import Run

KM_H = 3.6  # [km/h] in 1 m/s


@styled
def states(run: Run) -> Figure:
    """Longitudinal and lateral velocity, yaw rate, and Y over X, with the goals."""
    motion, goal = run.log.motion, run.scenario.goal
    figure = new_figure(run, height=4.6)
    (speed, lateral), (yaw_rate, path) = figure.subplots(2, 2)
    time = motion["time"]
    speed.plot(time, motion["vx"] * KM_H, **ACTING)
    speed.axhline(goal.speed * KM_H, label="goal", **GOAL)
    speed.set_ylabel("longitudinal velocity $v_x$ [km/h]")
    lateral.plot(time, motion["vy"], **ACTING)
    lateral.axhline(0.0, label="goal", **GOAL)
    lateral.set_ylabel("lateral velocity $v_y$ [m/s]")
    yaw_rate.plot(time, np.degrees(motion["r"]), **ACTING)
    yaw_rate.set_ylabel("yaw rate $r$ [deg/s]")
    path.plot(motion["X"], motion["Y"], **ACTING)
    path.axhline(goal.lateral_offset, label="goal", **GOAL)
    path.set_xlabel("$X$ [m]")
    path.set_ylabel("$Y$ [m]")
    for axes in (speed, lateral, path):
        axes.legend(loc="best")
    for axes in (speed, lateral, yaw_rate):
        axes.set_xlabel("time [s]")
    for axes, least in ((speed, 1.0), (lateral, 0.2), (yaw_rate, 2.0), (path, 1.0)):
        widen(axes, least)
    return figure
