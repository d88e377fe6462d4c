"""From a name or a file to a scenario."""

from pathlib import Path

import pytest

from swerve.errors import InputError
from swerve.scenario import library_names, load, parse


def test_a_file_is_read(tmp_path: Path) -> None:
    """A path that ends in .toml is a file, whoever's it is; a byte-order mark does no harm."""
    path = tmp_path / "mine.toml"
    path.write_bytes(b"\xef\xbb\xbf" + load("wet").to_toml().encode())
    assert load(path) == load(str(path)) == load("wet")


def test_an_unknown_name_gets_the_nearest() -> None:
    """A misspelled library name is answered with the right one."""
    with pytest.raises(InputError, match=r"^papre: no such scenario; did you mean paper\?"):
        load("papre")


@pytest.mark.parametrize("name", ["", "zzz", "paper "])
def test_a_name_like_no_other_gets_the_list(name: str) -> None:
    """A name is never taken for another one, and the message holds the right ones."""
    with pytest.raises(InputError, match=r"no such scenario; .*paper"):
        load(name)


def test_a_name_does_not_leave_the_library() -> None:
    """What looks like a path is a path, not a name of the library."""
    with pytest.raises(InputError, match="cannot be read: No such file"):
        load("../library/paper")


@pytest.mark.parametrize("path", ["absent.toml", ".", "/", "a\0.toml"])
def test_what_cannot_be_read_is_named(path: str) -> None:
    """An absent file, a directory and an impossible path are errors, not crashes."""
    with pytest.raises(InputError, match=r"cannot be read: .*; write a TOML file's path") as caught:
        load(path)
    assert str(caught.value).isprintable()


def test_a_file_without_permission_is_named(tmp_path: Path) -> None:
    """A file that the user may not read is an error that names it."""
    path = tmp_path / "locked.toml"
    path.touch(mode=0)
    try:
        path.read_bytes()
    except PermissionError:
        with pytest.raises(InputError, match=r"locked\.toml: cannot be read: Permission denied"):
            load(path)


def test_a_huge_file_is_refused(tmp_path: Path) -> None:
    """A file of more than a megabyte is not read to its end."""
    path = tmp_path / "huge.toml"
    path.write_bytes(b"#" * 1_000_001)
    with pytest.raises(InputError, match=r"huge\.toml: no scenario file: larger than 1000000 bytes"):
        load(path)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "empty; a scenario has name, duration"),
        (b"# nothing\n", "empty; a scenario has"),
        (b"\xff\xfe", "not UTF-8 text, at byte 0; save it as UTF-8"),
        (b'name = "a"\nname', "not valid TOML: Expected '=' after a key in a key/value pair (at end of document)"),
        (b"a = 1\nb = = 2\n", "not valid TOML: Invalid value (at line 2, column 5)"),
        (b"%PDF-1.4", "not valid TOML: Invalid statement (at line 1, column 1)"),
        (b"a = " + b"[" * 100_000, "not valid TOML: nested too deep"),
        (b"a = " + b"9" * 5000, "not valid TOML: Exceeds the limit"),
    ],
)
def test_what_is_not_toml_is_refused(content: bytes, message: str) -> None:
    """Anything but a TOML document of at least one key is an error, with its place."""
    with pytest.raises(InputError) as caught:
        parse(content, "mine.toml")
    assert str(caught.value).startswith(f"mine.toml: {message}")


def test_a_missing_key_is_named_with_an_example() -> None:
    """What a scenario must say, it is asked for by name; an unknown key comes first, as the likely cause."""
    content = load("paper").to_toml().replace("friction", "frictoin").encode()
    with pytest.raises(InputError) as caught:
        parse(content, "mine.toml")
    unknown = "mine.toml: road.frictoin: unknown key; did you mean road.friction?"
    assert str(caught.value) == f"{unknown}; also road.friction: missing; write one such as friction = 0.85"


def test_a_value_instead_of_a_table_is_refused() -> None:
    """`road = 5` is not a road."""
    content = load("paper").to_toml().replace("[road]\nfriction = 0.85", "").encode()
    with pytest.raises(InputError, match=r"^mine\.toml: road: 5 is not a table; write a table \[road\]"):
        parse(b"road = 5\n" + content, "mine.toml")


def test_the_library_has_the_paper_s_scenario() -> None:
    """Names are in order and without their files' ending."""
    names = library_names()
    assert "paper" in names
    assert names == sorted(names)
    assert not any(name.endswith(".toml") for name in names)
