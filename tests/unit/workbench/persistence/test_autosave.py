"""Unsaved work lies on the disk whole, is found again, never overwritten; locks end with their process."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from groundslab.errors import InputError
from groundslab.storage import atomic
from groundslab.workbench.editing.document import Document
from groundslab.workbench.persistence import autosave, files
from groundslab.workbench.persistence.autosave import Keeper
from groundslab.workbench.persistence.lock import Lock

TEXT = 'title = "ä"\n# a comment\n'


@pytest.fixture
def case(tmp_path: Path) -> Path:
    """Return a case file."""
    path = tmp_path / "raft.toml"
    path.write_text(TEXT, encoding="utf-8")
    return path


def test_work_is_kept_and_found(case: Path, tmp_path: Path) -> None:
    """What one keeper wrote, another finds with text, line ends, mark and what it builds on; dropped, it is gone."""
    state = tmp_path / "state"
    keeper = Keeper(case, state)
    document = Document(TEXT + "x = 1\n", "\r\n", True)
    keeper.keep(document, "digest")
    assert keeper.path == case.with_name(".raft.toml.unsaved")
    assert keeper.offers() == []
    (offer,) = Keeper(case, state).offers()
    assert offer.document == document
    assert (offer.base, offer.file) == ("digest", str(case))
    assert keeper.path.read_text(encoding="utf-8").endswith(TEXT + "x = 1\n")
    keeper.drop()
    assert Keeper(case, state).offers() == []
    assert sorted(path.name for path in tmp_path.iterdir()) == ["raft.toml"]


def test_kept_work_is_never_overwritten(case: Path, tmp_path: Path) -> None:
    """A keeper writes beside what earlier runs have kept, not over it; all of it is offered, the latest first."""
    for number in range(3):
        Keeper(case, tmp_path / "state").keep(Document(f"n = {number}\n"), None)
    texts = {kept.document.text for kept in Keeper(case, tmp_path / "state").offers()}
    assert texts == {"n = 0\n", "n = 1\n", "n = 2\n"}


def test_declined_work_is_put_aside(case: Path, tmp_path: Path) -> None:
    """Work that is not wanted is offered no more, but its file is still there."""
    Keeper(case, tmp_path / "state").keep(Document("n = 1\n"), None)
    (offer,) = Keeper(case, tmp_path / "state").offers()
    autosave.decline(offer)
    assert Keeper(case, tmp_path / "state").offers() == []
    assert (case.parent / ".raft.toml.unsaved-declined").read_text(encoding="utf-8").endswith("n = 1\n")


def test_a_folder_that_cannot_be_written_to(case: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The work then lies in the state folder, and is found there."""
    state, write = tmp_path / "state", atomic.write

    def refusing(path: Path, content: bytes, private: bool = False) -> None:
        if path.parent == case.parent:
            raise PermissionError(13, "Permission denied")
        path.parent.mkdir(parents=True, exist_ok=True)
        write(path, content, private=private)

    monkeypatch.setattr(atomic, "write", refusing)
    Keeper(case, state).keep(Document("n = 1\n"), None)
    (offer,) = Keeper(case, state).offers()
    assert offer.path.parent == state / "unsaved"
    assert offer.document.text == "n = 1\n"


def test_no_place_at_all(case: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where no place takes the work, that is told."""

    def refusing(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(atomic, "write", refusing)
    with pytest.raises(OSError, match="No space"):
        Keeper(case, tmp_path / "state").keep(Document("n = 1\n"), None)


def test_documents_without_a_file(tmp_path: Path) -> None:
    """Their work is offered only when the run that wrote it has ended; declined, the latest such stays."""
    keeper = Keeper(None, tmp_path)
    keeper.keep(Document("n = 1\n"), None)
    other = Keeper(None, tmp_path)
    assert other.offers() == []
    keeper.release()
    (offer,) = other.offers()
    assert offer.document.text == "n = 1\n"
    other.keep(Document("n = 2\n"), None)
    assert offer.path.exists()
    autosave.decline(offer)
    assert [kept.document.text for kept in Keeper(None, tmp_path).offers()] == []
    other.drop()
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
        keeper = Keeper(case, tmp_path / "state")
        assert keeper.offers() == []
        keeper.keep(Document("n = 1\n"), None)
        assert path.read_bytes() == content
        keeper.drop()


def test_a_lock_is_held_once_and_tells_by_whom(tmp_path: Path) -> None:
    """The second to come gets no lock but what the first said about itself; released, it is free."""
    path = tmp_path / "locks" / "a.lock"
    lock, _ = Lock.take(path, {"pid": 1, "url": "here"})
    assert lock is not None
    assert Lock.take(path, {}) == (None, {"pid": 1, "url": "here"})
    lock.release()
    again, _ = Lock.take(path, {"pid": 2})
    assert again is not None
    again.release(remove=True)
    assert not path.exists()


HOLD = """
import sys
from pathlib import Path
from groundslab.workbench.persistence.lock import Lock
lock, _ = Lock.take(Path(sys.argv[1]), {"pid": 7})
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
        assert Lock.take(path, {}) == (None, {"pid": 7})
        process.kill()
        process.wait()
    assert path.read_text(encoding="utf-8") == '{"pid": 7}'
    lock, _ = Lock.take(path, {})
    assert lock is not None
    lock.release()


def test_listing_of_a_folder(tmp_path: Path) -> None:
    """Folders and case files, sorted as people do; nothing hidden; a folder that is none is a fault."""
    for name in ("b.toml", "A.TOML", ".hidden.toml", "c.txt"):
        (tmp_path / name).write_text("", encoding="utf-8")
    for name in ("z", "Y", ".git"):
        (tmp_path / name).mkdir()
    told = files.listing(tmp_path)
    assert (told["folders"], told["files"]) == (["Y", "z"], ["A.TOML", "b.toml"])
    assert told["parent"] == str(tmp_path.parent)
    assert files.listing(Path(tmp_path.anchor))["parent"] is None
    with pytest.raises(InputError):
        files.listing(tmp_path / "none")


@pytest.mark.parametrize("platform", ["linux", "darwin", "win32"])
def test_the_state_folder_is_the_users(platform: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each system has a place for what a program remembers; it is made."""
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    for name in ("XDG_STATE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    folder = files.state_folder()
    assert folder.is_dir()
    assert tmp_path in folder.parents
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    if platform == "linux":
        assert files.state_folder() == tmp_path / "state" / "groundslab"
