"""Small pictures of runs."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from swerve.report.picture import SIZE, picture
from swerve.studio.thumbnail import STYLE
from tests.report.exports.folders import diverged
from tests.report.runs import MOST_SHOWN, ONCOMING, made

EVIL = '"</svg><script>"'


@pytest.mark.parametrize("overrides", [(), MOST_SHOWN, ONCOMING, ("obstacles=[]",), (f"name={EVIL}",)])
def test_a_picture_shows_the_run(overrides: tuple[str, ...]) -> None:
    """It is XML without a word of the scenario in it, and its path is the driven one, in metres, Y upwards."""
    run = made(*overrides)
    root = ElementTree.fromstring(picture([run], STYLE))
    path = _points(root, "path-1")
    driven = run.log.motion.stack("X", "Y") * (1, -1)
    assert all(np.hypot(*(driven - point).T).min() < 0.01 for point in path)
    x, _, width, height = map(float, str(root.get("viewBox")).split())
    assert (width, height) == SIZE
    assert (path[:, 0] >= x - 0.01).all()
    assert "script" not in {each.tag.split("}")[-1] for each in root.iter()}


def test_an_obstacle_is_where_the_vehicle_met_it() -> None:
    """The outline of the paper's obstacle at rest is its circle."""
    points = _points(ElementTree.fromstring(picture([made("duration=2 s")], STYLE)), "obstacle")
    np.testing.assert_allclose(np.hypot(*(points - (25, 0)).T), 2.0, atol=0.02)


def test_a_run_that_diverged_has_a_picture() -> None:
    """What is no motion is not in it."""
    assert np.isfinite(_points(ElementTree.fromstring(picture([diverged()], STYLE)), "path-1")).all()


def _points(root: ElementTree.Element, name: str) -> np.ndarray:
    (path,) = [each for each in root.iter() if each.get("class") == name]
    return np.array([[float(x) for x in each.split()] for each in re.findall(r"[-\d.]+ [-\d.]+", str(path.get("d")))])
