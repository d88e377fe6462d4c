"""The working controller: decision and control in one optimisation, on the paper's cost and constraints."""

from swerve.control.unified.controller import UnifiedController
from swerve.control.unified.formulation import Formulation
from swerve.control.unified.settings import UnifiedSettings

__all__ = ["Formulation", "UnifiedController", "UnifiedSettings"]
