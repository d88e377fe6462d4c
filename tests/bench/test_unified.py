"""The bench sees the unified controller as it is now."""

from bench import unified
from swerve.scenario import load

SHORT = load("paper", ["duration=0.5 s"])


def test_every_part_is_timed() -> None:
    """Each part is called in a run that meets the obstacle, and no part takes longer than the step."""
    (steps,) = unified.steps(SHORT, 1)
    assert len(steps) == 10
    for part in unified.PARTS:
        assert sum(step.total(part) for step in steps) > 0, part
    assert all(step.rest > 0 for step in steps)


def test_every_kernel_is_timed() -> None:
    """The call of a kernel is a part of the method around it."""
    for kernel, method in unified.kernel_calls(SHORT).values():
        assert 0 < kernel.median < method.median


def test_a_record_tells_what_acted() -> None:
    """At each step the record has the input that the step before commanded, and at the first step none."""
    measured = unified.measured(SHORT)
    assert [measurement.time for measurement, _ in measured] == [0.05 * k for k in range(10)]
    assert not measured[0][1].any()
    assert any(command.any() for _, command in measured[1:])


def test_recorded_problems_can_be_solved_again() -> None:
    """The record holds the quadratic programs themselves."""
    problems = unified.problems(SHORT)
    assert len(problems) >= 10
    assert unified.solver_times(problems[:3], "piqp", 1).median > 0
