"""The panels with which Foxglove opens a run's MCAP file: the scene in 3D from behind the vehicle, and plots over time.

The form is that of a layout which Foxglove has exported: a tree of panels, and the configuration of each by its name.
"""

import json
from pathlib import Path
from typing import Any, Final

from swerve.conventions import WHEELS
from swerve.simulate import Run

Json = dict[str, Any]

VIEW: Final = "3D!scene"
LOG: Final = "RosOut!verdict"  # by its first name Foxglove still knows the panel Log
PLOTS: Final = {  # title: the paths of its curves
    "speed [m/s]": ("/motion.vx", "/motion.vy"),
    "steering angle [rad]": ("/steps.delta", "/motion.delta"),
    "yaw rate [rad/s]": ("/motion.r",),
    "longitudinal tyre forces [N]": tuple(f"/motion.Fx_{wheel}" for wheel in WHEELS),
    "lateral tyre forces [N]": tuple(f"/motion.Fy_{wheel}" for wheel in WHEELS),
}
CAMERA: Final = {
    "distance": 30.0,  # [m]
    "phi": 62.0,  # from straight above [deg]
    "thetaOffset": 90.0,  # behind, where 0 is to the right of the scene [deg]
    "perspective": True,
    "target": [0.0, 0.0, 0.0],
    "targetOffset": [8.0, 0.0, 0.0],  # ahead of the vehicle [m]
    "targetOrientation": [0.0, 0.0, 0.0, 1.0],
    "fovy": 45.0,  # [deg]
    "near": 0.5,  # [m]
    "far": 5000.0,  # [m]
}


def write_layout(run: Run, path: Path) -> None:
    """Write the layout to a .json file; OSError as the file system says."""
    path.write_text(json.dumps(_layout(), indent=2) + "\n", encoding="utf-8", newline="\n")


def _layout() -> Json:
    plots = {f"Plot!{i}": _plot(title, paths) for i, (title, paths) in enumerate(PLOTS.items())}
    return {
        "configById": {VIEW: _view(), **plots, LOG: {"topicToRender": "/log", "minLogLevel": 1}},
        "globalVariables": {},
        "userNodes": {},
        "playbackConfig": {"speed": 1.0},
        "layout": {
            "direction": "row",
            "first": _column([VIEW, LOG], 80.0),
            "second": _column(list(plots)),
            "splitPercentage": 60.0,
        },
    }


def _column(panels: list[str], share: float | None = None) -> Json | str:
    """Panels one below the other; the first has `share` of the height [%], by default as much as each."""
    if len(panels) == 1:
        return panels[0]
    percentage = 100.0 / len(panels) if share is None else share
    return {"direction": "column", "first": panels[0], "second": _column(panels[1:]), "splitPercentage": percentage}


def _view() -> Json:
    ground = {
        "visible": True,
        "frameLocked": True,
        "label": "Ground, 10 m",
        "instanceId": "ground",
        "layerId": "foxglove.Grid",
        "frameId": "world",
        "size": 400,  # [m]
        "divisions": 40,
        "lineWidth": 1,
        "color": "#80808040",
        "position": [0, 0, 0],
        "rotation": [0, 0, 0],
        "order": 1,
    }
    return {
        "cameraState": CAMERA,
        "followMode": "follow-position",
        "followTf": "ego",
        "scene": {"transforms": {"axisScale": 0, "showLabel": False}},
        "transforms": {},
        "topics": {"/scene": {"visible": True}},
        "layers": {"ground": ground},
    }


def _plot(title: str, paths: tuple[str, ...]) -> Json:
    curves = [{"value": path, "enabled": True, "timestampMethod": "receiveTime"} for path in paths]
    return {
        "foxglovePanelTitle": title,
        "paths": curves,
        "showXAxisLabels": True,
        "showYAxisLabels": True,
        "showLegend": True,
        "legendDisplay": "floating",
        "showPlotValuesInLegend": True,
        "isSynced": True,
        "xAxisVal": "timestamp",
        "sidebarDimension": 240,
    }
