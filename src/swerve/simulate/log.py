"""What was recorded of a run: tables of columns, each with its unit."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import nan

import numpy as np
from numpy.typing import NDArray

from swerve.control import Plan
from swerve.conventions import INPUT_UNITS, INPUTS, STATE_UNITS, STATES, WHEELS
from swerve.plant import Trace
from swerve.signals import Command, DriverInput

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Table:
    """Columns of one length.

    Attributes:
        columns: name -> values (n,).
        units: name -> unit; "" for a column of words, "1" for a number without a dimension.
    """

    columns: Mapping[str, NDArray[np.generic]]
    units: Mapping[str, str]

    def __getitem__(self, name: str) -> Array:
        """The values (n,) of one column."""
        return np.asarray(self.columns[name])

    def stack(self, *names: str) -> Array:
        """Several columns side by side, (n, len(names))."""
        return np.column_stack([self[name] for name in names])


@dataclass(frozen=True, eq=False)
class Log:
    """A run as two tables.

    Attributes:
        motion: a row for each step of the plant: what the vehicle did.
        steps: a row for each step of the controller: what was commanded and why.
    """

    motion: Table
    steps: Table


def motion_table(time: Array, traces: Sequence[Trace]) -> Table:
    """The plant's traces, one after the other, at `time` (n,) [s]."""
    whole = {name: np.concatenate([getattr(trace, name) for trace in traces]) for name in vars(traces[0])}
    columns: dict[str, Array] = {"time": time, **dict(zip(STATES, whole["states"].T, strict=True))}
    units = {"time": "s", **dict(zip(STATES, STATE_UNITS, strict=True))}
    columns |= {"delta": whole["steering"], "ax": whole["acceleration"][:, 0], "ay": whole["acceleration"][:, 1]}
    units |= {"delta": "rad", "ax": "m/s^2", "ay": "m/s^2"}
    by_wheel = {
        "Fz": ("wheel_loads", "N"),
        "alpha": ("slip_angles", "rad"),
        "Fx": ("longitudinal", "N"),
        "Fy": ("lateral", "N"),
    }
    for symbol, (name, unit) in by_wheel.items():
        for i, wheel in enumerate(WHEELS):
            columns[f"{symbol}_{wheel}"], units[f"{symbol}_{wheel}"] = whole[name][:, i], unit
    return Table(columns, units)


def steps_table(
    time: Array,
    commands: Sequence[Command],
    plans: Sequence[Plan],
    step_times: Sequence[float],
    drivers: Sequence[DriverInput | None] = (),
) -> Table:
    """The controller's steps at `time` (n,) [s], with the time that each took [s] and what the driver asked for."""
    inputs = np.array([command.as_input() for command in commands])
    columns: dict[str, NDArray[np.generic]] = {"time": time, **dict(zip(INPUTS, inputs.T, strict=True))}
    units = {"time": "s", **dict(zip(INPUTS, INPUT_UNITS, strict=True))}
    columns["side"] = np.array([plan.side.name.lower() if plan.side else "" for plan in plans])
    columns["fallback"] = np.array([plan.fallback.value if plan.fallback else "" for plan in plans])
    columns["solver_failures"] = np.array([plan.solver_failures for plan in plans])
    units |= {"side": "", "fallback": "", "solver_failures": "1"}
    columns["branch"], units["branch"] = np.array([plan.name for plan in plans]), ""
    columns["reason"], units["reason"] = np.array([plan.reason for plan in plans]), ""
    columns["branches"], units["branches"] = np.array([_branches(plan) for plan in plans]), ""
    columns["active"], units["active"] = np.array([", ".join(plan.active) for plan in plans]), ""
    for i, wheel in enumerate(WHEELS):
        name = f"friction_use_{wheel}"
        columns[name], units[name] = np.array([plan.friction_use[i] for plan in plans]), "1"
    nobody = [None] * len(plans)
    asked = [(nan, nan) if each is None else (each.steering_angle, each.force) for each in drivers or nobody]
    columns["delta_driver"], columns["force_driver"] = np.array(asked).T
    units |= {"delta_driver": "rad", "force_driver": "N"}
    columns["step_time"], units["step_time"] = np.array(step_times), "s"
    return Table(columns, units)


def _branches(plan: Plan) -> str:
    """All that were tried, each with its cost and what it misses, as JSON."""
    keys = ("name", "cost", "violation", "off_road", "impact_speed")
    return json.dumps([{key: getattr(branch, key) for key in keys} for branch in plan.branches])
