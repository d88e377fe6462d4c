"""The loop: sense, control, move; one call each a sample, everything logged with its unit."""

import json
import math
from typing import Any

import numpy as np
import pytest

from swerve.errors import InputError
from swerve.plant import PlanarPlant, PlantState, Trace
from swerve.scenario import Scenario, load
from swerve.signals import Command
from swerve.simulate import CONTROLLERS, DEFAULT_CONTROLLER, DEFAULT_PLANT, PLANTS, Outcome, first_contact, run
from tests.simulate.recordings import COAST, FakeController

SHORT = ("duration=0.52 s",)


@pytest.fixture
def fake(monkeypatch: pytest.MonkeyPatch) -> list[FakeController]:
    """The controller `fake`, and those that were made of it."""
    made: list[FakeController] = []

    def make(scenario: Scenario, plant: str) -> FakeController:
        made.append(FakeController(scenario))
        return made[-1]

    monkeypatch.setitem(CONTROLLERS, "fake", make)
    return made


class Counted(PlanarPlant):
    """The planar plant; notes its calls."""

    calls: list[tuple[PlantState, Command]]

    def advance(self, state: PlantState, command: Command) -> tuple[PlantState, Trace]:
        """As ever."""
        self.calls.append((state, command))
        return super().advance(state, command)


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> list[tuple[PlantState, Command]]:
    """Calls of the plant `counted`."""
    monkeypatch.setattr(Counted, "calls", [], raising=False)
    monkeypatch.setitem(
        PLANTS,
        "counted",
        lambda scenario: Counted(
            scenario.ego.to_vehicle(), scenario.road.friction, scenario.plant.step, scenario.n_substeps
        ),
    )
    return Counted.calls


def test_the_controller_is_asked_once_a_sample(fake: list[FakeController]) -> None:
    """In 0.52 s there are eleven samples of 50 ms, each with its own time, state and memory."""
    done = run(load("slower-lead", SHORT), "fake", "planar")
    calls = fake[0].calls
    assert len(calls) == done.result.steps == len(done.plans) == 11
    assert [memory for _, memory in calls] == list(range(11))
    times = [measurement.time for measurement, _ in calls]
    np.testing.assert_allclose(times, np.arange(11) * 0.05)
    assert [measurement.stamp for measurement, _ in calls] == times
    for k, (measurement, _) in enumerate(calls):
        np.testing.assert_allclose(measurement.state, [25.0, 0, 0, 0, 25 * k * 0.05, 0], atol=1e-9)
        assert measurement.obstacles[0].position == pytest.approx((25.0 + 10.0 * k * 0.05, 0.0))
        assert measurement.obstacles[0].velocity == (10.0, 0.0)
        assert measurement.wheel_loads.sum() == pytest.approx(1530 * 9.81)


def test_the_plant_moves_with_the_command_held(fake: list[FakeController], counted: list[Any]) -> None:
    """Each sample is one call of the plant, from where the last one ended, with that sample's command."""
    done = run(load("paper", SHORT), "fake", "counted")
    assert len(counted) >= 11
    assert all(command is fake[0].command for _, command in counted)
    for k in range(11):
        row = done.log.motion.stack("vx", "vy", "r", "psi", "X", "Y")[50 * k]
        np.testing.assert_array_equal(counted[k][0].vehicle, row)
        np.testing.assert_array_equal(fake[0].calls[k][0].state, row)


@pytest.mark.parametrize(("step", "rows"), [("1 ms", 551), ("10 ms", 56), ("50 ms", 12)])
def test_the_log_has_a_row_for_each_step_and_one_for_the_end(fake: list[FakeController], step: str, rows: int) -> None:
    """The plant's clock divides the controller's; both tables have their clock, from zero to the last instant."""
    done = run(load("paper", (*SHORT, f"plant.step={step}")), "fake", "planar")
    time = done.log.motion["time"]
    assert len(time) == rows
    np.testing.assert_allclose(time, np.linspace(0.0, 0.55, rows), atol=1e-12)
    np.testing.assert_allclose(done.log.steps["time"], np.arange(11) * 0.05)
    assert all(len(column) == rows for column in done.log.motion.columns.values())
    assert all(len(column) == 11 for column in done.log.steps.columns.values())


@pytest.mark.parametrize("controller", CONTROLLERS)
def test_every_column_has_its_unit(controller: str) -> None:
    """Each column is in the table of units and the other way round, and each unit is one that SI has."""
    done = run(load("paper", SHORT), controller, "planar")
    known = {"s", "m", "m/s", "m/s^2", "rad", "rad/s", "N", "1", ""}
    for table in (done.log.motion, done.log.steps):
        assert list(table.columns) == list(table.units)
        assert set(table.units.values()) <= known
        for name, unit in table.units.items():
            assert (table[name].dtype.kind in "US") == (unit == ""), name


def test_the_motion_is_named_wheel_by_wheel() -> None:
    """Loads, slip angles and forces stand under the wheels' names, in the order FL FR RL RR."""
    done = run(load("paper", (*SHORT, "ego.parameters.cg_height=0.5 m", "obstacles=[]")), "unified", "planar")
    for symbol, unit in {"Fz": "N", "alpha": "rad", "Fx": "N", "Fy": "N"}.items():
        assert [done.log.motion.units[f"{symbol}_{wheel}"] for wheel in ("fl", "fr", "rl", "rr")] == [unit] * 4
    loads = done.log.motion.stack("Fz_fl", "Fz_fr", "Fz_rl", "Fz_rr")[0]
    np.testing.assert_allclose(loads, [4508.189, 4508.189, 2996.461, 2996.461], atol=1e-3)


def test_the_log_keeps_what_was_commanded(fake: list[FakeController]) -> None:
    """Steering angle and wheel forces of a step are those of its command; the road wheels follow on the plant's
    grid.
    """
    scenario = load("paper", SHORT)
    fake_command = Command(0.02, np.array([1.0, 2.0, 3.0, 4.0]))

    def make(scenario: Scenario, plant: str) -> FakeController:
        return FakeController(scenario, fake_command)

    CONTROLLERS["fake"] = make  # taken back by the fixture
    done = run(scenario, "fake", "planar")
    np.testing.assert_array_equal(
        done.log.steps.stack("delta", "Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr")[3], [0.02, 1, 2, 3, 4]
    )
    assert (done.log.motion["delta"] == 0.02).all()
    np.testing.assert_allclose(done.log.motion.stack("Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr")[20], [1, 2, 3, 4])


def test_every_branch_is_in_the_log() -> None:
    """Name, cost and faults of all that was tried stand beside what was taken, with the reason and what holds it."""
    done = run(load("paper", SHORT), "unified", "planar")
    steps = done.log.steps
    assert (steps["side"] != "").any()
    for k, plan in enumerate(done.plans):
        assert steps["branch"][k] == plan.name
        assert steps["reason"][k] == plan.reason
        assert steps["active"][k] == ", ".join(plan.active)
        assert steps["side"][k] == (plan.side.name.lower() if plan.side else "")
        told = json.loads(steps["branches"][k])
        assert [each["name"] for each in told] == [branch.name for branch in plan.branches]
        assert [each["cost"] for each in told] == [branch.cost for branch in plan.branches]


def test_progress_is_a_share(fake: list[FakeController]) -> None:
    """Progress is told after every sample, grows, and ends at 1."""
    told: list[float] = []
    run(load("paper", SHORT), "fake", "planar", progress=told.append)
    np.testing.assert_allclose(told, np.arange(1, 12) / 11)


def test_a_run_ends_where_motion_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    """When the plant's state stops being finite the run is over: no exception, no warning, diverged."""
    broken = Command(math.nan, np.full(4, math.nan))
    monkeypatch.setitem(CONTROLLERS, "fake", lambda scenario, plant: FakeController(scenario, broken))

    class Breaking(Counted):
        def advance(self, state: PlantState, command: Command) -> tuple[PlantState, Trace]:
            end, trace = PlanarPlant.advance(self, state, COAST)
            late = state.vehicle[4] > 5.0
            return (PlantState(end.vehicle * math.nan, end.wheel_loads, end.inner) if late else end), trace

    monkeypatch.setitem(
        PLANTS,
        "breaking",
        lambda scenario: Breaking(
            scenario.ego.to_vehicle(), scenario.road.friction, scenario.plant.step, scenario.n_substeps
        ),
    )
    done = run(load("paper"), "fake", "breaking")
    assert done.result.outcome.value == "diverged"
    assert done.result.steps == len(done.log.steps["time"]) == 7
    assert len(done.log.motion["time"]) == 7 * 50 + 1
    assert np.isnan(done.log.motion["X"][-1])
    assert done.result.to_json()["final_yaw_rate"] is None


@pytest.mark.parametrize("controller", CONTROLLERS)
def test_the_same_seed_gives_the_same_bits(controller: str) -> None:
    """Two runs agree to the last bit in every column but the time that a step took."""
    first, second = (run(load("paper", ("duration=1.2 s",)), controller, "planar", seed=3) for _ in range(2))
    assert first.result.seed == 3
    for one, other in ((first.log.motion, second.log.motion), (first.log.steps, second.log.steps)):
        for name in one.columns:
            if name != "step_time":
                np.testing.assert_array_equal(one[name], other[name], err_msg=name)


@pytest.mark.parametrize(
    ("controller", "plant", "words"), [("unifed", DEFAULT_PLANT, "unified"), (DEFAULT_CONTROLLER, "planer", "planar")]
)
def test_an_unknown_name_is_wrong_input(controller: str, plant: str, words: str) -> None:
    """A controller or plant that there is not is refused with the nearest right name."""
    with pytest.raises(InputError, match=f"did you mean {words}"):
        run(load("paper"), controller, plant)


def test_a_run_can_end_with_its_first_contact(fake: list[FakeController]) -> None:
    """It has all of the sample in which the coasting vehicle touches and nothing after; up to there it is the same."""
    scenario = load("paper", ["duration=2.5 s"])
    whole, ended = (run(scenario, "fake", "planar", until=each) for each in (None, first_contact(scenario)))
    assert (ended.result.outcome, ended.result.impact_speed) == (whole.result.outcome, whole.result.impact_speed)
    assert ended.result.outcome is Outcome.COLLIDED
    n = len(ended.log.motion["X"]) - 1
    assert n % scenario.n_substeps == 0
    reached = ended.log.motion["X"][[n - scenario.n_substeps, n]]
    edge = float(scenario.obstacles[0].to_world().position_at(0.0)[0]) - 2.0
    assert reached[0] < edge <= reached[1]
    np.testing.assert_array_equal(ended.log.motion["X"][:n], whole.log.motion["X"][:n])
