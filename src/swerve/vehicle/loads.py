"""Vertical loads of the four wheels: static, and with quasi-static load transfer.

    front, each: m g lr / (2 L),   rear, each: m g lf / (2 L)
    braking (ax < 0) moves  m ax h / (2 L)  a wheel to the front;
    a left turn (ay > 0) moves  m ay h / (2 lt)  to the right, shared over the axles as the static load is.

The same function takes numbers and CasADi symbols. With h = 0 the loads are the paper's, static.
"""

from typing import Any

from swerve.conventions import GRAVITY


def wheel_loads(parameters: Any, ax: Any = 0.0, ay: Any = 0.0) -> tuple[Any, Any, Any, Any]:
    """Loads FL FR RL RR [N] at accelerations ax, ay [m/s^2] of the centre of gravity; below zero means lift-off.

    Args:
        parameters: `two_track.Parameters` (m [kg], lf, lr, lt, h [m]).
        ax: forward acceleration [m/s^2].
        ay: acceleration to the left [m/s^2].
    """
    p = parameters
    wheelbase = p.lf + p.lr
    front, rear = p.lr / wheelbase, p.lf / wheelbase
    pitch = p.m * ax * p.h / (2 * wheelbase)
    roll = p.m * ay * p.h / (2 * p.lt)
    weight = p.m * GRAVITY / 2
    return (
        front * (weight - roll) - pitch,
        front * (weight + roll) - pitch,
        rear * (weight - roll) + pitch,
        rear * (weight + roll) + pitch,
    )
