"""From a scenario's words to the objects that run: controllers and plants by name."""

from collections.abc import Callable, Mapping
from dataclasses import fields
from typing import Any, Final

from swerve.control import Controller, Goal, Horizon, Latency, Weights
from swerve.control.actuation import Actuation
from swerve.control.as_printed import AsPrintedController, AsPrintedSettings
from swerve.control.brake import BrakeController, BrakeSettings
from swerve.control.driver import DriverController
from swerve.control.hierarchical import HierarchicalController, HierarchicalSettings
from swerve.control.nonlinear import NonlinearController, NonlinearSettings
from swerve.control.unified import Formulation, UnifiedController, UnifiedSettings
from swerve.conventions import GRAVITY
from swerve.driver import DriverSeries, LaneKeeper
from swerve.driver.series import NOTHING
from swerve.errors import InputError, unknown
from swerve.plant import MultibodyPlant, PlanarPlant, Plant
from swerve.scenario import Scenario
from swerve.scenario.actuation import MODES
from swerve.scenario.driver import PREVIEW
from swerve.sensing import Noise, Sensor
from swerve.signals import Driver
from swerve.vehicle import Vehicle
from swerve.vehicle.multibody import Actuators, completion_of
from swerve.world import Friction

ONE_FRICTION: Final = "the planar plant has one friction for all wheels; take the multibody plant"

# the modes that a controller can be told of, and whether of failures; those that are not here, of all of both
HONOURED: Final[Mapping[str, tuple[tuple[str, ...], bool]]] = {
    "as-printed": (("all",), False),
    "hierarchical": (("all", "no-drive", "steer+friction-brakes"), False),
    "nonlinear": (("all", "no-drive"), False),
}

AXLES_IN_TURN = (
    1.5  # [1] relaxation lengths until a turn is there: the front axle's, and half of the rear one's upon it
)


def _actuators(scenario: Scenario, plant: str) -> Actuators:
    """The actuators of a plant; those of the planar one have neither lags nor limits but the vehicle's."""
    return completion_of(scenario.ego.vehicle)[1] if plant == "multibody" else Actuators()


def _latency(scenario: Scenario, plant: str) -> Latency:
    """The delays that a controller can know of."""
    actuators = _actuators(scenario, plant)
    tyre = completion_of(scenario.ego.vehicle)[0].tyre
    relaxation = AXLES_IN_TURN * tyre.lateral_relaxation if plant == "multibody" else 0.0
    return Latency(scenario.sensing.delay, actuators.delay + actuators.steering_lag, relaxation)


def _shared(scenario: Scenario, plant: str) -> dict[str, Any]:
    """What every controller is told."""
    settings, vehicle = scenario.controller, scenario.ego.to_vehicle()
    rate = min(vehicle.steering_rate_limit, _actuators(scenario, plant).steering_rate_limit)
    return {
        "vehicle": vehicle.with_changes({"steering_rate_limit": rate}),
        "friction": scenario.road.friction,
        "goal": Goal(**scenario.goal.model_dump()),
        "horizon": Horizon(settings.prediction_horizon, settings.control_horizon, settings.sample_time),
        "weights": Weights(**settings.weights.model_dump()),
    }


def actuation_of(scenario: Scenario, plant: str) -> Actuation:
    """The inputs that a controller is told it has: those of the mode, less the failures that are known."""
    told, vehicle = scenario.actuation, scenario.ego.to_vehicle()
    if plant == "multibody" and not vehicle.cg_height:
        vehicle = vehicle.with_changes({"cg_height": completion_of(vehicle.name)[0].cg_height})
    failures = (told.failed, told.steering_stuck) if told.known else ()
    return Actuation.of(vehicle, told.mode, *failures)


def _unified(scenario: Scenario, plant: str) -> UnifiedController:
    formulation = Formulation(
        footprint=scenario.ego.to_footprint(),
        road=scenario.road.to_world(),
        latency=_latency(scenario, plant),
        settings=UnifiedSettings(**scenario.controller.unified.model_dump()),
        actuation=actuation_of(scenario, plant),
        **_shared(scenario, plant),
    )
    return UnifiedController(formulation)


def _as_printed(scenario: Scenario, plant: str) -> AsPrintedController:
    settings = AsPrintedSettings(**scenario.controller.as_printed.model_dump())
    return AsPrintedController(settings=settings, **_shared(scenario, plant))


def _brake(scenario: Scenario, plant: str) -> BrakeController:
    told = _shared(scenario, plant)
    del told["weights"]  # it minimises nothing
    actuation = actuation_of(scenario, plant)
    if not actuation.braking:
        raise InputError("actuation: brake has nothing to brake with; take unified, or leave it a wheel that brakes")
    return BrakeController(
        footprint=scenario.ego.to_footprint(),
        road=scenario.road.to_world(),
        latency=_latency(scenario, plant),
        settings=BrakeSettings(**scenario.controller.brake.model_dump()),
        actuation=actuation,
        **told,
    )


def _hierarchical(scenario: Scenario, plant: str) -> HierarchicalController:
    return HierarchicalController(
        footprint=scenario.ego.to_footprint(),
        road=scenario.road.to_world(),
        latency=_latency(scenario, plant),
        settings=HierarchicalSettings(**scenario.controller.hierarchical.model_dump()),
        actuation=actuation_of(scenario, plant),
        **_shared(scenario, plant),
    )


def _nonlinear(scenario: Scenario, plant: str) -> NonlinearController:
    both = scenario.controller.unified.model_dump() | scenario.controller.nonlinear.model_dump()
    return NonlinearController(
        footprint=scenario.ego.to_footprint(),
        road=scenario.road.to_world(),
        latency=_latency(scenario, plant),
        settings=NonlinearSettings(**{each.name: both[each.name] for each in fields(NonlinearSettings)}),
        shapes=[obstacle.to_world().shape for obstacle in scenario.obstacles],
        actuation=actuation_of(scenario, plant),
        **_shared(scenario, plant),
    )


def _driver(scenario: Scenario, plant: str) -> DriverController:
    return DriverController(scenario.ego.to_vehicle(), scenario.road.friction, actuation_of(scenario, plant))


def planar_plant(vehicle: Vehicle, friction: Friction, step: float, n_substeps: int) -> PlanarPlant:
    """The planar plant for a vehicle of the library; InputError on a road with patches."""
    if friction.patches:
        raise InputError(ONE_FRICTION)
    return PlanarPlant(vehicle, friction.base, step, n_substeps)


def multibody_plant(vehicle: Vehicle, friction: Friction, step: float, n_substeps: int) -> MultibodyPlant:
    """The multibody plant for a vehicle of the library, with its chassis and actuators."""
    return MultibodyPlant(vehicle, *completion_of(vehicle.name), friction, step, n_substeps)


def _planar(scenario: Scenario) -> PlanarPlant:
    if scenario.road.patches:
        raise InputError(f"road.patches: {ONE_FRICTION}")
    return planar_plant(*_driven(scenario))


def _multibody(scenario: Scenario) -> MultibodyPlant:
    return multibody_plant(*_driven(scenario))


def _driven(scenario: Scenario) -> tuple[Vehicle, Friction, float, int]:
    """What a plant is made of: vehicle, road, step [s] and the number of them in a sample."""
    road = scenario.road.to_friction()
    return scenario.ego.to_vehicle(), road, scenario.plant.step, scenario.n_substeps


def sensor_of(scenario: Scenario) -> Sensor:
    """Build the way from truth to measurement."""
    settings = scenario.sensing
    noise = Noise(**settings.noise.model_dump())
    estimates = settings.wheel_loads == "estimated"
    return Sensor(settings.delay, noise, estimates, scenario.ego.to_vehicle(), driver_of(scenario))


def driver_of(scenario: Scenario) -> Driver | None:
    """Who sits at the wheel; None where the scenario has no driver."""
    told, vehicle, friction = scenario.driver, scenario.ego.to_vehicle(), scenario.road.friction
    if told is None:
        return None
    if told.model is not None:
        goal = scenario.goal
        return LaneKeeper(vehicle, friction, goal.lateral_offset, goal.speed, told.preview or PREVIEW)
    full = vehicle.force_limit * friction * vehicle.mass * GRAVITY
    force = tuple((time, share * full) for time, share in told.pedal)
    return DriverSeries(told.steering or NOTHING, force or NOTHING)


ControllerBuilder = Callable[[Scenario, str], Controller[Any]]

CONTROLLERS: Final[dict[str, ControllerBuilder]] = {
    "unified": _unified,
    "as-printed": _as_printed,
    "brake": _brake,
    "hierarchical": _hierarchical,
    "nonlinear": _nonlinear,
    "driver": _driver,
}
PLANTS: Final[dict[str, Callable[[Scenario], Plant]]] = {"planar": _planar, "multibody": _multibody}
DEFAULT_CONTROLLER: Final = "unified"
DEFAULT_PLANT: Final = "multibody"


def controller_named(name: str, scenario: Scenario, plant: str) -> Controller[Any]:
    """Build the controller of this name, which knows the actuators of that plant.

    Raises:
        InputError: there is none of this name, or it can't be told of the scenario's mode or failures.
    """
    if name not in CONTROLLERS:
        raise InputError(unknown("controller", name, CONTROLLERS))
    _refuse_actuation(name, scenario)
    return CONTROLLERS[name](scenario, plant)


def _refuse_actuation(name: str, scenario: Scenario) -> None:
    """InputError for a mode or failures of which the controller of this name can't be told."""
    told = scenario.actuation
    modes, knows_failures = HONOURED.get(name, (MODES, True))
    if told.mode not in modes:
        raise InputError(f"actuation.mode: {name} knows no {told.mode}; take unified, or write {' or '.join(modes)}")
    if told.has_failures and told.known and not knows_failures:
        raise InputError(f"actuation.known: {name} knows no failures; take unified, or write known = false")


def plant_named(name: str, scenario: Scenario) -> Plant:
    """Build the plant of this name; InputError when there is none."""
    if name not in PLANTS:
        raise InputError(unknown("plant", name, PLANTS))
    return PLANTS[name](scenario)
