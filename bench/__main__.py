"""`python -m bench [--json FILE]`: measure, print a table for each measurement, and keep them as JSON if asked to."""

import argparse
import json
import os
import sys
from pathlib import Path

# The linear algebra of numpy and the solvers reads these when it is loaded: one thread, as in a car.
os.environ.update(dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1"))

from bench.machine import machine
from bench.suite import tables


def main() -> int:
    """Measure and print; the exit status is 0 whatever the numbers are."""
    parser = argparse.ArgumentParser(prog="python -m bench", description="Time the controller's step and its peers.")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the numbers there, too")
    options = parser.parse_args()
    on = machine()
    print("swerve {swerve} on {processor}, {cores} cores, load {load}".format(**on))
    print("Python {python}, casadi {casadi}, daqp {daqp}, piqp {piqp}, numpy {numpy}".format(**on))
    record: dict[str, object] = {"machine": on}
    for table in tables():
        print(f"\n{table.text()}", flush=True)
        record[table.key] = table.record()
    if options.json is not None:
        options.json.write_text(json.dumps(record, indent=2) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
