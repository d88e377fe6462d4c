"""Modes and failures in whole runs: the controller keeps to what there is, and the plant has what failed."""

from collections.abc import Callable
from dataclasses import replace
from math import radians
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from swerve.errors import InputError
from swerve.scenario import load
from swerve.signals import Command, Measurement
from swerve.simulate import PLANTS, Run, run
from swerve.simulate.assemble import actuation_of, sensor_of
from swerve.simulate.failures import Failures

WALL = ("obstacles=[{position=[45,0],size=[2.5,12]}]", "ego.speed=16.7", "goal.speed=16.7")
FORCES = ("Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr")
SETTINGS = {
    "steer-only": ("actuation.mode='steer-only'",),
    "steer+friction-brakes": ("actuation.mode='steer+friction-brakes'",),
    "no-drive": ("actuation.mode='no-drive'",),
    "a wheel failed": ("actuation.failed_wheels=['fl']",),
    "two wheels failed": ("actuation.failed_wheels=['fl','rl']",),
    "steering stuck": ("actuation.steering_stuck='2 deg'",),
}


def blinded(*overrides: str) -> Callable[..., Measurement]:
    """The paper's sensing, with a state of nan in every fourth step and the next."""
    measure = sensor_of(load("paper", overrides)).measure

    def sense(time: float, *rest: Any) -> Measurement:
        good = measure(time, *rest)
        return replace(good, state=good.state * np.nan) if round(time / 0.05) % 4 < 2 else good

    return sense


def commands(done: Run) -> NDArray[np.float64]:
    """The inputs (n, 5) that were commanded."""
    return done.log.steps.stack("delta", *FORCES)


@pytest.mark.parametrize("case", SETTINGS)
@pytest.mark.parametrize("is_blinded", [False, True])
def test_every_command_is_within_the_mode(case: str, is_blinded: bool) -> None:
    """The paper's obstacle is avoided in each mode, and no step, a fallback's neither, commands what does not exist."""
    scenario = load("paper", ("duration=2 s", *SETTINGS[case]))
    done = run(scenario, plant="planar", sense=blinded() if is_blinded else None)
    assert (done.result.fallback_steps > 0) == is_blinded
    if not is_blinded:
        assert done.result.outcome.value == "avoided"
    actuation, given = actuation_of(scenario, "planar"), commands(done)
    np.testing.assert_allclose(actuation.within(given, np.full(5, 1e5)), given, rtol=1e-12, atol=1e-9)
    np.testing.assert_array_equal(
        given[:, ~actuation.basis.any(axis=1)] - actuation.fixed[~actuation.basis.any(axis=1)], 0
    )


def test_steering_alone_avoids_without_any_force() -> None:
    """With "steer-only" no wheel force is ever commanded, and the paper's obstacle at 25 m is passed on a side."""
    done = run(load("paper", SETTINGS["steer-only"]), plant="planar")
    assert (commands(done)[:, 1:] == 0).all()
    assert done.result.outcome.value == "avoided"
    assert done.result.decision == "steer-left"


@pytest.mark.parametrize("plant", PLANTS)
@pytest.mark.parametrize("mode", ["brakes-only", "steer+friction-brakes", "no-drive"])
def test_brakes_alone_stop_before_a_wall(mode: str, plant: str) -> None:
    """45 m before a wall, at 16.7 m/s, a vehicle without drive torque stops, and never asks for any."""
    done = run(load("paper", (*WALL, f"actuation.mode='{mode}'")), plant=plant)
    assert done.result.outcome.value == "avoided"
    assert done.result.speed.final < 0.2
    assert commands(done)[:, 1:].max() <= 0
    if mode == "brakes-only":
        assert (commands(done)[:, 0] == 0).all()
    if mode == "steer+friction-brakes":
        forces = commands(done)[:, 1:]
        np.testing.assert_array_equal(forces[:, [0, 2]], forces[:, [1, 3]])


@pytest.mark.parametrize("plant", PLANTS)
@pytest.mark.parametrize("known", ["true", "false"])
def test_a_failure_is_the_plant_s(plant: str, known: str) -> None:
    """A failed wheel has no force that is worth one, a stuck steering its angle; only a controller that was told
    commands accordingly.
    """
    failed = ("actuation.failed_wheels=['fl']", f"actuation.known={known}", "duration=1.2 s")
    done = run(load("paper", failed), plant=plant)
    rolling = 200.0  # [N] of a wheel that is spun up or down by the road alone
    assert np.abs(done.log.motion["Fx_fl"]).max() < rolling
    assert np.abs(done.log.motion["Fx_fr"]).max() > 5 * rolling
    assert (commands(done)[:, 1] == 0).all() == (known == "true")

    stuck = ("actuation.steering_stuck='1 deg'", f"actuation.known={known}", "duration=1.2 s")
    done = run(load("paper", stuck), plant=plant)
    np.testing.assert_allclose(done.log.motion["delta"][400:], radians(1), rtol=1e-3)
    assert (commands(done)[:, 0] == radians(1)).all() == (known == "true")


def test_being_told_is_worth_it() -> None:
    """Full braking with a wheel that fails unknown turns the vehicle; told of it, the controller stops it straight."""
    failed = (*WALL, "actuation.failed_wheels=['fl']")
    told, untold = (
        run(load("paper", (*failed, f"actuation.known={known}")), plant="planar") for known in ("true", "false")
    )
    assert told.result.outcome.value == "avoided"
    assert told.result.max_sideslip < 0.1 < untold.result.max_sideslip


def test_a_failure_changes_what_acts_and_not_what_was_commanded() -> None:
    """The command stays as it was given; what acts lacks the failed wheels, and has the stuck angle."""
    command = Command(0.1, np.array([1.0, 2.0, 3.0, 4.0]))
    acting = Failures((1, 2), -0.02).acting(command)
    np.testing.assert_array_equal(acting.as_input(), [-0.02, 1.0, 0.0, 0.0, 4.0])
    np.testing.assert_array_equal(command.as_input(), [0.1, 1.0, 2.0, 3.0, 4.0])
    assert Failures().acting(command) is command


@pytest.mark.parametrize("overrides", [("actuation.mode='no-drive'",), ("actuation.failed_wheels=['fl']",)])
def test_a_controller_of_all_inputs_refuses_a_mode(overrides: tuple[str, ...]) -> None:
    """The controller as-printed knows no modes: it says so, and runs when the failure is not told."""
    with pytest.raises(InputError, match=r"as-printed knows no (no-drive|failures); take unified"):
        run(load("paper", overrides), "as-printed", "planar")
    untold = ("actuation.failed_wheels=['fl']", "actuation.known=false", "duration=0.2 s")
    assert run(load("paper", untold), "as-printed", "planar").result.steps == 4


BASELINES = [
    ("brake", ("actuation.mode='brakes-only'",)),
    ("brake", ("actuation.mode='steer+friction-brakes'",)),
    ("brake", ("actuation.failed_wheels=['fl']",)),
    ("brake", ("actuation.steering_stuck='1 deg'",)),
    ("hierarchical", ("actuation.mode='no-drive'",)),
    ("hierarchical", ("actuation.mode='steer+friction-brakes'",)),
    ("nonlinear", ("actuation.mode='no-drive'",)),
]


@pytest.mark.parametrize(("controller", "overrides"), BASELINES)
def test_a_baseline_keeps_to_the_modes_that_it_takes(controller: str, overrides: tuple[str, ...]) -> None:
    """With the paper's obstacle, which it brakes or steers for, and blinded now and then, so that it falls back."""
    scenario = load("paper", ("duration=1.5 s", *overrides))
    done = run(scenario, controller, "planar", sense=blinded())
    actuation, given = actuation_of(scenario, "planar"), commands(done)
    assert done.result.fallback_steps > 0
    assert np.abs(given).max() > 0.01
    np.testing.assert_allclose(actuation.within(given, np.full(5, 1e5)), given, rtol=1e-12, atol=1e-3)


@pytest.mark.parametrize("wall", [(), ("actuation.mode='steer+friction-brakes'",)])
def test_the_emergency_brake_knows_what_its_brakes_reach(wall: tuple[str, ...]) -> None:
    """With a single brake demand, worth 80 % until the load has moved, it stops before a wall, too."""
    done = run(load("paper", (*WALL, *wall)), "brake", "planar")
    assert done.result.outcome.value == "avoided"
    assert done.result.decision == "brake"


@pytest.mark.parametrize(
    ("controller", "overrides", "message"),
    [
        ("brake", ("actuation.mode='steer-only'",), "brake has nothing to brake with"),
        ("brake", ("actuation.failed_wheels=['fl','fr','rl','rr']",), "brake has nothing to brake with"),
        ("hierarchical", ("actuation.mode='brakes-only'",), "hierarchical knows no brakes-only"),
        ("hierarchical", ("actuation.steering_stuck=0",), "hierarchical knows no failures"),
        ("nonlinear", ("actuation.mode='steer+friction-brakes'",), "nonlinear knows no steer\\+friction-brakes"),
        ("nonlinear", ("actuation.failed_wheels=['rl']",), "nonlinear knows no failures"),
    ],
)
def test_a_baseline_refuses_what_it_does_not_know(controller: str, overrides: tuple[str, ...], message: str) -> None:
    """In one line that says what would be right."""
    with pytest.raises(InputError, match=message) as refused:
        run(load("paper", overrides), controller, "planar")
    assert "; take unified, or " in str(refused.value)


@pytest.mark.parametrize(
    ("overrides", "message"),
    [
        (("actuation.mode='steer'",), "actuation.mode: unknown mode 'steer'"),
        (("actuation.failed_wheels=['fx']",), "unknown wheel 'fx'"),
        (("actuation.failed_wheels=['fl','fl']",), "actuation.failed_wheels: names fl twice"),
        (("actuation.known=false",), "actuation.known: means nothing without a failure"),
        (("actuation.steering_stuck='40 deg'",), "actuation.steering_stuck: 0.698132 rad is beyond the vehicle's"),
        (
            ("actuation.mode='steer-only'", "actuation.steering_stuck=0"),
            "actuation.mode: steer-only with these",
        ),
    ],
)
def test_settings_that_make_no_sense_are_refused(overrides: tuple[str, ...], message: str) -> None:
    """Each wrong setting ends with a line that names the key and what would be right."""
    with pytest.raises(InputError) as refused:
        load("paper", overrides)
    assert message in str(refused.value)
