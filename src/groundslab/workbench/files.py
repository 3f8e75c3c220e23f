"""Files written whole or not at all, folders of the user, and what can be chosen in a folder."""

from __future__ import annotations

import errno
import hashlib
import os
import re
import secrets
import shutil
import stat
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from groundslab.errors import Fault, InputError

#: Pauses [s] between trials on Windows, where a virus scanner may hold a file for a moment.
PATIENCE = (0.05, 0.1, 0.2, 0.4, 0.8)
#: A file that has been half written for so long is nobody's any more [s].
STALE = 60.0


def digest(content: bytes) -> str:
    """Return a fingerprint of a file's bytes."""
    return hashlib.sha256(content).hexdigest()


def read(path: Path, most: int) -> bytes:
    """Return the first bytes of a regular file; raises OSError, for a pipe or a device, too, which may never end."""
    _require_regular(path.stat())
    flags = ("O_NONBLOCK", "O_NOCTTY", "O_BINARY")  # as far as the system has them
    handle = os.open(path, os.O_RDONLY | sum(getattr(os, name, 0) for name in flags))
    try:
        _require_regular(os.fstat(handle))  # it may have been replaced meanwhile
        with os.fdopen(handle, "rb", closefd=False) as file:
            return file.read(most)
    finally:
        os.close(handle)


def _require_regular(about: os.stat_result) -> None:
    if stat.S_ISDIR(about.st_mode):
        raise IsADirectoryError(errno.EISDIR, "a folder")
    if not stat.S_ISREG(about.st_mode):
        raise OSError(errno.EINVAL, "a pipe, a device or the like")


def write(path: Path, content: bytes, private: bool = False) -> None:
    """Write a file so that after a crash either the old or the new content is there, whole; raises OSError.

    The file keeps its mode; a new one is the user's alone if it is private.
    """
    target = Path(os.path.realpath(path))
    partial = target.with_name(f".{target.name}.partial-{secrets.token_hex(4)}")
    try:
        handle = os.open(partial, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600 if private else 0o666)
        with os.fdopen(handle, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        with suppress(FileNotFoundError):
            shutil.copymode(target, partial)
        replace(partial, target)
    finally:
        partial.unlink(missing_ok=True)
    sync_names(target.parent)


def sweep(path: Path) -> None:
    """Remove what a process that was killed while writing a file has left half written beside it."""
    pattern = re.compile(re.escape(f".{path.name}.partial-") + "[0-9a-f]{8}")
    with suppress(OSError):
        for each in path.parent.iterdir():
            if pattern.fullmatch(each.name) and time.time() - each.lstat().st_mtime > STALE:
                each.unlink()


def replace(old: Path, new: Path) -> None:
    """Rename a file, over another one if need be."""
    for pause in PATIENCE if os.name == "nt" else ():
        with suppress(PermissionError):
            old.replace(new)
            return
        time.sleep(pause)
    old.replace(new)


def sync_names(folder: Path) -> None:
    """Make sure that the names in a folder are on the disk, where the system can do that."""
    if os.name != "posix":
        return
    with suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def state_folder() -> Path:
    """Return the folder in which a program keeps what it must remember for the user, made if it is missing."""
    home = Path.home()
    if sys.platform == "win32":
        above = Path(os.environ.get("LOCALAPPDATA") or home / "AppData" / "Local")
    elif sys.platform == "darwin":
        above = home / "Library" / "Application Support"
    else:
        above = Path(os.environ.get("XDG_STATE_HOME") or home / ".local" / "state")
    folder = above / "groundslab"
    folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    return folder


def listing(folder: Path) -> dict[str, Any]:
    """Return the folders and case files in a folder, hidden ones left out; raises InputError."""
    folder = folder.expanduser().absolute()
    try:
        entries = [entry for entry in os.scandir(folder) if _can_be_listed(entry.name)]
        folders = sorted((entry.name for entry in entries if holds(entry.is_dir)), key=str.casefold)
        files = [entry.name for entry in entries if entry.name.lower().endswith(".toml") and holds(entry.is_file)]
    except OSError as error:
        raise InputError([Fault(str(folder), reason(error), "a folder that can be read")]) from None
    parent = None if folder.parent == folder else str(folder.parent)
    return {"folder": str(folder), "parent": parent, "folders": folders, "files": sorted(files, key=str.casefold)}


def holds(check: Callable[[], bool]) -> bool:
    """Return what a question to the system gives, False where the system cannot answer it."""
    try:
        return check()
    except (OSError, ValueError):
        return False


def _can_be_listed(name: str) -> bool:
    """Whether a name is not hidden, and is text."""
    return not name.startswith(".") and not any("\ud800" <= letter <= "\udfff" for letter in name)


def reason(error: OSError) -> str:
    """Return in words why the system said no."""
    return (error.strerror or str(error)).lower()
