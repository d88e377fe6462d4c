"""The baseline of an assistant: the driver alone."""

from swerve.control.driver.controller import DriverController
from swerve.control.driver.wheel_forces import DriverActuation

__all__ = ["DriverActuation", "DriverController"]
