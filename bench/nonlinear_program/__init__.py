"""The unified controller's problem as one nonlinear program, solved to convergence by Fatrop or IPOPT."""

from bench.nonlinear_program.controller import NonlinearController
from bench.nonlinear_program.program import NonlinearProgram
from bench.nonlinear_program.solver import SOLVERS
from bench.nonlinear_program.values import Answer, Guess, Question

__all__ = ["SOLVERS", "Answer", "Guess", "NonlinearController", "NonlinearProgram", "Question"]
