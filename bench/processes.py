"""Wall times of whole processes, Python's own start included."""

import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from typing import Final

COMMANDS: Final[Mapping[str, Sequence[str]]] = {
    "python alone": ("-c", "pass"),
    "import swerve": ("-c", "import swerve"),
    "import swerve.simulate": ("-c", "import swerve.simulate"),
    "swerve run paper": ("-m", "swerve", "run", "paper"),
    "swerve run paper --plant planar": ("-m", "swerve", "run", "paper", "--plant", "planar"),
}


def wall_times(n_runs: int) -> dict[str, float]:
    """Shortest wall time of each command in some runs [s]; the kernels are in the cache by the second one."""
    return {name: min(_wall_time(command) for _ in range(n_runs)) for name, command in COMMANDS.items()}


def _wall_time(arguments: Sequence[str]) -> float:
    began = time.perf_counter()
    run = subprocess.run([sys.executable, *arguments], check=False, capture_output=True, text=True)
    wall_time = time.perf_counter() - began
    if run.returncode != 0:
        raise RuntimeError(f"python {' '.join(arguments)} ended with status {run.returncode}: {run.stderr}")
    return wall_time
