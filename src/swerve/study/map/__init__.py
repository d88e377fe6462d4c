"""What each controller avoids and what the limit allows, over speed, friction, offset and distance."""

from swerve.study.map.boundary import Boundary, Condition, Map, RunRecord
from swerve.study.map.engine import EngineLostError, engine
from swerve.study.map.make import cells_of, is_complete, map_of, run_missing
from swerve.study.map.settings import MapSettings
from swerve.study.map.store import Store

__all__ = [
    "Boundary",
    "Condition",
    "EngineLostError",
    "Map",
    "MapSettings",
    "RunRecord",
    "Store",
    "cells_of",
    "engine",
    "is_complete",
    "map_of",
    "run_missing",
]
