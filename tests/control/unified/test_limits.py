"""The limits beside the obstacles: prices, slip angles, the input box, the steering rate."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.control import Side
from swerve.control.unified.condensing import INPUT_SCALE
from swerve.control.unified.limits import InputBox, Lane, Penalty, RoadEdge, SlipLimit, SteeringRateLimit
from swerve.control.unified.limits.limit import MOST_ROWS, nearest
from swerve.control.unified.prediction import Trajectory
from swerve.vehicle.tyre import lateral_force
from swerve.world import Footprint, Point
from tests.control.unified.situations import (
    BLOCKING,
    CAR,
    RUNNING,
    SIDES,
    along_the_linear_model,
    model,
    random_inputs,
    random_roll_out,
    random_start,
    seeds,
)
from tests.vehicle.motions import DRY, SEDAN, STATIC

TRUST = np.array([0.08, 4e3, 4e3, 4e3, 4e3])
BOX = InputBox.of(SEDAN, 0.85, STATIC, BLOCKING)


@given(st.floats(0.0, 10.0), st.floats(0.0, 1e4), st.floats(0.0, 1e5))
def test_a_violation_costs_its_size_and_its_square(violation: float, linear: float, quadratic: float) -> None:
    """Nothing for nothing, and more for more."""
    price = Penalty(linear, quadratic)
    assert price.of(violation) == pytest.approx(linear * violation + quadratic * violation**2)
    assert price.of(0.0) == 0.0
    assert price.of(violation + 1) >= price.of(violation)


@given(st.floats(0.0, 5.0), st.floats(0.0, 2.0), st.floats(0.0, 1e3))
def test_comfort_is_cheap_and_beyond_it_all_is_as_without(violation: float, comfort: float, cheap: float) -> None:
    """The first part costs its own price; what is beyond costs, and counts, as if there were no comfort."""
    bare, price = Penalty(5e3, 1e5), Penalty(5e3, 1e5, comfort, cheap)
    beyond = max(0.0, violation - comfort)
    assert price.missed(violation) == beyond
    assert price.of(violation) == pytest.approx(cheap * min(violation, comfort) + bare.of(beyond))
    assert bare.missed(violation) == violation


@given(st.lists(st.floats(-5.0, 5.0), max_size=120, unique=True), st.floats(-1.0, 5.0))
def test_the_nearest_are_the_smallest_in_reach(gaps: list[float], reach: float) -> None:
    """Of what is in reach the MOST_ROWS smallest, in their order."""
    found = nearest(np.array(gaps), reach)
    wanted = sorted(sorted((i for i, gap in enumerate(gaps) if gap < reach), key=lambda i: gaps[i])[:MOST_ROWS])
    assert found.tolist() == wanted


def test_violations_are_never_left_out_for_their_number() -> None:
    """Of many rows that are violated alike the worst one is among those that are kept."""
    gaps = np.full(90, -1.0)
    gaps[77] = -1.5
    assert 77 in nearest(gaps, 1.0)
    assert len(nearest(gaps, 1.0)) == MOST_ROWS


# Edges and lanes


def footprint_ends(footprint: Footprint, poses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Smallest and largest Y of the footprint at each pose, by its corners."""
    x, y = footprint.outline().T
    across = poses[:, 1, np.newaxis] + np.outer(np.sin(poses[:, 2]), x) + np.outer(np.cos(poses[:, 2]), y)
    return across.min(axis=1), across.max(axis=1)


@settings(max_examples=30)
@given(
    seeds,
    st.sampled_from([Point(), CAR]),
    st.sampled_from(SIDES),
    st.floats(-3.0, 3.0),
    st.sampled_from([0.0, 0.8, 2.0, np.pi, -2.0]),
)
def test_an_edge_is_missed_by_the_corner_that_is_furthest_out(
    seed: int, footprint: Footprint, side: Side, edge: float, heading: float
) -> None:
    """The violation is what the margin lacks between the edge and the outermost corner, at any pose but the first,
    whichever way the vehicle points.
    """
    trajectory, _, _ = random_roll_out(seed)
    trajectory = replace(trajectory, poses=trajectory.poses + np.array([0.0, 0.0, heading]))
    found = RoadEdge(side, edge, footprint, 0.1, Penalty(1.0, 1.0))
    lowest, highest = (each[1:] for each in footprint_ends(footprint, trajectory.poses))
    room = edge - highest if side is Side.LEFT else lowest - edge
    assert found.violation(trajectory) == pytest.approx(max(0.0, 0.1 - float(room.min())), abs=1e-12)
    assert found.name == ("left edge" if side is Side.LEFT else "right edge")


@settings(max_examples=30)
@given(seeds, st.sampled_from([Point(), CAR]), st.sampled_from(SIDES), st.floats(-1.0, 1.0))
def test_edge_rows_are_the_slopes_of_the_room(seed: int, footprint: Footprint, side: Side, edge: float) -> None:
    """Each row is the change of the room to the edge with the free inputs, and says how much of it is missing."""
    trajectory, sensitivities, random = random_roll_out(seed)
    found = RoadEdge(side, trajectory.poses[20, 1] + edge, footprint, 0.1, Penalty(1.0, 1.0))
    rows = found.rows(trajectory, sensitivities)
    assert np.isinf(rows.upper).all()
    z = 1e-6 * random.normal(size=BLOCKING.n)

    def missing(at: Trajectory) -> np.ndarray:
        lowest, highest = (each[1:] for each in footprint_ends(footprint, at.poses))
        return 0.1 - (found.edge - highest if side is Side.LEFT else lowest - found.edge)

    before, after = missing(trajectory), missing(along_the_linear_model(trajectory, sensitivities, z))
    near = np.flatnonzero(-before + 0.1 < 1.5)
    assert len(rows.lower) == len(near)
    np.testing.assert_allclose(rows.lower, before[near], atol=1e-12)
    away_from_kink = (np.abs(np.sin(trajectory.poses[1:, 2])) > 1e-4)[near] | (footprint == Point())
    np.testing.assert_allclose((rows.matrix @ z)[away_from_kink], (before - after)[near][away_from_kink], atol=1e-10)


@settings(max_examples=30)
@given(seeds, st.floats(-2.0, 2.0), st.floats(0.0, 1.0))
def test_a_lane_is_missed_on_both_sides(seed: int, middle: float, half: float) -> None:
    """The violation is the largest distance of the centre of gravity beyond the band; rows are its slopes."""
    trajectory, sensitivities, random = random_roll_out(seed)
    found = Lane(middle - half, middle + half, Penalty(1.0, 1.0))
    y = trajectory.poses[1:, 1]
    beyond = np.maximum(y - found.highest, found.lowest - y)
    assert found.violation(trajectory) == pytest.approx(max(0.0, float(beyond.max())), abs=1e-12)
    rows = found.rows(trajectory, sensitivities)
    z = random.normal(0.0, 0.05, BLOCKING.n)
    there = along_the_linear_model(trajectory, sensitivities, z).poses[1:, 1]
    in_reach = (y > found.highest - 0.5) | (y < found.lowest + 0.5)
    assert len(rows.lower) == min(MOST_ROWS, np.count_nonzero(in_reach))
    if np.count_nonzero(in_reach) <= MOST_ROWS:
        above, below = np.isfinite(rows.upper), np.isfinite(rows.lower)
        np.testing.assert_allclose((rows.upper - rows.matrix @ z)[above], (found.highest - there)[in_reach][above])
        np.testing.assert_allclose((rows.matrix @ z - rows.lower)[below], (there - found.lowest)[in_reach][below])
        assert (above | below).all()
    assert (rows.lower <= rows.upper).all()


@settings(max_examples=30)
@given(seeds)
def test_slip_rows_are_the_limit_on_the_linear_model(seed: int) -> None:
    """A row says how far a slip angle is from its limit, and a change that uses that up brings it there."""
    trajectory, sensitivities, random = random_roll_out(seed)
    found = SlipLimit(0.12, Penalty(1.0, 1.0))
    rows = found.rows(trajectory, sensitivities)
    z = random.normal(0.0, 0.1, BLOCKING.n)
    there = along_the_linear_model(trajectory, sensitivities, z)
    slips = np.concatenate([there.front_slip, there.rear_slip])
    assert len(rows.lower) == len(slips)
    bounded = np.isfinite(rows.upper)
    np.testing.assert_allclose((rows.upper - rows.matrix @ z)[bounded], (0.12 - slips)[bounded], atol=1e-12)
    bounded = np.isfinite(rows.lower)
    np.testing.assert_allclose((rows.matrix @ z - rows.lower)[bounded], (slips + 0.12)[bounded], atol=1e-12)


@settings(max_examples=30)
@given(seeds)
def test_what_violates_the_slip_limit_has_a_row(seed: int) -> None:
    """Left out are only sides that are far from the limit; the violation is the largest excess of both axles."""
    random = np.random.default_rng(seed)
    trajectory = model().roll_out(random_start(random), random_inputs(random, 3.0), STATIC)
    _, sensitivities, _ = random_roll_out(seed)
    found = SlipLimit(0.12, Penalty(1.0, 1.0))
    rows = found.rows(trajectory, sensitivities)
    slips = np.concatenate([trajectory.front_slip, trajectory.rear_slip])
    assert np.isfinite(rows.upper[slips > 0.12]).all()
    assert np.isfinite(rows.lower[slips < -0.12]).all()
    assert found.violation(trajectory) == pytest.approx(max(0.0, np.abs(slips).max() - 0.12))


@settings(max_examples=40)
@given(seeds, st.floats(0.1, 30.0), st.floats(1 / 64, 1.0))
def test_the_box_is_never_empty(seed: int, wildness: float, trust: float) -> None:
    """Whatever the inputs, loads and slip angles of a trajectory are, no lower bound is above its upper one."""
    random = np.random.default_rng(seed)
    loads = random.uniform(0.0, 8000.0, 4)
    trajectory = model().roll_out(random_start(random), random_inputs(random, wildness), STATIC)
    lower, upper = InputBox.of(SEDAN, 0.85, loads, BLOCKING).bounds(trajectory, trust * TRUST)
    assert lower.shape == upper.shape == (75,)
    assert (lower <= upper).all()
    assert (np.abs([lower, upper]) <= np.tile(trust * TRUST / INPUT_SCALE, 15) + 1e-12).all()


@settings(max_examples=40)
@given(seeds)
def test_what_the_box_allows_is_within_the_vehicles_limits(seed: int) -> None:
    """From inputs that keep the limits every change in the box keeps them."""
    trajectory, _, random = random_roll_out(seed)
    kept = model().roll_out(trajectory.states[0], BOX.clip(trajectory.inputs), STATIC)
    lower, upper = BOX.bounds(kept, TRUST)
    z = random.uniform(lower, upper)
    inputs = kept.inputs + BLOCKING.spread(z)
    free = BLOCKING.free(inputs)
    assert (np.abs(free[:, 0]) <= SEDAN.steering_limit + 1e-12).all()
    assert (np.abs(free[:, 1:]) <= 0.95 * 0.85 * STATIC + 1e-9).all()


@pytest.mark.parametrize("load", [-1.0, -1e4, 0.0])
def test_a_wheel_that_carries_nothing_has_no_force(load: float) -> None:
    """A load that is measured as less than nothing, as noise at a lifted wheel is, leaves a box that is not empty."""
    loads = STATIC * [1, 1, 1, 0] + np.array([0, 0, 0, load])
    box = InputBox.of(SEDAN, 0.85, loads, BLOCKING)
    assert box.largest[4] == 0.0
    lower, upper = box.bounds(model().roll_out(RUNNING, np.zeros((20, 5)), STATIC), TRUST)
    assert (lower <= upper).all()


def test_the_force_limit_leaves_room_for_the_lateral_demand() -> None:
    """A wheel that corners may brake less: running straight the whole share, at the tyre's peak a third of it."""
    wide = np.array([10.0, 1e6, 1e6, 1e6, 1e6])
    straight = model().roll_out(RUNNING, np.zeros((20, 5)), STATIC)
    _, upper = BOX.bounds(straight, wide)
    np.testing.assert_allclose(upper.reshape(15, 5)[:, 1:] * 1e3, np.tile(0.95 * 0.85 * STATIC, (15, 1)))
    inputs = np.zeros((20, 5))
    inputs[:, 0] = SEDAN.tyre.peak_slip(STATIC[0])
    turning = model().roll_out(RUNNING, inputs, STATIC)
    assert turning.lateral_demand[0, :2] == pytest.approx(1.0, abs=1e-3)
    _, upper = BOX.bounds(turning, wide)
    np.testing.assert_allclose(upper.reshape(15, 5)[0, 1:3] * 1e3, 0.31225 * 0.95 * 0.85 * STATIC[:2], rtol=1e-3)


@given(st.floats(-0.14, 0.14))
def test_with_the_force_at_its_limit_most_of_the_lateral_force_is_left(slip: float) -> None:
    """The force that is allowed at a lateral demand takes no more than a third of the lateral force that is asked
    for.
    """
    load = float(STATIC[0])
    free = abs(float(lateral_force(DRY, slip, 0.0, 0.85, load)))
    demand = free / (0.85 * load * (1.0161 - 9.0695e-6 * load))
    allowed = 0.95 * 0.85 * load * np.sqrt(1 - (0.95 * demand) ** 2)
    left = abs(float(lateral_force(DRY, slip, allowed, 0.85, load)))
    assert left >= 0.3 * free
    if demand > 0.9:
        assert left >= 0.85 * free


@given(seeds, st.floats(0.1, 50.0))
def test_clipping_keeps_what_is_within(seed: int, wildness: float) -> None:
    """Inputs come back within the vehicle's limits, those within unchanged."""
    inputs = random_inputs(np.random.default_rng(seed), wildness)
    clipped = BOX.clip(inputs)
    assert (np.abs(clipped) <= BOX.largest).all()
    within = np.abs(inputs) <= BOX.largest
    np.testing.assert_array_equal(clipped[within], inputs[within])
    assert (np.sign(clipped) == np.sign(inputs)).all()


@given(st.lists(st.floats(-0.5, 0.5), min_size=20, max_size=20), st.floats(0.2, 3.0), st.floats(-0.5, 0.5))
def test_clipping_follows_at_the_steering_rate(wanted: list[float], rate: float, previous: float) -> None:
    """Clipped steering angles go towards their own values as fast as the rate allows, from the angle that acts now."""
    inputs = np.column_stack([wanted, np.arange(80.0).reshape(20, 4)])
    found = SteeringRateLimit(rate * 0.05, previous, BLOCKING)
    clipped, before = found.clip(inputs), previous
    np.testing.assert_array_equal(clipped[:, 1:], inputs[:, 1:])
    for angle, target in zip(clipped[:, 0], wanted, strict=True):
        assert angle == pytest.approx(np.clip(target, before - rate * 0.05, before + rate * 0.05), abs=1e-12)
        before = angle
    np.testing.assert_allclose(found.clip(clipped), clipped, atol=1e-12)
    assert inputs[:, 0].tolist() == wanted


@settings(max_examples=20)
@given(seeds, st.floats(0.2, 3.0))
def test_the_steering_rate_is_bounded_from_what_acts_now(seed: int, rate: float) -> None:
    """The rows bound every change of the free steering angles, the first of them from the angle that acts now."""
    trajectory, sensitivities, random = random_roll_out(seed)
    rows = SteeringRateLimit(rate * 0.05, 0.04, BLOCKING).rows(trajectory, sensitivities)
    z = random.normal(size=BLOCKING.n)
    steering = BLOCKING.free(trajectory.inputs + BLOCKING.spread(z))[:, 0]
    change = np.diff(steering, prepend=0.04)
    keeps = (rows.lower - 1e-12 <= rows.matrix @ z) & (rows.matrix @ z <= rows.upper + 1e-12)
    np.testing.assert_array_equal(keeps, np.abs(change) <= rate * 0.05 + 1e-12)
    np.testing.assert_allclose((rows.upper - rows.matrix @ z) * 0.1, rate * 0.05 - change, atol=1e-12)
