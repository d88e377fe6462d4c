"""What counts as time in a part, by a clock that only the timed functions advance."""

from collections.abc import Iterator
from types import SimpleNamespace
from unittest.mock import patch

import pytest

from bench import stopwatch
from bench.stopwatch import Stopwatch, recording


class Clock:
    """A processor's time in whole seconds."""

    def __init__(self) -> None:
        self.now = 0.0

    def process_time(self) -> float:
        """The time."""
        return self.now


@pytest.fixture
def watched() -> Iterator[SimpleNamespace]:
    """Functions that take 1, 2 and 4 s of themselves: `inner`, `outer` which calls it, and `step` which calls all."""
    clock, functions = Clock(), SimpleNamespace()

    def inner() -> None:
        clock.now += 1

    def outer() -> None:
        clock.now += 2
        functions.inner()

    def step() -> None:
        clock.now += 4
        functions.inner()
        functions.outer()

    functions.inner, functions.outer, functions.step = inner, outer, step
    with patch.object(stopwatch, "time", clock):
        yield functions


def test_parts_and_rest_add_up_to_the_step(watched: SimpleNamespace) -> None:
    """A call inside a part counts in that part alone, and what is in no part is the rest."""
    watch = Stopwatch()
    with watch.watching((watched, "step"), {"inner": [(watched, "inner")], "outer": [(watched, "outer")]}):
        watched.step()
    (step,) = watch.steps
    assert step.parts == {"inner": (1.0,), "outer": (3.0,)}
    assert (step.duration, step.rest) == (8.0, 4.0)


def test_one_part_can_be_several_functions(watched: SimpleNamespace) -> None:
    """The calls of all its functions are listed in the order in which they happened."""
    watch = Stopwatch()
    with watch.watching((watched, "step"), {"both": [(watched, "inner"), (watched, "outer")]}):
        watched.step()
    assert watch.steps[0].parts == {"both": (1.0, 3.0)}
    assert watch.steps[0].total("neither") == 0


def test_calls_outside_of_steps_do_not_count(watched: SimpleNamespace) -> None:
    """What is called before, between and after the steps belongs to none of them."""
    watch = Stopwatch()
    with watch.watching((watched, "step"), {"inner": [(watched, "inner")]}):
        watched.inner()
        watched.step()
        watched.inner()
        watched.step()
        watched.inner()
    assert [step.parts for step in watch.steps] == [{"inner": (1.0, 1.0)}] * 2


def test_a_part_that_fails_is_counted_and_fails(watched: SimpleNamespace) -> None:
    """An exception passes through the stopwatch, and the next call is timed as ever."""
    watch, inner = Stopwatch(), watched.inner

    def failing() -> None:
        inner()
        raise ArithmeticError

    def step() -> None:
        with pytest.raises(ArithmeticError):
            watched.outer()
        watched.inner()

    watched.outer, watched.step = failing, step
    with watch.watching((watched, "step"), {"inner": [(watched, "inner")], "outer": [(watched, "outer")]}):
        watched.step()
    assert watch.steps[0].parts == {"outer": (1.0,), "inner": (1.0,)}


def test_functions_are_put_back(watched: SimpleNamespace) -> None:
    """After the block, also one that failed, the functions are the ones from before."""
    before = dict(vars(watched))
    watch = Stopwatch()
    with (
        pytest.raises(ArithmeticError),
        watch.watching((watched, "step"), {"inner": [(watched, "inner")]}),
        recording((watched, "outer")),
    ):
        raise ArithmeticError
    assert vars(watched) == before


def test_recording_keeps_arguments_and_answers() -> None:
    """Each call's arguments are kept in order, and the caller gets what it asked for."""
    owner = SimpleNamespace(add=lambda a, b: a + b)
    with recording((owner, "add")) as calls:
        assert [owner.add(1, 2), owner.add(3, b=4)] == [3, 7]
    assert calls == [(1, 2), (3,)]
