"""Beside a driver: who leads the plans of a step, the first of these who leaves a way clear and on the road.

    DRIVER      for a WINDOW the inputs are the driver's, a constraint; beyond it a plan is free to avoid
    ASSISTANT   nothing is held, but of all plans the one that deviates least from the driver (`terms/driver.py`)
    NOBODY      as without a driver: the ordinary cost, which pulls to the goal

With a driver who is right the first holds and the command is the driver's input, to the bit. An assistant steps in a
WINDOW before the last instant, and its least squares over the horizon spread the help: to wait would cost more. What
was taken from the driver is given back over time, in what is held:

    held(k+j) = driver's + (u(k-1) - driver's(k-1)) exp(-(j+1) Ts / HANDING_BACK)
"""

from dataclasses import dataclass, replace
from enum import Enum
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.control.driver import DriverActuation
from swerve.control.plan import Plan, Side
from swerve.control.unified.condensing import Blocking
from swerve.control.unified.program import Program
from swerve.control.unified.terms import DriverDeviation, Term
from swerve.conventions import DELTA, FORCES, N_INPUTS
from swerve.signals import Measurement

Array = NDArray[np.float64]

WINDOW: Final = 0.4  # [s] that a driver goes on: a plan that begins now may be late by the rest of it
HANDING_BACK: Final = 0.3  # [s] time constant
STEERING: Final = 1e3  # [1/rad^2] of a deviation from the driver's, in a sample
FORCE: Final = 6e-7  # [1/N^2] of that of a wheel: of all four 1 kN costs what 0.05 rad does
TURNED: Final = 0.01  # [rad] a deviation that is more than holding the lane
LEFT_ALONE: Final = np.array([1e-3] + 4 * [12.5])  # [rad, N] a deviation that is none: of all wheels together 50 N


class Lead(Enum):
    """Who leads the plans of a step; the value says of a plan's input what it is."""

    DRIVER = "the driver's, with what is still being given back"
    ASSISTANT = "the nearest to the driver's that leaves a way clear"
    NOBODY = "free of the driver, who leaves no way clear"


@dataclass(frozen=True, eq=False)
class Assistance:
    """What a driver is to one vehicle's plans.

    Attributes:
        actuation: from the driver to the vehicle.
        blocking: of the plans' free inputs.
        sample_time: Ts [s].
    """

    actuation: DriverActuation
    blocking: Blocking
    sample_time: float

    def leads(self, measurement: Measurement) -> tuple[tuple[Lead, float], ...]:
        """Who may lead, in order, each with a share of the time; what one leaves of it the next has."""
        if measurement.driver is None:
            return ((Lead.NOBODY, 1.0),)
        return ((Lead.DRIVER, 0.5), (Lead.ASSISTANT, 0.5), (Lead.NOBODY, 0.0))

    def deviation(self, command: Array, measurement: Measurement) -> Array:
        """(5,) by which an input (5,) is not the driver's; zero without one, or where the measurement is not finite."""
        if measurement.driver is None or not measurement.is_finite:
            return np.zeros(N_INPUTS)
        return command - self.actuation.inputs(measurement)

    def held(self, program: Program, measurement: Measurement, deviation: Array) -> Program:
        """The program whose first inputs are the driver's, as far as they keep its hard limits.

        Args:
            program: box and hard limits.
            measurement: with a driver.
            deviation: (5,) of the last command from the driver's input.
        """
        n = max(1, min(round(WINDOW / self.sample_time), self.blocking.n_blocks - 1))
        left = np.exp(-np.arange(1, self.blocking.n_samples + 1) * self.sample_time / HANDING_BACK)
        inputs = program.clip(self.actuation.inputs(measurement) + left[:, np.newaxis] * deviation)
        return replace(program, box=replace(program.box, held=inputs[:n]))

    def terms(self, lead: Lead, measurement: Measurement) -> tuple[Term, ...]:
        """The cost in place of the goal's."""
        if lead is Lead.DRIVER:
            return ()
        weights = np.array([STEERING] + 4 * [FORCE])
        return (DriverDeviation(self.actuation.inputs(measurement), weights, self.blocking),)

    def told(self, plan: Plan, lead: Lead, measurement: Measurement) -> Plan:
        """The plan, with what its first input is to the driver; where it is the driver's, no obstacle shaped it.

        One that passes nothing has the side to which it turns the wheel for the sake of an obstacle.
        """
        if measurement.driver is None:
            return plan
        deviation = self.deviation(plan.inputs[0], measurement)
        if (np.abs(deviation) <= LEFT_ALONE).all():
            return replace(plan, is_shaped=False, side=None, reason="the driver's input, which leaves a way clear")
        off = f"{deviation[DELTA]:+.3f} rad and {deviation[FORCES].sum():+.0f} N off"
        turned = Side.LEFT if deviation[DELTA] > 0 else Side.RIGHT
        is_held = any(name.startswith("obstacle") for name in plan.active)
        side = turned if plan.side is None and is_held and abs(deviation[DELTA]) > TURNED else plan.side
        return replace(plan, side=side, reason=f"{lead.value}; {off}; {plan.reason}")
