"""What the numbers were measured on."""

import os
import platform
from importlib.metadata import version
from pathlib import Path

LIBRARIES = ("swerve", "casadi", "daqp", "piqp", "numpy")


def machine() -> dict[str, str]:
    """Processor, cores, load, and versions."""
    return {
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        "load": f"{os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else "unknown",
        "python": platform.python_version(),
        **{library: version(library) for library in LIBRARIES},
    }


def _processor() -> str:
    """The processor's name."""
    described = Path("/proc/cpuinfo")
    lines = described.read_text().splitlines() if described.exists() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()
