"""The controller `driver`: passes on what the driver asks for. Where nobody sits at the wheel it coasts.

What a scene comes to without help, and what help is measured against.
"""

import numpy as np

from swerve.control.actuation import Actuation
from swerve.control.driver.wheel_forces import DriverActuation
from swerve.control.plan import Fallback, Plan
from swerve.control.protocol import Controller
from swerve.conventions import N_STATES
from swerve.signals import Command, Measurement
from swerve.vehicle import Vehicle


class DriverController(Controller[Command]):
    """No controller: its memory is the last command, which is held while the measurement is not finite."""

    def __init__(self, vehicle: Vehicle, friction: float, actuation: Actuation) -> None:
        """For one vehicle on a road of `friction` [1], with the inputs that there are."""
        self._actuation = DriverActuation(vehicle, friction, actuation)

    def start(self) -> Command:
        """No force; wheels straight, or as they are stuck."""
        return Command.from_input(self._actuation.actuation.fixed)

    def step(self, measurement: Measurement, memory: Command) -> tuple[Command, Plan, Command]:
        """The driver's input."""
        is_known = measurement.is_finite
        command = Command.from_input(self._actuation.inputs(measurement)) if is_known else memory
        fallback = None if is_known else Fallback.NOT_FINITE
        inputs, states = command.as_input()[np.newaxis], np.empty((0, N_STATES))
        plan = Plan(measurement.time, inputs, states, reason="the driver's input", fallback=fallback)
        return command, plan, command
