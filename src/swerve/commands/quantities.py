"""Lists of names and of quantities as options have them, such as "72 km/h,30"."""

from collections.abc import Iterable

from swerve.errors import InputError, unknown
from swerve.units import to_si


def names(option: str, kind: str, text: str, known: Iterable[str]) -> tuple[str, ...]:
    """Names in their order, each once; InputError for one that is none."""
    found = tuple(dict.fromkeys(name.strip() for name in text.split(",")))
    for name in found:
        if name not in known:
            raise InputError(f"--{option}: {unknown(kind, name, known)}")
    return found


def quantities(option: str, text: str, dimension: str, low: float, high: float) -> tuple[float, ...]:
    """Quantities of a dimension in SI, in ascending order, each once; InputError for one that cannot be."""
    return tuple(sorted({quantity(option, each, dimension, low, high) for each in text.split(",")}))


def quantity(option: str, text: str, dimension: str, low: float, high: float) -> float:
    """A quantity of a dimension in SI; InputError where it is none, or not from `low` to `high`."""
    try:
        value = to_si(_number(text), dimension)
    except ValueError as error:
        raise InputError(f"--{option}: {error}") from error
    if not low <= value <= high:
        raise InputError(f"--{option}: {text.strip()} is out of range; write {low:g} to {high:g}, in SI")
    return value


def _number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text.strip()
