"""The report of a run, or of several in one scene, as one HTML file that opens from disk and fetches nothing."""

from swerve.report.page.page import write_comparison, write_page

__all__ = ["write_comparison", "write_page"]
