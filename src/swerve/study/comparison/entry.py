"""One cell of a comparison: what became of one controller in one scenario."""

from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any, Final

from swerve import __version__
from swerve.errors import SwerveError
from swerve.scenario import Scenario
from swerve.simulate import Outcome, Result, Run, run

Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1

RANKS: Final = {outcome: i for i, outcome in enumerate(reversed(Outcome))}  # 0 is the best, as its order has the worst


@dataclass(frozen=True, eq=False)
class Entry:
    """A run, or the reason why there is none.

    Attributes:
        scenario: what was to be run.
        controller: by name.
        plant: by name.
        seed: of the run.
        run: None where the controller refused the scenario.
        refusal: why it did, a sentence; None where it did not.
    """

    scenario: Scenario
    controller: str
    plant: str
    seed: int
    run: Run | None
    refusal: str | None

    @classmethod
    def of(
        cls, scenario: Scenario, controller: str, plant: str, seed: int, progress: Progress | None = None
    ) -> "Entry":
        """Run it; a controller that cannot be built for the scenario refuses it."""
        try:
            return cls(scenario, controller, plant, seed, run(scenario, controller, plant, seed, progress), None)
        except SwerveError as error:
            return cls(scenario, controller, plant, seed, None, str(error))

    @property
    def result(self) -> Result | None:
        """The run's numbers."""
        return None if self.run is None else self.run.result

    @property
    def rank(self) -> tuple[int, float] | None:
        """How bad the outcome is: its rank, and among collisions the impact speed [m/s]; None for a refusal."""
        if self.result is None:
            return None
        return RANKS[self.result.outcome], self.result.impact_speed or 0.0

    def to_json(self) -> dict[str, Any]:
        """The result as in the JSON of `swerve run`, all null where there is none, and `refusal`."""
        names = {"scenario": self.scenario.name, "controller": self.controller, "plant": self.plant, "seed": self.seed}
        none = {**dict.fromkeys(each.name for each in fields(Result)), **names, "version": __version__}
        return {**(none if self.result is None else self.result.to_json()), "refusal": self.refusal}
