"""From a command to a motion: the vehicles that are driven, behind one protocol."""

from swerve.plant.multibody import MultibodyPlant
from swerve.plant.planar import PlanarPlant
from swerve.plant.protocol import Plant, PlantState, Trace

__all__ = ["MultibodyPlant", "PlanarPlant", "Plant", "PlantState", "Trace"]
