"""The tyre of a scenario: a name of the library, a TOML file as `swerve fit-tyre --out` writes it, or its table itself.

Whatever it was, a scenario holds the numbers, so that what was run can be run again without the file.
"""

from pathlib import Path
from typing import Annotated, Final, Self

import tomli_w
from pydantic import BeforeValidator, Field, ValidationError, ValidationInfo

from swerve.errors import InputError, shown, shown_path, unknown
from swerve.scenario.document import read_document, tables_of
from swerve.scenario.problems import input_error
from swerve.scenario.quantities import Name, Text, quantity
from swerve.scenario.settings import Settings
from swerve.vehicle import TYRES, Tyre

FOLDER: Final = "folder"  # key of the validation's context: where the scenario's file is
CONTENTS: Final = "a tyre has name, [stiffness_factor], [shape_factor] and [peak_factor]"

Slope = Annotated[float, quantity("dimensionless", -1.0, 1.0)]
Stiffness = Annotated[float, quantity("dimensionless", 0.0, 500.0, above=True)]
Shape = Annotated[float, quantity("dimensionless", 0.0, 2.0, above=True)]
Peak = Annotated[float, quantity("dimensionless", 0.0, 5.0, above=True)]


class StiffnessFactor(Settings):
    """B = at_no_load + per_newton Fz.

    Attributes:
        at_no_load: [1/rad].
        per_newton: [1/(rad N)].
    """

    at_no_load: Stiffness = Field(examples=["13.0409"])
    per_newton: Slope = Field(examples=["-1.4758e-4"])


class ShapeFactor(Settings):
    """C = at_no_load + per_newton Fz.

    Attributes:
        at_no_load: at most 2, beyond which a force would change its sign at large slip angles [1].
        per_newton: [1/N].
    """

    at_no_load: Shape = Field(examples=["1.4465"])
    per_newton: Slope = Field(examples=["7.4666e-7"])


class PeakFactor(Settings):
    """D = at_no_load + per_newton Fz.

    Attributes:
        at_no_load: [1].
        per_newton: [1/N].
    """

    at_no_load: Peak = Field(examples=["1.0161"])
    per_newton: Slope = Field(examples=["-9.0695e-6"])


class TyreSettings(Settings):
    """The reduced tyre of eq. (3), with mu = 1 for the surface that it was measured on.

    Attributes:
        name: how reports call it.
        source: where its numbers come from.
        stiffness_factor: B over the load.
        shape_factor: C over the load.
        peak_factor: D over the load.
    """

    name: Name = Field(examples=['"my-tyre"'])
    source: Text = ""
    stiffness_factor: StiffnessFactor = Field(examples=["{ at_no_load = 13.0409, per_newton = -1.4758e-4 }"])
    shape_factor: ShapeFactor = Field(examples=["{ at_no_load = 1.4465, per_newton = 7.4666e-7 }"])
    peak_factor: PeakFactor = Field(examples=["{ at_no_load = 1.0161, per_newton = -9.0695e-6 }"])

    @classmethod
    def of(cls, name: str, source: str, tyre: Tyre) -> Self:
        """The settings of a tyre.

        Raises:
            ValidationError: its numbers are out of range.
        """
        return cls.model_validate(
            {
                "name": name,
                "source": source,
                "stiffness_factor": {"at_no_load": tyre.b0, "per_newton": tyre.b1},
                "shape_factor": {"at_no_load": tyre.c0, "per_newton": tyre.c1},
                "peak_factor": {"at_no_load": tyre.d0, "per_newton": tyre.d1},
            }
        )

    def to_tyre(self) -> Tyre:
        """The tyre that a vehicle takes."""
        B, C, D = self.stiffness_factor, self.shape_factor, self.peak_factor
        return Tyre(B.at_no_load, B.per_newton, C.at_no_load, C.per_newton, D.at_no_load, D.per_newton)

    def to_toml(self) -> str:
        """The tyre as a TOML document, which `load_tyre` reads."""
        return tomli_w.dumps(self.model_dump())


def load_tyre(path: Path) -> TyreSettings:
    """The tyre in a TOML file.

    Raises:
        InputError: it cannot be read, or something in it is wrong.
    """
    file = shown_path(path)
    cure = f"write a TOML file's path, or one of {', '.join(TYRES)}"
    tables = tables_of(read_document(path, "tyre", cure), file, CONTENTS)
    try:
        return TyreSettings.model_validate(tables)
    except ValidationError as error:
        raise input_error(error, TyreSettings, file, []) from error


def _read(value: object, info: ValidationInfo) -> object:
    if value is None or isinstance(value, dict | TyreSettings):
        return value
    if not isinstance(value, str):
        names = ", ".join(TYRES)
        raise ValueError(f"{shown(value)} is no tyre; write one of {names}, a .toml file or a table [ego.tyre]")
    if not value.endswith(".toml") and value == Path(value).name:
        if value not in TYRES:
            raise ValueError(f"{unknown('tyre', value, TYRES)} (a file of your own ends in .toml)")
        return TyreSettings.of(value, "swerve's library of tyres", TYRES[value])
    try:
        return load_tyre(_found(Path(value), (info.context or {}).get(FOLDER)))
    except InputError as error:
        raise ValueError(str(error)) from error


def _found(path: Path, folder: Path | None) -> Path:
    """A path as it is from the folder of the scenario, else from the working directory."""
    beside = path if folder is None else folder / path
    try:
        return beside if beside.exists() else path
    except (OSError, ValueError):  # a path that no file system can hold, which reading it will say
        return path


ScenarioTyre = Annotated[TyreSettings | None, BeforeValidator(_read)]
