"""The page of the scenario library, made from the library itself: `python docs/hooks/library.py > docs/library.md`."""

from collections.abc import Sequence

from swerve.scenario import FAMILIES, Scenario, library_names, load

HEAD = """# Scenario library

What comes with swerve: `swerve scenarios` lists it, `swerve run NAME` runs one. `make library` makes this page from it.

A source that begins with *own* names no publication: the scene was made up, and what follows says how its numbers were
chosen. `[unverified]` stands after what was found in no text of the protocol. Braking distances are those of a full
stop with the friction of the road, $v^2 / (2 \\mu g)$.
"""

FAMILIES_HEAD = """
## Families

A test of a public protocol in all its speeds and impact locations. A member is called by its parameters, as in
`swerve run ccrs-50-il75`; `swerve scenarios --json` lists all of them.
"""

BASE = """
What is the protocol's: the speeds, the impact locations, the target of 4.023 m by 1.712 m, the body of the vehicle
under test, 4.358 m by 1.815 m, and for `ccrb` headway and deceleration. The impact location is where the middle of the
target meets the front, 0 % its right end and 100 % its left one.

What is our own: the vehicle but for its body, the centre of gravity 1.9 m behind the front, a friction of 0.9, a lane
of 3.5 m with a free one on its left, and when it begins: `ccrs` and `ccrm` at a time to collision of 4 s, `ccrb` and
the lane changes 1 s before the target acts. The controller sees the target from the start. In the cut-ins the gap is
such that without any reaction the time to collision of the protocol is left when the lane change is over, 0 s and 1.5
s; in the cut-outs the lead has 3 s to the stationary car when its lane change begins, and the vehicle under test
follows it at its speed, 1.5 s behind.
"""


def page() -> str:
    """The page in Markdown."""
    scenes = [_row(load(name)) for name in library_names()]
    kin = [
        (f"`{family.pattern}`", family.title, family.ranges, str(len(family.members)), family.source)
        for family in FAMILIES
    ]
    library = _table(("name", "what it is for", "speed, km/h", "friction", "source"), scenes)
    families = _table(("name", "target", "parameters", "members", "source"), kin)
    return "\n".join([HEAD, library, FAMILIES_HEAD, families, BASE]).rstrip() + "\n"


def _row(scenario: Scenario) -> tuple[str, ...]:
    speed = f"{scenario.ego.speed * 3.6:.0f}"
    return f"`{scenario.name}`", scenario.description, speed, f"{scenario.road.friction:g}", scenario.source


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


if __name__ == "__main__":
    print(page(), end="")
