"""Whether a Hessian is positive semidefinite, for solvers that do not say so themselves."""

from typing import Final

import numpy as np

from swerve.qp.problem import Array

ROUNDING: Final = 1e-10  # what a semidefinite matrix of unit diagonal may lack by rounding


def is_convex(hessian: Array) -> bool:
    """Whether the Hessian of an equilibrated problem is positive semidefinite: slightly shifted, it has a factor."""
    try:
        np.linalg.cholesky(hessian + ROUNDING * np.eye(len(hessian)))
    except np.linalg.LinAlgError:
        return False
    return True
