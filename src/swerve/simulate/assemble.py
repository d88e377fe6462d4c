"""From a scenario's words to the objects that run: controllers and plants by name."""

from collections.abc import Callable
from typing import Any, Final

from swerve.control import Controller, Goal, Horizon, Weights
from swerve.control.as_printed import AsPrintedController, AsPrintedSettings
from swerve.control.unified import UnifiedController, UnifiedSettings
from swerve.errors import InputError, unknown
from swerve.plant import MultibodyPlant, PlanarPlant, Plant
from swerve.scenario import Scenario
from swerve.vehicle.multibody import completion_of


def _shared(scenario: Scenario) -> dict[str, Any]:
    """What every controller is told."""
    settings = scenario.controller
    return {
        "vehicle": scenario.ego.to_vehicle(),
        "friction": scenario.road.friction,
        "goal": Goal(**scenario.goal.model_dump()),
        "horizon": Horizon(settings.prediction_horizon, settings.control_horizon, settings.sample_time),
        "weights": Weights(**settings.weights.model_dump()),
    }


def _unified(scenario: Scenario) -> UnifiedController:
    settings = UnifiedSettings(**scenario.controller.unified.model_dump())
    return UnifiedController(footprint=scenario.ego.to_footprint(), settings=settings, **_shared(scenario))


def _as_printed(scenario: Scenario) -> AsPrintedController:
    settings = AsPrintedSettings(**scenario.controller.as_printed.model_dump())
    return AsPrintedController(settings=settings, **_shared(scenario))


def _planar(scenario: Scenario) -> PlanarPlant:
    if scenario.road.patches:
        raise InputError("road.patches: the planar plant has one friction for all wheels; take the multibody plant")
    return PlanarPlant(scenario.ego.to_vehicle(), scenario.road.friction, scenario.plant.step, scenario.n_substeps)


def _multibody(scenario: Scenario) -> MultibodyPlant:
    chassis, actuators = completion_of(scenario.ego.vehicle)
    friction = scenario.road.to_friction()
    clocks = scenario.plant.step, scenario.n_substeps
    return MultibodyPlant(scenario.ego.to_vehicle(), chassis, actuators, friction, *clocks)


CONTROLLERS: Final[dict[str, Callable[[Scenario], Controller[Any]]]] = {"unified": _unified, "as-printed": _as_printed}
PLANTS: Final[dict[str, Callable[[Scenario], Plant]]] = {"planar": _planar, "multibody": _multibody}
DEFAULT_CONTROLLER: Final = "unified"
DEFAULT_PLANT: Final = "planar"


def controller_named(name: str, scenario: Scenario) -> Controller[Any]:
    """Build the controller of this name; InputError when there is none."""
    if name not in CONTROLLERS:
        raise InputError(unknown("controller", name, CONTROLLERS))
    return CONTROLLERS[name](scenario)


def plant_named(name: str, scenario: Scenario) -> Plant:
    """Build the plant of this name; InputError when there is none."""
    if name not in PLANTS:
        raise InputError(unknown("plant", name, PLANTS))
    return PLANTS[name](scenario)
