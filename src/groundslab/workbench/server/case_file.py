"""The file of a case: its lock, its content when it was last read or saved, and names that users enter."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.messages import Message, Name, quoted
from groundslab.storage import atomic, bounded
from groundslab.workbench.checking.file_reader import ENDING
from groundslab.workbench.persistence import files
from groundslab.workbench.persistence.lock import Lock


class Conflict(Exception):
    """A request conflicts with the present state; ``kind`` names the conflict, ``issues`` say what to do."""

    def __init__(self, kind: str, issues: Sequence[Issue] = ()) -> None:
        super().__init__(kind)
        self.kind = kind
        self.issues = tuple(issues)


class OpenElsewhere(Conflict):
    """The file is open in another workbench, whose address is ``url``."""

    def __init__(self, path: Path, owner: Mapping[str, Any]) -> None:
        self.url = str(owner.get("url", ""))
        self.pid = owner.get("pid")
        taken = Message("a file that another workbench has open (process {process})", process=str(self.pid))
        super().__init__(
            "open",
            [Issue(str(path), taken, "a file that is free", self.url and Message("go to {url}", url=Name(self.url)))],
        )


class CaseFile:
    """The file of the document, if it has one, and what is known of its content."""

    def __init__(self, path: Path | None, content: bytes | None, lock: Lock | None = None) -> None:
        """Take the content as it was read; without a path, that of the new document."""
        self.path = path
        self.content = content  # as it was read or saved last
        self.base = None if path is None or content is None else files.compute_digest(content)  # of the document
        self.lock = lock
        # of the version that was seen to have this content; one read after the content may be of a newer version
        self._stamp: tuple[int, int, int] | None = None

    @property
    def folder(self) -> Path:
        """The folder of the file, or the current one."""
        return Path.cwd() if self.path is None else self.path.parent

    def save(self, target: Path, content: bytes, overwrite: bool, lock: Callable[[Path], Lock]) -> CaseFile:
        """Write the content to a file, this one or another one, and return that; ``lock`` locks another one.

        Raises Conflict if another program has changed this file or the other one exists, unless it is to be
        overwritten, and InputError if it cannot be written.
        """
        is_own, present = target == self.path, read_content(target)
        if present is not None and not overwrite:
            if not is_own:
                raise Conflict("exists", [Issue(str(target), "a file that exists", "a name that is free")])
            if files.compute_digest(present) != self.base and present != content:
                hint = "save it under another name, open it again, or overwrite it"
                changed = "a file that another program has changed since it was read"
                raise Conflict("changed", [Issue(str(target), changed, "the file as it was read", hint)])
        saved = self if is_own else CaseFile(target, None, lock(target))
        try:
            atomic.write(target, content)
        except OSError as error:
            if not is_own:
                saved.close()
            hint = "choose another place; nothing is lost"
            issue = Issue(str(target), files.describe_error(error), "a file that can be written", hint)
            raise InputError([issue]) from None
        saved.adopt(content)
        return saved

    def adopt(self, content: bytes) -> None:
        """Take content that was saved, or that another program has written, as what was read last."""
        self.content, self.base, self._stamp = content, files.compute_digest(content), None

    def has_changed(self) -> bool:
        """Whether another program has changed the file since it was read or saved."""
        if self.path is None:
            return False
        stamp = _read_stamp(self.path)
        if stamp is not None and stamp == self._stamp:
            return False
        try:
            content = read_content(self.path)
        except InputError:
            return True  # it cannot even be read
        if (None if content is None else files.compute_digest(content)) != self.base:
            return True
        self._stamp = stamp
        return False

    def close(self) -> None:
        """Release the lock."""
        if self.lock is not None:
            self.lock.release()
            self.lock = None


def lock_file(path: Path, state: Path, url: str) -> Lock:
    """Return the lock on a file for the server with a URL; raises OpenElsewhere if another one has it."""
    name = files.compute_digest(os.fsencode(os.path.normcase(os.path.realpath(path))))[:32]
    try:
        lock, owner = Lock.acquire(state / "open" / f"{name}.lock", {"pid": os.getpid(), "url": url, "file": str(path)})
    except OSError as error:
        no_folder = Message("no folder for the list of open cases ({error})", error=files.describe_error(error))
        raise InputError([Issue(str(state), no_folder, "a folder that can be written")]) from None
    if lock is None:
        raise OpenElsewhere(path, owner)
    return lock


def read_content(path: Path) -> bytes | None:
    """Return the content of a file, None if it does not exist; raises InputError if it cannot be read."""
    try:
        return bounded.read_regular(path, casefile.LARGEST + 1)
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:
        raise InputError([Issue(str(path), files.describe_error(error), "a file that can be read")]) from None


def resolve_path(name: str, folder: Path) -> Path:
    """Return the full path of a name that the user enters; links are resolved, so that each file has one path."""
    if "\0" in name:
        raise InputError([Issue("file", "a name with a zero character", "the name of a file")])
    try:
        path = Path(name).expanduser()
    except RuntimeError:
        path = Path(name)
    return Path(os.path.realpath(folder / path))


def resolve_target(name: str | None, present: CaseFile) -> Path:
    """Return the path to save to, by default that of the present file; raises InputError."""
    if name is None:
        if present.path is None:
            raise InputError([Issue("file", "no name", "a name for the file", "choose one")])
        return present.path
    target = resolve_path(name, present.folder)
    if target == present.path:
        return target
    if not target.suffix and not os.path.lexists(target):
        target = target.with_suffix(".toml")
    if files.try_check(target.is_dir):
        raise InputError([Issue(str(target), "a folder", "a name for a file")])
    if target.suffix.lower() != ".toml":
        raise InputError([Issue(str(target), quoted([target.suffix]), Message(ENDING, ending=Name(".toml")))])
    return target


def _read_stamp(path: Path) -> tuple[int, int, int] | None:
    """Return the time, size and inode of a file, which identify its version."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino
