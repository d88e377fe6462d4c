"""What a controller is: a function from a measurement and a memory to a command, a plan and the next memory."""

from abc import abstractmethod
from typing import Generic, Protocol, TypeVar

from swerve.control.plan import Plan
from swerve.signals import Command, Measurement

Memory = TypeVar("Memory")


class Controller(Protocol, Generic[Memory]):
    """State in, state out: the same measurement and memory give the same answer, bit for bit."""

    @abstractmethod
    def start(self) -> Memory:
        """The memory before the first step."""

    @abstractmethod
    def step(self, measurement: Measurement, memory: Memory) -> tuple[Command, Plan, Memory]:
        """One sample. Never raises for what is measured: a plan that is no optimum says so by its `fallback`."""
