"""Nonlinear model predictive control: the unified controller's problem as one program, solved to convergence."""

from swerve.control.nonlinear.controller import NonlinearController
from swerve.control.nonlinear.program import NonlinearProgram
from swerve.control.nonlinear.settings import NonlinearSettings
from swerve.control.nonlinear.solver import SOLVERS
from swerve.control.nonlinear.values import Answer, Guess, Question

__all__ = ["SOLVERS", "Answer", "Guess", "NonlinearController", "NonlinearProgram", "NonlinearSettings", "Question"]
