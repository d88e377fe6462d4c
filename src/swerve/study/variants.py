"""The rows of the ablation: what is changed from one controller to the next, and why it matters."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from swerve.scenario import CORRECTIONS
from swerve.scenario.controller import Correction


@dataclass(frozen=True)
class Variant:
    """A controller and its settings.

    Attributes:
        name: of the row.
        controller: by name.
        overrides: KEY=VALUE on the scenario.
        change: against the row before, and why it matters; no numbers, which are the run's to tell.
    """

    name: str
    controller: str
    overrides: tuple[str, ...]
    change: str


_AS_PRINTED: Final = Variant(
    "as printed",
    "as-printed",
    (),
    "Sec. 4 to the letter. The predicted car stays where it is, so that in every prediction the obstacle is as far "
    "away as now, until the car is in it; only there do the programs have no solution.",
)

_CORRECTED: Final[Mapping[Correction, str]] = {
    "mass": "1/m and 1/Izz, which b11, b21 and b31 lack. Straight on and without wheel force the printed steering "
    "column is zero either way, so nothing moves yet.",
    "drift": "The term Ts f(xi_k, u_k), which (9) lacks: the predicted car moves, and meets the obstacle. But rho is "
    "quadratic and (15) linearises it where the car is: from afar its wall stands half way to the obstacle. Where "
    "the car cannot stop before that wall, the program has no solution and the last command is held; where it can, "
    "it brakes.",
    "hold-input": "After Nc samples the planned input stays, where W lets it fall back to the present one: the whole "
    "horizon answers to the plan.",
    "jacobian": "The derivatives of the lateral tyre forces by state and steering angle. The printed steering column "
    "is zero without wheel force and of the wrong sign under braking; now steering does in the prediction what it "
    "does on the road. It is no way out yet: on the obstacle's line p2 is 0, neither left nor right; beside it p2 is "
    "small against p1, and the wall half way is still in the way.",
    "discretisation": "The matrix exponential in place of Euler's rule, which over one sample is unstable at walking "
    "pace, where the tyres respond faster than that.",
}

_UNIFIED: Final = (
    Variant(
        "unified, bare",
        "unified",
        (
            "controller.unified.iterations=1",
            "controller.unified.first_iterations=1",
            "controller.unified.slip_limit=180 deg",
            "controller.unified.trust_steering=180 deg",
            "controller.unified.trust_force=1000 kN",
        ),
        "The same cost and horizons, another program: linearised along the previous plan instead of at one point, "
        "with soft half-planes at the predicted nodes and between them, once for the left and once for the right, and "
        "the better taken; a roll-out of the nonlinear model decides how far to go along the answer. One iteration.",
    ),
    Variant(
        "+ slip limit, trust region",
        "unified",
        ("controller.unified.iterations=1", "controller.unified.first_iterations=1"),
        "Slip angles stay below the tyre's peak, beyond which more steering gives less force, and an iteration stays "
        "where its linearisation holds: the same obstacle with less steering.",
    ),
    Variant(
        "unified",
        "unified",
        (),
        "More iterations, and more again where no plan keeps clear yet: the plan is closer to the optimum of the "
        "nonlinear problem, which counts where little room is left.",
    ),
)


def _corrected(n: int) -> Variant:
    """As printed with the first `n` corrections; the row is about the last of them."""
    names = ", ".join(f'"{name}"' for name in CORRECTIONS[:n])
    last = CORRECTIONS[n - 1]
    return Variant(f"+ {last}", "as-printed", (f"controller.as_printed.corrections=[{names}]",), _CORRECTED[last])


VARIANTS: Final = (_AS_PRINTED, *(_corrected(n) for n in range(1, len(CORRECTIONS) + 1)), *_UNIFIED)
