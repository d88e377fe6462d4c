"""What a run decided, in one word: none, brake, steer-left, steer-right, or brake with one of these.

Read from the steps in which an obstacle shaped the plan:
    brake   the commanded wheel forces together slow the vehicle by more than BRAKING of mu g for BRAKING_TIME;
    steer   the side of most of those steps that have one, if the commanded steering angle exceeds STEERING in them.
"""

from collections.abc import Sequence

import numpy as np

from swerve.control import Plan, Side
from swerve.signals import Command

BRAKING = 0.2  # [1]
BRAKING_TIME = 0.1  # [s]
STEERING = 0.01  # [rad]


def decision(commands: Sequence[Command], plans: Sequence[Plan], grip: float, sample_time: float) -> str:
    """The word for a run.

    Args:
        commands: of each step.
        plans: of each step.
        grip: mu m g [N].
        sample_time: [s].
    """
    shaped = [(command, plan.side) for command, plan in zip(commands, plans, strict=True) if plan.is_shaped]
    forces = np.array([command.wheel_forces.sum() for command, _ in shaped])
    brakes = np.count_nonzero(forces < -BRAKING * grip) * sample_time >= BRAKING_TIME
    sides = [(command, side) for command, side in shaped if side is not None]
    steers = any(abs(command.steering_angle) > STEERING for command, _ in sides)
    left = sum(side is Side.LEFT for _, side in sides)
    words = ["brake"] * bool(brakes)
    if steers:
        words.append("steer-left" if 2 * left >= len(sides) else "steer-right")
    return "+".join(words) or "none"
