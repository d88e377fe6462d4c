"""The equations of motion against conservation laws and statics that were worked out without them."""

import numpy as np
import pytest

from swerve.conventions import GRAVITY
from swerve.vehicle.multibody.model import N_MULTIBODY, SPIN
from tests.vehicle.multibody.cars import LOSSLESS, NUMBERS, SEDAN, STATIC, carried, glide, move, wild_start


def test_it_starts_at_rest() -> None:
    """With all at its place, nothing moves: springs and tyres carry just the weight."""
    motion = move(np.zeros(N_MULTIBODY))
    np.testing.assert_allclose(motion.derivative, 0.0, atol=1e-12)
    np.testing.assert_allclose(motion.loads, STATIC, rtol=1e-14)


def test_static_loads_are_those_of_the_lever() -> None:
    """Front m g lr / (2 L), rear m g lf / (2 L)."""
    front = SEDAN.mass * GRAVITY * SEDAN.cg_to_rear_axle / (2 * SEDAN.wheelbase)
    rear = SEDAN.mass * GRAVITY * SEDAN.cg_to_front_axle / (2 * SEDAN.wheelbase)
    np.testing.assert_allclose(move(np.zeros(N_MULTIBODY)).loads, [front, front, rear, rear], rtol=1e-12)


def test_energy_is_conserved_without_friction_and_dampers() -> None:
    """Bouncing, rolling, pitching and yawing on ice, the vehicle keeps its energy."""
    energy = [carried(x, LOSSLESS).energy for x in glide(wild_start(), 1.0, LOSSLESS)]
    assert np.ptp(energy) < 1e-8 * energy[0]


def test_momentum_is_conserved_on_ice() -> None:
    """Horizontal momentum stays, and so does the angular momentum about the vertical, dampers or not."""
    for p in (LOSSLESS, NUMBERS._replace(drag=0.0, rolling=0.0)):
        states = [carried(x, p) for x in glide(wild_start(), 0.5, p)]
        assert np.ptp([s.momentum[:2] for s in states], axis=0).max() < 1e-6
        assert np.ptp([s.turning for s in states]) < 1e-6 * abs(states[0].turning)


def test_in_flight_only_weight_acts() -> None:
    """Thrown up, it falls with g, and its angular momentum about the centre of gravity stays, dampers or not."""
    p = NUMBERS._replace(drag=0.0, rolling=0.0)
    states = glide(wild_start(height=3.0), 0.4, p)
    assert all((move(x, p=p).loads == 0).all() for x in states)
    parts = [carried(x, p) for x in states]
    assert np.ptp([part.spin for part in parts], axis=0).max() < 1e-6
    fallen = parts[0].momentum[2] - parts[-1].momentum[2]
    assert fallen == pytest.approx(SEDAN.mass * GRAVITY * 0.4, rel=1e-9)


def test_dampers_take_energy() -> None:
    """With its dampers the same motion loses energy all the time."""
    p = NUMBERS._replace(drag=0.0, rolling=0.0)
    energy = [carried(x, p).energy for x in glide(wild_start(), 0.5, p)]
    assert (np.diff(energy) < 0).all()


def test_power_of_the_tyres_is_what_the_vehicle_loses() -> None:
    """With sliding tyres and nothing else, energy falls by the power of torques less what slides and what winds up."""
    x = wild_start()
    x[24:28] = 0.0  # free rolling: every force is zero, whatever slides
    motion = move(x, p=LOSSLESS)
    np.testing.assert_allclose([*motion.longitudinal, *motion.lateral], 0.0, atol=1e-9)
    torques = np.array([300.0, -200.0, 100.0, 50.0])
    rate = 1e-6
    before, after = (carried(x + k * rate * move(x, torques=torques, p=LOSSLESS).derivative, LOSSLESS) for k in (-1, 1))
    # a motor works on the wheel and, backwards, on its carrier, which turns with the body
    body_rate = x[11] * np.cos(x[8]) + x[2] * np.sin(x[8]) * np.cos(x[9])
    power = torques @ (x[SPIN] - body_rate)
    assert (after.energy - before.energy) / (2 * rate) == pytest.approx(power, rel=1e-4)
