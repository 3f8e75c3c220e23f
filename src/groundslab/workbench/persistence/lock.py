"""Locks of the operating system, which end with their process; a file beside each lock names its owner."""

from __future__ import annotations

import errno
import json
import sys
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from filelock import FileLock, Timeout

from groundslab.storage import atomic, bounded

#: Errors of file systems without locks, as some in a network are.
_UNSUPPORTED = (errno.ENOSYS, errno.ENOLCK, errno.ENOTSUP, errno.EOPNOTSUPP)


LARGEST = 100_000  # bytes of what an owner says of itself


class Lock:
    """A lock held by this process."""

    def __init__(self, lock: FileLock) -> None:
        self._lock = lock
        self._path = Path(lock.lock_file)

    @classmethod
    def acquire(cls, path: Path, owner: Mapping[str, Any]) -> tuple[Lock | None, dict[str, Any]]:
        """Return the lock, or None and what its owner has written about itself.

        On a file system without locks everybody gets one. Raises OSError if the folder cannot be written to.
        """
        path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
        lock = FileLock(path, timeout=0, mode=0o600, thread_local=False, fallback_to_soft=False)
        owner_file = path.with_suffix(".json")
        try:
            lock.acquire()
        except Timeout:
            with suppress(OSError, ValueError, TypeError, RecursionError):
                return None, dict(json.loads(bounded.read_whole(owner_file, LARGEST)))
            return None, {}
        except OSError as error:
            if error.errno not in _UNSUPPORTED:
                raise
        with suppress(OSError):
            atomic.write(owner_file, json.dumps(dict(owner)).encode(), private=True)
        return cls(lock), {}

    def release(self) -> None:
        """Let others acquire the lock; removes its files."""
        for path in (self._path.with_suffix(".json"), self._path):
            with suppress(OSError):
                path.unlink()
        self._lock.release()
        if sys.platform == "win32":  # where a file that is open cannot be removed
            with suppress(OSError):
                self._path.unlink()
