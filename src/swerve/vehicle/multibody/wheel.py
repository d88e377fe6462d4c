"""A wheel's spin: I w' = T - Fx R - dry, with w its absolute rate about the axle.

Dry friction, of the brake and of rolling, opposes a wheel that turns, and takes any value up to its strength that keeps
a standing one standing. One step h of it, taken implicitly, moves the spin towards zero by h dry / I, and not beyond:

    w+ = shrink(w + h (T - Fx R) / I,  h dry / I)

So a brake never turns a wheel backwards, holds a standing one, and locks a turning one without a switch. The rate that
the integrator sees is (w+ - w) / h; of a wheel that turns it does not depend on h.
"""

from typing import Any

import casadi as ca


def spin_rate(spin: Any, torque: Any, dry: Any, inertia: Any, step: Any) -> Any:
    """w' [rad/s^2] over a step.

    Args:
        spin: w [rad/s].
        torque: of the motor less Fx R [N m].
        dry: strength of dry friction, >= 0 [N m].
        inertia: I [kg m^2].
        step: h [s].
    """
    free = spin + step * torque / inertia
    most = step * dry / inertia
    return (free - ca.fmax(-most, ca.fmin(most, free)) - spin) / step
