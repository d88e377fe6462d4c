"""A run as MCAP, for Foxglove and whatever else reads it: the scene in 3D, every row of the log, and the verdict.

    /tf      foxglove.FrameTransforms   where the vehicle and the obstacles are, at each step of the plant
    /scene   foxglove.SceneUpdate       what is drawn in their frames, once
    /motion  swerve.motion              rows of the log, in SI, by the columns' names, without what is not finite
    /steps   swerve.steps               likewise
    /log     foxglove.Log               the verdict, at the end

Times are those of the run, from zero. Result and scenario are attached: the run can be made again from the file.
"""

import json
from pathlib import Path
from typing import Any, Final

import numpy as np
from mcap.writer import Writer

from swerve import __version__
from swerve.report.exports.foxglove import NANO, scene, transforms, verdict
from swerve.report.exports.foxglove_schema import SCHEMAS, row_schema
from swerve.report.terminal import result_json
from swerve.simulate import Run, Table
from swerve.simulate.outcome import ABSURD

TOPICS: Final = {
    "/tf": "foxglove.FrameTransforms",
    "/scene": "foxglove.SceneUpdate",
    "/motion": "swerve.motion",
    "/steps": "swerve.steps",
    "/log": "foxglove.Log",
}


def write_mcap(run: Run, path: Path) -> None:
    """Write a run to an .mcap file; OSError as the file system says."""
    with path.open("wb") as stream:
        writer = Writer(stream)
        writer.start(profile="", library=f"swerve {__version__}")
        channels = _channels(writer, run)
        for topic, time, message in _messages(run):
            data, at = json.dumps(message, allow_nan=False).encode(), round(time * NANO)
            writer.add_message(channels[topic], log_time=at, publish_time=at, data=data)
        for name, kind, text in (
            ("result.json", "application/json", result_json(run.result)),
            ("scenario.toml", "application/toml", run.scenario.to_toml()),
        ):
            writer.add_attachment(create_time=0, log_time=0, name=name, media_type=kind, data=text.encode())
        writer.finish()  # type: ignore[no-untyped-call]


def _channels(writer: Writer, run: Run) -> dict[str, int]:
    """A channel for each topic, with its schema; their numbers."""
    rows = {"swerve.motion": row_schema(run.log.motion), "swerve.steps": row_schema(run.log.steps)}
    schemas = {**SCHEMAS, **rows}
    return {
        topic: writer.register_channel(
            topic=topic,
            message_encoding="json",
            schema_id=writer.register_schema(name, "jsonschema", json.dumps({"title": name, **schemas[name]}).encode()),
        )
        for topic, name in TOPICS.items()
    }


def _messages(run: Run) -> list[tuple[str, float, dict[str, Any]]]:
    """Topic, time [s] and content of each message, in the order of time."""
    motion = run.log.motion
    messages = [*_transforms(run), *_rows("/motion", motion), *_rows("/steps", run.log.steps)]
    path = motion.stack("X", "Y")
    messages.append(("/scene", 0.0, scene(run.scenario, path[(np.abs(path) < ABSURD).all(axis=1)])))
    messages.append(("/log", float(motion["time"][-1]), verdict(run)))
    return sorted(messages, key=lambda message: message[1])


def _transforms(run: Run) -> list[tuple[str, float, dict[str, Any]]]:
    motion = run.log.motion
    rows = motion.stack("time", "X", "Y", "psi")
    rows = rows[(np.abs(rows) < ABSURD).all(axis=1)]  # a run that diverged ends in others
    obstacles = [obstacle.to_world() for obstacle in run.scenario.obstacles]
    tracks = [np.column_stack([each.position_at(rows[:, 0]), each.heading_at(rows[:, 0])]) for each in obstacles]
    messages = []
    for i, (time, x, y, psi) in enumerate(rows.tolist()):
        seen = [(f"obstacle_{k}", *track[i].tolist()) for k, track in enumerate(tracks)]
        messages.append(("/tf", time, transforms(time, [("ego", x, y, psi), *seen])))
    return messages


def _rows(topic: str, table: Table) -> list[tuple[str, float, dict[str, Any]]]:
    """A message for each row."""
    columns = [values.tolist() for values in table.columns.values()]
    times = table["time"].tolist()
    return [
        (topic, time, {name: value for name, value in zip(table.columns, row, strict=True) if _is_json(value)})
        for time, row in zip(times, zip(*columns, strict=True), strict=True)
    ]


def _is_json(value: object) -> bool:
    return not isinstance(value, float) or bool(np.isfinite(value))
