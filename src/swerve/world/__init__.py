"""Obstacles, roads, footprints and the distances between them: plain geometry and motion, in SI units."""

from swerve.world.clearance import clearance, distance_ratio
from swerve.world.friction import MOST_PATCHES, Friction, Patch
from swerve.world.motions import Accelerating, AlongWaypoints, Motion, Steady, Waiting
from swerve.world.obstacle import Obstacle
from swerve.world.placing import place
from swerve.world.road import Road
from swerve.world.shapes import Ellipse, Footprint, Point, Rectangle, Shape

__all__ = [
    "MOST_PATCHES",
    "Accelerating",
    "AlongWaypoints",
    "Ellipse",
    "Footprint",
    "Friction",
    "Motion",
    "Obstacle",
    "Patch",
    "Point",
    "Rectangle",
    "Road",
    "Shape",
    "Steady",
    "Waiting",
    "clearance",
    "distance_ratio",
    "place",
]
