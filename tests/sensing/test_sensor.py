"""What the controller gets to know: delay, noise, and where the wheel loads come from."""

from dataclasses import replace

import numpy as np
import pytest

from swerve.scenario import load
from swerve.sensing import Noise, Past, Sensor, Truth
from swerve.simulate import run
from swerve.vehicle import vehicle_named
from swerve.world import Accelerating, AlongWaypoints, Ellipse, Obstacle, Steady, Waiting

STEP, N = 0.01, 5
SEDAN = vehicle_named("d-class-sedan")
IDEAL = Sensor(delay=0.0, noise=Noise(), estimates_loads=False, vehicle=SEDAN)
LEAD = Obstacle(Ellipse((2.0, 1.0)), Steady((30.0, 0.0), velocity=(10.0, -1.0)))


def past(samples: int) -> Past:
    """A vehicle at 20 m/s whose loads count the steps."""

    def truth(step: int) -> Truth:
        return Truth(np.array([20.0, 0, 0, 0, 20 * STEP * step, 0]), np.full(4, float(step)), np.zeros(2))

    recorded = Past(STEP, N, truth(0))
    for sample in range(samples):
        rows = [truth(N * sample + row) for row in range(N)]
        recorded.grow(
            np.array([row.vehicle for row in rows]),
            np.array([row.wheel_loads for row in rows]),
            np.zeros((N, 2)),
            truth(N * (sample + 1)),
        )
    return recorded


def generator() -> np.random.Generator:
    """The same random numbers for every test."""
    return np.random.default_rng(7)


def test_without_delay_and_noise_the_measurement_is_the_truth() -> None:
    """At each instant state, loads and obstacles are those of that instant, and the stamp says so."""
    seen = IDEAL.measure(0.1, past(2), [LEAD], generator())
    assert (seen.time, seen.stamp) == (0.1, 0.1)
    np.testing.assert_allclose(seen.state, [20, 0, 0, 0, 2.0, 0])
    np.testing.assert_allclose(seen.wheel_loads, 10)
    assert seen.obstacles[0].position == pytest.approx((31.0, -0.1))
    assert seen.obstacles[0].velocity == (10.0, -1.0)


@pytest.mark.parametrize("delay", [0.01, 0.03, 0.05, 0.07])
def test_a_delayed_measurement_is_the_truth_of_its_stamp(delay: float) -> None:
    """Vehicle, loads and obstacles are all as old as the stamp says, whether or not the delay is a whole sample."""
    seen = replace(IDEAL, delay=delay).measure(0.1, past(2), [LEAD], generator())
    assert seen.stamp == pytest.approx(0.1 - delay)
    np.testing.assert_allclose(seen.state[4], 20 * seen.stamp)
    np.testing.assert_allclose(seen.wheel_loads, seen.stamp / STEP)
    assert seen.obstacles[0].position == pytest.approx((30 + 10 * seen.stamp, -seen.stamp))


def test_a_measurement_knows_nothing_of_what_the_obstacle_will_do() -> None:
    """Of a braking, turning or waiting obstacle it has velocity and heading of the stamp, and keeps them."""
    curve = AlongWaypoints((0.0, 1.0, 2.0), ((30.0, 0.0), (40.0, 1.0), (45.0, 5.0)))
    braking = Accelerating((30.0, 0.0), (10.0, 0.0), 0.0, (-100.0, 0.0), accelerates_at=0.02)
    waiting = Waiting((30.0, 3.0), (0.0, -2.0), 0.0, moves_at=0.06)
    motions = (curve, braking, waiting)
    seen = replace(IDEAL, delay=0.05).measure(
        0.1, past(2), [Obstacle(Ellipse((2.0, 1.0)), motion) for motion in motions], generator()
    )
    assert [each.velocity for each in seen.obstacles[1:]] == [pytest.approx((7.0, 0.0)), (0.0, 0.0)]
    for each, motion in zip(seen.obstacles, motions, strict=True):
        assert each.velocity == pytest.approx(tuple(motion.velocity_at(0.05)))
        assert each.heading == pytest.approx(float(motion.heading_at(0.05)))
        ahead = each.as_obstacle().position_at(3.0) - motion.position_at(0.05)
        np.testing.assert_allclose(ahead, 3.0 * motion.velocity_at(0.05))


def test_before_the_first_delay_has_passed_the_start_is_what_is_known() -> None:
    """A measurement is never of a time before zero."""
    seen = replace(IDEAL, delay=0.2).measure(0.1, past(2), [LEAD], generator())
    assert seen.stamp == 0.0
    np.testing.assert_allclose(seen.state, [20, 0, 0, 0, 0, 0])


def test_noise_has_the_deviation_that_was_asked_for_on_its_own_channel() -> None:
    """Over many draws each channel's deviation is its own, and a channel without noise is exact."""
    noise = Noise(speed=0.3, yaw_rate=0.02, position=0.1, wheel_load=50.0, obstacle_position=0.5)
    sensor, recorded, numbers = replace(IDEAL, noise=noise), past(0), generator()
    draws = [sensor.measure(0.0, recorded, [LEAD], numbers) for _ in range(4000)]
    deviations = np.std([seen.state for seen in draws], axis=0)
    np.testing.assert_allclose(deviations, [0.3, 0, 0.02, 0, 0.1, 0.1], rtol=0.05)
    np.testing.assert_allclose(np.std([seen.wheel_loads for seen in draws], axis=0), 50, rtol=0.05)
    np.testing.assert_allclose(np.std([seen.obstacles[0].position for seen in draws], axis=0), 0.5, rtol=0.05)
    assert {seen.obstacles[0].velocity for seen in draws} == {(10.0, -1.0)}


def test_estimated_loads_are_those_of_the_accelerations() -> None:
    """Braking and turning left loads the front and the right, in sum the weight, and a lifted wheel carries nothing."""
    vehicle = SEDAN.with_changes({"cg_height": 0.5})
    sensor = replace(IDEAL, estimates_loads=True, vehicle=vehicle)
    braking = Past(STEP, N, Truth(np.zeros(6), np.full(4, np.nan), np.array([-5.0, 4.0])))
    front_left, front_right, rear_left, rear_right = sensor.measure(0.0, braking, [], generator()).wheel_loads
    assert front_left + front_right + rear_left + rear_right == pytest.approx(1530 * 9.81)
    shift = 1530 * 5.0 * 0.5 / vehicle.wheelbase
    assert front_left + front_right == pytest.approx(1530 * 9.81 * 1.67 / 2.78 + shift)
    assert front_right > front_left
    assert rear_right > rear_left
    rolling = Past(STEP, N, Truth(np.zeros(6), np.full(4, np.nan), np.array([0.0, 40.0])))
    assert sensor.measure(0.0, rolling, [], generator()).wheel_loads.min() == 0.0


def test_a_known_delay_is_made_up_for() -> None:
    """On its own model and without noise the controller drives the same with measurements that are 70 ms old."""
    ideal = run(load("static-20", []), plant="planar").result
    delayed = run(load("static-20", ["sensing.delay=70 ms"]), plant="planar").result
    assert delayed.fallback_steps == 0
    assert delayed.min_distance_ratio == pytest.approx(ideal.min_distance_ratio, abs=5e-3)
    assert delayed.lateral_offset.max == pytest.approx(ideal.lateral_offset.max, abs=0.05)


def test_noise_is_the_seeds_alone() -> None:
    """The same seed gives the same run, another seed another one."""
    noisy = load("static-20", ["duration=1", "sensing.noise={speed=0.1, position=0.05, yaw_rate=0.01}"])
    runs = [run(noisy, seed=seed).log.motion["Y"] for seed in (3, 3, 4)]
    np.testing.assert_array_equal(runs[0], runs[1])
    assert np.abs(runs[0] - runs[2]).max() > 1e-3
