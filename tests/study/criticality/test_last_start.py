"""Times to brake, to steer and to react: what they divide, closed forms, symmetry and friction."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.conventions import GRAVITY
from swerve.plant import PlanarPlant
from swerve.signals import Command
from swerve.study.criticality import Scene, measure
from swerve.study.criticality.manoeuvre import SHIFTS, swerve
from swerve.study.criticality.roll_out import roll_out
from swerve.vehicle import vehicle_named
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters
from tests.study.criticality.scenes import FRONT, box, is_hit, later, scene

SEDAN = vehicle_named("d-class-sedan")
STEP = 0.01  # [s] of the plant that brakes
MANY = np.geomspace(SHIFTS[0], SHIFTS[-1], 60)  # [m] shifts
frictions = st.floats(0.25, 1.1)


def value(at: Scene, name: str) -> float:
    """A measure of the only instant."""
    return float(measure(at)[name][0])


@given(st.floats(10, 40), st.floats(0, 8), frictions)
@settings(max_examples=20, deadline=None)
def test_the_two_track_model_brakes_as_a_point_mass_does(speed: float, lead: float, friction: float) -> None:
    """Straight ahead TTB is TTC - (v - w) / (2 a), within 2 ms of the stopping time's second."""
    deceleration = 0.95 * friction * GRAVITY
    ttc = (speed - lead) / (2 * deceleration) + 0.7
    at = scene(box(ttc * (speed - lead) + FRONT + 2, vx=lead), speed=speed, friction=friction)
    assert value(at, "ttb") == pytest.approx(0.7, abs=2e-3 * max(1, speed / deceleration))
    assert value(at, "ttb_point_mass") == pytest.approx(0.7, abs=1e-9)


@pytest.mark.parametrize("lead", [0.0, 8.0, -5.0])
@pytest.mark.parametrize("friction", [0.3, 0.85])
def test_braking_before_the_time_to_brake_avoids_and_after_it_collides(lead: float, friction: float) -> None:
    """In a run of the planar plant that brakes fully from an instant on."""
    at = scene(box(120, vx=lead), friction=friction)
    ttb = value(at, "ttb")
    if lead < 0:
        assert ttb == -np.inf  # it would be hit standing
        return
    before, after = ttb // STEP * STEP, ttb // STEP * STEP + 2 * STEP
    assert not is_hit(at, *_run(friction, before))
    assert is_hit(at, *_run(friction, after))


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(
    "at",
    [
        scene(box(45, 0.3)),
        scene(box(45, 0.3), plant="multibody", lane_width=3.5),
        scene(box(60, vx=8), speed=25.0, friction=0.5),
        scene({"position": (50.0, -0.4), "semi_axes": (3.0, 1.5)}, footprint="point"),
        scene(box(45, -8, vy=3), box(70, 3.5)),
    ],
)
def test_a_swerve_at_the_time_to_steer_is_the_last_that_avoids(at: Scene, side: int) -> None:
    """Driven from 3 ms before it one of many swerves touches nothing, and from 30 ms after it every one fails."""
    tts = value(at, "tts_left" if side > 0 else "tts_right")
    assert 0 < tts < np.inf
    assert any(_ends_well(later(at, tts - 3e-3), side, shift) for shift in MANY)
    assert not any(_ends_well(later(at, tts + 30e-3), side, shift) for shift in MANY)


@given(st.floats(-1.2, 1.2), st.floats(-0.1, 0.1), st.floats(-0.3, 0.3), frictions)
@settings(max_examples=20, deadline=None)
def test_left_and_right_are_mirrors(y: float, vy: float, yaw_rate: float, friction: float) -> None:
    """The mirrored scene has the mirrored times."""
    one, other = (
        _moving(scene(box(60, sign * y), friction=friction, lane_width=3.5), sign * vy, sign * yaw_rate)
        for sign in (1, -1)
    )
    here, there = measure(one), measure(other)
    for name, mirrored in (("tts_left", "tts_right"), ("tts_right", "tts_left"), ("ttb", "ttb"), ("stn", "stn")):
        assert here[name][0] == pytest.approx(there[mirrored][0], abs=1e-6)


@given(st.floats(30, 120), st.floats(-1.0, 1.0), frictions, frictions)
@settings(max_examples=20, deadline=None)
def test_more_friction_leaves_more_time(x: float, y: float, one: float, other: float) -> None:
    """No time to a manoeuvre falls, and no threat number grows, within the model's 10 ms."""
    less, more = (measure(scene(box(x, y), friction=mu)) for mu in sorted((one, other)))
    for name in ("ttb", "tts_left", "tts_right", "ttr", "ttb_point_mass", "tts_left_point_mass"):
        assert more[name][0] >= less[name][0] - 0.01
    assert more["btn"][0] <= less["btn"][0] and more["stn"][0] <= less["stn"][0]
    assert more["impact_speed"][0] <= less["impact_speed"][0] + 0.05


def test_steering_takes_longer_than_a_point_mass_does() -> None:
    """Its centre of gravity: the two-track model has to turn first, and begins up to 0.2 s earlier."""
    values = measure(scene(box(60), footprint="point"))
    assert 0 < values["tts_left_point_mass"][0] - values["tts_left"][0] < 0.2


def test_a_narrow_road_leaves_no_swerve() -> None:
    """Where the lane beside is blocked too, or there is none, it is too late for that side."""
    wall = {"position": (60.0, 3.5), "size": (30.0, 3.4)}
    values = measure(scene(box(60), wall, lane_width=3.5))
    assert values["tts_left"][0] == -np.inf
    assert values["tts_right"][0] > 0
    assert values["ttr"][0] == max(values["ttb"][0], values["tts_right"][0])


def _run(friction: float, begin: float) -> tuple[np.ndarray, np.ndarray]:
    """Times and poses of the planar plant that rolls until `begin`, a multiple of STEP [s], and then brakes fully."""
    plant = PlanarPlant(SEDAN, friction, STEP / 5, 5)
    state, poses = plant.start(np.array([20.0, 0, 0, 0, 0, 0])), []
    brakes = -0.95 * friction * np.array(wheel_loads(Parameters.of(SEDAN, friction)))
    for k in range(2000):
        command = Command(0.0, brakes if k * STEP >= begin - 1e-9 else np.zeros(4))
        state, trace = plant.advance(state, command)
        poses.append(trace.states[:, [4, 5, 3]])
    return STEP / 5 * np.arange(10000.0), np.concatenate(poses)


def _ends_well(at: Scene, side: int, shift: float) -> bool:
    """Whether a swerve touches no obstacle and leaves no road, by the functions that decide on a run."""
    path = roll_out(at, swerve(at, side, shift))
    poses = path.poses[0]
    return not is_hit(at, path.elapsed[0], poses) and bool(at.road.is_inside(at.footprint, poses).all())


def _moving(at: Scene, vy: float, yaw_rate: float) -> Scene:
    """With a lateral speed and a yaw rate."""
    states = at.states.copy()
    states[:, 1:3] = vy, yaw_rate
    return replace(at, states=states)
