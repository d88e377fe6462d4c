"""The cost: a sum of terms, one file each. A new term is a new file and a line where the controller lists its terms."""

from swerve.control.unified.terms.driver import DriverDeviation
from swerve.control.unified.terms.input_rate import InputRate
from swerve.control.unified.terms.term import Quadratic, Term
from swerve.control.unified.terms.tracking import Tracking
from swerve.control.unified.terms.wheel_force import WheelForce

__all__ = ["DriverDeviation", "InputRate", "Quadratic", "Term", "Tracking", "WheelForce"]
