"""Which ways are planned in a step, in what order, and what a price is worth."""

from dataclasses import replace

import numpy as np
import pytest

from swerve.control.fallback import shifted
from swerve.control.plan import Passing
from swerve.control.unified.deadline import Deadline
from swerve.control.unified.memory import Memory, is_same
from swerve.control.unified.planning import MOST_PLANNED, Planning
from swerve.control.unified.way import Way
from swerve.signals import Measurement
from swerve.world import Ellipse, Obstacle, Rectangle, Steady
from tests.control.unified.situations import (
    BOX_CAR,
    LANES,
    RUNNING,
    controller,
    empty,
    formulation,
    in_the_mirror,
    planned,
    scene,
    seen,
)

LEFT, RIGHT, BEHIND = Passing.LEFT, Passing.RIGHT, Passing.BEHIND
CROWD = [Obstacle(Ellipse((1.0, 1.0)), Steady((30.0 + 8 * k, 0.3 * k))) for k in range(3)]


def planning(measurement: Measurement, memory: Memory, *of: str, allowed: float = np.inf) -> Planning:
    """The planning of a step with this memory."""
    formula = formulation(*of)
    obstacles = tuple(each.as_obstacle() for each in measurement.obstacles)
    found = scene(*obstacles, state=measurement.state, memory=memory, of=of)
    return Planning(formula, found, measurement, memory, Deadline(allowed, None))


def test_ways_are_planned_in_the_order_in_which_equals_are_preferred() -> None:
    """Brake, left, right: the order of the enumeration, whichever was planned first."""
    for memory in (controller().start(), planned(3)):
        plans = planning(seen(), memory).plans()
        assert [plan.way.name for plan in plans] == ["brake", "left", "right"]


def test_the_brake_is_always_planned() -> None:
    """Of more ways than are planned the brake is one, and there are no more than that."""
    plans = planning(seen(0.0, RUNNING, *CROWD), controller().start()).plans()
    assert len(plans) <= MOST_PLANNED
    assert any(plan.way.is_straight for plan in plans)
    assert len({plan.way.passing for plan in plans}) == len(plans)


def test_the_way_so_far_is_always_planned() -> None:
    """A way that was taken stays among those that are planned, cheap or not."""
    memory = planned(3)
    known = {(RIGHT,): memory.inputs[(RIGHT,)]}
    so_far = Memory(memory.commands, inputs=known, taken=(RIGHT,), committed=(RIGHT,), threats=(0,), count=3)
    names = [plan.way.name for plan in planning(seen(), so_far).plans()]
    assert "right" in names


def test_nothing_in_the_path_is_one_plan() -> None:
    """Where nothing is in the path there is one way and one plan."""
    (keep,) = planning(empty(), controller().start()).plans()
    assert keep.way.name == "keep"
    assert keep.n_solved >= 1


def test_beside_a_way_that_is_clear_the_others_take_turns() -> None:
    """While the way so far is clear each step spends one program on one of the others, another one in the next step."""
    memory = planned(3)
    assert memory.plan is not None
    improved = []
    for count in (memory.count, memory.count + 1):
        turn = replace(memory, count=count)
        solved = {p.way.name: p.n_solved for p in planning(seen(0.15, memory.plan.states[1]), turn).plans()}
        assert solved["left"] >= 1
        improved.append([name for name in ("brake", "right") if solved[name]])
        assert sum(solved[name] for name in ("brake", "right")) == 1
    assert improved[0] != improved[1]


def test_an_unsolved_step_has_ways_without_programs() -> None:
    """What the ways begin with, for a step without time: rolled out from the measured state, no program solved."""
    for plan in planning(seen(), planned(2)).unsolved():
        assert (plan.n_solved, plan.n_failed) == (0, 0)
        np.testing.assert_array_equal(plan.step.trajectory.states[0], RUNNING)


def test_what_was_overlooked_is_planned_about() -> None:
    """An obstacle that nothing said was in the path, but that the only plan touches, is taken for one that is."""
    step = planning(seen(), controller().start())
    blind = replace(step, scene=replace(step.scene, threats=(), natural=(RIGHT,)))
    (keep,) = (replace(plan, step=plan.situation.roll_out(np.zeros((20, 5)))) for plan in blind.plans())
    assert (keep.way.name, keep.violation > 0.5) == ("keep", True)
    again = blind.overlooked([keep])
    assert again is not None
    assert again.scene.threats == (0,)
    assert {plan.way.name for plan in again.plans()} == {"brake", "left", "right"}


def test_what_is_clear_overlooks_nothing() -> None:
    """A plan without faults is not planned again, nor is one that was about something in the path."""
    (keep,) = planning(empty(), controller().start()).plans()
    assert planning(empty(), controller().start()).overlooked([keep]) is None
    step = planning(seen(), controller().start())
    assert step.overlooked(step.plans()) is None


# Prices


def price(passing: Passing, obstacle: Obstacle, *of: str) -> float:
    """The price of passing one obstacle in this way."""
    return formulation(*of).price(scene(obstacle, of=of), Way((passing,), (0,)))


@pytest.mark.parametrize("lateral", [0.4, 1.0])
def test_the_shorter_way_round_is_cheaper(lateral: float) -> None:
    """An obstacle that is more to the left is cheaper to pass on its right, by the same as in the mirror."""
    obstacle = Obstacle(Ellipse((1.0, 1.0)), Steady((30.0, lateral)))
    assert price(RIGHT, obstacle) < price(LEFT, obstacle)
    assert price(LEFT, in_the_mirror(obstacle)) == pytest.approx(price(RIGHT, obstacle), rel=1e-9)


def test_what_leaves_the_road_or_hits_is_dear() -> None:
    """A way off the road costs more than the same one on it, and so does one that comes too late to pass."""
    obstacle = Obstacle(Rectangle(4.5, 1.8), Steady((40.0, 0.0)))
    on_the_road = (*BOX_CAR, *LANES)
    assert price(RIGHT, obstacle, *on_the_road) > price(RIGHT, obstacle, *BOX_CAR) + 1e3
    near = Obstacle(Rectangle(4.5, 1.8), Steady((10.0, 0.0)))
    assert price(LEFT, near, *BOX_CAR) > price(LEFT, obstacle, *BOX_CAR) + 1e3
    assert price(BEHIND, near, *BOX_CAR) > price(BEHIND, Obstacle(Rectangle(4.5, 1.8), Steady((60.0, 0.0))), *BOX_CAR)


# Memory


def test_a_way_is_known_again_by_what_is_in_the_path() -> None:
    """What is not in the path may be passed otherwise; what is in it may not; another number is another scene."""
    assert is_same((LEFT, RIGHT), (LEFT, BEHIND), (0,))
    assert not is_same((LEFT, RIGHT), (LEFT, BEHIND), (0, 1))
    assert not is_same((LEFT,), (LEFT, LEFT), (0,))
    assert not is_same(None, (LEFT,), (0,))


def test_the_very_same_way_comes_first() -> None:
    """Of ways that pass the path alike the one that is the same all over is remembered."""
    zeros = np.zeros((20, 5))
    memory = Memory((zeros[0],), inputs={(LEFT, RIGHT): zeros, (LEFT, BEHIND): zeros + 1})
    assert memory.key_of((LEFT, BEHIND), (0,)) == (LEFT, BEHIND)
    assert memory.key_of((LEFT, LEFT), (0,)) == (LEFT, RIGHT)
    assert memory.key_of((RIGHT, LEFT), (0,)) is None


def test_commands_are_remembered_the_last_one_first() -> None:
    """A new command pushes out the oldest."""
    first, second, third = (np.full(5, each) for each in (1.0, 2.0, 3.0))
    assert [each[0] for each in Memory((second, first)).after(third)] == [3.0, 2.0]
    np.testing.assert_array_equal(Memory((second, first)).command, second)


@pytest.mark.parametrize("samples", [0, 1, 3, 19, 20, 50])
def test_a_shifted_plan_holds_its_last_input(samples: int) -> None:
    """Some samples later the plan goes on with its own inputs, and then with the last of them."""
    inputs = np.arange(100.0).reshape(20, 5)
    wanted = [inputs[min(k + samples, 19)] for k in range(20)]
    np.testing.assert_array_equal(shifted(inputs, samples), wanted)
