"""What holds for the library's scenes with every controller on every plant.

All scenes with all controllers, each driven twice, would take some ten minutes, and the baselines would meet in
most of them what they met in another. So `unified` drives all scenes, and the others one scene of each kind; which
controller it is makes no difference to a second run, so only those scenes are driven again. One second is enough: the
first steps decide, and the plans are at their limits then. `nonlinear` compiles a program for each number of outlines
to keep apart, which takes seconds for a point among ellipses and far longer for rectangles, so these are slow.
"""

from collections.abc import Iterator, Mapping
from typing import Final

import numpy as np
import pytest

from swerve.conventions import GRAVITY
from swerve.scenario import Scenario, library_names, load
from swerve.simulate import CONTROLLERS, PLANTS, Run, run

DURATION = "duration=1 s"
ONE_FRICTION = "planar"  # has one friction for all wheels: it refuses a road with patches
KINDS: Final = (
    "paper",  # at rest
    "pedestrian-crossing",  # moving
    "left-blocked",  # several
    "oncoming-overtaker",  # lanes
    "quiet-next-lane",
)
SMOOTH: Final = ("paper", "slower-lead", "far-away")  # a point among ellipses
RECTANGLES: Final = ("quiet-next-lane",)
DRIVEN: Final[Mapping[str, tuple[str, ...]]] = {
    "unified": tuple(library_names()),
    "nonlinear": (*SMOOTH, *RECTANGLES),
    "driver": (*KINDS, "driver-too-late"),
}
QUIET = [name for name in library_names() if name in ("far-away", "beside-the-lane") or name.startswith("quiet-")]
# What holding the speed may take: the planar plant rolls freely, the multibody one has resistances.
STEERING_AT_REST = {"planar": 1e-6, "multibody": 1e-4}  # [rad]
FORCE_AT_REST = {"planar": 1.0, "multibody": 300.0}  # [N]


def members(of: Mapping[str, tuple[str, ...]], others: tuple[str, ...]) -> Iterator[object]:
    """Scene, controller and plant of each case: the scenes of a controller are those in `of`, else the `others`."""
    for controller in CONTROLLERS:
        for scene in of.get(controller, others):
            for plant in PLANTS:
                if plant == ONE_FRICTION and load(scene).road.patches:
                    continue
                is_slow = controller == "nonlinear" and scene not in SMOOTH
                yield pytest.param(scene, controller, plant, marks=[pytest.mark.slow] if is_slow else [])


@pytest.mark.parametrize(("scenario", "controller", "plant"), [*members(DRIVEN, KINDS)])
def test_every_scenario_runs_with_every_controller(scenario: str, controller: str, plant: str) -> None:
    """Motion and commands are finite, commands are within the vehicle's limits, plans tell what was decided."""
    settings = load(scenario, [DURATION])
    done = run(settings, controller, plant)
    assert_within_limits(done, settings)
    assert done.result.steps == settings.n_samples
    for plan in done.plans:
        assert plan.name
        assert plan.side is None or plan.is_shaped
        for branch in plan.branches:
            assert len(branch.passing) == len(settings.obstacles)
            assert branch.violation >= 0 and branch.off_road >= 0


@pytest.mark.parametrize(
    ("scenario", "controller", "plant"), [*members({"unified": KINDS, "nonlinear": SMOOTH[:1]}, KINDS[:2])]
)
def test_a_second_run_is_the_same(scenario: str, controller: str, plant: str) -> None:
    """Bit by bit, from the same words."""
    one, other = (run(load(scenario, [DURATION]), controller, plant).log.motion for _ in range(2))
    for name in one.columns:
        np.testing.assert_array_equal(one[name], other[name], err_msg=name)


def assert_within_limits(done: Run, settings: Scenario) -> None:
    """Motion and commands."""
    vehicle, grip = settings.ego.to_vehicle(), settings.road.friction
    motion, steps = done.log.motion, done.log.steps
    assert all(np.isfinite(column).all() for column in motion.columns.values())
    assert (np.abs(steps["delta"]) <= vehicle.steering_limit + 1e-9).all()
    forces = np.abs(steps.stack("Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr"))
    loads = motion.stack("Fz_fl", "Fz_fr", "Fz_rl", "Fz_rr")[:: settings.n_substeps][: len(forces)]
    heaviest = np.maximum.accumulate(loads)  # a command that is held was within its limit when it was given
    assert (forces <= vehicle.force_limit * grip * heaviest * (1 + 1e-3)).all()
    assert loads.sum(axis=1).mean() == pytest.approx(vehicle.mass * GRAVITY, rel=0.02)


@pytest.mark.parametrize(
    ("scenario", "controller", "plant"),
    [*members({"unified": tuple(QUIET), "nonlinear": ("far-away",)}, tuple(QUIET[:2]))],
)
def test_without_a_threat_nothing_is_done(scenario: str, controller: str, plant: str) -> None:
    """Past what is far away or beside the lane it goes straight on: no steering, no wheel force, no decision."""
    done = run(load(scenario), controller, plant)
    assert done.result.decision == "none"
    assert np.abs(done.log.steps["delta"]).max() < STEERING_AT_REST[plant]
    assert np.abs(done.log.steps.stack("Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr")).max() < FORCE_AT_REST[plant]
    assert (done.result.fallback_steps, done.result.solver_failures) == (0, 0)
