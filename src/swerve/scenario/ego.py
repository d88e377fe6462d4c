"""The ego vehicle of a scenario: which one, with what changed, where it starts and how much room it takes."""

from dataclasses import fields, replace
from math import inf
from typing import TYPE_CHECKING, Annotated, Final, Literal, Self

from pydantic import BeforeValidator, Field, create_model, model_validator

from swerve.conventions import GRAVITY
from swerve.scenario.quantities import Coordinate, Heading, Speed, choice
from swerve.scenario.settings import KeyedError, Settings
from swerve.scenario.tyre import ScenarioTyre
from swerve.units import to_si
from swerve.vehicle import VEHICLES, Vehicle, vehicle_named
from swerve.vehicle.tyre import factors
from swerve.world import Footprint, Point, Rectangle

FOOTPRINTS: Final = ("point", "rectangle")


def _parameter(dimension: str) -> tuple[object, None]:
    """An optional quantity; its bounds are the vehicle's own business."""
    return Annotated[float | None, BeforeValidator(lambda value: to_si(value, dimension))], None


if TYPE_CHECKING:
    VehicleParameters = Settings
else:
    VehicleParameters = create_model(
        "VehicleParameters",
        __base__=Settings,
        __doc__="Numbers of the vehicle that the scenario replaces; one that is None stays as it is.",
        **{f.name: _parameter(f.metadata["dimension"]) for f in fields(Vehicle) if "dimension" in f.metadata},
    )


class EgoSettings(Settings):
    """The ego vehicle at time zero.

    Attributes:
        vehicle: its name in the library of vehicles.
        tyre: of all four wheels, in place of the vehicle's own; None leaves that.
        parameters: numbers of that vehicle to replace, each under the name it has in `Vehicle`.
        position: of the centre of gravity (X, Y) [m].
        heading: yaw angle psi [rad].
        speed: vx; the vehicle starts straight ahead, with vy = r = 0 [m/s].
        footprint: what must stay clear of obstacles, the centre of gravity alone or the body's rectangle.
    """

    vehicle: Annotated[str, choice("vehicle", VEHICLES)] = "d-class-sedan"
    tyre: ScenarioTyre = None
    position: tuple[Coordinate, Coordinate] = Field(examples=['["0 m", "0 m"]'])
    heading: Heading = 0.0
    speed: Speed = Field(examples=['"72 km/h"'])
    footprint: Annotated[Literal["point", "rectangle"], choice("footprint", FOOTPRINTS)] = Field(examples=['"point"'])
    parameters: VehicleParameters = Field(default_factory=VehicleParameters)

    @model_validator(mode="after")
    def _is_a_vehicle(self) -> Self:
        try:
            self.to_vehicle()
        except ValueError as error:  # "mass must be positive, got -5"
            name, _, fault = str(error).partition(" ")
            raise KeyedError(f"parameters.{name}", fault) from error
        return self

    @model_validator(mode="after")
    def _tyre_carries_the_vehicle(self) -> Self:
        if self.tyre is None:
            return self
        vehicle = self.to_vehicle()
        load = vehicle.mass * GRAVITY / 2  # of a wheel whose axle's other one is in the air
        for letter, value, most in zip("BCD", factors(vehicle.tyre, load), (inf, 2.0, inf), strict=True):
            if not 0 < value <= most:
                fault = f"{letter} is {value:.4g} at {load:.6g} N, half the vehicle's weight"
                limit = "above 0" if most == inf else f"above 0 and at most {most:g}"
                raise KeyedError("tyre", f"{fault}, and has to be {limit}; write the tyre of a vehicle as heavy")
        return self

    def to_vehicle(self) -> Vehicle:
        """The named vehicle with the scenario's own numbers and tyre in it."""
        vehicle = vehicle_named(self.vehicle).with_changes(self.parameters.model_dump(exclude_none=True))
        return vehicle if self.tyre is None else replace(vehicle, tyre=self.tyre.to_tyre())

    def to_footprint(self) -> Footprint:
        """What must stay clear of obstacles, in the body frame whose origin is the centre of gravity."""
        if self.footprint == "point":
            return Point()
        vehicle = self.to_vehicle()
        return Rectangle(vehicle.length, vehicle.width, centre=(vehicle.cg_to_front_end - vehicle.length / 2, 0.0))
