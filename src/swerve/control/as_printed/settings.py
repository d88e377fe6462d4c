"""Settings of the as-printed controller: which misprints of the paper are put right."""

from dataclasses import dataclass


@dataclass(frozen=True)
class AsPrintedSettings:
    """Switches, each for one misprint; none of them is the paper to the letter.

    Attributes:
        corrections: any of
            "mass"            1/m in b11 and b21, 1/Izz in b31,
            "drift"           the term Ts f(xi_k, u_k) that (9) lacks,
            "hold-input"      the input stays as it is after Nc, where W lets it fall back to u_k,
            "jacobian"        derivatives of the lateral tyre forces by the state and the steering angle,
            "discretisation"  matrix exponential where the paper took Euler.
    """

    corrections: tuple[str, ...]
