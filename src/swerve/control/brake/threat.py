"""The two triggers of an emergency brake.

time to collision       the first contact at the present speed comes within trigger_time
required deceleration   it comes at the present speed, and also with trigger_share of the largest deceleration
"""

from swerve.control.brake.settings import BrakeSettings
from swerve.control.corridor import Corridor
from swerve.control.forecast import Forecast

SLACK = 0.5  # [s] looked beyond the time that a stop takes


def is_alarming(forecast: Forecast, corridor: Corridor, braking: float, settings: BrakeSettings) -> bool:
    """Whether an obstacle sets the emergency brake off, whose largest deceleration is `braking` [m/s^2]."""
    stop = settings.trigger_share * braking
    horizon = corridor.speed / stop + SLACK
    contact = corridor.contact(forecast, 0.0, horizon)
    if contact is None:
        return False
    return contact < settings.trigger_time or corridor.contact(forecast, stop, horizon) is not None
