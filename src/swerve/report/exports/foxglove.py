"""The messages that Foxglove shows in 3D, as JSON: frames of the bodies, and what is drawn in each frame.

Names and fields are those of Foxglove's own schemas (FrameTransforms, SceneUpdate, Log), of which `foxglove_schema` has
the fields that are written. Frames are `world`, and in it `ego` and `obstacle_0`, `obstacle_1`, and so on.
"""

from collections.abc import Sequence
from math import cos, sin
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from swerve.scenario import Scenario
from swerve.simulate import Outcome, Run
from swerve.world import Ellipse

Array = NDArray[np.float64]
Json = dict[str, Any]

NANO: Final = 1_000_000_000  # nanoseconds in a second
EGO_HEIGHT: Final = 1.45  # as it is drawn [m]
OBSTACLE_HEIGHT: Final = 1.5  # likewise [m]
LINE: Final = 0.12  # width of the lines on the road [m]
DASH: Final = (
    6.0  # length of a dash between lanes, and of the gap behind it, as German highways have them: 6 and 12 [m]
)
GAP: Final = 12.0  # [m]
BEYOND: Final = 100.0  # of the road that is drawn before and behind what the vehicle covered [m]
BLUE: Final = (0.0, 0.45, 0.70, 0.9)  # red, green, blue, opacity; of Okabe and Ito's palette
ORANGE: Final = (0.84, 0.37, 0.0, 0.9)
WHITE: Final = (0.9, 0.9, 0.9, 1.0)
GREEN: Final = (0.0, 0.62, 0.45, 1.0)
LINE_STRIP: Final = 0  # Foxglove's numbers: of kinds of lines ...
LINE_LIST: Final = 2
INFO, WARNING = 2, 3  # ... and of levels of a log


def stamp(time: float) -> Json:
    """A time [s] in Foxglove's form."""
    seconds, nanoseconds = divmod(round(time * NANO), NANO)
    return {"sec": seconds, "nsec": nanoseconds}


def transforms(time: float, poses: Sequence[tuple[str, float, float, float]]) -> Json:
    """A FrameTransforms message: where frames are in the world, each by name, X [m], Y [m] and heading [rad]."""
    frames = [
        {
            "timestamp": stamp(time),
            "parent_frame_id": "world",
            "child_frame_id": name,
            "translation": _vector(x, y),
            "rotation": {"x": 0.0, "y": 0.0, "z": sin(heading / 2), "w": cos(heading / 2)},
        }
        for name, x, y, heading in poses
    ]
    return {"transforms": frames}


def scene(scenario: Scenario, path: Array) -> Json:
    """A SceneUpdate message with all that is drawn, from the start on; `path` (n, 2) of the centre of gravity [m]."""
    entities = [_entity("ego", "ego", cubes=[_ego(scenario)])]
    entities += [_obstacle(scenario, i) for i in range(len(scenario.obstacles))]
    entities.append(_entity("path", "world", lines=[_line(LINE_STRIP, path, GREEN)]))
    lines = _road_lines(scenario, path)
    return {"deletions": [], "entities": [*entities, _entity("road", "world", lines=lines)] if lines else entities}


def verdict(run: Run) -> Json:
    """A Log message with the outcome in a sentence, at the end of the run."""
    outcome = run.result.outcome
    return {
        "timestamp": stamp(run.log.motion["time"][-1]),
        "level": INFO if outcome is Outcome.AVOIDED else WARNING,
        "message": f"{outcome.value}: {outcome.sentence}",
        "name": "swerve",
        "file": "",
        "line": 0,
    }


def _ego(scenario: Scenario) -> Json:
    vehicle = scenario.ego.to_vehicle()
    centre = _vector(vehicle.cg_to_front_end - vehicle.length / 2, 0.0, EGO_HEIGHT / 2)
    return _solid(centre, _vector(vehicle.length, vehicle.width, EGO_HEIGHT), BLUE)


def _obstacle(scenario: Scenario, i: int) -> Json:
    shape, name = scenario.obstacles[i].to_world().shape, f"obstacle_{i}"
    width, height = np.ptp(shape.outline(), axis=0).tolist()
    solid = _solid(_vector(0.0, 0.0, OBSTACLE_HEIGHT / 2), _vector(width, height, OBSTACLE_HEIGHT), ORANGE)
    if isinstance(shape, Ellipse):
        return _entity(name, name, cylinders=[{**solid, "bottom_scale": 1.0, "top_scale": 1.0}])
    return _entity(name, name, cubes=[solid])


def _road_lines(scenario: Scenario, path: Array) -> list[Json]:
    """Both edges, a line between the directions, and dashes between lanes; none where the road has no edges."""
    road = scenario.road.to_world()
    if road.lane_width is None or road.left_edge is None or road.right_edge is None:
        return []
    solid = [road.left_edge, road.right_edge, *([] if road.oncoming_edge is None else [road.oncoming_edge])]
    start, end = path[:, 0].min() - BEYOND, path[:, 0].max() + BEYOND
    edges = [np.array([[start, y], [end, y]]) for y in solid]
    begins = np.arange(start, end, DASH + GAP)
    ends = np.column_stack([begins, begins + DASH]).ravel()
    between = [road.right_edge + k * road.lane_width for k in range(1, road.lanes_left + road.lanes_right + 1)]
    dashes = [np.column_stack([ends, np.full_like(ends, y)]) for y in between if not np.isclose(y, solid).any()]
    return [_line(LINE_STRIP, each, WHITE) for each in edges] + [_line(LINE_LIST, each, WHITE) for each in dashes]


def _entity(name: str, frame: str, **primitives: list[Json]) -> Json:
    """What is drawn in a frame and moves with it, until the end."""
    forever = {"sec": 0, "nsec": 0}
    return {
        "timestamp": stamp(0.0),
        "frame_id": frame,
        "id": name,
        "lifetime": forever,
        "frame_locked": True,
        "metadata": [],
        **{kind: primitives.get(kind, []) for kind in ("cubes", "cylinders", "lines")},
    }


def _solid(centre: Json, size: Json, colour: tuple[float, ...]) -> Json:
    return {"pose": _pose(centre), "size": size, "color": _colour(colour)}


def _line(kind: int, points: Array, colour: tuple[float, ...]) -> Json:
    """A line on the ground through points (n, 2) [m]."""
    return {
        "type": kind,
        "pose": _pose(_vector(0.0, 0.0)),
        "thickness": LINE,
        "scale_invariant": False,
        "points": [_vector(x, y) for x, y in points.tolist()],
        "color": _colour(colour),
        "colors": [],
        "indices": [],
    }


def _pose(position: Json) -> Json:
    return {"position": position, "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}}


def _vector(x: float, y: float, z: float = 0.0) -> Json:
    return {"x": float(x), "y": float(y), "z": z}


def _colour(rgba: tuple[float, ...]) -> Json:
    return dict(zip("rgba", rgba, strict=True))
