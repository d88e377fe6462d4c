"""A scenario's driver: what is read, and what is refused."""

import pytest

from swerve.errors import InputError
from swerve.scenario import load, parse
from swerve.scenario.driver import PREVIEW
from swerve.simulate.assemble import driver_of

STEERING = "driver.steering=[['0 s', '0 deg'], ['1 s', '9 deg']]"

REFUSED = [
    ("driver={}", "driver.steering: missing; write steering = "),
    ("driver.preview=1 s", "driver.steering: missing; write steering = "),
    ("driver={steering=[[0, 0]], preview=1}", "driver.preview: means nothing without a model; write model ="),
    ("driver={model='lane-keeper', steering=[[0, 0]]}", "driver.steering: is given beside model, which steers"),
    ("driver={model='lane-keeper', pedal=[[0, 0]]}", "driver.pedal: is given beside model, which steers"),
    ("driver.model=lane-keper", "driver.model: unknown driver 'lane-keper'; did you mean lane-keeper?"),
    ("driver={model='lane-keeper', preview='0 s'}", "driver.preview: '0 s' is out of range; write at least 0.1 s"),
    ("driver.steering=[['1 s', 0], ['1 s', 0]]", "driver.steering.1.0: 1 s is not after the one before it, 1 s; write"),
    ("driver.pedal=[[1, 0], [0.5, 0]]", "driver.pedal.1.0: 0.5 s is not after the one before it, 1 s; write"),
    ("driver.pedal=[[1, -1.5]]", "driver.pedal.0.1: -1.5 is out of range; write at least -1 and at most 1"),
    ("driver.pedal=[[1, '3 kN']]", "driver.pedal.0.1: '3 kN' is not a plain number; write"),
    ("driver.steering=[['0 s', '3 m']]", "driver.steering.0.1: '3 m' is not an angle; write"),
    ("driver.steering=[['0 s', '30 deg']]", "driver.steering.0: 0.523599 rad is beyond the vehicle's steering lock"),
    ("driver.steering=3", "driver.steering: 3 is not a list; write"),
    ("driver.stering=[[0, 0]]", "driver.stering: unknown key; did you mean driver.steering?"),
]


@pytest.mark.parametrize(("override", "message"), REFUSED, ids=[override for override, _ in REFUSED])
def test_a_wrong_driver_is_refused(override: str, message: str) -> None:
    """The message has the override, the key, the value and the cure, in one line."""
    with pytest.raises(InputError) as caught:
        load("paper", [override])
    assert "--set " in str(caught.value)
    assert message in str(caught.value)


def test_a_series_is_read_in_its_units() -> None:
    """Times and angles are quantities; a pedal's full brake is what all tyres carry together."""
    driver = driver_of(load("paper", [STEERING, "driver.pedal=[['0 s', '-50 %']]"]))
    assert driver is not None
    asked = driver(0.5, None)  # type: ignore[arg-type]  # a series looks at nothing
    assert asked.steering_angle == pytest.approx(0.0785398, abs=1e-6)
    assert asked.force == pytest.approx(-0.5 * 0.95 * 0.85 * 1530 * 9.81)


@pytest.mark.parametrize("keys", [(STEERING,), ("driver.model=lane-keeper",), ("driver.pedal=[[0, 0]]",), ()])
def test_a_driver_survives_the_file(keys: tuple[str, ...]) -> None:
    """A scenario that is written and read again has the same driver, or none."""
    scenario = load("paper", keys)
    assert parse(scenario.to_toml().encode(), "again.toml") == scenario
    assert (scenario.driver is None) == (not keys)


def test_a_quiet_driver_looks_ahead_as_long_as_is_told() -> None:
    """The preview time is the scenario's, or else that of quiet driving."""
    for keys, preview in (((), PREVIEW), (("driver.preview='2 s'",), 2.0)):
        driver = driver_of(load("driver-lane-keeping-quiet", keys))
        assert getattr(driver, "preview", None) == preview
