"""The hierarchical baseline: decide, draw a path, track it."""

from swerve.control.hierarchical.controller import HierarchicalController
from swerve.control.hierarchical.settings import HierarchicalSettings

__all__ = ["HierarchicalController", "HierarchicalSettings"]
