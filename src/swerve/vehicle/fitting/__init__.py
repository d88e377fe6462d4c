"""Tyre data to the reduced tyre of sec. 3: readers, the fit of B, C, D and E, and Table 1 to check it by."""

from swerve.vehicle.fitting.data import LoadBlock, TyreData
from swerve.vehicle.fitting.fit import LoadFit, TyreFit, fit_tyre
from swerve.vehicle.fitting.read import read_tyre_data
from swerve.vehicle.fitting.table_1 import TABLE_1

__all__ = ["TABLE_1", "LoadBlock", "LoadFit", "TyreData", "TyreFit", "fit_tyre", "read_tyre_data"]
