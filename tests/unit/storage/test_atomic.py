"""Files and folders are written whole or not at all, whatever they are called and whoever else writes them."""

from __future__ import annotations

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from groundslab.storage import atomic

TEXT = "old"


@pytest.fixture
def case(tmp_path: Path) -> Path:
    """Return a file."""
    path = tmp_path / "raft.toml"
    path.write_text(TEXT, encoding="utf-8")
    return path


def test_a_file_is_written_whole_or_not_at_all(case: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where writing fails half-way the old content stays, and nothing is left beside it; the mode is kept."""
    case.chmod(0o640)
    atomic.write(case, b"new")
    assert case.read_bytes() == b"new"
    assert case.stat().st_mode & 0o777 == 0o640 or os.name == "nt"

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space"):
        atomic.write(case, b"newer")
    assert case.read_bytes() == b"new"
    assert [path.name for path in case.parent.iterdir()] == ["raft.toml"]


def test_half_written_files_are_swept(case: Path) -> None:
    """What a killed process left half written goes after a while; what another one may be writing stays."""
    names = (".raft.toml.partial-0123abcd", ".raft.toml.partial-aaaaaaaa", ".raft.toml.partial-no")
    for name in names:
        case.with_name(name).write_bytes(b"half")
    os.utime(case.with_name(names[0]), (1, 1))
    os.utime(case.with_name(names[2]), (1, 1))
    atomic.sweep(case, age=60.0)
    assert sorted(path.name for path in case.parent.iterdir()) == [*names[1:], "raft.toml"]


def test_links_are_followed(case: Path) -> None:
    """A case that is a link stays one; what it leads to is written."""
    link = case.with_name("link.toml")
    link.symlink_to(case)
    atomic.write(link, b"new")
    assert link.is_symlink()
    assert case.read_bytes() == b"new"


def test_a_private_file_is_not_written_through_a_link(case: Path) -> None:
    """What a link in its place leads to stays as it is; the file is the user's alone."""
    link = case.with_name(".raft.toml.unsaved")
    link.symlink_to(case)
    atomic.write(link, b"private", private=True)
    assert not link.is_symlink()
    assert link.read_bytes() == b"private"
    assert case.read_text(encoding="utf-8") == TEXT
    assert link.stat().st_mode & 0o777 == 0o600 or os.name == "nt"


def test_a_new_file_takes_no_others_place(case: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A taken name is refused, with hard links and without; a free one gets a whole file; nothing lies beside it."""
    for _ in range(2):
        with pytest.raises(FileExistsError):
            atomic.write(case, b"new", new=True)
        atomic.write(case.with_name("free.toml"), b"new", new=True)
        assert case.with_name("free.toml").read_bytes() == b"new"
        case.with_name("free.toml").unlink()

        def no_links(*_: object) -> None:
            raise OSError(1, "Operation not permitted")

        monkeypatch.setattr(os, "link", no_links)
    assert [path.name for path in case.parent.iterdir()] == ["raft.toml"]


@pytest.mark.parametrize("name", ["x" * 255, "\N{SNOWMAN}" * 85, "x" * 236, "x" * 97, "a"])
def test_names_as_long_as_the_system_takes(tmp_path: Path, name: str) -> None:
    """Helpers beside a file or folder have names of their own that are short enough, and no two share them."""
    target = tmp_path / name
    atomic.check_name(target)
    atomic.write(target, b"file")
    assert target.read_bytes() == b"file"
    target.unlink()
    for content in (b"old", b"new"):
        atomic.write_folder(
            target, lambda folder, content=content: _fill(folder, content), {"a"}.__contains__, lambda: None
        )
        assert (target / "a").read_bytes() == content
    assert [path.name for path in tmp_path.iterdir()] == [name]
    other = tmp_path / (name[:-1] + "y")
    assert atomic.helper(target, "previous") != atomic.helper(other, "previous")


def test_names_that_are_too_long(tmp_path: Path) -> None:
    """Names and paths that no system can hold are found out before anything is written."""
    with pytest.raises(OSError, match="too long"):
        atomic.check_name(tmp_path / ("x" * 256))
    deep = tmp_path.joinpath(*["y" * 250] * 15)
    atomic.check_name(deep)
    with pytest.raises(OSError, match="too long"):
        atomic.check_name(deep, "/".join(["z" * 250] * 2))


def _fill(folder: Path, content: bytes) -> None:
    (folder / "a").write_bytes(content)
    (folder / "b").write_bytes(content)


#: Exchanges a folder many times.
EXCHANGES = """
import sys
from pathlib import Path
from groundslab.storage import atomic
def fill(folder):
    for name in "ab":
        (folder / name).write_text(sys.argv[2])
for _ in range(40):
    atomic.recover_folder(Path(sys.argv[1]), lambda _: [])
    atomic.write_folder(Path(sys.argv[1]), fill, {"a", "b"}.__contains__, lambda: None)
"""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="folders cannot be locked there")
def test_processes_that_write_the_same_folder_wait_for_each_other(tmp_path: Path) -> None:
    """None of several writers fails, what is left is one writer's alone, and nothing lies beside it."""
    target = tmp_path / "raft"

    def write(text: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-c", EXCHANGES, str(target), text]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    with ThreadPoolExecutor() as pool:
        for run in pool.map(write, ("one", "two", "three")):
            assert run.returncode == 0, run.stderr
    assert (target / "a").read_text() == (target / "b").read_text()
    assert [path.name for path in tmp_path.iterdir()] == ["raft"]


def test_only_what_could_be_ours_is_swept(tmp_path: Path) -> None:
    """A folder under the name of a half-written one that holds something else stays, however old."""
    for name, file in (("00000000", "a"), ("11111111", "thesis.odt")):
        half = tmp_path / f".raft.partial-{name}"
        half.mkdir()
        (half / file).touch()
        os.utime(half / file, (1, 1))
        os.utime(half, (1, 1))
    atomic.write_folder(tmp_path / "raft", lambda folder: _fill(folder, b""), {"a", "b"}.__contains__, lambda: None)
    assert sorted(path.name for path in tmp_path.iterdir()) == [".raft.partial-11111111", "raft"]


@pytest.mark.skipif(sys.platform == "win32", reason="there are no locks on folders")
def test_what_a_killed_run_has_left_is_removed_by_the_next(tmp_path: Path) -> None:
    """The partial folder of a killed process goes at once; that of one that still writes, and other files, stay."""
    target = tmp_path / "raft"
    words = "import os, pathlib, signal, sys; from groundslab.storage import atomic\n"
    fill = "lambda folder: ((folder / 'data').write_text('half'), os.kill(os.getpid(), signal.SIGKILL))"
    call = f"atomic.write_folder(pathlib.Path(sys.argv[1]), {fill}, {{'data'}}.__contains__, lambda: None)"
    subprocess.run([sys.executable, "-c", words + call, str(target)], check=False)
    (left,) = tmp_path.iterdir()
    assert left.name.startswith(".raft.partial-")
    mine = left.with_name(left.name[:-1] + ("0" if left.name[-1] != "0" else "1"))
    mine.mkdir()
    (mine / "thesis.txt").write_text("mine")

    def write_other(folder: Path) -> None:
        (folder / "data").write_text("other")

    def fill_both(folder: Path) -> None:
        (folder / "data").write_text("whole")
        # another run begins while this one writes
        atomic.write_folder(target, write_other, {"data"}.__contains__, lambda: None)
        assert (folder / "data").read_text() == "whole"

    atomic.write_folder(target, fill_both, {"data"}.__contains__, lambda: None)
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted([mine.name, "raft"])
    assert (target / "data").read_text() == "whole"
