"""What a second worker gains a map, against what a second plain process gains on the same machine in the same minutes.

    gain of the map = time with one worker / time with two
    gain of the machine = 2 * time of one busy process / time of two beside one another

The workers' start and first import, some seconds whatever the size of the map, are left out. Both gains are measured in
turn, as often as `ROUNDS` says, and the times are added up, since what else the machine does comes and goes; shared
cores, caches and clocks make both less than two.
"""

import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

from swerve.scenario import load
from swerve.study.map import MapSettings, Store, cells_of, engine, run_missing

BUSY: Final = "for _ in range(200_000_000): pass"
TOLERANCE: Final = 0.5  # [m]
ROUNDS: Final = 3


@dataclass(frozen=True)
class Gains:
    """Measured in one go.

    Attributes:
        maps: times of the map with one and with two workers [s], of all rounds.
        machine: times of one busy process and of two [s], of all rounds.
    """

    maps: tuple[float, float]
    machine: tuple[float, float]

    @property
    def of_map(self) -> float:
        """Gain of two workers over one [1]."""
        return self.maps[0] / self.maps[1]

    @property
    def of_machine(self) -> float:
        """Gain of two plain processes over one [1]."""
        return 2 * self.machine[0] / self.machine[1]


def gains() -> Gains:
    """Of a map of twelve boundaries."""
    rounds = [(_busy(1), _map(1), _busy(2), _map(2)) for _ in range(ROUNDS)]
    one, map_one, two, map_two = (sum(times) for times in zip(*rounds, strict=True))
    return Gains((map_one, map_two), (one, two))


def _map(n_workers: int) -> float:
    controllers, speeds, frictions = ("unified", "brake", "hierarchical"), (15.0, 25.0), (0.5, 0.85)
    settings = MapSettings(load("paper"), controllers, "planar", speeds, frictions, (0.0,), TOLERANCE, (), 0)
    cells = cells_of(settings)
    with TemporaryDirectory() as place, Store(Path(place), settings) as store, engine(n_workers, None) as client:
        client.run(cells_of, settings)  # imports all there is to import
        began = time.perf_counter()
        run_missing(cells, settings, store, client, lambda share: None)
        return time.perf_counter() - began


def _busy(n: int) -> float:
    """The time of so many busy processes beside one another [s]."""
    began = time.perf_counter()
    running = [subprocess.Popen([sys.executable, "-c", BUSY]) for _ in range(n)]
    for each in running:
        each.wait()
    return time.perf_counter() - began
