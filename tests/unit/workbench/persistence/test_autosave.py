"""Unsaved work lies on the disk whole, is found again, never overwritten; locks end with their process."""

from __future__ import annotations

import errno
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("filelock")
from groundslab.errors import InputError
from groundslab.storage import atomic
from groundslab.workbench.editing.document import Document
from groundslab.workbench.persistence import autosave, files
from groundslab.workbench.persistence.autosave import Autosave
from groundslab.workbench.persistence.lock import Lock

TEXT = 'title = "ä"\n# a comment\n'


@pytest.fixture
def case(tmp_path: Path) -> Path:
    """Return a case file."""
    path = tmp_path / "raft.toml"
    path.write_text(TEXT, encoding="utf-8")
    return path


def test_work_is_kept_and_found(case: Path, tmp_path: Path) -> None:
    """What one run wrote, another finds with text, line ends, mark and what it builds on; dropped, it is gone."""
    state = tmp_path / "state"
    saver = Autosave(case, state)
    document = Document(TEXT + "x = 1\n", "\r\n", True)
    saver.write(document, "digest")
    assert saver.path == case.with_name(".raft.toml.unsaved")
    assert saver.find_earlier() == []
    (offer,) = Autosave(case, state).find_earlier()
    assert offer.document == document
    assert (offer.base, offer.file) == ("digest", str(case))
    assert saver.path.read_text(encoding="utf-8").endswith(TEXT + "x = 1\n")
    saver.discard()
    assert Autosave(case, state).find_earlier() == []
    assert sorted(path.name for path in tmp_path.iterdir()) == ["raft.toml"]


def test_kept_work_is_never_overwritten(case: Path, tmp_path: Path) -> None:
    """A saver writes beside what earlier runs have kept, not over it; all of it is offered, the latest first."""
    for number in range(3):
        Autosave(case, tmp_path / "state").write(Document(f"n = {number}\n"), None)
    texts = {work.document.text for work in Autosave(case, tmp_path / "state").find_earlier()}
    assert texts == {"n = 0\n", "n = 1\n", "n = 2\n"}


def test_declined_work_is_put_aside(case: Path, tmp_path: Path) -> None:
    """Work that is not wanted is offered no more, but its file is still there."""
    Autosave(case, tmp_path / "state").write(Document("n = 1\n"), None)
    (offer,) = Autosave(case, tmp_path / "state").find_earlier()
    autosave.decline(offer)
    assert Autosave(case, tmp_path / "state").find_earlier() == []
    assert (case.parent / ".raft.toml.unsaved-declined").read_text(encoding="utf-8").endswith("n = 1\n")


def test_a_folder_that_cannot_be_written_to(case: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The work then lies in the state folder, and is found there."""
    state, write = tmp_path / "state", atomic.write

    def refusing(path: Path, content: bytes, private: bool = False) -> None:
        if path.parent == case.parent:
            raise PermissionError(13, "Permission denied")
        write(path, content, private=private)

    monkeypatch.setattr(atomic, "write", refusing)
    Autosave(case, state).write(Document("n = 1\n"), None)
    (offer,) = Autosave(case, state).find_earlier()
    assert offer.path.parent == state / "unsaved"
    assert offer.document.text == "n = 1\n"


def test_no_place_at_all(case: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where no place takes the work, an error is raised."""

    def refusing(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(atomic, "write", refusing)
    with pytest.raises(OSError, match="No space"):
        Autosave(case, tmp_path / "state").write(Document("n = 1\n"), None)


def test_documents_without_a_file(tmp_path: Path) -> None:
    """Their work is offered only when the run that wrote it has ended; declined, the latest such stays."""
    saver = Autosave(None, tmp_path)
    saver.write(Document("n = 1\n"), None)
    other = Autosave(None, tmp_path)
    assert other.find_earlier() == []
    saver.release()
    (offer,) = other.find_earlier()
    assert offer.document.text == "n = 1\n"
    other.write(Document("n = 2\n"), None)
    assert offer.path.exists()
    autosave.decline(offer)
    assert [work.document.text for work in Autosave(None, tmp_path).find_earlier()] == []
    other.discard()
    assert [path.name for path in (tmp_path / "unsaved").iterdir()] == ["untitled.unsaved-declined"]


def test_damaged_work_is_no_work(case: Path, tmp_path: Path) -> None:
    """Files of that name with something else in them are left alone."""
    for content in (
        b"",
        b"# unsaved work of groundslab: {}\n",
        b"\xff",
        b"# unsaved work of groundslab: [1]\nx",
        b"n = 1",
    ):
        path = case.with_name(".raft.toml.unsaved")
        path.write_bytes(content)
        saver = Autosave(case, tmp_path / "state")
        assert saver.find_earlier() == []
        saver.write(Document("n = 1\n"), None)
        assert path.read_bytes() == content
        saver.discard()


def test_a_lock_is_held_once_and_tells_by_whom(tmp_path: Path) -> None:
    """The second to come gets no lock but what the first said about itself; released, it is free."""
    path = tmp_path / "locks" / "a.lock"
    lock, _ = Lock.acquire(path, {"pid": 1, "url": "here"})
    assert lock is not None
    assert Lock.acquire(path, {}) == (None, {"pid": 1, "url": "here"})
    if sys.platform != "win32":  # the URL contains a secret
        assert path.with_suffix(".json").stat().st_mode & 0o777 == 0o600
    lock.release()
    again, _ = Lock.acquire(path, {"pid": 2})
    assert again is not None
    again.release()
    assert not path.exists()


def test_a_file_system_without_locks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the system has no locks everybody gets one; other errors are raised."""
    number = errno.ENOLCK

    def fail(*_: object, **__: object) -> None:
        raise OSError(number, "failed")

    monkeypatch.setattr("filelock.FileLock.acquire", fail)
    for _ in range(2):
        assert Lock.acquire(tmp_path / "a.lock", {})[0] is not None
    number = errno.EROFS
    with pytest.raises(OSError, match="failed"):
        Lock.acquire(tmp_path / "a.lock", {})


HOLD = """
import sys
from pathlib import Path
from groundslab.workbench.persistence.lock import Lock
lock, _ = Lock.acquire(Path(sys.argv[1]), {"pid": 7})
print("held", flush=True)
sys.stdin.read()
"""


def test_a_lock_ends_with_its_process(tmp_path: Path) -> None:
    """A process that is killed holds nothing any more, whatever its lock's file says."""
    path = tmp_path / "a.lock"
    command = [sys.executable, "-c", HOLD, str(path)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "held\n"
        assert Lock.acquire(path, {}) == (None, {"pid": 7})
        process.kill()
        process.wait()
    assert path.with_suffix(".json").read_text(encoding="utf-8") == '{"pid": 7}'
    lock, _ = Lock.acquire(path, {})
    assert lock is not None
    lock.release()


def test_listing_of_a_folder(tmp_path: Path) -> None:
    """Folders and case files, sorted as people do; nothing hidden; a folder that does not exist is an error."""
    for name in ("b.toml", "A.TOML", ".hidden.toml", "c.txt"):
        (tmp_path / name).write_text("", encoding="utf-8")
    for name in ("z", "Y", ".git"):
        (tmp_path / name).mkdir()
    listing = files.list_folder(tmp_path)
    assert (listing["folders"], listing["files"]) == (["Y", "z"], ["A.TOML", "b.toml"])
    assert listing["parent"] == str(tmp_path.parent)
    assert files.list_folder(Path(tmp_path.anchor))["parent"] is None
    with pytest.raises(InputError):
        files.list_folder(tmp_path / "none")


@pytest.mark.parametrize(
    ("name", "place"),
    [
        ("unix.Unix", ".local/state/groundslab"),
        ("macos.MacOS", "Library/Application Support/groundslab"),
        ("windows.Windows", "AppData/Local/groundslab"),
    ],
)
def test_the_state_folder_is_the_users(name: str, place: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each system has a folder for the state of a program; it is created."""
    pytest.importorskip("platformdirs.windows")
    module, _, kind = name.partition(".")
    system = getattr(pytest.importorskip(f"platformdirs.{module}"), kind)
    for variable in ("XDG_STATE_HOME", "XDG_DATA_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(variable, raising=False)
    for variable in ("HOME", "USERPROFILE"):
        monkeypatch.setenv(variable, str(tmp_path))
    monkeypatch.setattr("platformdirs.windows.get_win_folder", lambda _: str(tmp_path / "AppData" / "Local"))
    monkeypatch.setattr("platformdirs.PlatformDirs", system)
    assert files.create_state_folder() == tmp_path / place
    assert files.create_state_folder().is_dir()
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    if kind == "Unix":
        assert files.create_state_folder() == tmp_path / "state" / "groundslab"
