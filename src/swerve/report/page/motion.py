"""What the vehicle did, down-sampled for display.

The torque of a wheel is Fx Rt. The rows are evenly spaced, and those in which a result was measured are among them: the
largest value that a chart shows is the one that the result tells.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import WHEELS
from swerve.report.page.rounding import ANGLE, FORCE, MILLIMETRE, SHARE, TIME, rounded
from swerve.simulate import Run, Table
from swerve.simulate.friction_use import friction_use_of
from swerve.simulate.outcome import n_sane, sideslip
from swerve.world import clearance

Array = NDArray[np.float64]

MOST_ROWS = 1000  # evenly spaced ones
FINEST = 0.01  # between two of them [s]


@dataclass(frozen=True, eq=False)
class Motion:
    """A run's motion on the plant's time grid, as far as it is one.

    Attributes:
        time: (n,) [s].
        poses: X, Y, psi of the centre of gravity (n, 3) [m, m, rad].
        columns: name -> (n,), in SI: delta, speed, r, beta, clearance (nan without obstacles).
        wheels: name -> (n, 4): Fx, Fy, Fz, torque, use.
    """

    time: Array
    poses: Array
    columns: dict[str, Array]
    wheels: dict[str, Array]

    @classmethod
    def of(cls, run: Run) -> "Motion":
        """Read the log; a run that diverged is cut before the first row that is no motion."""
        logged, vehicle = run.log.motion, run.scenario.ego.to_vehicle()
        states = logged.stack("vx", "vy", "r", "psi", "X", "Y")
        n = max(1, n_sane(states))
        time, states, poses = logged["time"][:n], states[:n], logged.stack("X", "Y", "psi")[:n]
        wheels = {name: _by_wheel(logged, name)[:n] for name in ("Fx", "Fy", "Fz")}
        wheels["torque"] = wheels["Fx"] * vehicle.wheel_radius
        wheels["use"] = friction_use_of(run.scenario, logged, n)
        columns = {
            "delta": logged["delta"][:n],
            "speed": np.hypot(states[:, 0], states[:, 1]),
            "r": states[:, 2],
            "beta": sideslip(states),
            "clearance": _clearance(run, poses, time),
        }
        return cls(time, poses, columns, wheels)

    @property
    def closest(self) -> int | None:
        """The row of the smallest clearance, the first of several; None without obstacles."""
        gaps = self.columns["clearance"]
        return None if np.isnan(gaps).all() else int(np.nanargmin(gaps))

    def to_json(self) -> dict[str, Any]:
        """The rows that are shown; of what a wheel has, a list for each wheel."""
        rows = self._shown()
        columns = {name: rounded(values[rows], _DECIMALS[name]) for name, values in self.columns.items()}
        wheels = {name: rounded(values[rows].T, _DECIMALS[name]) for name, values in self.wheels.items()}
        place = {name: rounded(self.poses[rows, i], decimals) for i, (name, decimals) in enumerate(_POSE)}
        return {"time": rounded(self.time[rows], TIME), **place, **columns, **wheels}

    def _shown(self) -> NDArray[np.intp]:
        span = self.time[-1] - self.time[0]
        n = int(np.clip(round(span / FINEST), 1, MOST_ROWS))
        even = np.searchsorted(self.time, self.time[0] + np.linspace(0, span, n + 1) - 1e-9)
        extremes = [0 if self.closest is None else self.closest]
        for values in (*self.columns.values(), self.poses[:, 1], *self.wheels["use"].T):
            if not np.isnan(values).all():
                extremes += [int(np.nanargmin(values)), int(np.nanargmax(values))]
        return np.unique(np.clip(np.concatenate([even, extremes]), 0, len(self.time) - 1)).astype(np.intp)


_POSE = (("X", MILLIMETRE), ("Y", MILLIMETRE), ("psi", ANGLE))
_DECIMALS = {
    "delta": 5,
    "speed": 4,
    "r": 5,
    "beta": 5,
    "clearance": 4,
    "Fx": FORCE,
    "Fy": FORCE,
    "Fz": FORCE,
    "torque": 1,
    "use": SHARE,
}


def _by_wheel(logged: Table, name: str) -> Array:
    return logged.stack(*(f"{name}_{wheel}" for wheel in WHEELS))


def _clearance(run: Run, poses: Array, time: Array) -> Array:
    """To the nearest obstacle (n,) [m]; nan without obstacles."""
    footprint = run.scenario.ego.to_footprint()
    gaps = [clearance(footprint, poses, each.to_world(), time) for each in run.scenario.obstacles]
    nearest: Array = np.min(gaps, axis=0) if gaps else np.full(len(time), np.nan)
    return nearest
