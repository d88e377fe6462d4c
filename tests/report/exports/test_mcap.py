"""MCAP files, read back by the mcap library, and the layout that shows them."""

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mcap.reader import make_reader

from swerve.report.exports.layout import write_layout
from swerve.report.exports.mcap_file import write_mcap
from swerve.scenario import parse
from swerve.simulate import Outcome, Run
from tests.report.exports.folders import diverged
from tests.report.runs import FAILING, MOST_SHOWN, ONCOMING, made

Json = dict[str, Any]

RUNS = {
    "fine": lambda: made(controller="unified"),
    "lanes, boxes, one moving": lambda: made(*MOST_SHOWN, controller="unified"),
    "programs without a solution": lambda: made(FAILING),
    "no obstacle": lambda: made("obstacles=[]"),
    "diverged": diverged,
}


class Recording:
    """An MCAP file, read."""

    def __init__(self, run: Run, folder: Path) -> None:
        write_mcap(run, folder / "run.mcap")
        with (folder / "run.mcap").open("rb") as stream:
            reader = make_reader(stream, validate_crcs=True)
            summary = reader.get_summary()
            assert summary is not None
            self.schemas: dict[str, Json] = {}
            self.names: dict[str, str] = {}
            for channel in summary.channels.values():
                schema = summary.schemas[channel.schema_id]
                assert (channel.message_encoding, schema.encoding) == ("json", "jsonschema")
                self.schemas[channel.topic], self.names[channel.topic] = json.loads(schema.data), schema.name
            self.messages: dict[str, list[tuple[int, Json]]] = {topic: [] for topic in self.schemas}
            for _, channel, message in reader.iter_messages():
                self.messages[channel.topic].append((message.log_time, json.loads(message.data)))
            self.attachments = {each.name: each.data for each in reader.iter_attachments()}

    def column(self, topic: str, name: str) -> list[Any]:
        """The values of a topic by name; nan where there is none."""
        return [message.get(name, np.nan) for _, message in self.messages[topic]]


@pytest.mark.parametrize("topic", ["motion", "steps"])
@pytest.mark.parametrize("name", RUNS)
def test_the_log_comes_back_from_mcap(tmp_path: Path, name: str, topic: str) -> None:
    """Each row is a message at its time, with every number bit by bit, and the schema has the units."""
    done = RUNS[name]()
    read, table = Recording(done, tmp_path), getattr(done.log, topic)
    times = [time for time, _ in read.messages[f"/{topic}"]]
    np.testing.assert_allclose(np.array(times) * 1e-9, table["time"], rtol=0, atol=0.5e-9)
    properties = read.schemas[f"/{topic}"]["properties"]
    assert list(properties) == list(table.columns)
    for column, unit in table.units.items():
        values = table[column]
        finite = values if values.dtype.kind == "U" else np.where(np.isfinite(values), values, np.nan)
        np.testing.assert_array_equal(read.column(f"/{topic}", column), finite)
        assert properties[column].get("description") == (f"[{unit}]" if unit else None)


def _unknown(value: Any, schema: Json, path: str = "") -> Iterator[str]:
    """Where a message does not have the form that a schema says."""
    kinds = {"object": dict, "array": list, "string": str, "boolean": bool, "integer": int, "number": (int, float)}
    if not isinstance(value, kinds[schema["type"]]):
        yield path
    elif isinstance(value, dict):
        for key, each in value.items():
            known = schema["properties"].get(key)
            yield from [f"{path}.{key}"] if known is None else _unknown(each, known, f"{path}.{key}")
    elif isinstance(value, list):
        for each in value:
            yield from _unknown(each, schema["items"], f"{path}[]")


@pytest.mark.parametrize("name", RUNS)
def test_messages_are_as_their_schemas_say(tmp_path: Path, name: str) -> None:
    """No message has a field that its schema does not know, or one of another type; the schemas are Foxglove's."""
    read = Recording(RUNS[name](), tmp_path)
    for topic, messages in read.messages.items():
        assert messages
        for _, message in messages:
            assert list(_unknown(message, read.schemas[topic])) == []
    named = {topic: name for topic, name in read.names.items() if name.startswith("foxglove.")}
    assert named == {"/tf": "foxglove.FrameTransforms", "/scene": "foxglove.SceneUpdate", "/log": "foxglove.Log"}


def _yaw(rotation: Json) -> float:
    """The angle of a rotation about Z, as the X axis is turned by its quaternion."""
    x, y, z, w = (rotation[key] for key in "xyzw")
    return float(np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))


def test_bodies_move_as_in_the_run(tmp_path: Path) -> None:
    """The vehicle's frame is at each row's pose, and obstacles go on as they began."""
    done = made(*MOST_SHOWN, controller="unified")
    motion = done.log.motion
    messages = Recording(done, tmp_path).messages["/tf"]
    assert len(messages) == len(motion["time"])
    for (time, message), row in zip(messages, motion.stack("time", "X", "Y", "psi"), strict=True):
        ego, resting, oncoming = message["transforms"]
        assert [each["child_frame_id"] for each in (ego, resting, oncoming)] == ["ego", "obstacle_0", "obstacle_1"]
        assert {each["parent_frame_id"] for each in (ego, resting, oncoming)} == {"world"}
        assert ego["timestamp"]["sec"] * 10**9 + ego["timestamp"]["nsec"] == time
        assert (ego["translation"]["x"], ego["translation"]["y"]) == (row[1], row[2])
        assert _yaw(ego["rotation"]) == pytest.approx(row[3], abs=1e-12)
        assert (resting["translation"]["x"], resting["translation"]["y"]) == (20.0, 0.2)
        assert _yaw(resting["rotation"]) == pytest.approx(np.radians(6), abs=1e-12)
        assert (oncoming["translation"]["x"], oncoming["translation"]["y"]) == pytest.approx((45 - 5 * row[0], 3.5))


def test_obstacles_turn_as_they_go(tmp_path: Path) -> None:
    """An obstacle along way-points, one that brakes and one that waits are at each time where and as they are."""
    done = made(*ONCOMING)
    obstacles = [each.to_world() for each in done.scenario.obstacles]
    for time, message in Recording(done, tmp_path).messages["/tf"][::100]:
        for obstacle, frame in zip(obstacles, message["transforms"][1:], strict=True):
            place = [frame["translation"][axis] for axis in "xy"]
            assert place == pytest.approx(obstacle.position_at(time * 1e-9), abs=1e-9)
            expected = obstacle.heading_at(time * 1e-9)
            assert np.cos(_yaw(frame["rotation"]) - expected) == pytest.approx(1.0)


def test_the_line_between_directions_is_solid(tmp_path: Path) -> None:
    """Edges and the line before oncoming lanes are lines, what is between other lanes is dashed."""
    done = made("road.lane_width=3.5", "road.lanes_left=2", "road.lanes_oncoming=1", "obstacles=[]")
    ((_, update),) = Recording(done, tmp_path).messages["/scene"]
    lines = {each["id"]: each["lines"] for each in update["entities"]}["road"]
    kinds = {(line["type"], line["points"][0]["y"]) for line in lines}
    assert kinds == {(0, -1.75), (0, 8.75), (0, 5.25), (2, 1.75)}


def test_the_scene_has_all_bodies_in_their_sizes(tmp_path: Path) -> None:
    """Boxes and cylinders are as large as the scenario says, in their own frames; road and path lie in the world."""
    done = made(*MOST_SHOWN, controller="unified")
    ((time, update),) = Recording(done, tmp_path).messages["/scene"]
    entities = {each["id"]: each for each in update["entities"]}
    assert time == 0
    assert {name: each["frame_id"] for name, each in entities.items()} == {
        "ego": "ego",
        "obstacle_0": "obstacle_0",
        "obstacle_1": "obstacle_1",
        "path": "world",
        "road": "world",
    }
    vehicle = done.scenario.ego.to_vehicle()
    (body,) = entities["ego"]["cubes"]
    assert (body["size"]["x"], body["size"]["y"]) == (vehicle.length, vehicle.width)
    assert body["pose"]["position"]["x"] + vehicle.length / 2 == pytest.approx(vehicle.cg_to_front_end)
    (box,) = entities["obstacle_1"]["cubes"]
    assert (box["size"]["x"], box["size"]["y"]) == pytest.approx((4.5, 1.8))
    (path,) = entities["path"]["lines"]
    assert [[point["x"], point["y"]] for point in path["points"]] == done.log.motion.stack("X", "Y").tolist()
    across = sorted({point["y"] for line in entities["road"]["lines"] for point in line["points"]})
    assert across == pytest.approx([-5.25, -1.75, 1.75, 5.25])
    assert [line["type"] for line in entities["road"]["lines"]] == [0, 0, 2, 2]


def test_an_ellipse_is_a_cylinder(tmp_path: Path) -> None:
    """It has the axes of the ellipse, and a road without edges has no lines."""
    ((_, update),) = Recording(made("obstacles.0.semi_axes=[3, 1]"), tmp_path).messages["/scene"]
    entities = {each["id"]: each for each in update["entities"]}
    (cylinder,) = entities["obstacle_0"]["cylinders"]
    assert (cylinder["size"]["x"], cylinder["size"]["y"]) == pytest.approx((6.0, 2.0))
    assert "road" not in entities


@pytest.mark.parametrize(("outcome", "level"), [(Outcome.AVOIDED, 2), (Outcome.COLLIDED, 3)])
def test_the_verdict_is_said_at_the_end(tmp_path: Path, outcome: Outcome, level: int) -> None:
    """It is information where nothing was touched, and a warning at any other outcome."""
    done = made(controller="unified")
    ((time, message),) = Recording(replace(done, result=replace(done.result, outcome=outcome)), tmp_path).messages[
        "/log"
    ]
    assert (time, message["level"]) == (10**9, level)
    assert message["message"] == f"{outcome.value}: {outcome.sentence}"


def test_the_run_can_be_made_again_from_the_file(tmp_path: Path) -> None:
    """The scenario and the result are attached; the same run gives the same file."""
    done = made(*MOST_SHOWN, controller="unified")
    attached = Recording(done, tmp_path).attachments
    assert parse(attached["scenario.toml"], "scenario.toml") == done.scenario
    assert json.loads(attached["result.json"]) == done.result.to_json()
    first = (tmp_path / "run.mcap").read_bytes()
    write_mcap(done, tmp_path / "run.mcap")
    assert (tmp_path / "run.mcap").read_bytes() == first


def _panels(tree: str | Json) -> list[str]:
    return [tree] if isinstance(tree, str) else _panels(tree["first"]) + _panels(tree["second"])


def test_the_layout_shows_what_is_in_the_file(tmp_path: Path) -> None:
    """Every panel is configured and placed once; every curve, topic and frame in it is in the file."""
    done = made(controller="unified")
    write_layout(done, tmp_path / "layout.json")
    layout = json.loads((tmp_path / "layout.json").read_text())
    read = Recording(done, tmp_path)
    assert sorted(_panels(layout["layout"])) == sorted(layout["configById"])
    view, *others = layout["configById"].values()
    curves = [path["value"] for panel in others for path in panel.get("paths", [])]
    assert len(curves) > 10
    for curve in curves:
        topic, _, column = curve.partition(".")
        assert column in read.schemas[topic]["properties"]
    assert set(view["topics"]) <= set(read.schemas)
    frames = {each["child_frame_id"] for _, message in read.messages["/tf"] for each in message["transforms"]}
    assert view["followTf"] in frames
