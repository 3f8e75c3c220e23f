"""Folders of results: whole or not at all, and never in place of what somebody else wrote."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

import synthetic
from groundslab import casefile
from groundslab.errors import GroundslabError, InputError
from groundslab.views import archive, store

OLD, NEW = synthetic.results(), synthetic.results(lifts=False)
FILES = {"plate.vtu", "ground.vtu", "results.npz", "case.toml", "summary.json"}


def contents(folder: Path) -> dict[str, bytes]:
    """Return the files of a folder, byte by byte."""
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def debris(folder: Path) -> list[str]:
    """Return what lies beside the folder."""
    return sorted(path.name for path in folder.parent.iterdir() if path != folder)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder that holds results."""
    return store.write(OLD, tmp_path / "room" / "raft")


class TestWrite:
    """What is written, and where."""

    @pytest.mark.parametrize("plot", [False, True])
    def test_summary_lists_exactly_the_files(self, tmp_path: Path, plot: bool) -> None:
        """The folder holds what the summary lists, a picture only when asked for; nothing lies beside it."""
        folder = store.write(OLD, tmp_path / "deep" / "down" / "raft", plot=plot)
        files = FILES | ({"picture.png"} if plot else set())
        assert set(contents(folder)) == files == set(json.loads((folder / "summary.json").read_text())["files"])
        assert debris(folder) == []
        synthetic.assert_same(archive.load(folder / "results.npz"), OLD)
        assert casefile.load(folder / "case.toml") == OLD.model

    def test_replaces_earlier_results_whole(self, folder: Path) -> None:
        """Files of the earlier results that the new ones lack are gone."""
        store.write(OLD, folder, plot=True)
        store.write(NEW, folder)
        assert set(contents(folder)) == FILES
        synthetic.assert_same(archive.load(folder / "results.npz"), NEW)
        assert debris(folder) == []

    def test_an_empty_folder_and_litter_are_no_obstacle(self, tmp_path: Path) -> None:
        """An empty folder may be written to, also if a file manager has been there."""
        (tmp_path / "raft").mkdir()
        (tmp_path / "raft" / ".DS_Store").touch()
        assert set(contents(store.write(OLD, tmp_path / "raft"))) == FILES

    def test_follows_a_link_to_a_folder(self, tmp_path: Path) -> None:
        """A link stays a link, and the folder that it leads to holds the results."""
        (tmp_path / "real").mkdir()
        _link(tmp_path / "link", tmp_path / "real")
        assert store.write(OLD, tmp_path / "link") == (tmp_path / "real").resolve()
        assert (tmp_path / "link").is_symlink()
        assert set(contents(tmp_path / "real")) == FILES

    def test_rights_are_those_of_any_new_folder(self, folder: Path) -> None:
        """Others may read the results if the user's mask lets them."""
        plain = folder.parent / "plain"
        plain.mkdir()
        assert folder.stat().st_mode == plain.stat().st_mode


class TestRefuse:
    """What is in the way is named and left untouched."""

    @pytest.mark.parametrize("kind", ["file", "folder", "link"])
    def test_foreign_things_in_the_folder(self, folder: Path, kind: str) -> None:
        """A file, folder or link that somebody put among the results stops everything."""
        if kind == "file":
            (folder / "notes.txt").write_text("mine")
        elif kind == "folder":
            (folder / "notes.txt").mkdir()
        else:
            _link(folder / "notes.txt", folder / "plate.vtu")
        names = set(contents(folder) if kind != "folder" else [path.name for path in folder.iterdir()])
        with pytest.raises(InputError, match=r"notes\.txt"):
            store.write(NEW, folder)
        assert {path.name for path in folder.iterdir()} == names
        synthetic.assert_same(archive.load(folder / "results.npz"), OLD)
        assert debris(folder) == []

    def test_a_listed_name_that_is_a_link_now(self, folder: Path, tmp_path: Path) -> None:
        """A link under the name of one of our files is not ours."""
        (folder / "plate.vtu").rename(tmp_path / "elsewhere.vtu")
        _link(folder / "plate.vtu", tmp_path / "elsewhere.vtu")
        with pytest.raises(InputError, match=r"plate\.vtu"):
            store.write(NEW, folder)

    @pytest.mark.parametrize("summary", [None, "{", "[]", '{"program": "other", "files": ["a.txt"]}', '{"files": 3}'])
    def test_a_folder_without_our_summary(self, tmp_path: Path, summary: str | None) -> None:
        """Every file of a folder that is not ours is named, whatever its summary.json says."""
        (tmp_path / "a.txt").write_text("mine")
        if summary is not None:
            (tmp_path / "summary.json").write_text(summary)
        before = contents(tmp_path)
        with pytest.raises(InputError) as caught:
            store.write(NEW, tmp_path)
        assert {Path(fault.where).name for fault in caught.value.faults} == set(before)
        assert contents(tmp_path) == before

    def test_a_file(self, tmp_path: Path) -> None:
        """A file under the folder's name, or in place of its parent, is left alone."""
        (tmp_path / "raft").write_text("mine")
        for target in (tmp_path / "raft", tmp_path / "raft" / "results"):
            with pytest.raises(InputError, match="a file"):
                store.write(NEW, target)
        assert (tmp_path / "raft").read_text() == "mine"

    def test_a_link_to_itself(self, tmp_path: Path) -> None:
        """A loop of links is a fault, not a traceback, as the folder and as its parent."""
        _link(tmp_path / "loop", tmp_path / "loop")
        for target in (tmp_path / "loop", tmp_path / "loop" / "raft"):
            with pytest.raises(InputError, match="back to itself"):
                store.check(target)

    def test_the_folder_that_the_user_stands_in(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """The working directory is not pulled away."""
        monkeypatch.chdir(tmp_path)
        with pytest.raises(InputError, match="stand in"):
            store.check(".")

    def test_a_root_folder(self) -> None:
        """The root of the file system is no folder for results."""
        with pytest.raises(InputError):
            store.check(os.path.abspath(os.sep))  # noqa: PTH100

    def test_a_parent_without_leave_to_write(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """If the system refuses a folder, that is a fault; earlier results stay."""
        monkeypatch.setattr(os, "access", lambda *_: False)
        with pytest.raises(InputError, match="leave to write"):
            store.check(folder)
        monkeypatch.undo()

        def refuse(*_: Any, **__: Any) -> None:
            raise PermissionError(13, "Permission denied")

        monkeypatch.setattr(os, "mkdir", refuse)
        with pytest.raises(InputError, match="Permission denied"):
            store.write(NEW, folder)
        synthetic.assert_same(archive.load(folder / "results.npz"), OLD)

    def test_somebody_elses_previous(self, folder: Path) -> None:
        """A folder of somebody else under the helper's name is neither removed nor used."""
        other = folder.with_name(".raft.previous")
        other.mkdir()
        (other / "mine.txt").write_text("mine")
        with pytest.raises(InputError, match="in the way"):
            store.write(NEW, folder)
        assert contents(other) == {"mine.txt": b"mine"}

    def test_results_that_cannot_be_shown(self, folder: Path) -> None:
        """Results with a number that is none leave the earlier ones in place, and nothing beside them."""
        bad = synthetic.results(constants=synthetic.Constants((float("nan"),), (0.0,), None, 0))
        before = contents(folder)
        with pytest.raises(GroundslabError, match="not finite"):
            store.write(bad, folder)
        assert contents(folder) == before
        assert debris(folder) == []


class TestFailures:
    """Failures of the system while results are written."""

    @pytest.mark.parametrize("failing", [1, 2])
    def test_a_rename_that_fails_is_undone(self, folder: Path, monkeypatch: pytest.MonkeyPatch, failing: int) -> None:
        """Whichever of the two renames fails, the earlier results are in place afterwards."""
        before, rename, calls = contents(folder), os.rename, []

        def once(*arguments: Any, **options: Any) -> None:
            calls.append(arguments)
            if len(calls) == failing:
                raise PermissionError(13, "in use")
            rename(*arguments, **options)

        monkeypatch.setattr(os, "rename", once)
        with pytest.raises(InputError, match="in use"):
            store.write(NEW, folder)
        assert contents(folder) == before
        assert debris(folder) == []

    def test_a_full_disk(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        """If the disk is full nothing is left half written."""

        def full(_: int) -> None:
            raise OSError(28, "No space left on device")

        before = contents(folder)
        monkeypatch.setattr(os, "fsync", full)
        with pytest.raises(InputError, match="No space left"):
            store.write(NEW, folder)
        assert contents(folder) == before
        assert debris(folder) == []

    def test_only_old_rubbish_is_swept(self, folder: Path) -> None:
        """Half-written folders go after an hour, younger ones and other names stay."""
        names = {
            ".raft.partial-00000000": 2,
            ".raft.partial-11111111": 0,
            ".raft.partial-mine": 2,
            ".other.partial-00000000": 2,
        }
        for name, hours in names.items():
            path = folder.with_name(name)
            path.mkdir()
            (path / "plate.vtu").touch()
            then = time.time() - hours * 3600
            os.utime(path / "plate.vtu", (then, then))
            os.utime(path, (then, then))
        store.write(NEW, folder)
        assert debris(folder) == sorted(set(names) - {".raft.partial-00000000"})


class TestRecover:
    """What a crash between the renames left behind."""

    def test_puts_back_what_lies_aside(self, folder: Path) -> None:
        """Results under the name of the previous ones come back."""
        before = contents(folder)
        folder.rename(folder.with_name(".raft.previous"))
        assert store.recover(folder)
        assert contents(folder) == before
        assert not store.recover(folder)

    def test_puts_back_over_an_empty_folder(self, folder: Path) -> None:
        """An empty folder made since is no reason to give up the results."""
        before = contents(folder)
        folder.rename(folder.with_name(".raft.previous"))
        folder.mkdir()
        assert store.recover(folder)
        assert contents(folder) == before

    def test_keeps_both_where_something_foreign_stands(self, folder: Path) -> None:
        """If somebody's files stand in the results' place, neither these nor the old results are touched."""
        before, aside = contents(folder), folder.with_name(".raft.previous")
        folder.rename(aside)
        folder.mkdir()
        (folder / "notes.txt").write_text("mine")
        with pytest.raises(InputError):
            store.write(NEW, folder)
        assert contents(aside) == before
        assert contents(folder) == {"notes.txt": b"mine"}


#: Writes new results in a process that dies at the n-th call of a function of ``os``, before or after it acts.
DYING = f"""
import os, signal, sys
sys.path.insert(0, {str(Path(synthetic.__file__).parent)!r})
import synthetic
from groundslab.views import store
from groundslab.views import archive, summary, vtu
function, number, moment, folder = sys.argv[1], int(sys.argv[2]), sys.argv[3], sys.argv[4]
original, calls = getattr(os, function), []
def die():
    os.kill(os.getpid(), signal.SIGKILL) if hasattr(signal, "SIGKILL") else os._exit(9)
def fatal(*arguments, **options):
    calls.append(arguments)
    if len(calls) == number and moment == "before":
        die()
    value = original(*arguments, **options)
    if len(calls) == number:
        die()
    return value
setattr(os, function, fatal)
store.write(synthetic.results(lifts=False), folder)
"""


@pytest.mark.parametrize(
    ("function", "number", "moment", "survives", "needs_recovery"),
    [
        ("mkdir", 2, "after", "old", False),  # the staging folder is there, empty
        ("fsync", 1, "before", "old", False),  # all files are written, none is known to be on the disk
        ("fsync", 6, "after", "old", False),
        ("rename", 1, "before", "old", False),
        ("rename", 1, "after", "old", True),  # between the renames
        ("rename", 2, "before", "old", True),
        ("rename", 2, "after", "new", False),
        ("rename", 3, "before", "new", False),
        ("rename", 3, "after", "new", False),
        ("unlink", 2, "after", "new", False),  # while the old results are removed
    ],
)
def test_a_killed_run_leaves_whole_results(
    folder: Path, function: str, number: int, moment: str, survives: str, needs_recovery: bool
) -> None:
    """Wherever a run is killed, all of the old or all of the new results are there and can be replaced."""
    before = contents(folder)
    run = subprocess.run(
        [sys.executable, "-c", DYING, function, str(number), moment, str(folder)],
        capture_output=True,
        check=False,
    )
    assert run.returncode == (-signal.SIGKILL if hasattr(signal, "SIGKILL") else 9), run.stderr.decode()
    assert folder.exists() is not needs_recovery
    assert store.recover(folder) is needs_recovery
    if survives == "old":
        assert contents(folder) == before
    else:
        assert set(contents(folder)) == FILES
        synthetic.assert_same(archive.load(folder / "results.npz"), NEW)
    assert all(".partial-" in name for name in debris(folder))
    store.write(NEW, folder)
    synthetic.assert_same(archive.load(folder / "results.npz"), NEW)


def _link(link: Path, target: Path) -> None:
    """Make a symbolic link, or skip the test where the system does not let us."""
    try:
        link.symlink_to(target)
    except OSError:
        pytest.skip("no symbolic links here")
