"""What somebody has edited of files that groundslab wrote: it is known by checksums, and kept before it is replaced.

A folder has a list of checksums among its files. A file that stands alone has its own in a comment, the seal.
"""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import count
from pathlib import Path

from groundslab.errors import EditedFilesKept, InputError, Issue
from groundslab.storage import bounded

#: What stands behind the name of a file or folder that was kept; a number follows if that is taken.
KEPT = "-edited"
#: Bytes of the name that are repeated, and files that are named.
LONGEST, MOST_NAMES = 100, 10
#: Largest file whose seal is looked at; no report is larger.
LARGEST = 200_000_000
_SEAL = re.compile(rb"[^\n]*groundslab sha256 ([0-9a-f]{64})[^\n]*\n")


def checksums_of(folder: Path, names: Iterable[str]) -> dict[str, str]:
    """Return the SHA-256 checksums of files in a folder by their paths there."""
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor() as threads:
        checksums = {name: threads.submit(_checksum, folder / name) for name in names}
        return {name: checksum.result() for name, checksum in checksums.items()}


def find_edited(folder: Path, checksums: Mapping[str, str]) -> list[str]:
    """Return the files that are there and are not as they were written."""
    paths = ((name, folder / name) for name in checksums)
    return [name for name, path in paths if path.is_file() and _checksum(path) != checksums[name]]


def keep_files(folder: Path, names: Iterable[str]) -> None:
    """Copy files of a folder that will be replaced into a new one beside it, and warn; raises OSError."""
    names = list(names)
    if not names:
        return
    kept = next(path for path in _free_paths(folder, "") if not os.path.lexists(path))
    for name in names:
        (kept / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(folder / name, kept / name)
    shown = [*names[:MOST_NAMES], *([f"{len(names) - MOST_NAMES} more"] if len(names) > MOST_NAMES else [])]
    _warn(f"edited since groundslab wrote {folder}, and kept in {kept}: {', '.join(shown)}")


def keep_file(path: Path, is_unchanged: Callable[[Path], bool]) -> None:
    """Rename a file that will be replaced if it was edited, and warn; raises InputError if that is impossible."""
    if not path.is_file():
        return
    try:
        if is_unchanged(path):
            return
        kept = next(other for other in _free_paths(path.with_suffix(""), path.suffix) if not os.path.lexists(other))
        path.rename(kept)
    except OSError as error:
        hint = "move it away; nothing was changed"
        raise InputError([Issue(str(path), error.strerror or str(error), "a file that can be kept", hint)]) from error
    _warn(f"{path} is not as this version of groundslab wrote it, and is kept as {kept}")


def seal(content: bytes, before: str = "<!-- ", after: str = " -->") -> bytes:
    """Return a text with its checksum in a comment at its end."""
    return content + f"{before}groundslab sha256 {hashlib.sha256(content).hexdigest()}{after}\n".encode()


def is_sealed(path: Path) -> bool:
    """Return whether a file has a seal, and is as it was when it got it; raises OSError."""
    content = bounded.read_whole(path, LARGEST)
    seals = list(_SEAL.finditer(content[-1000:]))
    if not seals or seals[-1].end() != len(content[-1000:]):
        return False
    before = content[: len(content) - len(seals[-1][0])]
    return hashlib.sha256(before).hexdigest().encode() == seals[-1][1]


def _checksum(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _free_paths(path: Path, suffix: str) -> Iterator[Path]:
    """Yield names beside a file or folder under which it may be kept."""
    stem = os.fsencode(path.name)[:LONGEST].decode(errors="ignore")
    for number in count(1):
        yield path.with_name(f"{stem}{KEPT}{f'-{number}' if number > 1 else ''}{suffix}")


def _warn(message: str) -> None:
    warnings.warn(EditedFilesKept(message), stacklevel=4)
