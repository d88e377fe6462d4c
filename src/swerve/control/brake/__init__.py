"""The emergency brake: brakes in its lane, and nothing else."""

from swerve.control.brake.controller import BrakeController
from swerve.control.brake.settings import BrakeSettings

__all__ = ["BrakeController", "BrakeSettings"]
