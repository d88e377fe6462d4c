"""What commands print: the result of a run as JSON, as a table and as a drawing, and the ablation."""

import json
from collections.abc import Mapping
from math import degrees

from swerve.report.console import PLAIN, Console
from swerve.report.track import track
from swerve.simulate import Outcome, Result, Run
from swerve.study.ablation import Ablation


def result_json(result: Result) -> str:
    """The result as one JSON object on one line."""
    return json.dumps(result.to_json(), allow_nan=False)


def run_summary(run: Run, console: Console) -> str:
    """A run for people: its table, and below it the manoeuvre from above, where there is room for it."""
    drawing = track(run, console.width, console.charset, console.paint)
    return result_table(run.result, console) + (f"\n\n{drawing}\n" if drawing else "")


def result_table(result: Result, console: Console = PLAIN) -> str:
    """The result for people: a row each for what was decided, how near it came and what it took."""
    values = result.to_json()  # where a number that is not finite is None
    lost = result.divergence
    offset, speed, step_time = values["lateral_offset"], values["speed"], values["step_time"]
    verdict = console.paint("good" if result.outcome is Outcome.AVOIDED else "bad", result.outcome.value)
    rows = {
        "scenario": f"{result.scenario}, {result.controller} on {result.plant}, seed {result.seed}",
        "outcome": f"{verdict}: {result.outcome.sentence}",
        **({} if lost is None else {"diverged": f"at {lost.time:.3f} s, from {_state(lost.last)}"}),
        "decision": result.decision,
        "distance ratio": f"{_number(values['min_distance_ratio'], digits=3)} at the least (1 is contact)",
        "clearance": f"{_number(values['min_clearance'], 'm', digits=3)} at the least",
        "lateral offset": f"{_range(offset, 'm')}, {_number(offset['final'], 'm')} at the end",
        "speed": f"{_range(speed, 'm/s')} ({_range(speed, 'km/h', 3.6)})",
        "sideslip": f"{_number(values['max_sideslip'], 'deg', degrees(1))} at the most",
        "steps": f"{result.steps}: {result.fallback_steps} fallback, {result.solver_failures} solver failures",
        "step time": f"{_number(step_time['median'], 'ms', 1e3)} median, {_number(step_time['p99'], 'ms', 1e3)} p99",
    }
    return "\n".join(f"{name:<16}{text}" for name, text in rows.items())


def _state(values: Mapping[str, float]) -> str:
    return ", ".join(f"{name} {value:.3g}" for name, value in values.items())


def ablation_table(ablation: Ablation) -> str:
    """The ablation, a line for each variant, with a group of columns for each scene."""
    width = max(len(row.variant.name) for row in ablation.rows)
    groups = [" " * width, *(f"{scene.name:<29}" for scene in ablation.scenes)]
    columns = [" " * width, *["outcome    ratio steer failed"] * len(ablation.scenes)]
    lines = [groups, columns]
    lines += [[f"{row.variant.name:<{width}}", *map(_ablation_cells, row.results)] for row in ablation.rows]
    legend = (
        "ratio: smallest sqrt(rho), 1 is contact; steer: largest steering angle [deg];",
        "failed: steps that were answered by the fallback / programs without a solution",
    )
    return "\n".join([*("  ".join(line).rstrip() for line in lines), "", *legend])


def _ablation_cells(result: Result) -> str:
    values = result.to_json()
    ratio = _number(values["min_distance_ratio"], digits=3)
    steer = _number(values["max_steer"], factor=degrees(1), digits=1)
    failed = f"{result.fallback_steps}/{result.solver_failures}"
    return f"{result.outcome.value:<9}{ratio:>7}{steer:>6}{failed:>7}"


def _number(value: float | None, unit: str = "", factor: float = 1.0, digits: int = 2) -> str:
    return "none" if value is None else f"{value * factor:.{digits}f} {unit}".strip()


def _range(values: Mapping[str, float | None], unit: str, factor: float = 1.0) -> str:
    return f"{_number(values['min'], factor=factor)} to {_number(values['max'], unit, factor)}"
