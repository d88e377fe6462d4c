"""What a run decided, in one word, from its commands and plans."""

import numpy as np
import pytest

from swerve.control import Side
from swerve.signals import Command
from swerve.simulate.decision import decision
from tests.simulate.recordings import COAST, plan

GRIP = 0.85 * 1530 * 9.81  # [N]
LEFT, RIGHT = Side.LEFT, Side.RIGHT


def steer(angle: float, force: float = 0.0) -> Command:
    """A steering angle [rad] and a sum of wheel forces [N]."""
    return Command(angle, np.full(4, force / 4))


def word(*steps: tuple[Command, Side | None]) -> str:
    """The decision of these steps of 50 ms."""
    return decision([command for command, _ in steps], [plan(side) for _, side in steps], GRIP, 0.05)


def shaped(*steps: tuple[Command, bool]) -> str:
    """The decision of these steps without a side, each shaped by an obstacle or not."""
    plans = [plan(None, is_shaped=is_shaped) for _, is_shaped in steps]
    return decision([command for command, _ in steps], plans, GRIP, 0.05)


def test_braking_needs_no_side() -> None:
    """A run that stays behind its obstacle brakes, however it moves its wheels; unshaped steps are only driving."""
    assert shaped(*3 * [(steer(0.0, -0.5 * GRIP), True)]) == "brake"
    assert shaped(*3 * [(steer(0.3, -0.5 * GRIP), True)]) == "brake"
    assert shaped(*3 * [(steer(0.0, -0.5 * GRIP), False)]) == "none"
    assert shaped((steer(0.0, -0.5 * GRIP), True), *9 * [(steer(0.0, -0.5 * GRIP), False)]) == "none"
    assert shaped((COAST, True)) == "none"


def test_a_side_that_no_obstacle_shaped_is_none() -> None:
    """Steering to a side in steps that no obstacle shaped is only driving."""
    assert decision([steer(0.1)], [plan(LEFT, is_shaped=False)], GRIP, 0.05) == "none"


def test_braking_before_steering_is_both() -> None:
    """First behind the obstacle, then past it: both words, the side that of the steps that have one."""
    commands = [*3 * [steer(0.0, -0.5 * GRIP)], steer(-0.05)]
    plans = [*3 * [plan(None, is_shaped=True, name="brake")], plan(RIGHT, name="right")]
    assert decision(commands, plans, GRIP, 0.05) == "brake+steer-right"


def test_no_obstacle_no_decision() -> None:
    """Where no obstacle shaped a plan, braking hard and steering far are only driving."""
    assert word((COAST, None)) == "none"
    assert word(*5 * [(steer(0.3, -GRIP), None)]) == "none"


@pytest.mark.parametrize(("side", "found"), [(LEFT, "steer-left"), (RIGHT, "steer-right")])
def test_steering_is_named_by_the_side(side: Side, found: str) -> None:
    """One steering command beyond 0.01 rad, whatever its sign, is steering to the side of the plans."""
    assert word((steer(0.02), side), (COAST, side)) == found
    assert word((steer(-0.02), side), (COAST, side)) == found
    assert word((steer(0.009), side), (steer(-0.009), side)) == "none"


@pytest.mark.parametrize(
    ("share", "n", "found"), [(-0.21, 2, "brake"), (-0.19, 2, "none"), (-0.5, 1, "none"), (0.5, 9, "none")]
)
def test_braking_is_deceleration_that_lasts(share: float, n: int, found: str) -> None:
    """More than a fifth of the grip for a tenth of a second is braking; less, shorter, or driving is not."""
    assert word(*n * [(steer(0.0, share * GRIP), LEFT)], (COAST, LEFT)) == found


@pytest.mark.parametrize(("side", "found"), [(LEFT, "brake+steer-left"), (RIGHT, "brake+steer-right")])
def test_both_together(side: Side, found: str) -> None:
    """Braking and steering in one run are both named."""
    assert word(*4 * [(steer(0.05, -0.4 * GRIP), side)]) == found


def test_the_side_is_that_of_most_steps() -> None:
    """A change of mind at the beginning does not name the run; at a tie it is left."""
    assert word((steer(0.05), LEFT), *3 * [(steer(-0.05), RIGHT)]) == "steer-right"
    assert word((steer(0.05), LEFT), (steer(-0.05), RIGHT)) == "steer-left"
