"""Post-encroachment time: closed forms of a crossing, and where it makes no sense."""

from dataclasses import replace

import numpy as np
import pytest

from swerve.study.criticality import Scene
from swerve.study.criticality.post_encroachment import post_encroachment_time
from tests.study.criticality.scenes import FRONT, REAR, WIDTH, box, scenario


def drive(*obstacles: dict[str, object], speed: float = 10.0, duration: float = 10.0) -> Scene:
    """The instants of driving straight on."""
    times = np.arange(0, duration, 0.01)
    states = np.zeros((len(times), 6))
    states[:, 0], states[:, 4] = speed, speed * times
    return Scene.of_motion(scenario(*obstacles, speed=speed), "planar", times, states, np.zeros(len(times)))


@pytest.mark.parametrize("start", [-40.0, -20.0])
def test_at_a_crossing_it_is_the_time_between(start: float) -> None:
    """From when the one's outline leaves the common place until the other's reaches it, either being first."""
    found = post_encroachment_time(drive(box(50, start, vy=5)))
    mine = np.array([50 - 2 - FRONT, 50 + 2 + REAR]) / 10
    its = np.array([-start - 0.9 - WIDTH / 2, -start + 0.9 + WIDTH / 2]) / 5
    exact = its[0] - mine[1] if start < -30 else mine[0] - its[1]
    assert exact > 0
    assert found == pytest.approx(exact, abs=0.011)


def test_a_collision_is_zero() -> None:
    """Both are there at once."""
    assert post_encroachment_time(drive(box(50, -25, vy=5))) == 0


@pytest.mark.parametrize("obstacle", [box(50), box(50, 10, vx=5), box(50, -300, vy=5)])
def test_without_a_crossing_there_is_none(obstacle: dict[str, object]) -> None:
    """A resting obstacle never leaves; one in the lane beside, or too far away, is never where the vehicle was."""
    scene = drive(obstacle)
    assert post_encroachment_time(scene) == np.inf
    assert post_encroachment_time(replace(scene, obstacles=())) == np.inf
