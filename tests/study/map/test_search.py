"""The search for a boundary, against oracles that are known."""

from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.study.map.boundary import Boundary, Condition, RunRecord
from swerve.study.map.search import TURN, Lattice, boundary_of, search

HERE = Condition(20.0, 0.85, 0.0)
TOLERANCE = 0.1  # [m]
MOST_RUNS = 60

Oracle = Callable[[float], tuple[bool, str]]  # distance -> whether it is avoided, and the decision


def searched(lattice: Lattice, oracle: Oracle) -> tuple[list[RunRecord], Boundary]:
    """All runs in their order, and what is made of them."""
    runs: list[RunRecord] = []
    going = search(lattice)
    distance = next(going)
    while True:
        is_avoided, decision = oracle(distance)
        runs.append(RunRecord("one", HERE, distance, "avoided" if is_avoided else "collided", decision))
        try:
            distance = going.send(runs[-1])
        except StopIteration:
            return runs, boundary_of("one", HERE, runs)


lattices = st.builds(
    lambda nearest, swerving, beyond: Lattice(TOLERANCE, nearest, swerving, nearest + beyond),
    st.floats(0.5, 8.0),
    st.floats(3.0, 60.0),
    st.floats(1.0, 300.0),
)


@given(lattices, st.floats(0.0, 1.2))
def test_a_monotone_boundary_is_found_to_the_tolerance(lattice: Lattice, share: float) -> None:
    """The last avoided and the first failing distance are neighbours on the lattice, on either side of the truth."""
    truth = share * lattice.furthest
    runs, found = searched(lattice, lambda distance: (distance >= truth, "brake"))
    tried = sorted(run.distance for run in runs)
    assert len(tried) == len(set(tried)) <= MOST_RUNS
    assert found.holes == ()
    if truth > tried[-1]:
        assert found.avoided is None
        assert found.failed == tried[-1]
    elif found.failed is None:
        assert found.avoided == tried[0] >= truth
        assert tried[0] <= lattice.nearest + 2 * TOLERANCE
    else:
        assert found.failed < truth <= found.avoided
        assert found.avoided - found.failed == pytest.approx(TOLERANCE)


@given(lattices, st.lists(st.floats(0.0, 1.1), min_size=1, max_size=6))
def test_last_avoided_means_that_all_larger_distances_tried_are_avoided(lattice: Lattice, shares: list[float]) -> None:
    """Also where avoiding comes and goes with the distance; failures above an avoided distance are holes."""
    edges = sorted(share * lattice.furthest for share in shares)

    def oracle(distance: float) -> tuple[bool, str]:
        return sum(edge <= distance for edge in edges) % 2 == len(edges) % 2, "brake"

    runs, found = searched(lattice, oracle)
    by_distance = sorted(runs, key=lambda run: run.distance)
    above = [run for run in by_distance if found.avoided is not None and run.distance >= found.avoided]
    assert all(run.is_avoided for run in above)
    if found.avoided is not None and found.failed is not None:
        assert found.avoided - found.failed == pytest.approx(TOLERANCE)
        assert [run.distance for run in by_distance if run.distance < found.avoided][-1] == found.failed
    lowest = min((run.distance for run in runs if run.is_avoided), default=float("inf"))
    assert found.holes == tuple(run.distance for run in by_distance if not run.is_avoided and run.distance > lowest)
    assert found.n_runs == len(runs)


@given(lattices, st.floats(0.05, 0.5), st.floats(0.3, 0.9))
def test_the_turn_from_braking_to_steering_is_found(lattice: Lattice, low: float, high: float) -> None:
    """Within 2 % of its distance, or the tolerance; it is a distance at which the decision was to steer."""
    boundary, turn = low * lattice.furthest, high * lattice.furthest
    runs, found = searched(lattice, lambda d: (d >= boundary, "brake" if d >= turn else "brake+steer-left"))
    steering = [run.distance for run in runs if run.is_avoided and run.distance < turn and run.distance >= boundary]
    braking = [run.distance for run in runs if run.is_avoided and run.distance >= max(turn, boundary)]
    if not steering or not braking:
        assert found.turns is None
        return
    assert found.turns == max(steering)
    assert min(braking) - max(steering) <= max(TOLERANCE, TURN * max(steering)) + 1e-9


def test_who_never_avoids_is_not_tried_for_long() -> None:
    """Two failures in a row, from afar, are the end of it."""
    runs, found = searched(Lattice(TOLERANCE, 2.0, 14.0, 43.0), lambda distance: (False, "none"))
    assert len(runs) == 2
    assert (found.avoided, found.failed, found.outcome) == (None, 43.0, "collided")


def test_the_way_in_gets_denser_towards_the_swerving_distance() -> None:
    """Steps of 5 % beside it, and none larger than what lies between."""
    lattice = Lattice(TOLERANCE, 2.0, 20.0, 60.0)
    places = [lattice.distance(i) for i in lattice.inwards]
    assert places == [
        60.0,
        52.0,
        36.0,
        28.0,
        24.0,
        22.0,
        21.0,
        20.0,
        16.0,
        12.8,
        10.2,
        8.2,
        6.6,
        5.2,
        4.2,
        3.4,
        2.7,
        2.1,
    ]
