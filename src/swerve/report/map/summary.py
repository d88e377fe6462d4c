"""What is told of a map: of every distance its ratio to the limit, and how many metres the four wheel torques buy.

The limit is that of steering and a torque of its own on every wheel; what these torques buy is by how much nearer it is
than that of steering and brakes which act alike left and right.
"""

from typing import Final

from swerve.study.map.boundary import Condition, Map

INDIVIDUAL: Final = "limit: individual"
BOTH: Final = "limit: both"

Panel = tuple[float, float]  # friction [1] and offset [m]


def panels(found: Map) -> list[Panel]:
    """Friction and offset of each panel, by offset and then by friction."""
    pairs = {(each.offset, each.friction) for each in found.conditions}
    return [(friction, offset) for offset, friction in sorted(pairs)]


def conditions_of(found: Map, panel: Panel) -> list[Condition]:
    """The conditions of a panel, by speed."""
    return sorted(each for each in found.conditions if (each.friction, each.offset) == panel)


def panel_name(found: Map, panel: Panel) -> str:
    """Its friction, and where the map has several its offset."""
    friction, offset = panel
    several = len({each.offset for each in found.conditions}) > 1
    return f"friction {friction:g}" + (f", offset {offset:g} m" if several else "")


def avoided(found: Map, who: str, condition: Condition) -> float | None:
    """The last avoided distance of a series [m]; None where there is none."""
    boundary = found.boundary(who, condition)
    return None if boundary is None else boundary.avoided


def ratio(found: Map, who: str, condition: Condition) -> float | None:
    """Of a last avoided distance to the limit [1]; None without one of them."""
    own, limit = avoided(found, who, condition), avoided(found, INDIVIDUAL, condition)
    return None if own is None or limit is None else own / limit


def ratios(found: Map, who: str) -> list[float]:
    """Of every condition that has one [1]."""
    return [value for each in found.conditions if (value := ratio(found, who, each)) is not None]


def bought(found: Map, condition: Condition) -> float | None:
    """How many metres the four wheel torques buy [m]; None without both limits."""
    both, individual = avoided(found, BOTH, condition), avoided(found, INDIVIDUAL, condition)
    return None if both is None or individual is None else both - individual


def most_bought(found: Map) -> tuple[float, Condition] | None:
    """The most that they buy [m], and where; None without both limits."""
    pairs = [(value, each) for each in found.conditions if (value := bought(found, each)) is not None]
    return max(pairs, default=None)


def reach(found: Map, who: str) -> str | None:
    """From where to where a controller's ratios go, and of how many conditions; None without any."""
    values, n = ratios(found, who), len(found.conditions)
    if not values:
        return None
    return f"{min(values):.3f} to {max(values):.3f} times in {len(values)} of {n} conditions"
