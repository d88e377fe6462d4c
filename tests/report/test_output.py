"""Output directories: refused before a run, and never half filled."""

from pathlib import Path

import pytest

from swerve.errors import InputError
from swerve.report import prepare_output
from swerve.report.output import filled


def _tree(directory: Path) -> dict[str, str]:
    """Every file below a directory, by its relative path; a directory's text is "/"."""
    return {
        str(path.relative_to(directory)): "/" if path.is_dir() else path.read_text() for path in directory.rglob("*")
    }


@pytest.mark.parametrize("name", ["new", "a/b/new", "old"])
def test_a_fit_directory_passes_and_stays_as_it_is(tmp_path: Path, name: str) -> None:
    """A directory that can be made, with its parents, or that exists is accepted; looking leaves nothing behind."""
    (tmp_path / "old").mkdir()
    (tmp_path / "old" / "result.json").write_text("earlier")
    before = _tree(tmp_path)
    prepare_output(tmp_path / name)
    assert _tree(tmp_path) == before


@pytest.mark.parametrize("name", ["file", "file/new", "a/" + 300 * "x", "a/nul\0"])
def test_what_is_no_directory_is_refused(tmp_path: Path, name: str) -> None:
    """A file, a path through a file and a path that no file system can hold are wrong input, and nothing is made."""
    (tmp_path / "file").write_text("mine")
    with pytest.raises(InputError, match=r"^--out .*: cannot be written: .*; write the path of a new or existing"):
        prepare_output(tmp_path / name)
    assert _tree(tmp_path) == {"file": "mine"}


def test_a_directory_without_leave_to_write_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the file system refuses to make anything the directory is wrong input, whoever the user is."""

    def refuse(path: Path, *_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr("os.mkdir", refuse)  # below both pathlib and tempfile
    for name in (".", "new"):
        with pytest.raises(InputError, match=r"^--out .*: cannot be written: Permission denied"):
            prepare_output(tmp_path / name)


def test_files_show_only_when_all_are_made(tmp_path: Path) -> None:
    """While files are being made the directory has its earlier ones; then it has the new ones and its own others."""
    (tmp_path / "result.json").write_text("earlier")
    (tmp_path / "notes.txt").write_text("mine")
    with filled(tmp_path) as place:
        (place / "result.json").write_text("new")
        (place / "log").write_text("new")
        assert (tmp_path / "result.json").read_text() == "earlier"
        assert not (tmp_path / "log").exists()
    assert _tree(tmp_path) == {"result.json": "new", "log": "new", "notes.txt": "mine"}


@pytest.mark.parametrize("error", [OSError, KeyboardInterrupt])
def test_a_failure_leaves_no_trace(tmp_path: Path, error: type[BaseException]) -> None:
    """Where making a file fails or is interrupted, directories that were new are gone and old files are as before."""
    (tmp_path / "result.json").write_text("earlier")
    for directory in (tmp_path, tmp_path / "a" / "b"):
        with pytest.raises(error), filled(directory) as place:
            (place / "result.json").write_text("ne")
            raise error
    assert _tree(tmp_path) == {"result.json": "earlier"}


def test_folders_are_filled_as_files_are(tmp_path: Path) -> None:
    """A folder that is made with others appears at the end, and one that is there keeps what it has."""
    (tmp_path / "run").mkdir()
    (tmp_path / "run" / "notes.txt").write_text("mine")
    with filled(tmp_path) as place:
        for name in ("run", "other"):
            (place / name).mkdir()
            (place / name / "log").write_text("new")
        assert not (tmp_path / "other").exists()
    assert _tree(tmp_path) == {
        **dict.fromkeys(("run", "other"), "/"),
        "run/notes.txt": "mine",
        "run/log": "new",
        "other/log": "new",
    }
