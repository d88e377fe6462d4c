"""Families of scenarios: the grids of public test protocols, each member by its name, such as ccrs-50-il75."""

from typing import Final

from swerve.errors import InputError, nearest, one_line
from swerve.scenario.families.family import Case, Family, Tables
from swerve.scenario.families.lane_change import CUT_IN, CUT_OUT
from swerve.scenario.families.rear import CCRB, CCRM, CCRS

__all__ = ["FAMILIES", "Case", "Family", "member_tables"]

FAMILIES: Final[tuple[Family, ...]] = (CCRS, CCRM, CCRB, CUT_IN, CUT_OUT)


def member_tables(name: str) -> Tables | None:
    """The member of this name as the tables of a scenario file; None when no family is called so.

    Raises:
        InputError: the family has no such member.
    """
    for family in FAMILIES:
        if name in family.members:
            return family.tables(name)
        if name == family.name or name.startswith(f"{family.name}-"):
            near = nearest(name, family.members) or next(iter(family.members))
            cure = f"write one such as {near} ({family.pattern}: {family.ranges})"
            raise InputError(f"{one_line(name)}: no such member of the family {family.name}; {cure}")
    return None
