"""Measured characteristic values against what can be worked out without a simulation."""

from math import pi, sin

import numpy as np
import pytest

from swerve.conventions import GRAVITY
from swerve.study.manoeuvres import (
    BrakingInATurn,
    SineWithDwell,
    SplitFrictionBraking,
    SteadyCircle,
    StepSteer,
    run_manoeuvre,
)
from swerve.study.manoeuvres.manoeuvre import Car, Measures
from swerve.vehicle import vehicle_named
from swerve.vehicle.steady_state import cornering_stiffness

SEDAN = vehicle_named("d-class-sedan")
MU = 0.85


def understeer() -> float:
    """K = m / L (lr / Cf - lf / Cr) [rad s^2/m], with the slope of eq. (3) at the static loads, by differences."""
    v, h = SEDAN, 1e-6
    stiffness = []
    for arm in (v.cg_to_rear_axle, v.cg_to_front_axle):
        load = v.mass * GRAVITY * arm / (2 * v.wheelbase)
        b, c, d = (getattr(v.tyre, f"{x}0") + getattr(v.tyre, f"{x}1") * load for x in "bcd")
        stiffness.append(2 * MU * load * d * np.sin(c * np.arctan(b * h)) / h)
    assert cornering_stiffness(v, MU) == pytest.approx(stiffness, rel=1e-6)
    return float(v.mass / v.wheelbase * (v.cg_to_rear_axle / stiffness[0] - v.cg_to_front_axle / stiffness[1]))


def test_a_slow_circle_has_the_understeer_gradient_of_the_linear_car() -> None:
    """At a few tenths of m/s^2, understeer gradient and yaw rate gain are those of the closed form."""
    circle = SteadyCircle(acceleration_rate=0.05, largest_acceleration=0.6, linear_range=0.5)
    measures = run_manoeuvre(circle, SEDAN, "planar").measures
    v, gradient = circle.speed, understeer()
    assert measures["understeer_gradient"].value == pytest.approx(gradient, rel=0.05)
    assert measures["yaw_rate_gain"].value == pytest.approx(v / (SEDAN.wheelbase + gradient * v**2), rel=0.01)


def test_the_limit_of_the_circle_is_the_friction() -> None:
    """No more lateral acceleration than mu g, and most of it."""
    for plant in ("planar", "multibody"):
        most = run_manoeuvre(SteadyCircle(), SEDAN, plant).measures["largest_lateral_acceleration"].value
        assert 0.85 * MU * GRAVITY < most < MU * GRAVITY


def test_a_small_step_has_the_yaw_rate_of_the_linear_car() -> None:
    """r / delta = v / (L + K v^2) after a step to 0.3 m/s^2."""
    step = StepSteer(lateral_acceleration=0.3)
    measures = run_manoeuvre(step, SEDAN, "planar").measures
    v = step.speed
    assert measures["yaw_rate_gain"].value == pytest.approx(v / (SEDAN.wheelbase + understeer() * v**2), rel=0.01)


def test_sine_with_dwell_has_the_shape_of_the_standard() -> None:
    """0.7 Hz; a rest of 500 ms at the end of the third quarter; back after 1 / 0.7 + 0.5 s; zero before and after."""
    manoeuvre = SineWithDwell()
    start, period = manoeuvre.steering_time, 1 / 0.7
    assert manoeuvre.completion - start == pytest.approx(period + 0.5)
    for since in np.linspace(0.0, 0.75 * period, 50):
        assert manoeuvre.shape(start + since) == pytest.approx(sin(2 * pi * 0.7 * since), abs=1e-12)
    for since in np.linspace(0.75 * period, 0.75 * period + 0.5, 20):
        assert manoeuvre.shape(start + since) == pytest.approx(-1.0)
    for since in np.linspace(0.75 * period, period, 20):
        assert manoeuvre.shape(start + since + 0.5) == pytest.approx(sin(2 * pi * 0.7 * since), abs=1e-12)
    assert manoeuvre.shape(start - 1e-6) == manoeuvre.shape(manoeuvre.completion + 1e-6) == 0.0


def test_sine_with_dwell_follows_its_multiple_of_a() -> None:
    """On the planar plant, whose steering has no lag, the road wheels are at each sample where the shape says."""
    manoeuvre = SineWithDwell(amplitude=2.0)
    run = run_manoeuvre(manoeuvre, SEDAN, "planar")
    angle = 2.0 * run.measures["characteristic_steering"].value
    wanted = [angle * manoeuvre.shape(time) for time in run.motion["time"][::10]]
    np.testing.assert_allclose(run.motion["delta"][9::10], wanted, atol=1e-12)


def test_sine_with_dwell_passes_gently_and_fails_hard() -> None:
    """Without stability control, 1 A is stable and not far enough, and 5 A is far enough and not stable."""
    gentle, hard = (run_manoeuvre(SineWithDwell(amplitude=a), SEDAN).measures for a in (1.0, 5.0))
    assert _verdicts(gentle) == (1.0, 0.0, 0.0)
    assert _verdicts(hard) == (0.0, 1.0, 0.0)


def _verdicts(measures: Measures) -> tuple[float, ...]:
    return tuple(measures[name].value for name in ("is_stable", "is_responsive", "passed"))


def test_the_way_to_rest_is_that_of_the_braking() -> None:
    """On one friction, v^2 / (2 share mu g) on the planar plant, where forces act at once."""
    braking = SplitFrictionBraking(friction=0.8, low_friction=0.8)
    run = run_manoeuvre(braking, SEDAN, "planar")
    expected = braking.speed**2 / (2 * braking.brake_share * 0.8 * GRAVITY)
    assert run.measures["stopping_distance"].value == pytest.approx(expected, rel=0.005)
    assert run.measures["yaw_moment"].value == pytest.approx(0.0, abs=1e-6)
    assert run.measures["final_heading"].value == pytest.approx(0.0, abs=1e-9)


def test_split_friction_turns_the_car_to_the_side_that_grips() -> None:
    """The right wheels brake harder: moment, yaw rate, heading and offset are to the right."""
    braking = SplitFrictionBraking()
    measures = run_manoeuvre(braking, SEDAN, "multibody").measures
    most = SEDAN.half_track * braking.brake_share * (0.8 - 0.3) * SEDAN.mass * GRAVITY / 2
    assert -most < measures["yaw_moment"].value < -0.5 * most
    for name in ("yaw_rate", "heading", "lateral_offset"):
        assert measures[name].value < 0


def test_wheels_know_the_friction_under_them() -> None:
    """In the driver's command each wheel has its own side's share of the load it carries."""
    braking = SplitFrictionBraking()
    run = run_manoeuvre(braking, SEDAN, "multibody")
    after = np.searchsorted(run.motion["time"], braking.braking_time + 0.3)
    for wheel, mu in (("fl", 0.3), ("fr", 0.8), ("rl", 0.3), ("rr", 0.8)):
        force, load = run.motion[f"Fx_{wheel}"][after], run.motion[f"Fz_{wheel}"][after]
        assert force == pytest.approx(-braking.brake_share * mu * load, rel=0.15)


def test_a_turn_is_steady_before_the_brakes_and_slows_as_asked() -> None:
    """5 m/s^2 on about 100 m before; then the way of the deceleration that was asked for, on both plants."""
    for plant in ("planar", "multibody"):
        braking = BrakingInATurn()
        measures = run_manoeuvre(braking, SEDAN, plant).measures
        assert measures["radius"].value == pytest.approx(100.0, rel=0.05)
        assert measures["initial_lateral_acceleration"].value == pytest.approx(5.0, rel=0.05)
        assert measures["mean_deceleration"].value == pytest.approx(braking.deceleration, rel=0.05)
        assert 0.5 < measures["yaw_rate_ratio"].value < 1.1


def test_the_car_is_what_the_driver_was_told() -> None:
    """The run keeps vehicle, plant and road, so that its numbers can be told apart."""
    run = run_manoeuvre(StepSteer(friction=0.7), SEDAN, "planar")
    assert run.car == Car(SEDAN, "planar", StepSteer(friction=0.7).road())
