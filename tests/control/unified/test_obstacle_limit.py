"""The half-planes between footprint and obstacle against brute force: who keeps them keeps clear, between poses too."""

from functools import cache

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from swerve.control.forecast import Forecast
from swerve.control.plan import Passing
from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.limits import ObstacleLimit, Penalty, Rows
from swerve.control.unified.limits.limit import MOST_ROWS
from swerve.control.unified.limits.obstacle import REACH, SAG
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.separation import Separation
from swerve.world import Ellipse, Footprint, Obstacle, Point, Rectangle, Shape, Steady, clearance, distance_ratio
from tests.control.unified.situations import (
    BLOCKING,
    BOX_CAR,
    CAR,
    PASSED,
    RUNNING,
    in_the_mirror,
    other_side,
    random_inputs,
    seeds,
    situation,
)

N_FINE, N_COARSE = 9, 2  # poses of the paths below
N_POSES = N_FINE + N_COARSE
TIMES = np.concatenate([np.arange(N_FINE) * 0.025, [0.3, 0.4]])  # [s]
PRICE = Penalty(5e3, 1e5)
MARGIN = 0.01  # [m]

lengths = st.floats(0.4, 4.0)
shapes = st.builds(Ellipse, st.tuples(lengths, lengths)) | st.builds(Rectangle, lengths, lengths)
footprints = st.sampled_from([Point(), CAR, Rectangle(2.0, 0.8)])
angles = st.floats(-np.pi, np.pi)
sides = st.sampled_from(PASSED)
passings = st.sampled_from(list(Passing))


@st.composite
def obstacles(draw: st.DrawFn) -> Obstacle:
    """Any shape with any heading round the origin, at rest or moving."""
    velocity = draw(st.tuples(st.floats(-15.0, 15.0), st.floats(-5.0, 5.0)))
    position = draw(st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0)))
    return Obstacle(draw(shapes), Steady(position, velocity, draw(angles)))


@st.composite
def paths(draw: st.DrawFn) -> np.ndarray:
    """Poses (11, 3) of a vehicle that passes near the origin at up to 35 m/s, turning a little."""
    speed, course = draw(st.floats(0.0, 35.0)), draw(st.floats(-0.6, 0.6))
    middle = np.array([draw(st.floats(-6.0, 6.0)), draw(st.floats(-6.0, 6.0))])
    travelled = speed * (TIMES - draw(st.floats(0.0, 0.4)))
    heading = course + draw(st.floats(-0.6, 0.6)) * TIMES
    direction = np.array([np.cos(course), np.sin(course)])
    return np.column_stack([middle + np.outer(travelled, direction), heading])


def along(poses: np.ndarray) -> Trajectory:
    """A trajectory with these poses; nothing else in it matters to the limit."""
    return Trajectory(np.zeros((1, 5)), np.zeros((2, 6)), poses, np.zeros(1), np.zeros(1), np.zeros((1, 4)))


def each_pose_alone(n: int = N_POSES - 1) -> Sensitivities:
    """Sensitivities by 3 n free numbers that are X, Y and psi of each pose but the first."""
    return Sensitivities(
        np.zeros((1, 6, 3 * n)), np.eye(3 * n).reshape(n, 3, 3 * n), np.zeros((1, 3 * n)), np.zeros((1, 3 * n))
    )


@cache
def separation(footprint: Footprint) -> Separation:
    """The lines for the paths above."""
    return Separation(footprint, N_POSES, N_FINE)


def limit(
    obstacle: Obstacle,
    footprint: Footprint,
    passing: Passing,
    margin: float = MARGIN,
    price: Penalty = PRICE,
    growth: float = 0.0,
) -> ObstacleLimit:
    """The limit over the paths above, for an obstacle that is expected to go on as it does."""
    position, velocity = obstacle.position_at(0.0), obstacle.velocity_at(0.0)
    expected = Forecast(obstacle.shape, float(obstacle.heading_at(0.0)), 0.0, position, velocity, np.zeros(2))
    return ObstacleLimit(0, expected, TIMES, separation(footprint), passing, margin, price, growth)


def directions(rows: Rows) -> tuple[np.ndarray, np.ndarray]:
    """For each row the pose that it is about (m,), and its normal and derivative by psi (m, 3)."""
    by_pose = rows.matrix.reshape(len(rows.lower), N_POSES - 1, 3)
    pose = np.argmax(np.abs(by_pose).sum(axis=2), axis=1)
    assert (np.count_nonzero(by_pose.any(axis=2), axis=1) == 1).all()
    return pose + 1, by_pose[np.arange(len(pose)), pose]


@given(obstacles(), footprints, passings, paths())
def test_a_gap_is_no_more_than_the_clearance(
    obstacle: Obstacle, footprint: Footprint, passing: Passing, poses: np.ndarray
) -> None:
    """Where a half-plane says that there is room, the polygons are apart by that much at least."""
    rows = limit(obstacle, footprint, passing).rows(along(poses), each_pose_alone())
    pose, _ = directions(rows)
    gap = MARGIN - rows.lower
    apart = clearance(footprint, poses[pose], obstacle, TIMES[pose])
    assert (gap <= apart + 2e-4).all()
    assert np.isinf(rows.upper).all()


POLE = Obstacle(Ellipse((0.1, 0.1)), Steady((0.0, 0.0)))
PEDESTRIAN = Obstacle(Ellipse((0.3, 0.3)), Steady((0.0, 0.0)))
BOX = Obstacle(Rectangle(1.274, 0.791), Steady((0.0, 0.0), heading=-0.298))
ROUND_THE_CORNER = np.column_stack(
    [
        [-3.814, -3.105, -2.396, -1.687, -0.978, -0.269, 0.44, 1.149, 1.858, 4.0, 7.0],
        [1.475, 0.548, 0.255, 0.647, 1.144, 1.072, 0.278, -0.725, -1.235, -1.2, -1.2],
        np.full(N_POSES, -0.323),
    ]
)


def straight_over(speed: float) -> np.ndarray:
    """Poses of a vehicle that drives over the origin between two of them."""
    return np.column_stack([speed * (TIMES - 0.0875), np.zeros((N_POSES, 2))])


def only_just_clear(found: ObstacleLimit, poses: np.ndarray, away: np.ndarray) -> np.ndarray:
    """The path, moved in a direction (2,) until it keeps the limit, and no further."""
    least, most = 0.0, 60.0
    for _ in range(30):
        middle = (least + most) / 2
        moved = poses + np.array([*(middle * away), 0.0])
        least, most = (least, middle) if found.violation(along(moved)) == 0 else (middle, most)
    return poses + np.array([*(most * away), 0.0])


@settings(max_examples=60)
@given(obstacles(), footprints, passings, paths(), st.floats(-1.0, 1.0))
@example(POLE, Point(), Passing.LEFT, straight_over(20.0), 0.0)
@example(PEDESTRIAN, Point(), Passing.RIGHT, straight_over(35.0), 0.0)
@example(BOX, Point(), Passing.LEFT, ROUND_THE_CORNER, 0.0)
@example(PEDESTRIAN, CAR, Passing.BEHIND, straight_over(35.0), 0.0)
def test_nothing_cuts_between_two_poses(
    obstacle: Obstacle, footprint: Footprint, passing: Passing, poses: np.ndarray, bent: float
) -> None:
    """A path that only just keeps its limit is clear of the obstacle all the way, not at its poses alone."""
    poses = poses + np.column_stack([0 * TIMES, bent * np.sin(40 * TIMES), 0 * TIMES])
    if isinstance(footprint, Rectangle):
        poses[:, 2] = poses[0, 2]  # corners that turn move on arcs, which the margin is for
    found = limit(obstacle, footprint, passing, margin=SAG + 1e-6)
    away = np.array([-1.0, 0.0]) if passing is Passing.BEHIND else np.array([0.0, passing.value])
    poses = only_just_clear(found, poses, away)
    assume(found.violation(along(poses)) == 0.0)
    share = np.linspace(0.0, 1.0, 51)[:, np.newaxis]
    for k in range(1, N_POSES - 1):  # the pose that is measured can't be moved: no half-plane is about it
        between = poses[k] + share * (poses[k + 1] - poses[k])
        times = TIMES[k] + share[:, 0] * (TIMES[k + 1] - TIMES[k])
        if footprint == Point() and isinstance(obstacle.shape, Ellipse):
            assert distance_ratio(footprint, between, obstacle, times).min() >= 1.0 - 1e-9
        else:
            assert clearance(footprint, between, obstacle, times).min() > -1e-9
            assert (clearance(footprint, between, obstacle, times) > 0).all() or isinstance(obstacle.shape, Ellipse)


@pytest.mark.parametrize("side", PASSED)
@pytest.mark.parametrize("heading", [0.0, 0.3])
@pytest.mark.parametrize(
    ("shape", "footprint"),
    [(Rectangle(4.0, 1.8), CAR), (Rectangle(3.0, 2.0), Point()), (Ellipse((0.4, 0.4)), CAR)],
)
def test_abreast_of_a_face_nothing_is_given_away(
    shape: Shape, footprint: Footprint, heading: float, side: Passing
) -> None:
    """Driving along a face of the obstacle, or with a face of its own to the obstacle, the gap is the clearance."""
    obstacle = Obstacle(shape, Steady((0.0, 0.0), heading=heading))
    along_x, across = np.array([np.cos(heading), np.sin(heading)]), np.array([-np.sin(heading), np.cos(heading)])
    travelled = 10.0 * (TIMES - TIMES[4])
    path = np.outer(travelled, along_x) + side.value * 2.5 * across
    poses = np.column_stack([path, np.full(N_POSES, heading)])
    rows = limit(obstacle, footprint, side).rows(along(poses), each_pose_alone())
    pose, _ = directions(rows)
    apart = clearance(footprint, poses, obstacle, TIMES)
    assert MARGIN - rows.lower[pose == 4].max() == pytest.approx(apart[4], abs=2e-3 if footprint == Point() else 2e-4)


@given(obstacles(), footprints, passings, paths())
def test_normals_point_to_the_side(
    obstacle: Obstacle, footprint: Footprint, passing: Passing, poses: np.ndarray
) -> None:
    """A unit normal for passing on the left never pushes to the right, and the other way round."""
    _, direction = directions(limit(obstacle, footprint, passing).rows(along(poses), each_pose_alone()))
    np.testing.assert_allclose(np.hypot(direction[:, 0], direction[:, 1]), 1.0, atol=1e-12)
    assert (direction[:, 1] * passing.value >= -1e-12).all()


@given(obstacles(), footprints, passings, paths())
def test_violation_is_the_largest_missing_distance(
    obstacle: Obstacle, footprint: Footprint, passing: Passing, poses: np.ndarray
) -> None:
    """What is missed is the margin, less a tolerance for curvature, less the smallest gap of all rows: what a program
    is charged with is what it sees.
    """
    found = limit(obstacle, footprint, passing)
    rows = found.rows(along(poses), each_pose_alone())
    violation = found.violation(along(poses))
    assert violation == pytest.approx(max(0.0, rows.lower.max(initial=0.0) - SAG), abs=1e-12)
    assert found.is_near(along(poses)) == (len(rows.lower) > 0)
    assert (MARGIN - rows.lower < REACH).all()


@given(obstacles(), footprints, passings, paths())
def test_left_and_right_are_mirror_images(
    obstacle: Obstacle, footprint: Footprint, passing: Passing, poses: np.ndarray
) -> None:
    """Passing on the left misses as much as passing on the right does in the mirror."""
    here = limit(obstacle, footprint, passing).violation(along(poses))
    there = limit(in_the_mirror(obstacle), footprint, other_side(passing)).violation(along(poses * [1, -1, -1]))
    assert there == pytest.approx(here, abs=1e-9)


@given(st.floats(0.3, 5.0), st.floats(0.3, 3.9), st.floats(2.0, 30.0))
def test_clear_of_a_disc_it_gives_away_little(radius: float, gap: float, speed: float) -> None:
    """Abreast of a disc the gap is the clearance, less what the chord between two poses takes."""
    poses = np.column_stack([speed * (TIMES - TIMES[4]), np.full(N_POSES, radius + gap), np.zeros(N_POSES)])
    disc = Obstacle(Ellipse((radius, radius)), Steady((0.0, 0.0)))
    rows = limit(disc, Point(), Passing.LEFT).rows(along(poses), each_pose_alone())
    pose, _ = directions(rows)
    abreast = MARGIN - rows.lower[pose == 4][0]
    chord = radius * (1 / np.cos(np.arctan(speed * 0.025 / (radius + gap)) / 2) - 1)
    assert gap - chord - 1e-9 <= abreast <= gap + 1e-9


@pytest.mark.parametrize("passing", list(Passing))
def test_straight_behind_it_says_stay_behind(passing: Passing) -> None:
    """A vehicle straight behind a box that is wider than itself is held back, however it is to pass."""
    box = Obstacle(Rectangle(2.0, 6.0), Steady((0.0, 0.0)))
    poses = np.column_stack([np.linspace(-6.0, -4.0, N_POSES), np.zeros((N_POSES, 2))])
    rows = limit(box, CAR, passing).rows(along(poses), each_pose_alone())
    _, direction = directions(rows)
    np.testing.assert_allclose(direction[:, :2], np.tile([-1.0, 0.0], (len(direction), 1)), atol=1e-12)


@pytest.mark.parametrize("passing", list(Passing))
def test_the_obstacle_is_where_it_will_be(passing: Passing) -> None:
    """Each pose keeps clear of the obstacle's position at its own time."""
    leading = Obstacle(Ellipse((1.0, 1.0)), Steady((3.0, 0.0), velocity=(20.0, 0.0)))
    poses = np.column_stack([20 * TIMES, np.zeros((N_POSES, 2))])
    rows = limit(leading, Point(), passing).rows(along(poses), each_pose_alone())
    np.testing.assert_allclose(MARGIN - rows.lower, 2.0, atol=1e-6)


def gaps(obstacle: Obstacle, footprint: Footprint, passing: Passing, poses: np.ndarray) -> np.ndarray:
    """The gap of each pose but the first, infinite where it is out of reach."""
    rows = limit(obstacle, footprint, passing).rows(along(poses), each_pose_alone())
    pose, _ = directions(rows)
    found = np.full(N_POSES - 1, np.inf)
    found[pose - 1] = MARGIN - rows.lower
    return found


@given(obstacles(), footprints, passings, paths(), st.floats(0.0, 1.5), st.floats(0.0, 3.0))
def test_a_comfort_grows_with_foresight(
    obstacle: Obstacle, footprint: Footprint, passing: Passing, poses: np.ndarray, comfort: float, growth: float
) -> None:
    """Nothing is missed exactly where each pose has its margin and its own comfort; what is missed of the margin, and
    that alone, is a fault, as large as without any comfort.
    """
    found = limit(obstacle, footprint, passing, price=Penalty(5e3, 1e5, comfort, 1e3), growth=growth)
    gap = gaps(obstacle, footprint, passing, poses) - MARGIN + SAG
    wanted = comfort * (1 + growth * TIMES[1:])
    assume(np.abs(gap - wanted).min() > 1e-9)
    violation = found.violation(along(poses))
    assert (violation > 0) == (gap < wanted).any()
    assert found.penalty.missed(violation) == pytest.approx(max(0.0, -float(gap.min())), abs=1e-9)
    assert violation == pytest.approx(limit(obstacle, footprint, passing).violation(along(poses)) + comfort) or (
        violation < comfort + 1e-9
    )


@given(obstacles(), footprints, passings, paths(), st.floats(0.0, 1.5), st.floats(0.0, 1.0))
def test_rows_miss_what_the_violation_says_with_a_comfort_too(
    obstacle: Obstacle, footprint: Footprint, passing: Passing, poses: np.ndarray, comfort: float, growth: float
) -> None:
    """At the point of expansion the largest row is the violation, but for what curvature may take."""
    found = limit(obstacle, footprint, passing, price=Penalty(5e3, 1e5, comfort, 1e3), growth=growth)
    rows = found.rows(along(poses), each_pose_alone())
    largest, violation = max(0.0, rows.lower.max(initial=0.0)), found.violation(along(poses))
    assert violation - 1e-9 <= largest <= violation + SAG + 1e-9
    assert rows.weight is not None
    assert ((rows.weight > 0) & (rows.weight <= 1)).all()


@settings(max_examples=25)
@given(st.floats(-15.0, 15.0), st.floats(1.0, 2.5), sides)
def test_whatever_crosses_has_rows_where_it_has_a_price(speed: float, seconds: float, side: Passing) -> None:
    """An obstacle that crosses has a wide gap; each pose that misses it is one that the program sees."""
    meeting = 20.0 * seconds
    walker = Obstacle(Ellipse((0.4, 0.4)), Steady((meeting, -speed * seconds + side.value * 1.0), (0.0, speed)))
    found = situation((side,), walker)
    (crossing,) = (each for each in found.program.soft if isinstance(each, ObstacleLimit))
    step = found.roll_out(np.zeros((20, 5)))
    rows = crossing.rows(step.trajectory, found.sensitivities(step))
    violation = crossing.violation(step.trajectory)
    assert violation - 1e-9 <= max(0.0, rows.lower.max(initial=0.0)) <= violation + SAG + 1e-9


@given(obstacles(), footprints, passings, paths())
def test_an_impact_is_where_the_footprint_touches(
    obstacle: Obstacle, footprint: Footprint, passing: Passing, poses: np.ndarray
) -> None:
    """Without an impact no pose overlaps the obstacle; with one it is at the first that does, or before."""
    found = limit(obstacle, footprint, passing)
    gap = MARGIN - found.rows(along(poses), each_pose_alone()).lower
    assume(np.abs(gap).min(initial=1.0) > 2e-4)  # an ellipse is not known better than that
    impact = found.impact(along(poses))
    overlapping = np.flatnonzero(clearance(footprint, poses, obstacle, TIMES)[1:] == 0.0) + 1
    assert (impact is None) == (gap.min(initial=1.0) > 0)
    if impact is None:
        assert len(overlapping) == 0
    else:
        first, velocity = impact
        assert first <= min(overlapping, default=N_POSES)
        np.testing.assert_allclose(velocity, obstacle.velocity_at(0.0), atol=1e-12)


@settings(max_examples=12)
@given(seeds, sides, st.sampled_from([(), BOX_CAR]))
def test_rows_are_the_slopes_all_the_way_to_the_tail(seed: int, side: Passing, of: tuple[str, ...]) -> None:
    """Beside a long wall each row is the change of a gap with the free inputs, to the last pose of the tail."""
    random = np.random.default_rng(seed)
    start, inputs = RUNNING + random.normal(0.0, 0.02, 6), random_inputs(random, 0.2)
    wall = Obstacle(Rectangle(800.0, 2.0), Steady((0.0, -side.value * 3.0)))
    found = situation((side,), wall, state=start, of=of)
    (beside,) = (each for each in found.program.soft if isinstance(each, ObstacleLimit))
    step = found.roll_out(inputs)
    rows = beside.rows(step.trajectory, found.sensitivities(step))
    assert 0 < len(rows.lower) <= MOST_ROWS
    z = random.normal(size=BLOCKING.n)
    ahead, behind = (
        beside.rows(found.roll_out(inputs + sign * BLOCKING.spread(1e-5 * z)).trajectory, found.sensitivities(step))
        for sign in (1, -1)
    )
    np.testing.assert_allclose(rows.matrix @ z, (behind.lower - ahead.lower) / 2e-5, rtol=1e-3, atol=1e-4)


def test_the_price_is_that_of_the_settings() -> None:
    """A limit's violation costs what its penalty says."""
    assert limit(PEDESTRIAN, Point(), Passing.LEFT).penalty is PRICE
    assert limit(PEDESTRIAN, Point(), Passing.LEFT).name == "obstacle 0"
