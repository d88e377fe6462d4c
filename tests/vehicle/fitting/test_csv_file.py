"""CSV files: the ways to write the same data, and the line, column and value at fault where they are not read."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.errors import InputError
from swerve.vehicle.fitting import TyreData, read_tyre_data
from swerve.vehicle.fitting.data import blocks_of
from tests.vehicle.fitting.points import DEGREES, GOOD, HEADER, rows, table

Read = Callable[[str | bytes], TyreData]


@pytest.fixture
def read(tmp_path: Path) -> Read:
    """Reads data out of the text of a file."""

    def done(content: str | bytes) -> TyreData:
        path = tmp_path / "data.csv"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return read_tyre_data(path)

    return done


def test_points_become_blocks_in_si(read: Read) -> None:
    """A block for each load, in newtons and radians."""
    data = read(GOOD)
    assert [block.load for block in data.blocks] == [1500, 3000, 6000]
    assert [block.place for block in data.blocks] == ["lines 2 to 50", "lines 51 to 99", "lines 100 to 148"]
    np.testing.assert_allclose(data.blocks[0].slip_angles, np.radians(DEGREES))


def scaled(header: str, *factors: float) -> str:
    """GOOD with another header and each column multiplied."""
    cells = [[float(cell) for cell in line.split(",")] for line in GOOD.splitlines()[1:]]
    return table([",".join(repr(x * f) for x, f in zip(row, factors, strict=True)) for row in cells], header=header)


@pytest.mark.parametrize(
    "text",
    [
        GOOD.replace("\n", "\r\n"),
        "\ufeff" + GOOD,
        "# measured\n\n" + GOOD.replace("\n", "\n\n# next\n", 20),
        GOOD.replace(HEADER, "Load[N],Slip Angle [ °],LATERAL_FORCE  [N]").replace("[ °]", "[°]"),
        GOOD.replace(HEADER, '"load [N]","slip_angle [deg]","lateral_force [N]"'),
        scaled("load [kN], slip_angle [deg], lateral_force [kN]", 1e-3, 1, 1e-3),
        scaled("load [N], slip_angle [rad], lateral_force [N]", 1, np.pi / 180, 1),
        scaled("load [N], slip_angle [mrad], lateral_force [N]", 1, np.pi / 180 * 1e3, 1),
        "\n".join(",".join(reversed(line.split(","))) for line in GOOD.splitlines()),
    ],
    ids=["crlf", "byte order mark", "comments", "case", "quotes", "kN", "rad", "mrad", "other order"],
)
def test_other_ways_to_write_the_same(read: Read, text: str) -> None:
    """Units, order of the columns, case, comments, quotes and line ends change nothing."""
    for a, b in zip(read(text).blocks, read(GOOD).blocks, strict=True):
        np.testing.assert_allclose(a.loads, b.loads, rtol=1e-14)
        np.testing.assert_allclose(a.slip_angles, b.slip_angles, rtol=1e-14)
        np.testing.assert_allclose(a.forces, b.forces, rtol=1e-14)


@given(st.permutations(range(len(DEGREES))), st.floats(-0.04, 0.04))
def test_points_of_a_block_stand_in_any_order_and_at_nearly_one_load(order: list[int], drift: float) -> None:
    """A block goes on while its load is near its first point's."""
    angles = np.radians(DEGREES)[order]
    loads = np.concatenate([np.linspace(load, load * (1 + drift), len(order)) for load in (1500, 3000, 6000)])
    blocks = blocks_of("f", range(loads.size), loads, np.tile(angles, 3), loads)
    assert [len(block.loads) for block in blocks] == [len(order)] * 3
    np.testing.assert_array_equal(blocks[1].slip_angles, angles)


def changed(line: int, cells: str) -> str:
    """GOOD with one line replaced."""
    lines = GOOD.splitlines()
    lines[line - 1] = cells
    return "\n".join(lines)


REFUSED = [
    (GOOD.replace("load [N], ", "", 1), "line 1: no column load; write a header such as load [N]"),
    (
        GOOD.replace("slip_angle [deg]", "slip_angel [deg]"),
        "line 1: unknown column 'slip_angel [deg]'; did you mean slip",
    ),
    (GOOD.replace(HEADER, HEADER + ", camber [deg]"), "line 1: unknown column 'camber [deg]'; write a header such as"),
    (GOOD.replace(HEADER, HEADER + ", load [N]"), "line 1: column load is there twice"),
    (GOOD.replace("[deg]", ""), "line 1: column slip_angle has no unit; write slip_angle [rad] or slip_angle [mrad]"),
    (GOOD.replace("[N],", "[kg],", 1), "line 1: column load: [kg] is no unit of a force; write load [N] or load [kN]"),
    (GOOD.replace("[deg]", "[N]"), "line 1: column slip_angle: [N] is no unit of an angle"),
    (GOOD.split("\n", 1)[1], "line 1: unknown column '1500.0'; write a header such as"),
    (HEADER, "line 1: no points below the header"),
    (GOOD.replace(",", ";"), "line 1: columns are separated by a semicolon; write commas between them"),
    (GOOD.replace(",", "\t"), "line 1: columns are separated by a tab; write commas"),
    (changed(7, "1500, -9.5"), "line 7: 2 values under 3 columns"),
    (changed(7, "1500, -9,5, -1400"), "line 7: 4 values under 3 columns"),
    (changed(7, "1500, nan, -1400"), "line 7: column slip_angle: 'nan' is not finite; write a plain number in deg"),
    (changed(7, "1500, -9.5, -inf"), "line 7: column lateral_force: '-inf' is not finite"),
    (changed(7, "1500, -9.5, -1e400"), "line 7: column lateral_force: '-1e400' is not finite"),
    (changed(7, "1500 N, -9.5, -1400"), "line 7: column load: '1500 N' is no number; write a plain number in N"),
    (changed(7, "1500, , -1400"), "line 7: column slip_angle: '' is no number"),
    (changed(7, "1_500, -9.5, -1400"), "line 7: column load: '1_500' is no number"),
    (changed(7, "0, -9.5, 0"), "line 7: column load: 0 N is not above 0"),
    (changed(7, "-1500, -9.5, -1400"), "line 7: column load: -1500 N is not above 0"),
    (
        changed(7, "1500, -95, -1400"),
        "line 7: column slip_angle: -95 deg is beyond 90 deg; mend the value, or the unit",
    ),
    (changed(7, "1500, -9.5, -9000"), "line 7: column lateral_force: -9000 N is 6 times the load, more than any tyre"),
    (changed(7, '1500, "-9.5, -1400'), "line 7: not CSV: "),
    (
        table(rows(3000.0), rows(1500.0), rows(6000.0)),
        "line 51: load 1500 N after 3000 N (line 2); write all points of",
    ),
    (table(rows(1500.0), rows(3000.0), rows(1500.0)), "line 100: load 1500 N after 3000 N (line 51)"),
    (table(rows(1500.0), rows(3000.0)), "points at 2 loads; at least 3 are needed, more than 5% apart"),
    (table(rows(1500.0)), "points at 1 load; at least 3 are needed"),
    (
        table(rows(1500.0), rows(3000.0, DEGREES[::8]), rows(6000.0)),
        "lines 51 to 57: load 3000 N has 7 slip angles; at least 8 different ones are needed",
    ),
    (
        table(rows(1500.0), rows(3000.0, [1.0] * 20), rows(6000.0)),
        "lines 51 to 70: load 3000 N has 1 slip angle; at least 8",
    ),
    (
        scaled(HEADER, 1, -1, 1),
        "lines 2 to 50: lateral force against the slip angle, -1407.3 N at 12 deg; a positive slip angle gives a",
    ),
    ("", "empty; write tyre data in it"),
    (" \n\n", "empty; write tyre data in it"),
    (b"\x89PNG\r\n\x1a\n\x00\x00", "no text but binary data"),
    (GOOD.encode("utf-16"), "no text but binary data; save it as UTF-8 text"),
]


@pytest.mark.parametrize(("content", "message"), REFUSED, ids=[message[:60] for _, message in REFUSED])
def test_a_wrong_file_is_refused(read: Read, content: str | bytes, message: str) -> None:
    """The message names the file, the line, the column and the value, and the cure, on one line."""
    with pytest.raises(InputError) as caught:
        read(content)
    said = str(caught.value)
    assert message in said
    assert "data.csv: " in said
    assert "\n" not in said


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("absent.csv", "cannot be read: No such file or directory; write the path of a .csv or .tir file"),
        ("folder.csv", "cannot be read: Is a directory"),
        ("data.xlsx", "no tyre data by its name; write a file that ends in .csv or .tir"),
        ("nul\0.csv", "cannot be read"),
    ],
)
def test_a_file_that_is_none_is_refused(tmp_path: Path, name: str, message: str) -> None:
    """Absent, a directory, of another kind, or no path at all."""
    (tmp_path / "folder.csv").mkdir()
    with pytest.raises(InputError) as caught:
        read_tyre_data(tmp_path / name)
    assert message in str(caught.value)
