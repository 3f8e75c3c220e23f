"""Fingerprints of files, folders of the user, and what can be chosen in a folder."""

from __future__ import annotations

import errno
import hashlib
import os
import stat
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from groundslab.errors import InputError, Issue


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
        raise InputError([Issue(str(folder), reason(error), "a folder that can be read")]) from None
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
