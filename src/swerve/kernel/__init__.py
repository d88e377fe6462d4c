"""One symbolic function becomes one fast callable: compiled C where there is a compiler, CasADi's machine elsewhere."""

from swerve.kernel.kernel import Kernel

__all__ = ["Kernel"]
