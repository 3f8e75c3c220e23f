"""Reading of files that others may have made: regular ones, up to a size that their role allows."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path


def read_regular(path: Path, limit: int) -> bytes:
    """Return the first bytes of a regular file; raises OSError, also for pipes and devices, which may never end."""
    _require_regular(path.stat())
    flags = ("O_NONBLOCK", "O_NOCTTY", "O_BINARY")  # as far as the system has them
    handle = os.open(path, os.O_RDONLY | sum(getattr(os, name, 0) for name in flags))
    try:
        _require_regular(os.fstat(handle))  # it may have been replaced meanwhile
        with os.fdopen(handle, "rb", closefd=False) as file:
            return file.read(limit)
    finally:
        os.close(handle)


def read_whole(path: Path, most: int) -> bytes:
    """Return the content of a regular file; raises OSError, also if it is larger than `most` bytes."""
    size = path.stat().st_size
    content = read_regular(path, most + 1) if size <= most else None
    if content is None or len(content) > most:
        raise OSError(errno.EFBIG, f"a file of more than {most / 1e6:g} MB", str(path))
    return content


def _require_regular(about: os.stat_result) -> None:
    if stat.S_ISDIR(about.st_mode):
        raise IsADirectoryError(errno.EISDIR, "a folder")
    if not stat.S_ISREG(about.st_mode):
        raise OSError(errno.EINVAL, "a pipe, a device or the like")
