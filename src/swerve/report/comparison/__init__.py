"""A comparison of controllers: table, JSON, Parquet, Markdown, figures and pages."""

from swerve.report.comparison.table import comparison_json, comparison_table
from swerve.report.comparison.write import write_comparison

__all__ = ["comparison_json", "comparison_table", "write_comparison"]
