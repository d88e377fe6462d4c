"""A scene of the studio: a scenario that has a name, moved by hand, as the TOML file that makes the same run anywhere.

What is run is that file and nothing else, so that saving it saves the run.
"""

import tomllib
from functools import cache
from typing import Annotated, Any, Final

import tomli_w
from pydantic import BaseModel, ConfigDict, Field

from swerve.errors import InputError, nearest, one_line
from swerve.scenario import FAMILIES, Scenario, library_names, load, parse
from swerve.scenario.document import tables_of
from swerve.units import to_si
from swerve.vehicle.tyres import TYRES

FILE: Final = "scene"  # what messages call it
CONTENTS: Final = "a scenario has name, duration, [road], [ego] and [goal] at least"
LONGEST_TOML: Final = 20_000  # [character]
MOST_ROWS: Final = 400_000  # of the log's motion, which has to be in memory
MOST_OBSTACLES: Final = 30
TEXTS: Final = {
    "speed": "speed {}",
    "distance": "obstacle at X = {}",
    "friction": "friction {}",
    "offset": "at Y = {}",
    "duration": "for {}",
}

Quantity = Annotated[str, Field(max_length=40)] | Annotated[float, Field(strict=True, allow_inf_nan=False)]


class Moved(BaseModel):
    """What is moved of a scenario; what is null stays.

    Attributes:
        scenario: its name in the library, or that of a family's member.
        speed: of the ego vehicle at the start, which is to hold it.
        distance: X of the first obstacle; the others keep their places from it.
        friction: of the road.
        offset: Y of the first obstacle; likewise.
        duration: of the run.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    scenario: str = Field(max_length=100, examples=["paper"])
    speed: Quantity | None = Field(None, examples=["90 km/h"])
    distance: Quantity | None = Field(None, examples=["30 m"])
    friction: Quantity | None = Field(None, examples=[0.5])
    offset: Quantity | None = Field(None, examples=["-0.3 m"])
    duration: Quantity | None = Field(None, examples=["8 s"])


@cache
def scenarios() -> dict[str, Scenario]:
    """Every scenario of the library, then every member of a family, by its name."""
    return {name: load(name) for name in (*library_names(), *(each for family in FAMILIES for each in family.members))}


def start_of(scenario: Scenario) -> dict[str, float | None]:
    """Where a scenario's own values are, in SI; of the obstacle None where there is none."""
    place = first_place(scenario)
    x, y = (None, None) if place is None else place
    return {"speed": scenario.ego.speed, "distance": x, "friction": scenario.road.friction, "offset": y}


def first_place(scenario: Scenario) -> tuple[float, float] | None:
    """Where the first obstacle begins [m]; None without obstacles."""
    if not scenario.obstacles:
        return None
    first = scenario.obstacles[0]
    return first.waypoints[0].position if first.position is None else first.position


def moved_toml(moved: Moved) -> str:
    """The TOML document of a scenario with what is moved.

    Raises:
        InputError: there is no such scenario, or a value cannot be.
    """
    if moved.scenario not in scenarios():
        guess = nearest(moved.scenario, scenarios())
        advice = f"did you mean {guess}?" if guess else "write a name that `swerve scenarios` lists"
        raise InputError(f"{one_line(moved.scenario)}: no such scenario; {advice}")
    base = scenarios()[moved.scenario]
    tables = tomllib.loads(base.to_toml())
    changes = moved.model_dump(exclude={"scenario"}, exclude_none=True)
    if changes:
        _move(tables, first_place(base), changes)
    return read_scene(tomli_w.dumps(tables)).to_toml()


def read_scene(toml: str) -> Scenario:
    """The scenario in a scene's TOML document.

    Raises:
        InputError: it is no scenario, is more than the studio runs, or wants a file.
    """
    content = toml.encode()
    _check_reads_nothing(tables_of(content, FILE, CONTENTS))
    scenario = parse(content, FILE)
    rows = scenario.n_samples * scenario.n_substeps
    if rows > MOST_ROWS:
        fault = f"{rows} steps of the plant are more than {MOST_ROWS}"
        raise InputError(f"{FILE}: duration: {fault}; write a shorter one, or a longer plant.step")
    if len(scenario.obstacles) > MOST_OBSTACLES:
        raise InputError(f"{FILE}: obstacles: are {len(scenario.obstacles)}; write at most {MOST_OBSTACLES}")
    return scenario


def _check_reads_nothing(tables: dict[str, Any]) -> None:
    """A scenario file can name a tyre's file; what comes through the network must not read any."""
    ego = tables.get("ego")
    tyre = ego.get("tyre") if isinstance(ego, dict) else None
    if isinstance(tyre, str) and tyre not in TYRES:
        cure = f"write one of {', '.join(TYRES)}, or its tables as [ego.tyre]"
        raise InputError(f"{FILE}: ego.tyre: no file is read here; {cure}")


def _move(tables: dict[str, Any], place: tuple[float, float] | None, changes: dict[str, Any]) -> None:
    """Write the changes into a scenario's tables, its name and description included."""
    if "speed" in changes:
        tables["ego"]["speed"] = tables["goal"]["speed"] = changes["speed"]
    if "friction" in changes:
        tables["road"]["friction"] = changes["friction"]
    if "duration" in changes:
        tables["duration"] = changes["duration"]
    if "distance" in changes or "offset" in changes:
        _shift(tables, _shift_of(place, changes))
    told = ", ".join(text.format(changes[key]) for key, text in TEXTS.items() if key in changes)
    tables["description"] = f"{tables['name']} with {told}"
    tables["name"] = f"{tables['name']}-moved"


def _shift_of(place: tuple[float, float] | None, changes: dict[str, Any]) -> tuple[float, float]:
    """By how much the obstacles are moved along X and Y [m]."""
    if place is None:
        raise InputError(f"{FILE}: distance and offset: the scenario has no obstacle; leave both out")
    shift = []
    for key, start in zip(("distance", "offset"), place, strict=True):
        try:
            shift.append(to_si(changes[key], "length") - start if key in changes else 0.0)
        except ValueError as error:
            raise InputError(f"{FILE}: {key}: {error}") from error
    return shift[0], shift[1]


def _shift(tables: dict[str, Any], shift: tuple[float, float]) -> None:
    for obstacle in tables["obstacles"]:
        for each in (*obstacle.get("waypoints", ()), *([obstacle] if "position" in obstacle else [])):
            each["position"] = [value + by for value, by in zip(each["position"], shift, strict=True)]
