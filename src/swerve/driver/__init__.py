"""Who sits at the wheel: from the true motion to a driver's input, by a time series or a simple model."""

from swerve.driver.lane_keeper import LaneKeeper
from swerve.driver.series import DriverSeries

__all__ = ["DriverSeries", "LaneKeeper"]
