"""Motions: closed forms, and the velocity as the derivative of the position."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from swerve.world import Accelerating, AlongWaypoints, Ellipse, Motion, Obstacle, Steady, Waiting
from tests.world.strategies import angles, coordinates

times = st.floats(-3.0, 12.0)
speeds = st.floats(-30.0, 30.0)
pairs = st.tuples(coordinates, coordinates)
velocities = st.tuples(speeds, speeds)
accelerations = st.tuples(st.floats(-10.0, 10.0), st.floats(-10.0, 10.0))


@st.composite
def paths(draw: st.DrawFn) -> AlongWaypoints:
    """Two to six way-points at least 0.1 s apart."""
    knots = np.cumsum(draw(st.lists(st.floats(0.1, 3.0), min_size=2, max_size=6)))
    return AlongWaypoints(tuple(knots.tolist()), tuple(draw(pairs) for _ in knots))


motions = st.one_of(
    st.builds(Steady, pairs, velocities, angles),
    st.builds(Waiting, pairs, velocities, angles, st.floats(0.0, 8.0)),
    st.builds(Accelerating, pairs, velocities, angles, accelerations, st.floats(0.0, 8.0)),
    paths(),
)


@given(motions, times)
def test_the_velocity_is_the_derivative_of_the_position(motion: Motion, time: float) -> None:
    """A central difference of the position is the velocity, wherever that does not jump or bend within the step."""
    step = 1e-5
    around = motion.velocity_at([time - step, time, time + step])
    assume(np.abs(np.diff(around, axis=0)).max() < 0.1)
    before, after = motion.position_at([time - step, time + step])
    np.testing.assert_allclose((after - before) / (2 * step), around[1], atol=0.1)
    middles = (np.arange(60_000) + 0.5) / 4000 - 3.0
    distance = motion.velocity_at(middles).mean(axis=0) * 15
    np.testing.assert_allclose(motion.position_at(12.0) - motion.position_at(-3.0), distance, atol=0.1)


@given(motions)
def test_times_of_any_shape_have_answers_of_that_shape(motion: Motion) -> None:
    """A scalar, a list and a table of times give as many positions, velocities and headings, and the same ones."""
    obstacle = Obstacle(Ellipse((2.0, 2.0)), motion)
    table = np.linspace(-1.0, 9.0, 12).reshape(3, 4)
    for ask, shape in ((obstacle.position_at, (2,)), (obstacle.velocity_at, (2,)), (obstacle.heading_at, ())):
        assert ask(table).shape == (3, 4, *shape)
        np.testing.assert_array_equal(ask(table)[1, 2], ask(table[1, 2]))
        assert ask([]).shape == (0, *shape)


def test_a_steady_motion_is_linear_in_time() -> None:
    """It is where start and velocity put it, before time zero as well."""
    steady = Steady((25.0, 1.0), (10.0, -2.0), 0.3)
    np.testing.assert_allclose(steady.position_at([-1.0, 0.5]), [[15.0, 3.0], [30.0, 0.0]])
    np.testing.assert_array_equal(steady.velocity_at([0.0, 7.0]), [[10.0, -2.0]] * 2)
    np.testing.assert_array_equal(steady.heading_at([0.0, 7.0]), [0.3, 0.3])


@pytest.mark.parametrize(("course", "reaction"), [(0.0, 0.0), (0.6, 1.5), (-2.5, 0.3)])
def test_a_braking_car_stands_after_its_braking_distance(course: float, reaction: float) -> None:
    """From v at deceleration a it drives v t_a + v^2 / 2 a, in t_a + v / a, and does not move after that."""
    speed, rate = 20.0, 8.0
    ahead = np.array([math.cos(course), math.sin(course)])
    car = Accelerating((5.0, 1.0), tuple(speed * ahead), course, tuple(-rate * ahead), reaction)
    stops_at = reaction + speed / rate
    assert car.duration == pytest.approx(speed / rate)
    end = np.array([5.0, 1.0]) + (speed * reaction + speed**2 / (2 * rate)) * ahead
    np.testing.assert_allclose(car.position_at([stops_at, stops_at + 1, stops_at + 99]), [end] * 3)
    np.testing.assert_allclose(car.velocity_at([stops_at, stops_at + 99]), 0.0, atol=1e-12)
    np.testing.assert_allclose(car.velocity_at(stops_at - 0.25), 2.0 * ahead)
    np.testing.assert_allclose(car.velocity_at(reaction), speed * ahead)


def test_a_final_speed_ends_the_acceleration() -> None:
    """Braking from 20 to 8 m/s at 4 m/s^2, and speeding up from 8 to 20 m/s, take 3 s and 42 m; then it drives on."""
    slower = Accelerating((0.0, 0.0), (20.0, 0.0), 0.0, (-4.0, 0.0), 1.0, 8.0)
    faster = Accelerating((0.0, 0.0), (8.0, 0.0), 0.0, (4.0, 0.0), 1.0, 20.0)
    np.testing.assert_allclose(slower.position_at([1.0, 4.0, 5.0])[:, 0], [20.0, 62.0, 70.0])
    np.testing.assert_allclose(faster.position_at([1.0, 4.0, 5.0])[:, 0], [8.0, 50.0, 70.0])
    assert Accelerating((0.0, 0.0), (8.0, 0.0), 0.0, (4.0, 0.0)).duration == math.inf


def test_a_car_pulls_out_from_rest() -> None:
    """Without a velocity the final speed is along the acceleration: (3, 4) m/s^2 reach 10 m/s after 2 s."""
    parked = Accelerating((0.0, 0.0), (0.0, 0.0), 0.9, (3.0, 4.0), 1.0, 10.0)
    np.testing.assert_allclose(parked.velocity_at([1.0, 2.0, 3.0, 9.0]), [[0, 0], [3, 4], [6, 8], [6, 8]])


@given(velocities, accelerations, times)
def test_an_accelerating_obstacle_never_reverses(
    velocity: tuple[float, float], acceleration: tuple[float, float], time: float
) -> None:
    """Along the way that it went at first it never goes back."""
    motion = Accelerating((0.0, 0.0), velocity, 0.0, acceleration)
    assert motion.velocity_at(time) @ np.array(velocity) >= -1e-9


@pytest.mark.parametrize(
    ("velocity", "acceleration", "final"), [(10.0, -2.0, 11.0), (10.0, 2.0, 9.0), (10.0, 0.0, 5.0), (10.0, 2.0, 10.0)]
)
def test_a_final_speed_out_of_reach_is_refused(velocity: float, acceleration: float, final: float) -> None:
    """Braking does not end at a higher speed, nor speeding up at a lower one."""
    with pytest.raises(ValueError, match=r"final_speed of .* is never reached from 10 m/s"):
        Accelerating((0.0, 0.0), (velocity, 0.0), 0.0, (acceleration, 0.0), 0.0, final)


def test_a_pedestrian_steps_out() -> None:
    """Until the instant he stands, from it on he walks."""
    pedestrian = Waiting((30.0, -4.0), (0.0, 1.5), math.pi / 2, 2.0)
    np.testing.assert_allclose(pedestrian.position_at([0.0, 2.0, 4.0]), [[30.0, -4.0], [30.0, -4.0], [30.0, -1.0]])
    np.testing.assert_allclose(pedestrian.velocity_at([1.999, 2.0])[:, 1], [0.0, 1.5])


@given(paths())
def test_way_points_are_met_and_not_overshot(path: AlongWaypoints) -> None:
    """At each time it is at its way-point, and between two of them X and Y stay within theirs."""
    np.testing.assert_allclose(path.position_at(path.times), path.positions, atol=1e-9)
    for k in range(len(path.times) - 1):
        between = path.position_at(np.linspace(path.times[k], path.times[k + 1], 50))
        low, high = np.sort(path.positions[k : k + 2], axis=0)
        assert (between >= low - 1e-9).all()
        assert (between <= high + 1e-9).all()
        steps = np.diff(between, axis=0) * np.sign(np.subtract(*path.positions[k : k + 2][::-1]))
        assert (steps >= -1e-9).all()


@given(paths(), st.floats(0.0, 20.0))
def test_the_velocities_at_both_ends_are_kept(path: AlongWaypoints, beyond: float) -> None:
    """Before the first way-point and after the last one it moves as it does there, without a jump."""
    for end, time in ((path.times[0], path.times[0] - beyond), (path.times[-1], path.times[-1] + beyond)):
        velocity = path.velocity_at(end)
        np.testing.assert_array_equal(path.velocity_at(time), velocity)
        np.testing.assert_allclose(path.position_at(time), path.position_at(end) + (time - end) * velocity, atol=1e-9)


def test_two_way_points_are_a_straight_and_steady_motion() -> None:
    """Nothing but constant velocity goes through two of them."""
    path, steady = AlongWaypoints((1.0, 3.0), ((10.0, 3.5), (50.0, 0.0))), Steady((-10.0, 5.25), (20.0, -1.75))
    when = np.linspace(-2.0, 9.0, 20)
    np.testing.assert_allclose(path.position_at(when), steady.position_at(when), atol=1e-9)
    np.testing.assert_allclose(path.heading_at(when), math.atan2(-1.75, 20.0))


def test_a_cut_in_is_smooth_and_ends_in_its_lane() -> None:
    """At constant speed along X and between two stretches of one lane each, Y has no speed at either end."""
    cut_in = AlongWaypoints((0.0, 2.0, 4.0, 6.0), ((20.0, 3.5), (50.0, 3.5), (80.0, 0.0), (110.0, 0.0)))
    when = np.array([1.0, 2.0, 3.0, 4.0, 5.0, 9.0])
    np.testing.assert_allclose(cut_in.velocity_at(when)[:, 0], 15.0)
    np.testing.assert_allclose(cut_in.position_at(when)[:, 1], [3.5, 3.5, 1.75, 0.0, 0.0, 0.0], atol=1e-12)
    np.testing.assert_allclose(cut_in.heading_at(when), [0, 0, math.atan2(-1.5 * 3.5 / 2, 15.0), 0, 0, 0], atol=1e-9)


@pytest.mark.parametrize("course", [0.4, -2.0, math.pi / 2])
def test_a_standing_obstacle_keeps_the_heading_that_it_had(course: float) -> None:
    """Before it starts it points where it will go, at a stop where it went; one that never moves points along X."""
    ahead, left = np.array([math.cos(course), math.sin(course)]), np.array([-math.sin(course), math.cos(course)])
    places = [0 * ahead, 0 * ahead, 5 * ahead, 5 * ahead, 5 * ahead + 3 * left, 5 * ahead + 3 * left]
    path = AlongWaypoints(tuple(float(k) for k in range(6)), tuple((float(x), float(y)) for x, y in places))
    headings = path.heading_at([-1.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 9.0])
    turned = math.remainder(course + math.pi / 2, 2 * math.pi)
    expected = np.array([*[course] * 7, *[turned] * 4])
    np.testing.assert_allclose(np.cos(headings - expected), 1.0, atol=1e-9)
    assert AlongWaypoints((0.0, 1.0), ((3.0, 3.0), (3.0, 3.0))).heading_at(0.5) == 0.0


def test_a_given_heading_is_kept_along_way_points() -> None:
    """A vehicle that slides sideways does not point along its velocity."""
    path = AlongWaypoints((0.0, 1.0), ((0.0, 0.0), (0.0, 5.0)), heading=0.2)
    np.testing.assert_array_equal(path.heading_at([-1.0, 0.5, 3.0]), [0.2, 0.2, 0.2])


@pytest.mark.parametrize(
    ("when", "places"),
    [((0.0,), 1), ((0.0, 1.0), 3), ((0.0, 0.0), 2), ((1.0, 0.0), 2), ((0.0, math.nan), 2), ((), 0)],
)
def test_way_points_that_are_no_motion_are_refused(when: tuple[float, ...], places: int) -> None:
    """Fewer than two, not a time for each, or times that do not ascend."""
    with pytest.raises(ValueError, match=r"^times must"):
        AlongWaypoints(when, ((1.0, 2.0),) * places)


@pytest.mark.parametrize(
    ("kind", "field"),
    [
        *((Steady, name) for name in ("position", "velocity", "heading")),
        *((Waiting, name) for name in ("position", "velocity", "heading", "moves_at")),
        *(
            (Accelerating, name)
            for name in ("position", "velocity", "heading", "acceleration", "accelerates_at", "final_speed")
        ),
        *((AlongWaypoints, name) for name in ("positions", "heading")),
    ],
)
@pytest.mark.parametrize("number", [math.nan, math.inf])
def test_a_motion_that_is_nowhere_is_refused(kind: type[Motion], field: str, number: float) -> None:
    """A number that is not finite names itself in the error."""
    values: dict[type[Motion], dict[str, object]] = {
        Steady: {"position": (0.0, 0.0)},
        Waiting: {"position": (0.0, 0.0), "velocity": (1.0, 0.0), "heading": 0.0, "moves_at": 1.0},
        Accelerating: {"position": (0.0, 0.0), "velocity": (9.0, 0.0), "heading": 0.0, "acceleration": (-1.0, 0.0)},
        AlongWaypoints: {"times": (0.0, 1.0), "positions": ((0.0, 0.0), (1.0, 0.0))},
    }
    scalars = ("heading", "moves_at", "accelerates_at", "final_speed")
    pair = (0.0, number)
    wrong: object = number if field in scalars else (pair, pair) if field == "positions" else pair
    with pytest.raises(ValueError, match=f"^{field} must be finite"):
        kind(**(values[kind] | {field: wrong}))
