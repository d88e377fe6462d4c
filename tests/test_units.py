"""The grammar of quantities."""

import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.units import DIMENSIONS, to_si

NUMBERS = st.floats(min_value=-1e6, max_value=1e6)
UNITS = st.sampled_from([(name, unit) for name, dimension in DIMENSIONS.items() for unit in dimension.units])


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("72 km/h", "speed", 20.0),
        ("25 m", "length", 25.0),
        ("3.5m", "length", 3.5),
        ("  .5 m ", "length", 0.5),
        ("50 ms", "time", 0.05),
        ("0 deg", "angle", 0.0),
        ("90°", "angle", math.pi / 2),
        ("180 deg/s", "angular speed", math.pi),
        ("-4 m/s^2", "acceleration", -4.0),
        ("-4 m/s2", "acceleration", -4.0),
        ("-4 m/s²", "acceleration", -4.0),
        ("1600 kg", "mass", 1600.0),
        ("1.6 t", "mass", 1600.0),
        ("2315.3 kg m^2", "moment of inertia", 2315.3),
        ("2315.3 kg·m²", "moment of inertia", 2315.3),
        ("+4e0 kN", "force", 4000.0),
        ("85 %", "dimensionless", 0.85),
        ("0.85", "dimensionless", 0.85),
        ("60 mph", "speed", 26.8224),
    ],
)
def test_a_number_with_a_unit_is_read(text: str, dimension: str, value: float) -> None:
    """A number and a unit of the dimension give the SI value, however the unit's power or product is spelled."""
    assert to_si(text, dimension) == pytest.approx(value, rel=1e-15)


@given(NUMBERS, UNITS)
def test_every_unit_is_its_factor(number: float, named: tuple[str, str]) -> None:
    """A number written with any unit is that number times the unit's factor."""
    dimension, unit = named
    assert to_si(f"{number!r} {unit}", dimension) == number * DIMENSIONS[dimension].units[unit]


@given(NUMBERS | st.integers(-(10**6), 10**6), st.sampled_from(list(DIMENSIONS)))
def test_a_bare_number_is_in_si(number: float, dimension: str) -> None:
    """A number without a string round it is the SI value itself, as a float."""
    value = to_si(number, dimension)
    assert value == number
    assert isinstance(value, float)


@given(NUMBERS, UNITS, st.sampled_from(list(DIMENSIONS)))
def test_a_unit_of_another_dimension_is_refused(number: float, named: tuple[str, str], dimension: str) -> None:
    """A unit that the dimension does not list is refused, and the message lists those that it does."""
    unit = named[1]
    if unit in DIMENSIONS[dimension].units:
        return
    with pytest.raises(ValueError, match=re.escape(f"{number!r} {unit}".strip())) as caught:
        to_si(f"{number!r} {unit}", dimension)
    assert all(accepted in str(caught.value) for accepted in DIMENSIONS[dimension].units)


def test_the_message_says_what_would_be_right() -> None:
    """A refusal names the value, what it is not, how one is written, and the units."""
    cure = 'write a number in m/s or a string such as "72 km/h" (units: m/s, km/h, mph, kn)'
    with pytest.raises(ValueError, match=re.escape(f"'72 kg' is not a speed; {cure}")):
        to_si("72 kg", "speed")
    with pytest.raises(ValueError, match="'72' is without a unit; write a number in m/s"):
        to_si("72", "speed")


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, "nan m", "-inf m", "Infinity", "1e999 m", 10**400])
def test_what_is_not_finite_is_refused(value: object) -> None:
    """No infinite number and no nan comes in, as a number, as a word, or by overflow."""
    with pytest.raises(ValueError, match="is not finite; write"):
        to_si(value, "length")


@pytest.mark.parametrize("value", [True, None, [1.0], {"m": 1}, "", "m", "1 2 m", "1.2.3 m", "1,5 m", "0x10 m", "٣ m"])
def test_what_is_no_quantity_is_refused(value: object) -> None:
    """A bool, another type, or a string of another form is no quantity."""
    with pytest.raises(ValueError, match="is not a length; write"):
        to_si(value, "length")


@given(st.text(), st.sampled_from(list(DIMENSIONS)))
def test_any_text_is_a_finite_number_or_one_line(text: str, dimension: str) -> None:
    """Whatever the text, the answer is finite or the refusal is one printable line of bounded length."""
    try:
        assert math.isfinite(to_si(text, dimension))
    except ValueError as error:
        assert str(error).isprintable()
        assert len(str(error)) < 1000


def test_the_table_agrees_with_itself() -> None:
    """Every dimension's first unit is SI, with factor 1, and its example is a right quantity."""
    for name, dimension in DIMENSIONS.items():
        assert dimension.units[dimension.si_unit] == 1
        assert math.isfinite(to_si(dimension.example, name))
