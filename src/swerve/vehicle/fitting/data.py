"""Tyre data: the lateral force over the slip angle, in blocks of one vertical load each.

Signs are those of the two-track model: a positive slip angle (alpha = delta - beta for a steered wheel) gives a
positive lateral force, to the left. The friction coefficient of the data's surface counts as mu = 1.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import degrees
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.errors import InputError

Array = NDArray[np.float64]

FEWEST_LOADS: Final = 3  # two make a line, the third shows how good it is
FEWEST_SLIP_ANGLES: Final = 8  # in a block: two more than B, C, D, E and two shifts
SAME_LOAD: Final = 0.05  # of a block's first load: as far as its others may be from it [1]


@dataclass(frozen=True, eq=False)
class LoadBlock:
    """Points at one vertical load, in any order.

    Attributes:
        place: where in the file they are, for messages.
        loads: (n,) as measured [N].
        slip_angles: (n,) [rad].
        forces: (n,) lateral [N].
    """

    place: str
    loads: Array
    slip_angles: Array
    forces: Array

    @property
    def load(self) -> float:
        """Mean of the loads [N]."""
        return float(self.loads.mean())

    @property
    def is_two_sided(self) -> bool:
        """Whether there are points enough on both sides of zero slip angle to tell a shift of the curve."""
        sides = (self.slip_angles[self.slip_angles > 0], self.slip_angles[self.slip_angles < 0])
        return all(len(np.unique(side)) >= FEWEST_SLIP_ANGLES // 2 for side in sides)


@dataclass(frozen=True, eq=False)
class TyreData:
    """What a fit starts from.

    Attributes:
        file: what messages call it.
        note: what it is and how it was brought into the signs above, one line.
        blocks: with rising loads.
    """

    file: str
    note: str
    blocks: tuple[LoadBlock, ...]

    def __post_init__(self) -> None:
        if len(self.blocks) < FEWEST_LOADS:
            cure = f"at least {FEWEST_LOADS} are needed, more than {SAME_LOAD:.0%} apart"
            raise InputError(f"{self.file}: points at {_count(len(self.blocks), 'load')}; {cure}")
        for block in self.blocks:
            _check(block, f"{self.file}: {block.place}")


def blocks_of(
    file: str, lines: Sequence[int], loads: Array, slip_angles: Array, forces: Array
) -> tuple[LoadBlock, ...]:
    """Points in the order of the file, cut into blocks where the load rises.

    Args:
        file: what messages call it.
        lines: (n,) of the points in it.
        loads: (n,) above 0 [N].
        slip_angles: (n,) [rad].
        forces: (n,) [N].

    Raises:
        InputError: the load falls.
    """
    starts = [0]
    for i, load in enumerate(loads):
        first = loads[starts[-1]]
        if load < (1 - SAME_LOAD) * first:
            fault = f"load {load:g} N after {first:g} N (line {lines[starts[-1]]})"
            cure = "write all points of one load together, and the loads in rising order"
            raise InputError(f"{file}: line {lines[i]}: {fault}; {cure}")
        if load > (1 + SAME_LOAD) * first:
            starts.append(i)
    return tuple(
        LoadBlock(f"lines {lines[a]} to {lines[b - 1]}", loads[a:b], slip_angles[a:b], forces[a:b])
        for a, b in zip(starts, [*starts[1:], len(loads)], strict=True)
    )


def _check(block: LoadBlock, place: str) -> None:
    n = len(np.unique(block.slip_angles))
    if n < FEWEST_SLIP_ANGLES:
        fault = f"load {block.load:.6g} N has {_count(n, 'slip angle')}"
        raise InputError(f"{place}: {fault}; at least {FEWEST_SLIP_ANGLES} different ones are needed")
    if not float(block.slip_angles @ block.forces) > 0:
        widest = int(np.abs(block.slip_angles).argmax())
        pair = f"{block.forces[widest]:g} N at {degrees(block.slip_angles[widest]):g} deg"
        cure = "a positive slip angle gives a positive force here; change the sign of one column"
        raise InputError(f"{place}: lateral force against the slip angle, {pair}; {cure}")


def _count(n: int, noun: str) -> str:
    return f"{n} {noun}{'' if n == 1 else 's'}"
