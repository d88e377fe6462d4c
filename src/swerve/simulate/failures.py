"""Failures between controller and plant: what is commanded is not what the actuators are given.

A wheel without torque rolls freely. A steering that is stuck stays at its angle; from the start of the run, when the
wheels are straight, it goes there as fast as the plant's actuator can.
"""

from dataclasses import dataclass, replace

from swerve.signals import Command


@dataclass(frozen=True)
class Failures:
    """What has failed, whether the controller knows it or not.

    Attributes:
        wheels: indices of wheels without torque.
        steering_stuck: angle at which the steering stays, None where it moves [rad].
    """

    wheels: tuple[int, ...] = ()
    steering_stuck: float | None = None

    def acting(self, command: Command) -> Command:
        """What the actuators are given; the command itself where nothing has failed."""
        if self.wheels:
            forces = command.wheel_forces.copy()
            forces[list(self.wheels)] = 0.0
            command = replace(command, wheel_forces=forces)
        return command if self.steering_stuck is None else replace(command, steering_angle=self.steering_stuck)
