"""The half-planes between footprint and obstacle against brute force: who keeps them keeps clear, between poses too."""

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from swerve.control import Side
from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.limits import ObstacleLimit, Penalty, Rows
from swerve.control.unified.limits.obstacle import REACH, SAG
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.tail import Tail
from swerve.world import Ellipse, Footprint, Obstacle, Point, Rectangle, Shape, Steady, clearance, distance_ratio
from tests.control.unified.situations import HORIZON, SIDES, random_roll_out, seeds

N = 4  # samples of the paths below
N_POSES = 2 * N + 1
TIMES = np.arange(N_POSES) * 0.025  # [s]
NO_TAIL = Tail(np.empty(0), 0.0)
PRICE = Penalty(5e3, 1e5)
MARGIN = 0.01  # [m]
CAR = Rectangle(4.85, 1.8, (-0.4, 0.0))

lengths = st.floats(0.4, 4.0)
shapes = st.builds(Ellipse, st.tuples(lengths, lengths)) | st.builds(Rectangle, lengths, lengths)
footprints = st.sampled_from([Point(), CAR, Rectangle(2.0, 0.8)])
angles = st.floats(-np.pi, np.pi)
sides = st.sampled_from(SIDES)


@st.composite
def obstacles(draw: st.DrawFn) -> Obstacle:
    """Any shape with any heading round the origin, at rest or moving."""
    velocity = draw(st.tuples(st.floats(-15.0, 15.0), st.floats(-5.0, 5.0)))
    position = draw(st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0)))
    return Obstacle(draw(shapes), Steady(position, velocity, draw(angles)))


@st.composite
def paths(draw: st.DrawFn) -> np.ndarray:
    """Poses (9, 3) of a vehicle that passes near the origin at up to 35 m/s, turning a little."""
    speed, course = draw(st.floats(0.0, 35.0)), draw(st.floats(-0.6, 0.6))
    middle = np.array([draw(st.floats(-6.0, 6.0)), draw(st.floats(-6.0, 6.0))])
    travelled = speed * (TIMES - draw(st.floats(0.0, 0.2)))
    heading = course + draw(st.floats(-0.6, 0.6)) * TIMES
    direction = np.array([np.cos(course), np.sin(course)])
    return np.column_stack([middle + np.outer(travelled, direction), heading])


def along(poses: np.ndarray) -> Trajectory:
    """A trajectory with these poses; nothing else in it matters to the limit."""
    n = len(poses) // 2
    states = np.zeros((n + 1, 6))
    states[:, [4, 5, 3]] = poses[0::2]
    return Trajectory(np.zeros((n, 5)), states, poses, np.zeros(n), np.zeros(n), np.zeros((n, 4)))


def each_pose_alone(n: int = N) -> Sensitivities:
    """Sensitivities by 3 * 2 n free numbers that are X, Y and psi of each pose but the first."""
    free = 6 * n
    return Sensitivities(
        np.zeros((n, 6, free)), np.eye(free).reshape(2 * n, 3, free), np.zeros((n, free)), np.zeros((n, free))
    )


def limit(obstacle: Obstacle, footprint: Footprint, side: Side, margin: float = MARGIN) -> ObstacleLimit:
    """The limit over the paths above."""
    return ObstacleLimit(obstacle, footprint, side, TIMES, NO_TAIL, margin, PRICE)


def directions(rows: Rows) -> tuple[np.ndarray, np.ndarray]:
    """For each row the pose that it is about (m,), and its normal and derivative by psi (m, 3)."""
    by_pose = rows.matrix.reshape(len(rows.lower), 2 * N, 3)
    pose = np.argmax(np.abs(by_pose).sum(axis=2), axis=1)
    assert (np.count_nonzero(by_pose.any(axis=2), axis=1) == 1).all()
    return pose + 1, by_pose[np.arange(len(pose)), pose]


def support(shape: Shape, direction: np.ndarray, heading: float) -> float:
    """How far a shape reaches in a direction of the world, by its outline."""
    outline = shape.outline(3600)
    cos, sin = np.cos(heading), np.sin(heading)
    return float((outline @ np.array([[cos, -sin], [sin, cos]]).T @ direction).max())


@given(obstacles(), footprints, sides, paths())
def test_a_gap_is_no_more_than_the_clearance(
    obstacle: Obstacle, footprint: Footprint, side: Side, poses: np.ndarray
) -> None:
    """Where a half-plane says that there is room, the polygons are apart by that much at least."""
    rows = limit(obstacle, footprint, side).rows(along(poses), each_pose_alone())
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
        [-3.814, -3.105, -2.396, -1.687, -0.978, -0.269, 0.44, 1.149, 1.858],
        [1.475, 0.548, 0.255, 0.647, 1.144, 1.072, 0.278, -0.725, -1.235],
        np.full(9, -0.323),
    ]
)


def straight_over(speed: float) -> np.ndarray:
    """Poses of a vehicle that drives over the origin between two of them."""
    return np.column_stack([speed * (TIMES - 0.0875), np.zeros((N_POSES, 2))])


def only_just_clear(found: ObstacleLimit, poses: np.ndarray, side: Side) -> np.ndarray:
    """The path, moved to the side until it keeps the limit, and no further."""
    least, most = 0.0, 60.0
    for _ in range(40):
        middle = (least + most) / 2
        moved = poses + np.array([0.0, side.value * middle, 0.0])
        least, most = (least, middle) if found.violation(along(moved)) == 0 else (middle, most)
    return poses + np.array([0.0, side.value * most, 0.0])


@given(obstacles(), footprints, sides, paths(), st.floats(-1.0, 1.0))
@example(POLE, Point(), Side.LEFT, straight_over(20.0), 0.0)
@example(PEDESTRIAN, Point(), Side.RIGHT, straight_over(35.0), 0.0)
@example(BOX, Point(), Side.LEFT, ROUND_THE_CORNER, 0.0)
def test_nothing_cuts_between_two_poses(
    obstacle: Obstacle, footprint: Footprint, side: Side, poses: np.ndarray, bent: float
) -> None:
    """A path that only just keeps its limit is clear of the obstacle all the way, not at its poses alone."""
    poses = poses + np.column_stack([0 * TIMES, bent * np.sin(40 * TIMES), 0 * TIMES])
    # a point needs no margin beyond the tolerance; a body's corners move on arcs, which the margin is for
    found = limit(obstacle, footprint, side, margin=SAG + 1e-6 if footprint == Point() else MARGIN)
    poses = only_just_clear(found, poses, side)
    assume(found.violation(along(poses)) == 0.0)
    share = np.linspace(0.0, 1.0, 51)[:, np.newaxis]
    for k in range(1, N_POSES - 1):  # the pose that is measured can't be moved: no half-plane is about it
        between = poses[k] + share * (poses[k + 1] - poses[k])
        times = TIMES[k] + share[:, 0] * 0.025
        if footprint == Point() and isinstance(obstacle.shape, Ellipse):
            assert distance_ratio(footprint, between, obstacle, times).min() >= 1.0
        else:
            assert clearance(footprint, between, obstacle, times).min() > 0.0


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("turned", [0.0, 0.3])
@pytest.mark.parametrize(
    ("shape", "footprint"),
    [(Rectangle(4.0, 1.8), CAR), (Rectangle(3.0, 2.0), Point()), (Ellipse((0.4, 0.4)), CAR)],
)
def test_abreast_of_a_face_nothing_is_given_away(shape: Shape, footprint: Footprint, turned: float, side: Side) -> None:
    """Driving along a face of the obstacle, or with a face of its own to the obstacle, the gap is the clearance."""
    obstacle = Obstacle(shape, Steady((0.0, 0.0), heading=turned))
    along_x, across = np.array([np.cos(turned), np.sin(turned)]), np.array([-np.sin(turned), np.cos(turned)])
    travelled = 10.0 * (TIMES - TIMES[4])
    path = np.outer(travelled, along_x) + side.value * 2.5 * across
    poses = np.column_stack([path, np.full(N_POSES, turned)])
    rows = limit(obstacle, footprint, side).rows(along(poses), each_pose_alone())
    pose, _ = directions(rows)
    apart = clearance(footprint, poses, obstacle, TIMES)
    assert MARGIN - rows.lower[pose == 4].max() == pytest.approx(apart[4], abs=2e-3 if footprint == Point() else 2e-4)


@given(obstacles(), footprints, sides, paths())
def test_normals_point_to_the_side(obstacle: Obstacle, footprint: Footprint, side: Side, poses: np.ndarray) -> None:
    """A unit normal for passing on the left never pushes to the right, and the other way round."""
    _, direction = directions(limit(obstacle, footprint, side).rows(along(poses), each_pose_alone()))
    np.testing.assert_allclose(np.hypot(direction[:, 0], direction[:, 1]), 1.0, atol=1e-12)
    assert (direction[:, 1] * side.value >= -1e-12).all()


@given(obstacles(), footprints, sides, paths())
def test_a_row_is_the_slope_of_its_gap(obstacle: Obstacle, footprint: Footprint, side: Side, poses: np.ndarray) -> None:
    """With its line held still, a gap changes with X, Y and psi of its pose as the row says."""
    rows = limit(obstacle, footprint, side).rows(along(poses), each_pose_alone())
    centres = obstacle.position_at(TIMES)

    def gap(pose: np.ndarray, normal: np.ndarray, centre: np.ndarray) -> float:
        """normal . (p - c) - h_ego(-normal; psi), by the outline of the footprint."""
        return float(normal @ (pose[:2] - centre)) - support(footprint, -normal, pose[2])

    for k, row in list(zip(*directions(rows), strict=True))[:6]:
        normal = row[:2]
        corner = np.abs(
            np.array(
                [
                    np.cos(poses[k, 2]) * normal[0] + np.sin(poses[k, 2]) * normal[1],
                    np.cos(poses[k, 2]) * normal[1] - np.sin(poses[k, 2]) * normal[0],
                ]
            )
        )
        if isinstance(footprint, Rectangle) and corner.min() < 1e-3:
            continue  # along a face two corners are equally far: a kink
        for j in range(3):
            d = np.eye(3)[j] * 1e-6
            slope = (gap(poses[k] + d, normal, centres[k]) - gap(poses[k] - d, normal, centres[k])) / 2e-6
            assert row[j] == pytest.approx(slope, abs=1e-6)


@given(obstacles(), footprints, sides, paths())
def test_violation_is_the_largest_missing_distance(
    obstacle: Obstacle, footprint: Footprint, side: Side, poses: np.ndarray
) -> None:
    """What is missed is the margin, less a tolerance for curvature, less the smallest gap of all rows."""
    found = limit(obstacle, footprint, side)
    rows = found.rows(along(poses), each_pose_alone())
    violation = found.violation(along(poses))
    if len(rows.lower):
        assert violation == pytest.approx(max(0.0, rows.lower.max() - SAG), abs=1e-12)
    else:
        assert violation == 0.0
    assert found.is_near(along(poses)) == (len(rows.lower) > 0)
    assert (MARGIN - rows.lower < REACH).all()


@given(obstacles(), st.sampled_from([Point(), CAR, Rectangle(2.0, 0.8)]), sides, paths())
def test_left_and_right_are_mirror_images(
    obstacle: Obstacle, footprint: Footprint, side: Side, poses: np.ndarray
) -> None:
    """Passing on the left misses as much as passing on the right does in the mirror."""
    (x, y), (vx, vy) = obstacle.position_at(0.0), obstacle.velocity_at(0.0)
    mirrored = Obstacle(obstacle.shape, Steady((x, -y), (vx, -vy), -float(obstacle.heading_at(0.0))))
    here = limit(obstacle, footprint, side).violation(along(poses))
    there = limit(mirrored, footprint, Side(-side.value)).violation(along(poses * [1, -1, -1]))
    assert there == pytest.approx(here, abs=1e-9)


@given(st.floats(0.3, 5.0), st.floats(0.3, 5.0), st.floats(2.0, 30.0))
def test_clear_of_a_disc_it_gives_away_little(radius: float, gap: float, speed: float) -> None:
    """Abreast of a disc the gap is the clearance, less what the chord between two poses takes."""
    poses = np.column_stack([speed * (TIMES - TIMES[4]), np.full(N_POSES, radius + gap), np.zeros(N_POSES)])
    assume(gap < REACH)
    rows = limit(Obstacle(Ellipse((radius, radius)), Steady((0.0, 0.0))), Point(), Side.LEFT).rows(
        along(poses), each_pose_alone()
    )
    pose, _ = directions(rows)
    abreast = MARGIN - rows.lower[pose == 4][0]
    chord = radius * (1 / np.cos(np.arctan(speed * 0.025 / (radius + gap)) / 2) - 1)
    assert gap - chord - 1e-9 <= abreast <= gap + 1e-9


def test_straight_behind_it_says_stay_behind() -> None:
    """A vehicle straight behind a box that is wider than itself is held back, whatever the side."""
    box = Obstacle(Rectangle(2.0, 6.0), Steady((0.0, 0.0)))
    poses = np.column_stack([np.linspace(-6.0, -4.0, N_POSES), np.zeros((N_POSES, 2))])
    for side in SIDES:
        rows = limit(box, CAR, side).rows(along(poses), each_pose_alone())
        _, direction = directions(rows)
        np.testing.assert_allclose(direction[:, :2], np.tile([-1.0, 0.0], (len(direction), 1)), atol=1e-12)


def test_the_obstacle_is_where_it_will_be() -> None:
    """Each pose keeps clear of the obstacle's position at its own time."""
    leading = Obstacle(Ellipse((1.0, 1.0)), Steady((3.0, 0.0), velocity=(20.0, 0.0)))
    poses = np.column_stack([20 * TIMES, np.zeros((N_POSES, 2))])
    rows = limit(leading, Point(), Side.LEFT).rows(along(poses), each_pose_alone())
    np.testing.assert_allclose(MARGIN - rows.lower, 2.0, atol=1e-6)


@given(seeds, sides)
def test_the_tail_has_rows_too(seed: int, side: Side) -> None:
    """Beyond the horizon the rows are those of the tail's poses, by the tail's own sensitivities."""
    trajectory, sensitivities, _random = random_roll_out(seed)
    tail = Tail.of(0.85, 20, 0.05)
    end = trajectory.states[-1]
    obstacle = Obstacle(Ellipse((2.0, 2.0)), Steady(tuple(end[4:] + 8.0 * np.array([np.cos(end[3]), np.sin(end[3])]))))
    times = np.arange(41) * HORIZON.sample_time / 2
    found = ObstacleLimit(obstacle, Point(), side, times, tail, MARGIN, PRICE)
    rows = found.rows(trajectory, sensitivities)
    poses = np.concatenate([trajectory.poses, tail.poses(end, side)])
    slopes = np.concatenate([sensitivities.poses, tail.sensitivities(end, sensitivities.states[-1])])
    matched = np.zeros(len(rows.lower), dtype=bool)
    for k in range(1, len(poses)):
        normals, *_ = np.linalg.lstsq(slopes[k - 1, :2].T, rows.matrix.T, rcond=None)
        residual = np.abs(slopes[k - 1, :2].T @ normals - rows.matrix.T).max(axis=0)
        gap = np.einsum("ij,ij->j", normals, (poses[k, :2] - obstacle.position_at(0.0))[:, np.newaxis] + 0 * normals)
        matched |= (residual < 1e-9) & (gap - 2.0 >= MARGIN - rows.lower - 1e-6)
    assert matched.all()
    assert found.is_near(trajectory)


def test_the_price_is_that_of_the_settings() -> None:
    """A limit's violation costs what its penalty says."""
    assert limit(Obstacle(Ellipse((1.0, 1.0)), Steady((0.0, 0.0))), Point(), Side.LEFT).penalty is PRICE
