"""A CasADi function as a callable on numpy arrays, through buffers that are bound once.

Binding arguments at every call costs about 100 us, more than most kernels take to run; bound buffers leave the copy
of a few numbers in and out.
"""

from functools import lru_cache
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import ArrayLike, NDArray

from swerve.kernel.library import SOURCES, compiled


class Kernel:
    """Evaluates `function`; compiled to C when a compiler is there, with the same result, bit for bit, when not.

    Not for use by two threads at once: the buffers are the kernel's own. Results are copies.
    """

    def __init__(self, function: ca.Function) -> None:
        """Compile (or take from the cache) and bind buffers.

        Args:
            function: CasADi function; sparse inputs and outputs are made dense.
        """
        function = _made_dense(function)
        library = compiled(function)
        self.is_compiled = library is not None
        self._function = function if library is None else ca.external(function.name(), str(library))
        self._buffer: Any  # its stub asks for a size, which a memoryview has
        self._buffer, self._evaluate = self._function.buffer()
        self._inputs = [_dense(self._function.size_in(i)) for i in range(self._function.n_in())]
        self._outputs = [_dense(self._function.size_out(i)) for i in range(self._function.n_out())]
        for i, array in enumerate(self._inputs):
            self._buffer.set_arg(i, _bytes(array))
        for i, array in enumerate(self._outputs):
            self._buffer.set_res(i, _bytes(array))

    def __call__(self, *arguments: ArrayLike) -> tuple[NDArray[np.float64], ...]:
        """Outputs for these inputs, each of the function's own shape; a column is (n,), and may come as (n, 1)."""
        for buffer, argument in zip(self._inputs, arguments, strict=True):
            buffer[...] = argument if np.ndim(argument) <= buffer.ndim else np.reshape(argument, buffer.shape)
        self._evaluate()
        return tuple(output.copy(order="K") for output in self._outputs)


def _bytes(array: NDArray[np.float64]) -> Any:
    """The memory of a buffer, in its own order."""
    return array.reshape(-1, order="A").data


def _dense(shape: tuple[int, int]) -> NDArray[np.float64]:
    """A buffer in CasADi's column-major order; (n, 1) becomes (n,)."""
    return np.zeros(shape[0]) if shape[1] == 1 else np.zeros(shape, order="F")


@lru_cache(maxsize=SOURCES)
def _made_dense(function: ca.Function) -> ca.Function:
    """The same function; buffers hold only the non-zeros of a sparse matrix, whose place would then be lost."""
    inputs, outputs = range(function.n_in()), range(function.n_out())
    patterns = [function.sparsity_in(i) for i in inputs] + [function.sparsity_out(i) for i in outputs]
    if all(pattern.is_dense() for pattern in patterns):
        return function
    symbols = [ca.MX.sym(function.name_in(i), *function.size_in(i)) for i in inputs]
    return ca.Function(function.name(), symbols, [ca.densify(output) for output in function.call(symbols)])
