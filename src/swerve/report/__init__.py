"""What is shown of runs and studies: tables, figures, files. Nothing here runs anything."""

from swerve.report.console import Console
from swerve.report.output import prepare_output
from swerve.report.progress import Progress
from swerve.report.terminal import ablation_table, result_json, result_table, run_summary
from swerve.report.write import write_reproduction, write_run

__all__ = [
    "Console",
    "Progress",
    "ablation_table",
    "prepare_output",
    "result_json",
    "result_table",
    "run_summary",
    "write_reproduction",
    "write_run",
]
