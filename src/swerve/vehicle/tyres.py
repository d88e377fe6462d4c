"""The tyres that scenarios can name."""

from typing import Final

from swerve.vehicle.tyre import PASSENGER_215_55_R17, Tyre

TYRES: Final[dict[str, Tyre]] = {"passenger-215-55-r17": PASSENGER_215_55_R17}
