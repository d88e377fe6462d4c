"""A plan tells the truth about itself."""

from functools import cache
from typing import Any

import numpy as np
import pytest

from swerve.control import Plan
from swerve.control.plan import Passing
from swerve.control.unified import Formulation
from swerve.scenario import load
from swerve.simulate import run
from swerve.vehicle.tyre import factors, magic_formula
from swerve.world import Ellipse, Obstacle, Rectangle, Steady, clearance
from tests.control.unified.situations import (
    AHEAD,
    BOX_CAR,
    LANES,
    RUNNING,
    controller,
    empty,
    formulation,
    random_start,
    seen,
)
from tests.vehicle.motions import DRY, STATIC, move

CAR = Obstacle(Rectangle(4.5, 1.8), Steady((22.0, 0.3)))
SECOND = Obstacle(Rectangle(4.5, 1.8), Steady((34.0, 3.5)))


@cache
def answers() -> tuple[tuple[Plan, Any], ...]:
    """Plans and what was measured, over states and scenes of all kinds, at first sight."""
    random = np.random.default_rng(3)
    cases = []
    for obstacles in ((AHEAD,), (CAR,), (CAR, SECOND), (SECOND,), ()):
        for of in ((), (*BOX_CAR, *LANES)):
            for state in (RUNNING, random_start(random)):
                measurement = empty(0.0, state, *obstacles)
                plan = controller(*of).step(measurement, controller(*of).start())[1]
                cases.append((plan, (measurement, obstacles, formulation(*of))))
    return tuple(cases)


def test_every_plan_has_a_reason_and_its_branches() -> None:
    """Where something is in the path there are several ways, one of them the brake, and the taken one is among them."""
    for plan, (measurement, obstacles, _) in answers():
        assert plan.reason
        assert plan.time == measurement.time
        assert plan.name in [branch.name for branch in plan.branches]
        assert len({branch.passing for branch in plan.branches}) == len(plan.branches) >= 1
        assert all(len(branch.passing) == len(obstacles) for branch in plan.branches)
        if plan.name != "keep" and len(plan.branches) > 1:
            assert "brake" in [branch.name for branch in plan.branches]


def test_a_side_is_that_of_a_plan_an_obstacle_shapes() -> None:
    """Braking and keeping on have no side, a swerve has that of its name."""
    for plan, _ in answers():
        if plan.side is not None:
            assert plan.is_shaped
            assert plan.name.startswith(plan.side.name.lower())
        if plan.name in ("brake", "keep"):
            assert plan.side is None


def test_a_way_that_nothing_shapes_has_no_side() -> None:
    """An obstacle in the path that is still too far to ask for anything has a way by its name, and no side."""
    far = Obstacle(Ellipse((0.3, 0.3)), Steady((120.0, 0.0)))
    fast = RUNNING * 1.5
    calm = ("goal.speed=30 m/s",)
    _, plan, memory = controller(*calm).step(seen(0.0, fast, far), controller(*calm).start())
    assert memory.threats == (0,)
    assert (plan.is_shaped, plan.side) == (False, None)
    np.testing.assert_allclose(plan.inputs / [1, 1e3, 1e3, 1e3, 1e3], 0.0, atol=1e-3)


def test_branches_are_where_they_go() -> None:
    """The first pose is the measured one, and the path that is drawn of the branch that is taken is the plan's."""
    for plan, (measurement, _, _) in answers():
        for branch in plan.branches:
            np.testing.assert_allclose(branch.poses[0], measurement.state[[4, 5, 3]])
            assert np.isfinite(branch.poses).all()
            assert len(branch.poses) > 41
        taken = [branch for branch in plan.branches if branch.name == plan.name]
        assert any(np.array_equal(branch.poses[:41:2], plan.states[:, [4, 5, 3]]) for branch in taken)


def _apart(formula: Formulation, poses: np.ndarray, obstacle: Obstacle) -> float:
    return float(clearance(formula.place.footprint, poses, obstacle, np.zeros(len(poses))).min())


def test_a_branch_is_as_clear_as_it_says() -> None:
    """No violation is no contact, by brute force, all along horizon and tail; an impact speed is a contact's."""
    n_clear, n_hit = 0, 0
    for plan, (_, obstacles, formula) in answers():
        for branch in plan.branches:
            apart = min((_apart(formula, branch.poses[1:], each) for each in obstacles), default=np.inf)
            if branch.violation <= 0.005:
                n_clear += 1
                assert apart > 0
                assert branch.impact_speed is None
            if branch.impact_speed is not None:
                n_hit += 1
                assert branch.violation > 0.005
                assert 0 <= branch.impact_speed < 45
            if apart == 0:
                assert branch.violation > 0
    assert n_clear > 10
    assert n_hit > 0


def test_a_branch_is_as_far_off_the_road_as_it_says() -> None:
    """The outermost corner of the footprint, by brute force, against the edges with their margin."""
    for plan, (_, _, formula) in answers():
        road, x_y = formula.place.road, formula.place.footprint.outline()
        for branch in plan.branches:
            if road.left_edge is None:
                assert branch.off_road == 0.0
                continue
            _, y, psi = branch.poses[1:].T
            corners = y[:, np.newaxis] + np.outer(np.sin(psi), x_y[:, 0]) + np.outer(np.cos(psi), x_y[:, 1])
            beyond = max(corners.max() - road.left_edge, (road.right_edge or 0.0) - corners.min())
            assert branch.off_road == pytest.approx(max(0.0, beyond + formula.place.margin), abs=1e-9)


def test_friction_use_is_the_friction_ellipses() -> None:
    """Of each wheel's mu Fz what longitudinal force and the lateral one that is left beside it take together."""
    checked = 0
    for plan, (measurement, _, _) in answers():
        state, u = plan.states[0], plan.inputs[0]
        slips = move(state, u, STATIC).slip_angles
        for i in range(4):
            demand = abs(magic_formula(DRY, slips[i], STATIC[i])) / factors(DRY, STATIC[i])[2]
            share = abs(u[1 + i]) / (0.85 * measurement.wheel_loads[i])
            wanted = np.hypot(share, demand * np.sqrt(1 - share**2))
            assert plan.friction_use[i] == pytest.approx(wanted, abs=2e-3)
            checked += 0.05 < wanted < 0.95
        assert ((plan.friction_use >= 0) & (plan.friction_use <= 1 + 1e-9)).all()
    assert checked > 10


def test_what_is_active_holds_the_plan() -> None:
    """Names are those of limits and inputs; an input that is named is at its limit; an empty road has no obstacle."""
    known = {"slip", "lane", "left edge", "right edge", "steering lock", *(f"obstacle {i}" for i in range(2))}
    known |= {f"force {wheel}" for wheel in ("fl", "fr", "rl", "rr")}
    seen_names = set()
    for plan, (_, obstacles, _) in answers():
        seen_names |= set(plan.active)
        assert set(plan.active) <= known
        assert len(set(plan.active)) == len(plan.active)
        for i, wheel in enumerate(("fl", "fr", "rl", "rr")):
            at_limit = abs(plan.inputs[0, 1 + i]) >= 0.999 * 0.95 * 0.85 * STATIC[i]
            assert (f"force {wheel}" in plan.active) == at_limit
        if not obstacles:
            assert not any("obstacle" in name for name in plan.active)
    assert any("obstacle" in name for name in seen_names)


def test_impact_speed_is_how_fast_it_closes_in() -> None:
    """Too near to brake or steer: the impact speed of the brake is by the closed form, from speed and distance."""
    wall = Obstacle(Rectangle(2.0, 60.0), Steady((14.0, 0.0)))
    _, plan, _ = controller().step(seen(0.0, RUNNING, wall), controller().start())
    (brake,) = (branch for branch in plan.branches if branch.name == "brake")
    best = np.sqrt(20.0**2 - 2 * 0.85 * 9.81 * 13.0)
    assert brake.impact_speed is not None
    assert best - 0.5 <= brake.impact_speed <= 16.0
    assert plan.name == "brake"
    assert "impact" in plan.reason


def test_impact_speed_is_relative() -> None:
    """Against a wall that comes towards it the impact is faster by the wall's speed, away from it slower."""
    speeds = []
    for wall_speed in (-5.0, 0.0, 5.0):
        wall = Obstacle(Rectangle(2.0, 60.0), Steady((9.0, 0.0), (wall_speed, 0.0)))
        _, plan, _ = controller().step(seen(0.0, RUNNING, wall), controller().start())
        (brake,) = (branch for branch in plan.branches if branch.name == "brake")
        speeds.append(brake.impact_speed or 0.0)
    assert speeds[0] > speeds[1] + 3 > speeds[2] + 5


def test_a_run_tells_every_step() -> None:
    """Through a run each plan has a reason, finite friction use, and branches that pass the one obstacle."""
    plans = run(load("paper", ["duration=1.5 s"]), plant="planar").plans
    for plan in plans:
        assert plan.reason
        assert np.isfinite(plan.friction_use).all()
        assert {branch.passing for branch in plan.branches} <= {(each,) for each in Passing}
    assert plans[0].is_shaped
    assert not any(branch.name == "keep" for branch in plans[0].branches)
    assert isinstance(AHEAD.shape, Ellipse)
