"""A kernel is its CasADi function, fast: the same numbers, in arrays of its own shape."""

from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from swerve.kernel import Kernel
from swerve.kernel.folder import VARIABLE
from swerve.scenario import load
from swerve.simulate import run
from tests.kernel.compilers import compiler, example, uncompiled

NUMBERS = st.floats(-1e6, 1e6) | st.floats(-3.0, 3.0)


@pytest.fixture(scope="module")
def kernels(tmp_path_factory: pytest.TempPathFactory) -> tuple[Kernel, Kernel]:
    """The example compiled, and not."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(VARIABLE, str(tmp_path_factory.mktemp("kernels", numbered=True)))
        with compiler(patch, "cc"):
            fast = Kernel(example())
        return fast, uncompiled(patch, lambda: Kernel(example()))


@given(arrays(float, 3, elements=NUMBERS), arrays(float, (2, 3), elements=NUMBERS))
def test_compiled_and_uncompiled_agree_to_the_last_bit(
    kernels: tuple[Kernel, Kernel], x: np.ndarray, y: np.ndarray
) -> None:
    """A machine without a compiler gets the same numbers as one with it, to the last bit."""
    fast, slow = kernels
    assert (fast.is_compiled, slow.is_compiled) == (True, False)
    for compiled, interpreted in zip(fast(x, y), slow(x, y), strict=True):
        np.testing.assert_array_equal(compiled, interpreted)


@pytest.mark.parametrize(("controller", "plant"), [("unified", "planar"), ("as-printed", "multibody")])
def test_all_kernels_of_a_run_agree_to_the_last_bit(
    controller: str, plant: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Prediction, Jacobians and plant give the same bits compiled and uncompiled, on the way of a run and around it."""
    calls: dict[str, tuple[ca.Function, list]] = {}

    class Recorded(Kernel):
        def __init__(self, function: ca.Function) -> None:
            super().__init__(function)
            self.calls = calls.setdefault(function.name(), (function, []))[1]

        def __call__(self, *arguments: np.ndarray) -> tuple[np.ndarray, ...]:
            self.calls.append([np.array(each) for each in arguments])
            return super().__call__(*arguments)

    for user in ("control.unified.prediction", "control.as_printed.controller", "plant.planar", "plant.multibody"):
        monkeypatch.setattr(f"swerve.{user}.Kernel", Recorded)
    run(load("paper", ["duration=0.3 s"]), controller, plant)
    assert len(calls) >= 2
    random = np.random.default_rng(0)
    for function, known in calls.values():
        fast, slow = Kernel(function), uncompiled(monkeypatch, lambda function=function: Kernel(function))
        assert (fast.is_compiled, slow.is_compiled) == (True, False)
        for arguments in known[:20]:
            near = [
                each * random.uniform(0.5, 1.5, each.shape) + random.normal(0.0, 0.1, each.shape) for each in arguments
            ]
            for point in (arguments, near):
                for compiled, interpreted in zip(fast(*point), slow(*point), strict=True):
                    np.testing.assert_array_equal(compiled, interpreted)


@given(arrays(float, 3, elements=NUMBERS), arrays(float, (2, 3), elements=NUMBERS))
def test_a_kernel_is_its_function(kernels: tuple[Kernel, Kernel], x: np.ndarray, y: np.ndarray) -> None:
    """Every output has the function's own value in its own place; a column is (n,), a matrix (m, n)."""
    column, matrix, scalar = kernels[0](x, y)
    wanted = [np.array(each) for each in example().call([x, y])]
    assert (column.shape, matrix.shape, scalar.shape) == ((2,), (2, 3), (1,))
    np.testing.assert_array_equal(column, wanted[0][:, 0])
    np.testing.assert_array_equal(matrix, wanted[1])
    np.testing.assert_array_equal(scalar, wanted[2][0])


@pytest.mark.parametrize("which", [0, 1])
def test_results_are_the_callers_own(kernels: tuple[Kernel, Kernel], which: int) -> None:
    """A later call changes no earlier result, and writing into a result changes no later one."""
    kernel, x, y = kernels[which], np.array([1.0, 2.0, 3.0]), np.full((2, 3), 0.5)
    first = kernel(x, y)
    kept = [each.copy() for each in first]
    kernel(-x, -y)
    for each, copy in zip(first, kept, strict=True):
        np.testing.assert_array_equal(each, copy)
    for each in first:
        each[...] = np.nan
    for each, copy in zip(kernel(x, y), kept, strict=True):
        np.testing.assert_array_equal(each, copy)


@pytest.mark.parametrize("which", [0, 1])
def test_arguments_are_left_alone_and_may_have_any_layout(kernels: tuple[Kernel, Kernel], which: int) -> None:
    """Rows first, columns first, a slice of something larger, or lists: the same numbers, and none is written to."""
    kernel, x, y = kernels[which], np.arange(3.0), np.arange(6.0).reshape(2, 3) - 2
    wanted = kernel(x, y)
    strided = np.zeros((4, 6))
    strided[::2, ::2] = y
    for other in (np.asfortranarray(y), strided[::2, ::2], y.tolist()):
        for each, known in zip(kernel(x, other), wanted, strict=True):
            np.testing.assert_array_equal(each, known)
    np.testing.assert_array_equal(y, np.arange(6.0).reshape(2, 3) - 2)


def test_what_is_sparse_lands_at_its_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Matrices with structural zeros are taken and given whole, zeros included, compiled or not."""
    lower, diagonal = ca.SX.sym("L", ca.Sparsity.lower(3)), ca.SX.sym("d", 3)
    function = ca.Function("sparse", [lower, diagonal], [ca.sum1(lower), ca.diag(diagonal), ca.SX(2, 2)])
    matrix = np.arange(1.0, 10.0).reshape(3, 3)
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    for kernel in (Kernel(function), uncompiled(monkeypatch, lambda: Kernel(function))):
        sums, on_diagonal, nothing = kernel(matrix, [1.0, 2.0, 3.0])
        np.testing.assert_array_equal(sums, [np.tril(matrix).sum(axis=0)])
        np.testing.assert_array_equal(on_diagonal, np.diag([1.0, 2.0, 3.0]))
        np.testing.assert_array_equal(nothing, np.zeros((2, 2)))


def test_nan_passes_through(kernels: tuple[Kernel, Kernel]) -> None:
    """A nan goes in and comes out where the function says, and leaves nothing behind for the next call."""
    x, y = np.array([1.0, 2.0, 3.0]), np.full((2, 3), 0.5)
    for kernel in kernels:
        clean = kernel(x, y)
        assert np.isnan(kernel(x * np.nan, y)[2]).all()
        for each, known in zip(kernel(x, y), clean, strict=True):
            np.testing.assert_array_equal(each, known)


@pytest.mark.parametrize(
    "arguments", [(np.zeros(3),), (np.zeros(3), np.zeros((2, 3)), 1.0), (np.zeros(4), np.zeros((2, 3)))]
)
def test_misuse_is_refused(kernels: tuple[Kernel, Kernel], arguments: tuple[np.ndarray, ...]) -> None:
    """Too few arguments, too many, or one of the wrong length are an error, not a wrong number."""
    with pytest.raises(ValueError):
        kernels[0](*arguments)
