"""Numbers of a frozen dataclass that carry their dimension, their unit and the sign that they must have."""

from dataclasses import field, fields
from math import inf, isfinite
from typing import Any


def quantity(
    dimension: str, unit: str, *, sign: str = "positive", default: float | None = None, unlimited: bool = False
) -> float:
    """A field that carries its dimension and unit; `sign` is 'positive' or 'not negative'; `unlimited` allows inf."""
    metadata = {"dimension": dimension, "unit": unit, "sign": sign, "unlimited": unlimited or default == inf}
    return field(metadata=metadata) if default is None else field(default=default, metadata=metadata)


def check(instance: Any) -> None:
    """ValueError when a quantity of a dataclass is not finite (unless it may be unlimited), or has the wrong sign."""
    for each in fields(instance):
        if "sign" in each.metadata:
            _check(each.name, getattr(instance, each.name), each.metadata["sign"], each.metadata["unlimited"])


def _check(name: str, value: float, sign: str, unlimited: bool) -> None:
    if not (isfinite(value) or (unlimited and value == inf)):
        raise ValueError(f"{name} must be finite, got {value}")
    if value < 0 or (value == 0 and sign == "positive"):
        raise ValueError(f"{name} must be {sign}, got {value:g}")
