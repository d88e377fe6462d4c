"""Every wrong value is refused in one line that names where, which key, which value and the cure."""

import pytest

from swerve.errors import InputError
from swerve.scenario import load

WAYPOINTS = "waypoints=[{time=0, position=[60, 0]}, {time=2, position=[70, 0]}]"

# what --set sets; what follows "--set ...: " in the message
REFUSED = [
    ("road.frictoin=0.4", "road.frictoin: unknown key; did you mean road.friction?"),
    ("ego.mass=1600", "ego.mass: unknown key; did you mean ego.parameters.mass?"),
    ("speed=20", "speed: unknown key; did you mean ego.speed or goal.speed or controller.weights.speed?"),
    ("goal.heading=1", "goal.heading: unknown key; did you mean ego.heading or obstacles.0.heading"),
    ("ego.parameters.mas=5", "ego.parameters.mas: unknown key; did you mean ego.parameters.mass?"),
    ("road.zzz=1", "road.zzz: unknown key; the keys here are friction, lane_width, lanes_left, lanes_right"),
    ("ego.speed=72 kg", "ego.speed: '72 kg' is not a speed; write a number in m/s"),
    ("ego.speed=nan", "ego.speed: nan is not finite; write"),
    ("ego.speed=-inf", "ego.speed: -inf is not finite; write"),
    ("ego.speed=true", "ego.speed: true is not a speed; write"),
    ("ego.speed=-1 km/h", "ego.speed: '-1 km/h' is out of range; write at least 0 m/s and at most 150 m/s"),
    ("ego.speed=151", "ego.speed: 151 is out of range; write"),
    ("goal.speed=1979-05-27", "goal.speed: 1979-05-27 is not a speed; write"),
    ("ego.heading=3 deg/s", "ego.heading: '3 deg/s' is not an angle; write"),
    ("ego.position=[inf, 0]", "ego.position.0: inf is not finite; write"),
    ("ego.position=[0]", 'ego.position: not a list of two values; write one such as ["25 m", "0 m"]'),
    ("ego.position=[0, 0, 0]", "ego.position: not a list of two values; write"),
    ("ego.position=3 m", "ego.position: '3 m' is not a list; write"),
    ("ego.footprint=rectangel", "ego.footprint: unknown footprint 'rectangel'; did you mean rectangle?"),
    ("ego.vehicle=d-class-sedn", "ego.vehicle: unknown vehicle 'd-class-sedn'; did you mean d-class-sedan?"),
    ("ego.vehicle=7", "ego.vehicle: unknown vehicle 7; write one of d-class-sedan"),
    ("ego.parameters.mass=-5 kg", "ego.parameters.mass: must be positive, got -5"),
    ("ego.parameters.mass=5 m", "ego.parameters.mass: '5 m' is not a mass; write"),
    ("ego.parameters.name=x", "ego.parameters.name: unknown key; did you mean name or ego.tyre.name or obst"),
    ("ego=5", "ego: 5 is not a table; write a table [ego]"),
    ("road.friction=-1", "road.friction: -1 is out of range; write more than 0 and at most 2"),
    ("road.friction=0", "road.friction: 0 is out of range; write"),
    ("road.friction=2.1", "road.friction: 2.1 is out of range; write"),
    ("road.lanes_left=2", 'road.lanes_left: means nothing without a width; write lane_width = "3.5 m" too'),
    ("road.lanes_oncoming=1", "road.lanes_oncoming: means nothing without a width; write"),
    (
        "road={friction=0.8, lane_width=3, lanes_oncoming=2}",
        "road.lanes_oncoming: is 2 of 1 lanes on the left; write at most as many as there are",
    ),
    ("road.lane_width=0", "road.lane_width: 0 is out of range; write more than 0 m"),
    ("obstacles.0.semi_axes=[2, 0]", "obstacles.0.semi_axes.1: 0 is out of range; write more than 0 m"),
    ("obstacles.0.size=[4, 2]", "obstacles.0.size: is given beside semi_axes; write one of them"),
    ("obstacles.0={position=[25, 0]}", "obstacles.0.semi_axes: missing; write semi_axes ="),
    ("obstacles.0.zzz=3", "obstacles.0.zzz: unknown key; the keys here are name, position"),
    ("obstacles.0={size=[4, 2]}", 'obstacles.0.position: missing; write one such as position = ["25 m", "0 m"]'),
    (
        "obstacles.0.position=[1, 1]",
        "obstacles.0.position: the obstacle covers the ego vehicle at its start, (0 m, 0 m)",
    ),
    (
        'obstacles=[{name="a van", semi_axes=[2, 2], position=[1, 1]}]',
        "obstacles.0.position: the obstacle 'a van' covers the ego vehicle at its start, (0 m, 0 m)",
    ),
    (
        f"obstacles=[{{size=[4, 2], {WAYPOINTS.replace('60', '1')}}}]",
        "obstacles.0.waypoints: the obstacle covers the ego vehicle at its start, (0 m, 0 m)",
    ),
    ("obstacles.0.final_speed=3", "obstacles.0.final_speed: means nothing without an acceleration; write accel"),
    ("obstacles.0.accelerates_at=3", "obstacles.0.accelerates_at: means nothing without an acceleration; write accel"),
    ('obstacles.0.acceleration=["4 m", 0]', "obstacles.0.acceleration.0: '4 m' is not an acceleration; write"),
    ("obstacles.0.moves_at=1 s", "obstacles.0.moves_at: means nothing without a velocity; write velocity ="),
    (
        "obstacles=[{size=[4, 2], position=[40, 0], velocity=[9, 0], acceleration=[-2, 0], moves_at=1}]",
        "obstacles.0.moves_at: is given beside acceleration; write one of them, or waypoints",
    ),
    (
        "obstacles=[{size=[4, 2], position=[40, 0], velocity=[9, 0], acceleration=[-2, 0], final_speed=10}]",
        "obstacles.0.final_speed: of 10 m/s is never reached from 9 m/s at -2 m/s^2 along its direction; write",
    ),
    *(
        (
            f"obstacles=[{{size=[4, 2], {WAYPOINTS}, {key}={value}}}]",
            f"obstacles.0.{key}: is given beside waypoints, which tell the whole motion; write one of them",
        )
        for key, value in (
            ("position", "[9, 0]"),
            ("velocity", "[9, 0]"),
            ("acceleration", "[1, 0]"),
            ("accelerates_at", "1"),
            ("final_speed", "1"),
            ("moves_at", "1"),
        )
    ),
    (
        "obstacles=[{size=[4, 2], waypoints=[{time=0, position=[60, 0]}]}]",
        "obstacles.0.waypoints: is a single one; write at least two, or position and velocity",
    ),
    (
        f"obstacles=[{{size=[4, 2], {WAYPOINTS.replace('time=2', 'time=0')}}}]",
        "obstacles.0.waypoints.1.time: 0 s is not after the one before it, 0 s; write them in the order",
    ),
    (
        f"obstacles=[{{size=[4, 2], {WAYPOINTS.replace('time', 'tim')}}}]",
        "obstacles.0.waypoints.0.tim: unknown key; did you mean obstacles.0.waypoints.0.time?",
    ),
    (
        "obstacles=[{size=[4, 2], waypoints=[{position=[60, 0]}, {time=1, position=[70, 0]}]}]",
        'obstacles.0.waypoints.0.time: missing; write one such as time = "0 s"',
    ),
    ("duration=0 s", "duration: '0 s' is out of range; write more than 0 s and at most 300 s"),
    ("duration=1e9", "duration: 1000000000.0 is out of range; write"),
    ("controller.prediction_horizon=-3", "controller.prediction_horizon: -3 is no number of samples; write a whole"),
    ("controller.prediction_horizon=2.5", "controller.prediction_horizon: 2.5 is no number of samples; write"),
    ("controller.prediction_horizon=100000", "controller.prediction_horizon: 100000 is no number of samples; write"),
    ("controller.control_horizon=0", "controller.control_horizon: 0 is no number of samples; write a whole number"),
    ("controller.control_horizon=21", "controller.control_horizon: 21 samples is longer than prediction_horizon, 20"),
    ("controller.sample_time=50.5 ms", "controller.sample_time: 0.0505 s is no whole multiple of plant.step, 0.001 s"),
    ("controller.weights.speed=-1", "controller.weights.speed: -1 is out of range; write at least 0"),
    (
        "controller.weights={speed=0, lateral_speed=0, lateral_offset=0}",
        "controller.weights.lateral_offset: all weights on the motion are 0; write at least one above 0",
    ),
    (
        'controller.as_printed.corrections=["drfit"]',
        "controller.as_printed.corrections.0: unknown correction 'drfit'; did you mean drift?",
    ),
    (
        'controller.as_printed.corrections=["drift", "drift"]',
        "controller.as_printed.corrections: names drift twice; write it once",
    ),
    ("controller.as_printed.corrections=drift", "controller.as_printed.corrections: 'drift' is not a list; write"),
    ("plant.step=0", "plant.step: 0 is out of range; write at least 0.0001 s"),
    ("name=5", "name: 5 is not a text; write it between quotes"),
    ("name=", "name: '' is empty; write"),
    ('description="a\\u001b[2J"', "description: 'a\\x1b[2J' is not one line of at most 500 characters"),
]


@pytest.mark.parametrize(("override", "message"), REFUSED, ids=[override for override, _ in REFUSED])
def test_a_wrong_value_is_refused(override: str, message: str) -> None:
    """The message starts with the override at fault, then has the key, the value and the cure, in one line."""
    with pytest.raises(InputError) as caught:
        load("paper", [override])
    text = str(caught.value)
    assert text.startswith("--set ")
    assert message in text
    assert text.isprintable()


@pytest.mark.parametrize(
    ("override", "message"),
    [
        (
            "controller.prediction_horizon=3",
            "controller.control_horizon: 15 samples is longer than prediction_horizon, 3",
        ),
        ("plant.step=3 ms", "controller.sample_time: 0.05 s is no whole multiple of plant.step, 0.003 s"),
        ("ego.position=[24, 0]", "obstacles.0.position: the obstacle covers the ego vehicle at its start, (24 m, 0 m)"),
    ],
)
def test_a_value_that_does_not_go_with_the_file_s_names_both(override: str, message: str) -> None:
    """Where an override makes another key wrong, the message has the file, the override and that key."""
    with pytest.raises(InputError) as caught:
        load("paper", [override])
    assert str(caught.value).startswith(f"paper.toml with --set {override}: {message}")


def test_the_footprint_counts_at_the_start() -> None:
    """An obstacle ahead of a point may be under the bonnet of the body."""
    near = "obstacles.0.position=[3.5, 0]"
    load("paper", [near])
    with pytest.raises(InputError, match="covers the ego vehicle"):
        load("paper", [near, "ego.footprint=rectangle"])


def test_all_faults_are_in_one_message() -> None:
    """Several faults are told together, each with its origin, and no more than three of them."""
    with pytest.raises(InputError) as caught:
        load("paper", ["road.frictoin=0.4", "ego.speed=72 kg", "goal.speed=x", "name=4"])
    text = str(caught.value)
    assert text.isprintable()
    assert text.count("; also ") == 2
    assert text.endswith("; and 1 more")
