"""Property files: what is read of them, and the line at fault where they are not read."""

import re
from collections.abc import Callable
from math import radians
from pathlib import Path

import numpy as np
import pytest

from swerve.errors import InputError
from swerve.vehicle.fitting import fit_tyre, read_tyre_data
from tests.vehicle.fitting.points import HERE

MF_61, MF_52 = ((HERE / name).read_text() for name in ("sample_61.tir", "sample_52.tir"))
Write = Callable[[str], Path]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Writes a property file."""

    def done(text: str) -> Path:
        path = tmp_path / "tyre.tir"
        path.write_text(text)
        return path

    return done


def line_of(text: str, start: str) -> int:
    """The number of the first line that begins so."""
    return next(i for i, line in enumerate(text.splitlines(), start=1) if line.startswith(start))


def test_loads_and_slip_angles_stay_within_the_file_s_ranges() -> None:
    """Eight loads to FZMAX, slip angles from ALPMIN to ALPMAX turned into the signs used here."""
    data = read_tyre_data(HERE / "sample_61.tir")
    assert [block.load for block in data.blocks] == pytest.approx(np.linspace(4300 / 4, 8200, 8))
    slips = data.blocks[0].slip_angles
    assert (slips.min(), slips.max(), len(slips)) == pytest.approx((-0.28, 0.3, 81))


def test_ranges_that_a_file_does_not_give_have_defaults() -> None:
    """A quarter of FNOMIN to twice it, -20 to 20 deg."""
    data = read_tyre_data(HERE / "sample_52.tir")
    assert (data.blocks[0].load, data.blocks[-1].load) == pytest.approx((1025, 8200))
    assert data.blocks[0].slip_angles.max() == pytest.approx(radians(20))


def test_a_positive_slip_angle_gives_a_positive_force(write: Write) -> None:
    """Whichever way the file counts it, and the two give the same tyre."""
    turned = re.sub(r"^(P[HK]Y1) = (-?)", lambda m: f"{m[1]} = {'' if m[2] else '-'}", MF_52, flags=re.MULTILINE)
    turned = re.sub(r"^(PHY[23]|PEY[34]) = (-?)", lambda m: f"{m[1]} = {'' if m[2] else '-'}", turned, flags=re.M)
    ours, other = (read_tyre_data(path) for path in (HERE / "sample_52.tir", write(turned)))
    assert ("turned" in ours.note, "turned" in other.note) == (True, False)
    for a, b in zip(ours.blocks, other.blocks, strict=True):
        assert a.slip_angles @ a.forces > 0
        np.testing.assert_allclose(a.forces[::-1], b.forces, rtol=1e-12)


def test_the_inflation_pressure_is_the_file_s_own(write: Write) -> None:
    """INFLPRES over NOMPRES counts; without them, or in PAC2002's names, likewise."""
    own = read_tyre_data(HERE / "sample_61.tir").blocks[3].forces
    nominal = read_tyre_data(write(MF_61.replace("INFLPRES = 210000", "INFLPRES = 230000"))).blocks[3].forces
    absent = read_tyre_data(write(re.sub("(INFL|NOM)PRES.*", "", MF_61))).blocks[3].forces
    named = read_tyre_data(write(MF_61.replace("INFLPRES", "IP").replace("NOMPRES", "IP_NOM"))).blocks[3].forces
    np.testing.assert_array_equal(nominal, absent)
    np.testing.assert_array_equal(own, named)
    assert np.abs(own - nominal).max() > 10


@pytest.mark.parametrize("fittyp", ["60", "61", "62"])
def test_versions_6_give_the_same_pure_side_force(write: Write, fittyp: str) -> None:
    """6.0, 6.1 and 6.2 differ elsewhere."""
    data = read_tyre_data(write(MF_61.replace("= 61 ", f"= {fittyp} ")))
    assert f"6.{fittyp[1]}" in data.note
    np.testing.assert_array_equal(data.blocks[0].forces, read_tyre_data(HERE / "sample_61.tir").blocks[0].forces)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("FITTYP = 6 ", "FITTYP = 21 "),
        ("FITTYP = 6 ", "FITTYP = 52 "),
        ("PROPERTY_FILE_FORMAT ='MF-TYRE'", "property_file_format = 'pac2002'"),
        ("FITTYP = 6  $Magic Formula Version number\n", "PROPERTY_FILE_FORMAT ='PAC2002'\n"),
        ("PCY1 = 0.131000E+01  $Shape", "pcy1=1.31 ! shape"),
        ("LGAY = .900000E+00\n", "LGAY = .900000E+00\r\n"),
        ("! : COMMENT :", "! : 20 \xb0C :"),
    ],
)
def test_other_ways_to_write_the_same(write: Write, old: str, new: str) -> None:
    """Other names of version 5.2, lower case, comments after !, other line ends and Latin-1 change nothing."""
    text = MF_52.replace("PROPERTY_FILE_FORMAT ='MF-TYRE'\n", "") if "PAC2002" in new else MF_52
    assert old in text
    path = write("")
    path.write_bytes(text.replace(old, new).encode("latin-1"))
    expected = read_tyre_data(HERE / "sample_52.tir")
    np.testing.assert_array_equal(read_tyre_data(path).blocks[5].forces, expected.blocks[5].forces)


def test_the_fit_of_a_property_file_is_near_its_own_coefficients() -> None:
    """C is near PCY1 LCY, D near mu_y and E near Ey, and little is left over."""
    fits = fit_tyre(read_tyre_data(HERE / "sample_61.tir")).loads
    for fit in fits:
        curve, dfz = fit.full, fit.full.load / (1.05 * 4300) - 1
        assert pytest.approx(1.37 * 0.98, rel=2e-3) == curve.C
        assert pytest.approx((0.98 - 0.115 * dfz) * 0.9, rel=2e-2) == curve.D
        assert pytest.approx((-0.55 - 0.35 * dfz) * 1.1, rel=5e-2) == curve.E
        assert curve.rms_error < 0.002 * curve.D * curve.load


REFUSED = [  # what is replaced in sample_61.tir, by what, the line that the message names, and what it says
    (
        "FITTYP   = 61 ",
        "FITTYP   = 5 ",
        "FITTYP",
        "FITTYP 5 stands for another tyre model; Magic Formula 5.2 (FITTYP 6",
    ),
    ("FITTYP   = 61 ", "FITTYP   = 51 ", "FITTYP", "FITTYP 51 stands for another tyre model"),
    ("FITTYP   = 61 ", "FITTYP   = ", "FITTYP", "FITTYP is empty, stands for another tyre model"),
    ("FITTYP   = 61 ", "PROPERTY_FILE_FORMAT = 'FTIRE' ", "PROP", "PROPERTY_FILE_FORMAT 'FTIRE' is another tyre model"),
    ("LONGVL ", "PROPERTY_FILE_FORMAT = 'PAC_MC'\nLONGVL ", "PROP", "PROPERTY_FILE_FORMAT 'PAC_MC' is another tyre"),
    ("PDY1 ", "PCY2 = 0.7\nPDY1 ", "PCY2", "PCY2 belongs to the Magic Formula of motorcycle tyres"),
    ("FITTYP   = 61 ", "", None, "no FITTYP, which tells the tyre model"),
    ("PKY1 = -19.5", "", None, "no PKY1; write it"),
    ("FNOMIN = 4300", "FNOMIN = -4300", "FNOMIN", "FNOMIN = -4300 is not above 0"),
    ("PDY2 = -0.115", "PDY2 = nan", "PDY2", "PDY2: 'nan' is not finite; write a plain number, or"),
    ("PDY2 = -0.115", "PDY2 = 1e999", "PDY2", "PDY2: '1e999' is not finite"),
    ("PDY2 = -0.115", "PDY2 = -0,115", "PDY2", "PDY2: '-0,115' is no number"),
    ("PDY2 = -0.115", "PDY2 =", "PDY2", "PDY2: '' is no number"),
    ("PDY2 = -0.115", "PDY2 -0.115", "PDY2", "no '=' in 'PDY2 -0.115'; write KEY = value"),
    ("PVY1 =", "PDY2 = 0.1\nPVY1 =", None, "PDY2 again, after line"),
    ("FZMIN = 500", "FZMIN = 9000", None, "FZMIN = 9000 is not below FZMAX = 8200; mend one of them"),
    ("FZMIN = 500", "FZMIN = 8200", None, "FZMIN = 8200 is not below FZMAX = 8200"),
    ("FZMAX = 8200", "FZMAX = 900", None, "FZMIN = 500 to FZMAX = 900 has nothing of what is fitted"),
    ("ALPMAX = 0.28", "ALPMAX = -0.5", None, "ALPMIN = -0.3 is not below ALPMAX = -0.5"),
    ("ALPMIN = -0.3\nALPMAX = 0.28", "ALPMIN = -0.01\nALPMAX = 0.01", None, "slip angles reach 0.573 deg"),
    ("FORCE  = 'newton'", "FORCE  = 'pound_force'", "FORCE", "FORCE = 'pound_force' is a unit that is not read"),
    (
        "ANGLE  = 'radians'",
        "ANGLE  = 'degree'",
        "ANGLE",
        "ANGLE = 'degree' is a unit that is not read; convert the file",
    ),
    ("NOMPRES  = 230000", "NOMPRES  = 0", "NOMPRES", "NOMPRES = 0 is not above 0"),
    ("PCY1 =  1.37 ", "PCY1 =  0 ", "PCY1", "PCY1 = 0 makes no force; write a number that does"),
    ("PDY2 = -0.115", "PDY2 = 1e308", None, "a lateral force that is not finite; mend PCY1"),
]


@pytest.mark.parametrize(("old", "new", "at", "message"), REFUSED, ids=[f"{new[:24]!r}" for _, new, _, _ in REFUSED])
def test_a_wrong_file_is_refused(write: Write, old: str, new: str, at: str | None, message: str) -> None:
    """The message names the file, the line where there is one, the key and the value, on one line."""
    assert old in MF_61
    text = MF_61.replace(old, new, 1)
    with pytest.raises(InputError) as caught:
        fit_tyre(read_tyre_data(write(text)))
    said = str(caught.value)
    assert message in said
    assert "tyre.tir: " in said
    assert "\n" not in said
    if at is not None:
        assert f"tyre.tir: line {line_of(text, at)}: " in said
