"""What holds for every scenario of the library with every controller on every plant."""

from itertools import product

import numpy as np
import pytest

from swerve.conventions import GRAVITY
from swerve.scenario import library_names, load
from swerve.simulate import CONTROLLERS, PLANTS, run

DURATION = "duration=1.5 s"
QUIET = ["far-away", "beside-the-lane"]


@pytest.mark.parametrize(("scenario", "controller", "plant"), [*product(library_names(), CONTROLLERS, PLANTS)])
def test_every_scenario_runs_with_every_controller(scenario: str, controller: str, plant: str) -> None:
    """Motion and commands are finite, commands are within the vehicle's limits, and a second run is the same."""
    settings = load(scenario, [DURATION])
    done, again = (run(settings, controller, plant) for _ in range(2))
    vehicle, grip = settings.ego.to_vehicle(), settings.road.friction
    motion, steps = done.log.motion, done.log.steps
    assert all(np.isfinite(column).all() for column in motion.columns.values())
    assert (np.abs(steps["delta"]) <= vehicle.steering_limit + 1e-9).all()
    forces = np.abs(steps.stack("Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr"))
    loads = motion.stack("Fz_fl", "Fz_fr", "Fz_rl", "Fz_rr")[:: settings.n_substeps][: len(forces)]
    assert (forces <= vehicle.force_limit * grip * loads * (1 + 1e-6)).all()
    assert loads.sum(axis=1) == pytest.approx(vehicle.mass * GRAVITY)
    for name in motion.columns:
        np.testing.assert_array_equal(motion[name], again.log.motion[name], err_msg=name)
    assert done.result.steps == settings.n_samples


@pytest.mark.parametrize(("scenario", "controller", "plant"), [*product(QUIET, CONTROLLERS, PLANTS)])
def test_without_a_threat_nothing_is_done(scenario: str, controller: str, plant: str) -> None:
    """Past what is far away or beside the lane the vehicle goes straight on: no steering, no wheel force, no decision."""
    done = run(load(scenario), controller, plant)
    assert done.result.decision == "none"
    assert np.abs(done.log.steps["delta"]).max() < 1e-6
    assert np.abs(done.log.steps.stack("Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr")).max() < 1.0
    assert (done.result.fallback_steps, done.result.solver_failures) == (0, 0)


@pytest.mark.parametrize("scenario", [name for name in library_names() if name not in QUIET])
def test_the_library_is_avoided(scenario: str) -> None:
    """The default controller gets through every scenario of the library without a contact, to its end."""
    result = run(load(scenario)).result
    assert result.outcome.value == "avoided"
    assert result.min_distance_ratio is None or result.min_distance_ratio >= 1.0
    assert (result.fallback_steps, result.solver_failures) == (0, 0)
