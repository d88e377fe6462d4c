"""What distinguishes processors for a compiler that is told to use all of this one."""

import platform
from functools import cache
from pathlib import Path


@cache
def processor_id() -> str:
    """Architecture, model and instruction set flags of this machine's processor."""
    described = Path("/proc/cpuinfo")
    lines = described.read_text().splitlines() if described.exists() else []
    wanted = ("model name", "flags", "Features", "CPU part")
    first = {line.split(":")[0].strip(): line for line in reversed(lines) if line.startswith(wanted)}
    return "\n".join([platform.machine(), platform.processor(), *(first[key] for key in sorted(first))])
