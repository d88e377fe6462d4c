"""What a map found, as one HTML file that opens from disk, as a figure, and as a table."""

from swerve.report.map.commands import Source
from swerve.report.map.figure import write_figure
from swerve.report.map.page import write_map
from swerve.report.map.replays import write_replays
from swerve.report.map.tables import as_markdown

__all__ = ["Source", "as_markdown", "write_figure", "write_map", "write_replays"]
