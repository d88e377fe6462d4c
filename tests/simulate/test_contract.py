"""What holds for every scenario of the library with every controller on every plant."""

from itertools import product

import numpy as np
import pytest

from swerve.conventions import GRAVITY
from swerve.scenario import library_names, load
from swerve.simulate import CONTROLLERS, PLANTS, run

DURATION = "duration=1 s"
ONE_FRICTION = "planar"  # has one friction for all wheels: it refuses a road with patches
MEMBERS = [
    (scenario, controller, plant)
    for scenario, controller, plant in product(library_names(), CONTROLLERS, PLANTS)
    if not (plant == ONE_FRICTION and load(scenario).road.patches)
]
QUIET = [name for name in library_names() if name in ("far-away", "beside-the-lane") or name.startswith("quiet-")]
# What holding the speed may take: the planar plant rolls freely, the multibody one has resistances.
STEERING_AT_REST = {"planar": 1e-6, "multibody": 1e-4}  # [rad]
FORCE_AT_REST = {"planar": 1.0, "multibody": 300.0}  # [N]


@pytest.mark.parametrize(("scenario", "controller", "plant"), MEMBERS)
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
    heaviest = np.maximum.accumulate(loads)  # a command that is held was within its limit when it was given
    assert (forces <= vehicle.force_limit * grip * heaviest * (1 + 1e-3)).all()
    assert loads.sum(axis=1).mean() == pytest.approx(vehicle.mass * GRAVITY, rel=0.02)
    for name in motion.columns:
        np.testing.assert_array_equal(motion[name], again.log.motion[name], err_msg=name)
    assert done.result.steps == settings.n_samples


@pytest.mark.parametrize(("scenario", "controller", "plant"), [*product(QUIET, CONTROLLERS, PLANTS)])
def test_without_a_threat_nothing_is_done(scenario: str, controller: str, plant: str) -> None:
    """Past what is far away or beside the lane it goes straight on: no steering, no wheel force, no decision."""
    done = run(load(scenario), controller, plant)
    assert done.result.decision == "none"
    assert np.abs(done.log.steps["delta"]).max() < STEERING_AT_REST[plant]
    assert np.abs(done.log.steps.stack("Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr")).max() < FORCE_AT_REST[plant]
    assert (done.result.fallback_steps, done.result.solver_failures) == (0, 0)
