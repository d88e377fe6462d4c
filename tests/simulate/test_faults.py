"""Faults of one step or a few, at every point of a run: the ladder of fallbacks holds, and is counted."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from swerve.control.unified import UnifiedController
from swerve.qp import Problem, Solution
from swerve.qp import solve as solve_really
from swerve.qp.solution import Status
from swerve.scenario import load
from swerve.signals import Measurement
from swerve.simulate import CONTROLLERS, Run, run
from swerve.simulate.assemble import sensor_of

N_STEPS = 28  # until the paper's obstacle is passed
FORCES = ("Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr")
KINDS = ("measurement", "solver", "deadline")


class Faults:
    """Faults of one kind in some steps of a run."""

    def __init__(self, kind: str, steps: range, overrides: tuple[str, ...] = ()) -> None:
        self.kind, self.steps = kind, steps
        self.scenario = load("paper", ("duration=1.4 s", *overrides))
        self.measure: Callable[..., Measurement] = sensor_of(self.scenario).measure
        self._is_faulty, self._time = False, 0.0

    def sense(self, time: float, *rest: Any) -> Measurement:
        """As ever, but for a state of nan."""
        self._is_faulty = round(time / 0.05) in self.steps
        good = self.measure(time, *rest)
        return replace(good, state=good.state * np.nan) if self._is("measurement") else good

    def solve(self, problem: Problem, *rest: Any, **named: Any) -> Solution:
        """As ever, or no answer."""
        if self._is("solver"):
            return Solution.without_answer(problem, Status.FAILED, 0, "none")
        return solve_really(problem, *rest, **named)

    def clock(self) -> float:
        """It stands still, or a second goes by between two looks at it."""
        self._time += self._is("deadline")
        return self._time

    def _is(self, kind: str) -> bool:
        return self._is_faulty and self.kind == kind


@pytest.fixture
def drive(monkeypatch: pytest.MonkeyPatch) -> Callable[[Faults], Run]:
    """A run of the unified controller on the planar plant, with faults."""
    build: Any = CONTROLLERS["unified"]

    def driven(faults: Faults) -> Run:
        monkeypatch.setattr("swerve.control.unified.improve.solve", faults.solve)
        clock = faults.clock if faults.kind == "deadline" else None

        def make(scenario: Any, plant: str) -> UnifiedController:
            return UnifiedController(build(scenario, plant)._formulation, clock)

        monkeypatch.setitem(CONTROLLERS, "unified", make)
        return run(faults.scenario, plant="planar", sense=faults.sense)

    return driven


def check(done: Run, faults: Faults) -> None:
    """Avoided, with a fallback in the faulty steps alone, and finite commands within the vehicle's limits."""
    assert [k for k, plan in enumerate(done.plans) if plan.fallback] == list(faults.steps)
    assert done.result.fallback_steps == len(faults.steps)
    assert done.result.outcome.value == "avoided"
    vehicle, given = faults.scenario.ego.to_vehicle(), done.log.steps
    largest = vehicle.force_limit * faults.scenario.road.friction * vehicle.mass * 9.81 / 2
    assert np.isfinite(given.stack("delta", *FORCES)).all()
    assert (np.abs(given["delta"]) <= vehicle.steering_limit).all()
    assert (np.abs(given.stack(*FORCES)).sum(axis=1) <= 2 * largest * (1 + 1e-9)).all()


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_one_fault_at_any_step_is_survived(kind: str, drive: Callable[[Faults], Run]) -> None:
    """In whichever step it is that fails, of any kind, the paper's obstacle is avoided with one fallback."""
    for first in range(N_STEPS):
        faults = Faults(kind, range(first, first + 1))
        check(drive(faults), faults)


@pytest.mark.slow
@pytest.mark.parametrize("n", range(2, 7))
def test_a_burst_at_any_time_is_survived(n: int, drive: Callable[[Faults], Run]) -> None:
    """Two to six faults in a row, one kind after the other, wherever they begin: a fallback each, and avoided."""
    for i, first in enumerate(range(0, N_STEPS - n + 1, 3)):
        faults = Faults(KINDS[(i + n) % len(KINDS)], range(first, first + n))
        check(drive(faults), faults)


@pytest.mark.parametrize("mode", ["steer-only", "brakes-only", "steer+friction-brakes"])
@pytest.mark.parametrize("kind", KINDS)
def test_a_fallback_keeps_to_the_mode(kind: str, mode: str, drive: Callable[[Faults], Run]) -> None:
    """From the very first step on, when there is no plan yet, a fallback commands only what there is."""
    done = drive(Faults(kind, range(3), (f"actuation.mode='{mode}'", "duration=0.3 s")))
    forces = done.log.steps.stack(*FORCES)[:3]
    assert done.result.fallback_steps == 3
    assert (forces == 0).all() if mode == "steer-only" else (forces < -1000).all()
    assert (done.log.steps["delta"][:3] == 0).all()


def test_braking_comes_where_the_plan_runs_into_something(drive: Callable[[Faults], Run]) -> None:
    """A plan that knew no obstacle is not followed into one: with no program solved, the measured obstacle is braked
    for; when nothing can be measured, the plan is all that is known.
    """
    appears = ("obstacles=[{position=[30,-40],velocity=[0,0],size=[3,30]}]",)

    def shows_up(faults: Faults) -> None:
        measure = faults.measure

        def moved(time: float, *rest: Any) -> Measurement:
            good = measure(time, *rest)
            ahead = tuple(replace(each, position=(30.0, 0.0)) for each in good.obstacles)
            return replace(good, obstacles=ahead) if round(time / 0.05) >= 4 else good

        faults.measure = moved

    for kind, brakes in (("solver", True), ("deadline", True), ("measurement", False)):
        faults = Faults(kind, range(4, 6), (*appears, "duration=0.3 s"))
        shows_up(faults)
        done = drive(faults)
        assert [plan.name == "full braking" for plan in done.plans[4:6]] == [brakes, brakes]
        assert (done.log.steps.stack(*FORCES)[4:6] < -2000).all() == brakes
