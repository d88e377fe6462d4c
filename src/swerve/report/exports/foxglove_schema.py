"""JSON schemas of the messages in an MCAP file: those of `foxglove`, and rows of the log."""

from typing import Any, Final

from swerve.simulate import Table

Schema = dict[str, Any]


def _object(**properties: Schema) -> Schema:
    return {"type": "object", "properties": properties}


def _list(items: Schema) -> Schema:
    return {"type": "array", "items": items}


NUMBER: Final[Schema] = {"type": "number"}
INTEGER: Final[Schema] = {"type": "integer"}
BOOLEAN: Final[Schema] = {"type": "boolean"}
STRING: Final[Schema] = {"type": "string"}

TIME: Final = {"title": "time", **_object(sec=INTEGER, nsec=INTEGER)}  # by the title Foxglove knows it
DURATION: Final = {"title": "duration", **_object(sec=INTEGER, nsec=INTEGER)}
VECTOR: Final = _object(x=NUMBER, y=NUMBER, z=NUMBER)
QUATERNION: Final = _object(x=NUMBER, y=NUMBER, z=NUMBER, w=NUMBER)
POSE: Final = _object(position=VECTOR, orientation=QUATERNION)
COLOUR: Final = _object(r=NUMBER, g=NUMBER, b=NUMBER, a=NUMBER)

CUBE: Final = _object(pose=POSE, size=VECTOR, color=COLOUR)
CYLINDER: Final = _object(pose=POSE, size=VECTOR, bottom_scale=NUMBER, top_scale=NUMBER, color=COLOUR)
LINE: Final = _object(
    type=INTEGER,
    pose=POSE,
    thickness=NUMBER,
    scale_invariant=BOOLEAN,
    points=_list(VECTOR),
    color=COLOUR,
    colors=_list(COLOUR),
    indices=_list(INTEGER),
)
ENTITY: Final = _object(
    timestamp=TIME,
    frame_id=STRING,
    id=STRING,
    lifetime=DURATION,
    frame_locked=BOOLEAN,
    metadata=_list(_object(key=STRING, value=STRING)),
    cubes=_list(CUBE),
    cylinders=_list(CYLINDER),
    lines=_list(LINE),
)

SCHEMAS: Final = {  # by the name by which Foxglove knows them
    "foxglove.FrameTransforms": _object(
        transforms=_list(
            _object(
                timestamp=TIME,
                parent_frame_id=STRING,
                child_frame_id=STRING,
                translation=VECTOR,
                rotation=QUATERNION,
            )
        )
    ),
    "foxglove.SceneUpdate": _object(
        deletions=_list(_object(timestamp=TIME, type=INTEGER, id=STRING)), entities=_list(ENTITY)
    ),
    "foxglove.Log": _object(timestamp=TIME, level=INTEGER, message=STRING, name=STRING, file=STRING, line=INTEGER),
}


def row_schema(table: Table) -> Schema:
    """The schema of a row of a table: each column with its unit as the description."""
    return _object(**{name: _column(table, name) for name in table.columns})


def _column(table: Table, name: str) -> Schema:
    kind = {"U": STRING, "i": INTEGER}.get(table[name].dtype.kind, NUMBER)
    return {**kind, "description": f"[{table.units[name]}]"} if table.units[name] else kind
