"""Who has a file open: a lock of the operating system, which ends with the process, however that ends."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

#: Windows keeps others from reading what is locked, so a byte far behind the content is.
_FAR = 1 << 30


class Lock:
    """A lock that is held, on a file that says by whom."""

    def __init__(self, path: Path, handle: int | None) -> None:
        self.path = path
        self._handle = handle

    @classmethod
    def take(cls, path: Path, about: Mapping[str, Any]) -> tuple[Lock | None, dict[str, Any]]:
        """Return the lock, or None and what its holder says about itself.

        Where the system has no locks, as on some network file systems, everybody gets one.
        """
        path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o600)
        try:
            _lock(handle)
        except (BlockingIOError, PermissionError):
            content = os.read(handle, 100_000)
            os.close(handle)
            return None, _about(content)
        except OSError:
            os.close(handle)
            return cls(path, None), {}
        os.ftruncate(handle, 0)
        os.write(handle, json.dumps(dict(about)).encode())
        return cls(path, handle), {}

    def release(self, remove: bool = False) -> None:
        """Let others take the lock; its file is removed if nobody else knows its name."""
        if self._handle is not None:
            with suppress(OSError):
                os.ftruncate(self._handle, 0)
            os.close(self._handle)
            self._handle = None
        if remove:
            with suppress(OSError):
                self.path.unlink()


def _about(content: bytes) -> dict[str, Any]:
    """Return what the holder of a lock says about itself; nothing if it is just writing that."""
    try:
        about = json.loads(content)
    except ValueError:
        return {}
    return about if isinstance(about, dict) else {}


if sys.platform == "win32":
    import msvcrt

    def _lock(handle: int) -> None:
        os.lseek(handle, _FAR, os.SEEK_SET)
        try:
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        finally:
            os.lseek(handle, 0, os.SEEK_SET)

else:
    import fcntl

    def _lock(handle: int) -> None:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
