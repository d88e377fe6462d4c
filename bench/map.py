"""What a second worker gains a map, against what a second plain process gains on the same machine in the same minutes.

    gain of the map = time with one worker / time with two
    gain of the machine = 2 * time of one busy process / time of two beside one another

The workers' start, a second or two whatever the size of the map, is left out. The machine's gain is that of plain
loops, measured before, between and after the maps; shared cores, caches and clocks make it less than two.
"""

import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

import numpy as np

from swerve.scenario import load
from swerve.study.map import MapSettings, Store, cells_of, engine, run_missing

BUSY: Final = "for _ in range(40_000_000): pass"
TOLERANCE: Final = 0.5  # [m]


@dataclass(frozen=True)
class Gains:
    """Measured in one go.

    Attributes:
        times: of the map [s], by the number of workers.
        machine: gain of two plain processes over one [1].
    """

    times: dict[int, float]
    machine: float

    @property
    def map(self) -> float:
        """Gain of two workers over one [1]."""
        return self.times[1] / self.times[2]


def gains() -> Gains:
    """Of a map of eight boundaries."""
    machine, times = [_machine()], {}
    for n_workers in (1, 2):
        times[n_workers] = _map(n_workers)
        machine.append(_machine())
    return Gains(times, float(np.median(machine)))


def _map(n_workers: int) -> float:
    controllers, speeds, frictions = ("unified", "brake"), (15.0, 25.0), (0.5, 0.85)
    settings = MapSettings(load("paper"), controllers, "planar", speeds, frictions, (0.0,), TOLERANCE, (), 0)
    cells = cells_of(settings)
    with TemporaryDirectory() as place, Store(Path(place), settings) as store, engine(n_workers, None) as client:
        began = time.perf_counter()
        run_missing(cells, settings, store, client, lambda share: None)
        return time.perf_counter() - began


def _machine() -> float:
    return 2 * _busy(1) / _busy(2)


def _busy(n: int) -> float:
    """The time of so many busy processes beside one another [s]."""
    began = time.perf_counter()
    running = [subprocess.Popen([sys.executable, "-c", BUSY]) for _ in range(n)]
    for each in running:
        each.wait()
    return time.perf_counter() - began
