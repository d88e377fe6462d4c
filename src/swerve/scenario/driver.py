"""Who sits at the wheel: a time series of steering and pedals, or a model of a driver.

steering, pedal         piecewise linear over time; what is not written is 0
model                   "lane-keeper": a preview driver who keeps the goal's lane and speed and sees no obstacle
"""

from itertools import pairwise
from typing import Annotated, Final, Literal, Self

from pydantic import model_validator

from swerve.scenario.quantities import Instant, Pedal, Preview, SteeringAngle, choice
from swerve.scenario.settings import KeyedError, Settings

DRIVERS: Final = ("lane-keeper",)
PREVIEW: Final = 1.0  # [s] time that a quiet driver looks ahead; 0.5 s is that of a severe lane change


class DriverSettings(Settings):
    """A driver.

    Attributes:
        steering: (time [s], road-wheel angle [rad]) each, in the order of time.
        pedal: (time [s], share of the force that the tyres carry at most: 1 full drive, -1 full brake [1]) each.
        model: name of a driver, in place of both.
        preview: time that the model looks ahead; None for PREVIEW [s].
    """

    steering: tuple[tuple[Instant, SteeringAngle], ...] = ()
    pedal: tuple[tuple[Instant, Pedal], ...] = ()
    model: Annotated[Literal["lane-keeper"], choice("driver", DRIVERS)] | None = None
    preview: Preview | None = None

    @model_validator(mode="after")
    def _drives_in_one_way(self) -> Self:
        if self.model is None and not (self.steering or self.pedal):
            cure = 'write steering = [["0 s", "0 deg"], ["1 s", "3 deg"]], pedal, or model = "lane-keeper"'
            raise KeyedError("steering", f"missing; {cure}")
        for key in ("steering", "pedal"):
            if self.model is not None and getattr(self, key):
                raise KeyedError(key, "is given beside model, which steers and drives by itself; write one of them")
        if self.preview is not None and self.model is None:
            raise KeyedError("preview", 'means nothing without a model; write model = "lane-keeper" too')
        return self

    @model_validator(mode="after")
    def _times_ascend(self) -> Self:
        for key, series in (("steering", self.steering), ("pedal", self.pedal)):
            for index, (before, after) in enumerate(pairwise(series), 1):
                if after[0] <= before[0]:
                    fault = f"{after[0]:g} s is not after the one before it, {before[0]:g} s"
                    raise KeyedError(f"{key}.{index}.0", f"{fault}; write them in the order of their times")
        return self
