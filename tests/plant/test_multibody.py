"""The multibody plant: order, statics, limits, standstill, and its agreement with models that are not it."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from swerve.conventions import GRAVITY
from swerve.plant import MultibodyPlant, PlanarPlant, PlantState, Trace
from swerve.signals import Command
from swerve.vehicle.multibody import Actuators
from swerve.vehicle.tyre import factors
from swerve.world import Friction, Patch
from tests.kernel.compilers import uncompiled
from tests.vehicle.motions import MIRROR
from tests.vehicle.multibody.cars import ACTUATORS, CHASSIS, NUMBERS, SEDAN, STATIC

Array = NDArray[np.float64]
Build = Callable[..., MultibodyPlant]

IDEAL = Actuators()
NO_DRAG = replace(CHASSIS, drag_area=0.0, tyre=replace(CHASSIS.tyre, rolling_resistance=0.0))
FLAT = replace(NO_DRAG, cg_height=0.02, tyre=replace(NO_DRAG.tyre, lateral_relaxation=0.05))
START = np.array([20.0, 0.3, 0.1, 0.2, 3.0, -1.0])
SPIN, MOTOR, BRAKE = slice(14, 18), slice(27, 31), slice(31, 35)  # of PlantState.inner


@pytest.fixture(scope="module")
def build() -> Build:
    """A plant; not compiled, which would take longer than the runs of these tests."""

    def built(chassis=CHASSIS, actuators=ACTUATORS, friction=Friction(0.85), step=1e-3, n=50) -> MultibodyPlant:  # type: ignore[no-untyped-def]  # noqa: B008
        with pytest.MonkeyPatch.context() as patch:
            return uncompiled(patch, lambda: MultibodyPlant(SEDAN, chassis, actuators, friction, step, n))

    return built


def ahead(speed: float) -> Array:
    """A vehicle state straight ahead at a speed [m/s]."""
    return np.array([speed, 0, 0, 0, 0, 0])


def push(force: float, steering: float = 0.0) -> Command:
    """The same force on every wheel [N]."""
    return Command(steering, np.full(4, force))


def drive(plant: MultibodyPlant | PlanarPlant, start: Array, commands: Sequence[Command]) -> tuple[PlantState, Trace]:
    """The state after one sample for each command, and the whole trace."""
    state, traces = plant.start(start), []
    for command in commands:
        state, trace = plant.advance(state, command)
        traces.append(trace)
    return state, Trace(*(np.concatenate([vars(trace)[name] for trace in traces]) for name in vars(traces[0])))


def test_the_integrator_has_second_order(build: Build) -> None:
    """Halving the step leaves a quarter of the distance to a solution on a step sixteen times as fine."""
    actuators, turn = replace(ACTUATORS, delay=0.0), [Command(0.05, np.array([-300.0, -200.0, -100.0, 0.0]))]
    fine, _ = drive(build(actuators=actuators, step=0.2 / 3200, n=3200), START, turn)
    errors = []
    for n in (100, 200, 400):
        end, _ = drive(build(actuators=actuators, step=0.2 / n, n=n), START, turn)
        errors.append(np.abs(end.vehicle - fine.vehicle).max())
    np.testing.assert_allclose(np.log2(np.array(errors[:-1]) / errors[1:]), 2.0, atol=0.2)
    assert errors[1] < 1e-5  # at 1 ms


def test_at_rest_it_stays_at_rest(build: Build) -> None:
    """Standing on its springs with nothing asked of it, the vehicle does not move by one bit."""
    state, trace = drive(build(), ahead(0.0), 20 * [push(0.0)])
    assert (state.vehicle == 0).all()
    np.testing.assert_allclose(trace.wheel_loads, np.broadcast_to(STATIC, (1000, 4)), rtol=1e-12)


@pytest.mark.parametrize("speed", [10.0, 20.0, 30.0])
def test_a_small_turn_has_the_understeer_of_the_tyres(build: Build, speed: float) -> None:
    """r = vx delta / (L + K vx^2), K = m / L (lr / Cf - lf / Cr), with cornering stiffnesses at the static loads."""
    state, _ = drive(build(NO_DRAG), ahead(speed), 100 * [push(0.0, 0.002)])
    front, rear = (2 * 0.85 * load * np.prod(factors(SEDAN.tyre, load)) for load in STATIC[[0, 2]])
    wheelbase = SEDAN.wheelbase
    understeer = SEDAN.mass / wheelbase * (SEDAN.cg_to_rear_axle / front - SEDAN.cg_to_front_axle / rear)
    vx = state.vehicle[0]
    assert state.vehicle[2] == pytest.approx(vx * 0.002 / (wheelbase + understeer * vx**2), rel=1e-3)


@pytest.mark.parametrize("speed", [10.0, 20.0, 30.0])
def test_gentle_driving_is_that_of_the_planar_plant(build: Build, speed: float) -> None:
    """Without what the planar plant lacks (height, relaxation, drag, lags), yaw rate and vy agree within 2 %."""
    commands = [push(0.0, 0.01 * np.sin(np.pi * k * 0.05)) for k in range(80)]
    _, full = drive(build(FLAT, IDEAL), ahead(speed), commands)
    with pytest.MonkeyPatch.context() as patch:
        planar = uncompiled(patch, lambda: PlanarPlant(SEDAN, 0.85, 1e-3, 50))
    _, flat = drive(planar, ahead(speed), commands)
    for column in (1, 2):
        difference = np.abs(full.states[:, column] - flat.states[:, column]).max()
        assert difference < 0.02 * np.abs(flat.states[:, column]).max()


def test_an_ideal_slip_controller_stops_within_the_friction(build: Build) -> None:
    """From 100 km/h with every wheel at the peak of its curve, the way is v^2 / (2 mu g) within 3 %."""
    plant, peak = build(actuators=IDEAL, n=1), np.tan(np.pi / (2 * NUMBERS.Cx)) / NUMBERS.Bx
    state, forces = plant.start(ahead(100 / 3.6)), np.zeros(4)
    while state.vehicle[0] > 0.5:
        state, trace = plant.advance(state, Command(0.0, forces))
        kappa = state.inner[SPIN] * SEDAN.wheel_radius / state.vehicle[0] - 1
        forces = np.minimum(trace.longitudinal[0] - 2e4 * (kappa + peak), 0.0)
    assert state.vehicle[4] == pytest.approx((100 / 3.6) ** 2 / (2 * 0.85 * GRAVITY), rel=0.03)


def test_wheels_lock_and_the_vehicle_stops_and_stays(build: Build) -> None:
    """Braked far beyond the friction, all wheels stand, slide to rest on a longer way, and the vehicle stays there."""
    state, trace = drive(build(actuators=IDEAL), ahead(20.0), 140 * [push(-12e3)])
    assert (state.inner[SPIN] == 0).all()
    assert state.vehicle[4] > 1.15 * 20.0**2 / (2 * 0.85 * GRAVITY)
    assert np.abs(trace.states[-1000:, 0]).max() < 0.01


def test_wheels_never_turn_backwards_by_braking(build: Build) -> None:
    """Friction brake and motor together stop a wheel on slippery road and never reverse it."""
    for mu in (0.05, 0.2):
        plant = build(friction=Friction(mu))
        state = plant.start(ahead(5.0))
        for _ in range(60):
            state, _ = plant.advance(state, push(-3000.0))
            assert (state.inner[SPIN] >= -1e-9).all()


def test_wheels_spin_up(build: Build) -> None:
    """Driven far beyond the friction from standstill, the wheels outrun the vehicle, which keeps less than mu g."""
    state, trace = drive(build(actuators=IDEAL), ahead(0.0), 20 * [push(8000.0)])
    assert (state.inner[SPIN] * SEDAN.wheel_radius > 3 * state.vehicle[0]).all()
    assert 5.0 < trace.acceleration[500, 0] < 0.85 * GRAVITY


@pytest.mark.parametrize("start", [[0, 5, 1, 0, 0, 0], [-5, 0, 0, 0, 0, 0], [15, 0.5, 0.3, 0, 0, 0]])
def test_it_comes_to_rest_from_any_side(build: Build, start: list[float]) -> None:
    """Braked while it slides sideways, rolls back or turns, the vehicle comes to rest without shaking."""
    state, trace = drive(build(), np.array(start, dtype=float), 120 * [push(-3000.0, 0.05)])
    assert np.abs(trace.states[:, :3]).max() <= max(np.abs(start)) * 1.01
    assert np.abs(state.vehicle[:3]).max() < 0.01


def test_split_friction_pulls_to_the_high_side(build: Build) -> None:
    """Braking straight with the left wheels on dry road and the right ones on ice turns the vehicle left."""
    for split, side in ((Friction.split(right=0.2, left=0.85), 1), (Friction.split(right=0.85, left=0.2), -1)):
        state, _ = drive(build(friction=split), ahead(25.0), 10 * [push(-2500.0)])
        assert state.vehicle[2] * side > 0.1


def test_each_wheel_finds_its_own_friction(build: Build) -> None:
    """On a patch that holds the front right wheel alone, that wheel alone has less force."""
    patch = Patch((0.5, 1e3), (-1.5, 0.0), 0.1)
    _, trace = drive(build(friction=Friction(0.85, (patch,))), ahead(20.0), 6 * [push(-2500.0)])
    used = np.abs(trace.longitudinal[100]) / trace.wheel_loads[100]
    assert used[1] < 0.11
    assert (used[[0, 2]] > 0.3).all()


def test_braking_and_cornering_move_the_load(build: Build) -> None:
    """In a steady state what moves is the inertia's moment over wheelbase or track; nobody told the plant."""
    height, m = CHASSIS.cg_height, SEDAN.mass
    _, trace = drive(build(NO_DRAG), ahead(30.0), 30 * [push(-1000.0)])
    front = trace.wheel_loads[-1, :2].sum() - STATIC[:2].sum()
    assert front == pytest.approx(-m * trace.acceleration[-1, 0] * height / SEDAN.wheelbase, rel=0.04)
    _, trace = drive(build(NO_DRAG), ahead(20.0), 80 * [push(0.0, 0.03)])
    right = trace.wheel_loads[-1, [1, 3]].sum() - STATIC[[1, 3]].sum()
    moved = m * trace.acceleration[-1, 1] * height / (2 * SEDAN.half_track)
    assert right == pytest.approx(moved, rel=0.06)  # and the body leans out, by what the springs give


def test_left_and_right_are_mirror_images(build: Build) -> None:
    """Started and commanded in the mirror, the plant moves in the mirror."""
    plant, forces = build(), np.array([-900.0, 100.0, 400.0, -50.0])
    here, _ = drive(plant, START, 4 * [Command(0.1, forces)])
    there, _ = drive(plant, START * MIRROR, 4 * [Command(-0.1, forces[[1, 0, 3, 2]])])
    np.testing.assert_allclose(there.vehicle, here.vehicle * MIRROR, rtol=1e-9, atol=1e-9)


def test_samples_are_only_a_way_to_count(build: Build) -> None:
    """Fifty steps in one sample or in ten, or one by one, end at the same bits, delayed commands included."""
    ends = [drive(build(n=n), START, (50 // n) * [push(-500.0, 0.1)])[0] for n in (50, 5, 1)]
    for end in ends[1:]:
        np.testing.assert_array_equal(end.vehicle, ends[0].vehicle)
        np.testing.assert_array_equal(end.inner, ends[0].inner)


def test_a_command_comes_after_its_delay(build: Build) -> None:
    """Steering starts to move after the delay, whether that is shorter or longer than a sample."""
    for delay in (0.0, 0.01, 0.12):
        actuators = replace(ACTUATORS, delay=delay, steering_lag=0.0, steering_rate_limit=np.inf)
        _, trace = drive(build(actuators=actuators), ahead(10.0), 4 * [push(0.0, 0.05)])
        assert np.argmax(trace.steering > 0) == round(delay / 1e-3) + 1
        assert trace.steering[-1] == 0.05


def test_a_delay_between_two_steps_is_refused(build: Build) -> None:
    """The message has the delay and the step."""
    with pytest.raises(ValueError, match=r"delay must be a whole number of plant steps of 0.001 s, got 0.0015 s"):
        build(actuators=replace(ACTUATORS, delay=1.5e-3))


def test_actuators_lag_and_keep_their_limits(build: Build) -> None:
    """Steering keeps its rate and lock; motors keep torque and power and brake first; friction brakes do the rest."""
    state, trace = drive(build(), ahead(15.0), 20 * [push(-5000.0, 2.0)])
    assert np.abs(np.diff(trace.steering)).max() <= 1.2 * 1e-3 * (1 + 1e-9)
    assert trace.steering[-1] == pytest.approx(SEDAN.steering_limit, rel=1e-3)
    plant = build(friction=Friction(1.2))
    state, _ = drive(plant, ahead(30.0), 8 * [Command(0.0, np.array([-5000.0, -5000.0, 0.0, 0.0]))])
    motor, brake, spin = (state.inner[part][:2] for part in (MOTOR, BRAKE, SPIN))
    np.testing.assert_allclose(motor, -ACTUATORS.motor_power_limit / spin, rtol=0.05)
    np.testing.assert_allclose(brake - motor, 5000.0 * SEDAN.wheel_radius, rtol=0.01)
    state, _ = drive(plant, ahead(5.0), 8 * [push(9000.0)])
    assert (state.inner[MOTOR] <= ACTUATORS.motor_torque_limit).all()
    assert (state.inner[BRAKE] == 0).all()


def test_any_command_gives_a_finite_motion(build: Build) -> None:
    """Whatever is commanded, from standstill to 50 m/s, the motion stays finite and no wheel is pulled to the road."""
    rng, plant = np.random.default_rng(3), build()
    for speed in (0.0, 0.3, 5.0, 50.0):
        commands = [Command(rng.uniform(-0.6, 0.6), rng.uniform(-8e3, 8e3, 4)) for _ in range(30)]
        state, trace = drive(plant, ahead(speed), commands)
        assert np.isfinite(state.inner).all()
        assert (trace.wheel_loads >= 0).all()


@pytest.mark.parametrize("broken", [np.nan, np.inf, 1e200])
@pytest.mark.parametrize("place", [0, 1, 2])
def test_a_motion_that_diverges_ends_in_nan(build: Build, broken: float, place: int) -> None:
    """From a state that no vehicle has, the plant goes on without an exception, to numbers that are none."""
    start = START.copy()
    start[place] = broken
    state, _ = drive(build(), start, 3 * [push(-100.0, 0.05)])
    assert not np.isfinite(state.vehicle).all()
