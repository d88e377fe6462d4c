"""The measurements, each as a table; limits are printed beside what was measured and hold nothing up."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from operator import attrgetter, methodcaller
from typing import Final

import numpy as np

from bench import map as parallel
from bench import multibody, peers, processes, unified
from bench.statistic import Statistic
from bench.stopwatch import Step
from bench.table import Cell, Table, in_ms
from swerve.control.nonlinear import SOLVERS
from swerve.qp import SOLVERS as QP_SOLVERS
from swerve.scenario import Scenario, load
from swerve.simulate import Result

N_RUNS: Final = 5  # of the unified controller, and of each process
N_REPLAYS: Final = 2  # of each peer
N_REPEATS: Final = 3  # of each quadratic program
TIMES: Final = ("median", "p99", "max")
STEP_LIMITS: Final = (2.0, 8.0, 25.0)  # [ms]
WALL_LIMITS: Final = {"import swerve": 0.8, "swerve run paper": 3.0, "swerve run paper --plant planar": 3.0}  # [s]
LEAST_REAL_TIME: Final = 500.0  # of the multibody plant [1]
LEAST_SHARE: Final = 0.9  # of two plain processes' gain, that a map's second worker has [1]
SIDES: Final[Mapping[str, Callable[[Step], float]]] = {
    "left": lambda step: step.parts["solve"][0],
    "right": lambda step: step.parts["solve"][1],
}


def tables() -> Iterator[Table]:
    """All of them, each when it is measured."""
    scenario = load("paper")
    yield _step(scenario)
    yield _kernels(scenario)
    yield _quadratic_programs(scenario)
    yield from _peers(scenario)
    yield _plants()
    yield _processes()
    yield _workers()


def _step(scenario: Scenario) -> Table:
    runs = unified.steps(scenario, N_RUNS)
    whole = sum(step.duration for steps in runs for step in steps)

    def row(name: str, time: Callable[[Step], float], calls: float | None) -> list[Cell]:
        share = sum(time(step) for steps in runs for step in steps) / whole
        return [name, *in_ms(_typical(runs, time)), 100 * share, calls]

    n_steps = sum(len(steps) for steps in runs)
    rows = []
    for part in unified.PARTS:
        n_calls = sum(len(step.parts.get(part, ())) for steps in runs for step in steps)
        rows.append(row(part, methodcaller("total", part), n_calls / n_steps))
    rows += [row("rest", attrgetter("rest"), None), row("step", attrgetter("duration"), None)]
    rows.append(["limit", *STEP_LIMITS, None, None])
    title = f"Unified controller's step, paper's scenario, closed loop, all ways, median of {N_RUNS} runs [ms]"
    return Table("unified_step", title, ("part", *TIMES, "share in %", "calls"), rows)


def _kernels(scenario: Scenario) -> Table:
    calls = unified.kernel_calls(scenario)
    rows: list[list[Cell]] = [[name, *in_ms(kernel), in_ms(method)[0]] for name, (kernel, method) in calls.items()]
    return Table("kernels", "Calls of compiled kernels [ms]", ("kernel", *TIMES, "median with numpy"), rows)


def _quadratic_programs(scenario: Scenario) -> Table:
    recorded = unified.problems(scenario)
    variables = np.median([problem.gradient.size for problem in recorded])
    rows_of = np.median([problem.row_lower.size for problem in recorded])
    rows: list[list[Cell]] = [[name, *in_ms(unified.solver_times(recorded, name, N_REPEATS))] for name in QP_SOLVERS]
    size = f"{len(recorded)} of them, {variables:.0f} variables and {rows_of:.0f} rows in the median"
    return Table("quadratic_programs", f"Quadratic programs of one run, {size}, cold [ms]", ("solver", *TIMES), rows)


def _peers(scenario: Scenario) -> Iterator[Table]:
    measured = unified.measured(scenario)
    scenarios = {solver: peers.with_solver(scenario, solver) for solver in SOLVERS}
    rows: list[list[Cell]] = []
    for solver, each in scenarios.items():
        controller = peers.nonlinear_controller(each)
        replays = [peers.replay(controller, measured) for _ in range(N_REPLAYS)]
        runs = [replay.steps for replay in replays]
        unsolved = max(replay.n_unsolved for replay in replays)
        for name, time in SIDES.items():
            rows.append([f"{solver} {name}", *in_ms(_typical(runs, time)), None])
        rows.append([f"{solver} both", *in_ms(_typical(runs, methodcaller("total", "solve"))), float(unsolved)])
    title = f"Full nonlinear program, compiled, on the same measurements, median of {N_REPLAYS} replays [ms]"
    yield Table("nonlinear_program", title, ("solver and side", *TIMES, "unsolved"), rows)
    yield _closed_loops(scenario, scenarios)


def _closed_loops(scenario: Scenario, peer_scenarios: Mapping[str, Scenario]) -> Table:
    results = {"unified": unified.drive(scenario).result}
    results |= {solver: peers.closed_loop(each) for solver, each in peer_scenarios.items()}
    rows = [_numbers(name, result) for name, result in results.items()]
    columns = ("controller", "outcome", "decision", "smallest sqrt(rho)", "largest |Y| [m]", "unsolved")
    return Table("closed_loops", "Each in a closed loop of its own", columns, rows)


def _numbers(name: str, result: Result) -> list[Cell]:
    """What was decided, smallest sqrt(rho), largest |Y| [m], and programs without a solution."""
    offset = max(-result.lateral_offset.min, result.lateral_offset.max)
    reached = [result.min_distance_ratio, offset, float(result.solver_failures)]
    return [name, result.outcome.value, result.decision, *reached]


def _plants() -> Table:
    speeds = multibody.speeds(N_RUNS)
    rows: list[list[Cell]] = [[name, each.real_time, each.kernel, each.yaw_rate] for name, each in speeds.items()]
    rows.append(["limit of multibody", LEAST_REAL_TIME, None, None])
    columns = ("plant", "speed", "kernel alone", "last yaw rate [rad/s]")
    return Table("plants", "Step steer of 5 s at 1 ms, seconds simulated in a second of the processor", columns, rows)


def _processes() -> Table:
    rows = [[name, time, WALL_LIMITS.get(name)] for name, time in processes.wall_times(N_RUNS).items()]
    return Table("processes", f"Processes by the clock, the best of {N_RUNS} [s]", ("command", "time", "limit"), rows)


def _workers() -> Table:
    gains = parallel.gains()
    share = gains.of_map / gains.of_machine
    rows: list[list[Cell]] = [
        ["time with one worker [s]", gains.maps[0], None],
        ["time with two workers [s]", gains.maps[1], None],
        ["gain of two workers over one", gains.of_map, None],
        ["gain of two busy processes over one", gains.of_machine, None],
        ["share of that gain", share, LEAST_SHARE],
    ]
    return Table("map_workers", "A map of twelve boundaries, all rounds of it", ("", "measured", "least"), rows)


def _typical(runs: Sequence[Sequence[Step]], time: Callable[[Step], float]) -> Statistic:
    """The statistic of a time over the steps of each run, typical of the runs."""
    return Statistic.typical([Statistic.of([time(step) for step in steps]) for steps in runs])
