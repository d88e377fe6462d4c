"""Times functions from outside, in time of the processor: for as long as a `with` block lasts, timed ones replace them.

A call inside a timed part belongs to that part and is not counted by itself, so the parts of a step add up to no more
than the step; a call outside of a step does not count at all.
"""

import functools
import time
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from typing import Any
from unittest.mock import patch

Target = tuple[Any, str]  # a module or class, and the name of a function in it


@dataclass(frozen=True)
class Step:
    """One call of the function whose parts are timed.

    Attributes:
        duration: of the call [s].
        parts: of each part, the durations of its calls in order [s].
    """

    duration: float
    parts: Mapping[str, Sequence[float]]

    def total(self, part: str) -> float:
        """Time in a part, 0 where it was not called [s]."""
        return sum(self.parts.get(part, ()))

    @property
    def rest(self) -> float:
        """Time in no part [s]."""
        return self.duration - sum(self.total(part) for part in self.parts)


@dataclass
class Stopwatch:
    """What has been timed so far.

    Attributes:
        steps: in the order of their calls.
    """

    steps: list[Step] = field(default_factory=list)
    _parts: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    _is_running: bool = False

    @contextmanager
    def watching(self, step: Target, parts: Mapping[str, Sequence[Target]]) -> Iterator[None]:
        """Time `step`, and the parts by their names, until the block ends."""
        with ExitStack() as replaced:
            for name, targets in parts.items():
                for owner, function in targets:
                    timed = self._part(name, getattr(owner, function))
                    replaced.enter_context(patch.object(owner, function, timed))
            owner, function = step
            replaced.enter_context(patch.object(owner, function, self._step(getattr(owner, function))))
            yield

    def _part(self, name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(function)
        def timed(*arguments: Any, **named: Any) -> Any:
            if self._is_running:
                return function(*arguments, **named)
            self._is_running = True
            began = time.process_time()
            try:
                return function(*arguments, **named)
            finally:
                self._parts[name].append(time.process_time() - began)
                self._is_running = False

        return timed

    def _step(self, function: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(function)
        def timed(*arguments: Any, **named: Any) -> Any:
            self._parts = defaultdict(list)
            began = time.process_time()
            answer = function(*arguments, **named)
            duration = time.process_time() - began
            self.steps.append(Step(duration, {name: tuple(times) for name, times in self._parts.items()}))
            return answer

        return timed


@contextmanager
def recording(target: Target) -> Iterator[list[tuple[Any, ...]]]:
    """The positional arguments of each call of a function, in order, until the block ends."""
    owner, name = target
    function = getattr(owner, name)
    calls: list[tuple[Any, ...]] = []

    @functools.wraps(function)
    def recorded(*arguments: Any, **named: Any) -> Any:
        calls.append(arguments)
        return function(*arguments, **named)

    with patch.object(owner, name, recorded):
        yield calls
