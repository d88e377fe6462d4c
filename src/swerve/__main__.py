"""`python -m swerve`: the command line."""

import sys

from swerve.cli import main

sys.exit(main())
