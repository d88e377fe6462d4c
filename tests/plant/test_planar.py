"""The planar plant: an integrator of fourth order, actuators with limits, tyres that stay on their ellipse."""

import math
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from swerve.conventions import GRAVITY
from swerve.plant import PlanarPlant, PlantState, Trace
from swerve.signals import Command
from swerve.vehicle import Vehicle
from swerve.vehicle.tyre import factors
from tests.kernel.compilers import uncompiled
from tests.vehicle.motions import DRY, MIRROR, SEDAN, STATIC, move, states, steering_angles

Array = NDArray[np.float64]
Build = Callable[..., PlanarPlant]

TALL = SEDAN.with_changes({"cg_height": 0.55})
SLOW = SEDAN.with_changes({"steering_rate_limit": 2.5, "steering_limit": 0.3})
START = np.array([20.0, 0.3, 0.1, 0.2, 3.0, -1.0])
TURN = Command(0.05, np.array([-300.0, -200.0, -100.0, 0.0]))


@pytest.fixture(scope="module")
def build() -> Build:
    """A plant of any clock; not compiled, which would take longer than the runs of these tests."""
    plants: dict[tuple[Vehicle, float, int], PlanarPlant] = {}

    def built(vehicle: Vehicle = SEDAN, step: float = 1e-3, n: int = 50) -> PlanarPlant:
        key = (vehicle, step, n)
        if key not in plants:
            with pytest.MonkeyPatch.context() as patch:
                plants[key] = uncompiled(patch, lambda: PlanarPlant(vehicle, 0.85, step, n))
        return plants[key]

    return built


def drive(plant: PlanarPlant, start: Array, *commands: Command) -> tuple[PlantState, Trace]:
    """The state after one sample for each command, and the whole trace."""
    state, traces = plant.start(start), []
    for command in commands:
        state, trace = plant.advance(state, command)
        traces.append(trace)
    return state, Trace(*(np.concatenate([vars(trace)[name] for trace in traces]) for name in vars(traces[0])))


def test_the_integrator_has_fourth_order(build: Build) -> None:
    """Halving the step leaves a sixteenth of the distance to a solution by another, tighter integrator."""
    u = TURN.as_input()
    exact = solve_ivp(lambda _, xi: move(xi, u).derivative, (0.0, 0.2), START, method="DOP853", rtol=1e-13, atol=1e-13)
    errors = []
    for n in (4, 8, 16, 32):
        end, _ = drive(build(step=0.2 / n, n=n), START, TURN)
        errors.append(np.abs(end.vehicle - exact.y[:, -1]).max())
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(orders[-2:], 4.0, atol=0.3)
    assert errors[-1] < 1e-7


def test_load_transfer_converges_too(build: Build) -> None:
    """With load transfer, whose loads are those of a step's start, halving the step halves the error at least."""
    fine, _ = drive(build(TALL, 0.2 / 1024, 1024), START, TURN)
    errors = [np.abs(drive(build(TALL, 0.2 / n, n), START, TURN)[0].vehicle - fine.vehicle).max() for n in (16, 32, 64)]
    assert errors[1] < 0.6 * errors[0]
    assert errors[2] < 0.6 * errors[1]


@pytest.mark.parametrize("n", [1, 2, 50])
def test_a_sample_is_n_steps(build: Build, n: int) -> None:
    """A trace has a row for the start of each step, and after n steps of h the clock has gone n h on."""
    end, trace = drive(build(step=1e-3, n=n), START, Command(0.0, np.zeros(4)))
    assert {name: values.shape for name, values in vars(trace).items()} == {
        "states": (n, 6),
        "steering": (n,),
        "acceleration": (n, 2),
        "wheel_loads": (n, 4),
        "slip_angles": (n, 4),
        "longitudinal": (n, 4),
        "lateral": (n, 4),
    }
    np.testing.assert_array_equal(trace.states[0], START)
    assert end.vehicle.shape == (6,)
    travelled = np.hypot(*(end.vehicle - START)[4:])
    assert travelled == pytest.approx(math.hypot(20.0, 0.3) * n * 1e-3, rel=2e-3)


def test_samples_are_only_a_way_to_count(build: Build) -> None:
    """Fifty steps in one sample, or in ten, end at the same bits and pass through the same rows."""
    one, whole = drive(build(SLOW, 1e-3, 50), START, TURN)
    ten, parts = drive(build(SLOW, 1e-3, 5), START, *10 * [TURN])
    np.testing.assert_array_equal(one.vehicle, ten.vehicle)
    np.testing.assert_array_equal(one.inner, ten.inner)
    for name in vars(whole):
        np.testing.assert_array_equal(vars(whole)[name], vars(parts)[name])


def test_rows_are_the_model_at_their_instant(build: Build) -> None:
    """Accelerations, slip angles and tyre forces of a row are those of eq. (1) at the row's own state and steering."""
    _, trace = drive(build(SLOW), START, TURN)
    for k in (0, 7, 49):
        motion = move(trace.states[k], [trace.steering[k], *TURN.wheel_forces])
        np.testing.assert_allclose(trace.acceleration[k], motion.acceleration, atol=1e-12)
        np.testing.assert_allclose(trace.slip_angles[k], motion.slip_angles, atol=1e-14)
        np.testing.assert_allclose(trace.longitudinal[k], motion.longitudinal, atol=1e-9)
        np.testing.assert_allclose(trace.lateral[k], motion.lateral, atol=1e-9)


@given(st.lists(st.floats(-2.0, 2.0), min_size=3, max_size=6))
def test_the_actuator_keeps_its_lock_and_its_rate(build: Build, wanted: list[float]) -> None:
    """The road-wheel angle follows any commands no faster than its rate and no further than its lock, and gets
    there.
    """
    commands = [Command(angle, np.zeros(4)) for angle in wanted]
    state, trace = drive(build(SLOW), np.array([5.0, 0, 0, 0, 0, 0]), *commands)
    angles = np.concatenate([[0.0], trace.steering])
    assert np.abs(np.diff(angles)).max() <= 2.5 * 1e-3 * (1 + 1e-9)
    assert np.abs(angles).max() <= 0.3
    target, before = np.clip(wanted[-1], -0.3, 0.3), angles[-51]
    reach = 2.5 * 0.05
    assert state.inner[0] == pytest.approx(np.clip(target, before - reach, before + reach), abs=1e-9)


def test_without_a_rate_limit_the_angle_is_there_at_once(build: Build) -> None:
    """The paper's own actuator: the first step already has the commanded angle."""
    _, trace = drive(build(), START, TURN)
    assert (trace.steering == 0.05).all()


@settings(max_examples=40)
@given(states, steering_angles, st.lists(st.floats(-20e3, 20e3), min_size=4, max_size=4))
def test_tyres_stay_on_their_ellipse(build: Build, start: Array, delta: float, forces: list[float]) -> None:
    """Whatever is demanded, |Fx| <= mu Fz, both forces stay on the ellipse (2), and the loads carry the weight."""
    _, trace = drive(build(TALL), start, Command(delta, np.array(forces)))
    grip = 0.85 * trace.wheel_loads
    peak = factors(SEDAN.tyre, trace.wheel_loads)[2]
    assert (np.abs(trace.longitudinal) <= grip + 1e-9).all()
    assert (trace.longitudinal**2 + (trace.lateral / peak) ** 2 <= grip**2 * (1 + 2e-6) + 1e-6).all()
    within = np.abs(forces) <= grip
    np.testing.assert_array_equal(trace.longitudinal[within], np.broadcast_to(forces, grip.shape)[within])
    assert (trace.wheel_loads >= 0).all()
    lifted = (trace.wheel_loads == 0).any(axis=1)
    np.testing.assert_allclose(trace.wheel_loads[~lifted].sum(axis=1), SEDAN.mass * GRAVITY)


def test_loads_go_where_a_driver_feels_them(build: Build) -> None:
    """With a centre of gravity above the road, braking loads the front wheels and a left turn the right ones."""
    straight = np.array([20.0, 0, 0, 0, 0, 0])
    state, _ = drive(build(TALL), straight, *4 * [Command(0.0, np.full(4, -1500.0))])
    np.testing.assert_array_equal(np.sign(np.round(state.wheel_loads - STATIC, 6)), [1, 1, -1, -1])
    pitch = SEDAN.mass * (6000.0 / SEDAN.mass) * 0.55 / (2 * 2.78)
    np.testing.assert_allclose(state.wheel_loads - STATIC, pitch * np.array([1, 1, -1, -1]), rtol=1e-6)
    state, trace = drive(build(TALL), straight, *10 * [Command(0.03, np.zeros(4))])
    assert trace.acceleration[-1, 1] > 3.0
    assert (np.sign(state.wheel_loads - STATIC) == [-1, 1, -1, 1]).all()


def test_a_vehicle_without_height_has_the_papers_loads(build: Build) -> None:
    """With the centre of gravity on the road all loads stay static."""
    state, trace = drive(build(), START, TURN, TURN)
    np.testing.assert_array_equal(trace.wheel_loads, np.broadcast_to(STATIC, (100, 4)))
    np.testing.assert_array_equal(state.wheel_loads, STATIC)


@settings(max_examples=30)
@given(states, steering_angles)
def test_left_and_right_are_mirror_images(build: Build, start: Array, delta: float) -> None:
    """Started and commanded in the mirror, the plant moves in the mirror."""
    forces = np.array([-900.0, 100.0, 400.0, -50.0])
    here, trace = drive(build(TALL), start, Command(delta, forces), Command(-delta, forces))
    swapped = forces[[1, 0, 3, 2]]
    there, other = drive(build(TALL), start * MIRROR, Command(-delta, swapped), Command(delta, swapped))
    np.testing.assert_allclose(there.vehicle, here.vehicle * MIRROR, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(other.states, trace.states * MIRROR, rtol=1e-9, atol=1e-9)


def test_the_same_start_gives_the_same_bits(build: Build) -> None:
    """Another plant of the same numbers moves alike to the last bit, and a plant remembers nothing between calls."""
    plant = build(TALL)
    first, trace = plant.advance(plant.start(START), TURN)
    plant.advance(plant.start(-START), Command(-0.3, np.full(4, 1e4)))
    with pytest.MonkeyPatch.context() as patch:
        other = uncompiled(patch, lambda: PlanarPlant(TALL, 0.85, 1e-3, 50))
    for again in (plant, other):
        end, repeated = again.advance(again.start(START), TURN)
        np.testing.assert_array_equal(end.vehicle, first.vehicle)
        for name in vars(trace):
            np.testing.assert_array_equal(vars(repeated)[name], vars(trace)[name])


def test_states_are_values(build: Build) -> None:
    """What a plant is given stays as it was, and what it gave is not changed by what it does next."""
    plant, given_state = build(), START.copy()
    state = plant.start(given_state)
    given_state[:] = np.nan
    np.testing.assert_array_equal(state.vehicle, START)
    command = Command(0.02, np.zeros(4))
    end, _ = plant.advance(state, command)
    kept = end.vehicle.copy()
    plant.advance(end, Command(-0.3, np.full(4, -5e3)))
    np.testing.assert_array_equal(state.vehicle, START)
    np.testing.assert_array_equal(end.vehicle, kept)


def test_it_starts_with_its_wheels_straight(build: Build) -> None:
    """At the start the steering angle is zero and the wheels carry their static loads."""
    state = build(TALL).start(START)
    assert (state.inner == 0).all()
    np.testing.assert_allclose(state.wheel_loads, STATIC)


@pytest.mark.parametrize("broken", [np.nan, np.inf, -np.inf, 1e200, -1e160])
@pytest.mark.parametrize("place", [0, 1, 2, 3])
def test_a_motion_that_diverges_ends_in_nan(build: Build, broken: float, place: int) -> None:
    """From a state that no vehicle has, it goes on without an exception, to numbers that are none or are huge."""
    start = START.copy()
    start[place] = broken
    state, trace = drive(build(TALL), start, *5 * [TURN])
    assert trace.states.shape == (250, 6)
    assert not np.isfinite(state.vehicle).all() or np.abs(state.vehicle).max() > 1e100


@pytest.mark.parametrize("command", [Command(np.nan, np.zeros(4)), Command(0.0, np.full(4, np.nan))])
def test_a_command_that_is_no_number_is_no_exception(build: Build, command: Command) -> None:
    """A plant takes any command; one of nan moves it to nan, or is no force at all, and never raises."""
    state, _ = drive(build(), START, command, TURN)
    assert state.vehicle.shape == (6,)


@pytest.mark.parametrize("step", [1e-3, 2e-3, 5e-3])
def test_it_brakes_to_a_standstill_and_stays(build: Build, step: float) -> None:
    """Braked out of a turn, gently at the end, the vehicle comes to rest and does not shake itself apart."""
    plant = build(step=step, n=round(0.05 / step))
    state = plant.start(np.array([15.0, 0.5, 0.3, 0.0, 0.0, 0.0]))
    for _ in range(80):
        share = np.clip(state.vehicle[0] / 2.0, 0.0, 1.0)
        state, trace = plant.advance(state, Command(0.05, -0.8 * share * 0.85 * STATIC))
        assert np.abs(trace.states[:, :3]).max() <= 15.0
    assert 0.0 <= state.vehicle[0] < 0.05
    assert np.abs(trace.states[:, 1:3]).max() < 0.02


@pytest.mark.parametrize("speed", [15.0, -3.0, 0.0])
def test_a_brake_ends_with_the_motion(build: Build, speed: float) -> None:
    """Held for long, full braking brings the vehicle to rest, forwards or backwards, and never sets it in motion."""
    start = np.array([speed, 0, 0, 0, 0, 0])
    state, trace = drive(build(), start, *60 * [Command(0.0, -0.95 * 0.85 * STATIC)])
    assert abs(state.vehicle[0]) < 1e-3
    assert (np.diff(np.abs(trace.states[:, 0])) <= 0).all()
    assert (trace.states[:, 0] * np.sign(speed) >= 0).all()


def test_a_drive_sets_in_motion(build: Build) -> None:
    """From standstill a positive wheel force accelerates by force over mass."""
    state, _ = drive(build(), np.zeros(6), *4 * [Command(0.0, np.full(4, 300.0))])
    assert state.vehicle[0] == pytest.approx(1200.0 / SEDAN.mass * 0.2, rel=1e-6)


def test_braking_distance_is_that_of_the_friction(build: Build) -> None:
    """From 20 m/s with all wheels at 95 % of mu Fz the vehicle needs v^2 / (2 a)."""
    deceleration = 0.95 * 0.85 * GRAVITY
    seconds = 20.0 / deceleration
    n_samples = math.ceil(seconds / 0.05)
    state, trace = drive(build(), np.array([20.0, 0, 0, 0, 0, 0]), *n_samples * [Command(0.0, -0.95 * 0.85 * STATIC)])
    at_rest = int(np.argmin(np.abs(trace.states[:, 0])))
    assert trace.states[at_rest, 4] == pytest.approx(20.0**2 / (2 * deceleration), rel=1e-4)
    assert abs(state.vehicle[1]) + abs(state.vehicle[2]) < 1e-12
    assert DRY.mu == 0.85
