"""Atomic writing of files and folders.

While NAME is written, temporary files stand next to it:

    .NAME.partial-<random>  a file or folder being written, or an old folder being removed: worthless after a crash
    .NAME.previous          the complete previous folder, between two renames

After a crash NAME is either unchanged or complete and new. Between the two renames of a folder NAME is absent and
.NAME.previous present, which ``recover_folder`` restores. Processes that replace the same folder wait for each other,
where the system has locks. The names of temporary files are valid wherever NAME is.
"""

from __future__ import annotations

import errno
import os
import platform
import re
import secrets
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from hashlib import sha256
from pathlib import Path

#: Files that file managers put into any folder that is looked at.
LITTER = frozenset({".DS_Store", "Thumbs.db", "desktop.ini"})
#: So many files are flushed to disk or removed at the same time: a disk makes each of them wait.
THREADS = 16
#: Age after which a folder left half written is removed [s].
STALE = 3600.0
#: Pauses [s] between trials on Windows, where a virus scanner may hold a new file for a moment.
PAUSES = (0.05, 0.1, 0.2, 0.4, 0.8) if sys.platform == "win32" else ()
#: Bytes of a name that its helpers' names repeat; of longer names they hold the beginning and a checksum.
LONGEST_STEM = 96
#: Begins the random part of the names of partial folders: a machine knows its own.
_HOST = sha256(platform.node().encode()).hexdigest()[:3]


def write(path: Path, content: bytes, *, private: bool = False, new: bool = False) -> None:
    """Write a file atomically; raises OSError.

    The file keeps its mode, and a link stays one. A private file can be read by the user only and is never written
    through a link. A new one replaces nothing: FileExistsError is raised if the name is taken.
    """
    target = path if private or new else Path(os.path.realpath(path))
    partial = helper(target, f"partial-{secrets.token_hex(4)}")
    try:
        handle = os.open(partial, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600 if private else 0o666)
        with os.fdopen(handle, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        if new:
            _take_name(partial, target)
        else:
            if not private:
                with suppress(FileNotFoundError):
                    shutil.copymode(target, partial)
            replace(partial, target)
    finally:
        with suppress(OSError):
            partial.unlink(missing_ok=True)
    _sync_names(target.parent)


def _take_name(partial: Path, target: Path) -> None:
    """Rename a file unless the name is taken; raises FileExistsError."""
    try:
        os.link(partial, target)
    except OSError:
        # it is taken, or this disk has no hard links
        if os.path.lexists(target):
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), str(target)) from None
        replace(partial, target)


def replace(old: Path, new: Path) -> None:
    """Rename a file, replacing another one."""
    _rename(old.replace, new)


def _rename(rename: Callable[[Path], object], new: Path) -> None:
    """Rename to a new name by a method of the old one, tried again after pauses."""
    for pause in PAUSES:
        with suppress(PermissionError):
            rename(new)
            return
        time.sleep(pause)
    rename(new)


def sweep(path: Path, age: float) -> None:
    """Remove partial files that killed processes left, older than an age [s]."""
    for partial in _find_partial(path):
        with suppress(OSError):
            if not partial.is_dir() and time.time() - partial.lstat().st_mtime > age:
                partial.unlink()


def write_folder(
    target: Path, fill: Callable[[Path], None], ours: Callable[[str], bool], check: Callable[[], object]
) -> None:
    """Let ``fill`` write into a new folder and replace the target by it; raises OSError.

    ``ours`` says which paths below the folder ``fill`` could write. ``check`` is called just before the exchange and
    raises an error of its own if what is there may not be replaced.
    """
    target.parent.mkdir(parents=True, exist_ok=True)
    staging = helper(target, f"partial-{_HOST}{secrets.token_hex(8 - len(_HOST))[: 8 - len(_HOST)]}")
    with ExitStack() as held:
        with _locked(target.parent):
            _sweep_folders(target, ours)
            staging.mkdir()
            held.callback(shutil.rmtree, staging, ignore_errors=True)
            held.enter_context(_locked(staging))  # until this process ends, so that others see that it is alive
        fill(staging)
        _sync(staging)
        with _locked(target.parent):
            check()
            _replace_folder(staging, target)


def recover_folder(target: Path, strangers: Callable[[Path], list[str]]) -> bool:
    """Restore the folder that a crash has left aside; return whether there was one; raises OSError.

    If the newer one is in place, the older one is removed. ``strangers`` returns the paths in such a folder that must
    not be removed; where there are any, nothing is touched.
    """
    if not previous_path(target).is_dir():
        return False
    with _locked(target.parent):
        previous = previous_path(target)
        if not previous.is_dir() or previous.is_symlink() or strangers(previous):
            return False
        if target.is_dir() and not any(target.iterdir()):
            target.rmdir()
        if not os.path.lexists(target):
            _rename(previous.rename, target)
            return True
        if any(path.name not in LITTER for path in target.iterdir()) and not strangers(target):
            _discard(previous, target)
    return False


def previous_path(target: Path) -> Path:
    """Return the path of the previous folder while a target is replaced."""
    return helper(target, "previous")


def helper(target: Path, ending: str) -> Path:
    """Return the path of a temporary file next to the target, whose name is valid wherever the target's is."""
    name, whole = target.name, os.fsencode(target.name)
    if len(whole) > LONGEST_STEM:
        name = whole[: LONGEST_STEM - 9].decode("utf-8", "ignore") + "~" + sha256(whole).hexdigest()[:8]
    return target.with_name(f".{name}.{ending}")


def check_name(target: Path, inside: str = "") -> None:
    """Raise OSError if the system can hold no such name, or no path like ``inside`` within such a folder."""
    for path in (target, target / inside, helper(target, "partial-01234567") / inside):
        with suppress(FileNotFoundError, NotADirectoryError):
            path.lstat()


@contextmanager
def _locked(folder: Path) -> Iterator[None]:
    """Lock a folder against other processes, where the system has locks on folders."""
    if sys.platform == "win32":
        yield
        return
    import fcntl

    with _open_folder(folder) as handle:
        # Some network file systems refuse this.
        with suppress(OSError):
            fcntl.flock(handle, fcntl.LOCK_EX)
        yield


@contextmanager
def _open_folder(folder: Path) -> Iterator[int]:
    handle = os.open(folder, os.O_RDONLY)
    try:
        yield handle
    finally:
        os.close(handle)


def _replace_folder(staging: Path, target: Path) -> None:
    """Replace the target by the staged folder; the old contents stay until the new ones are there."""
    previous = previous_path(target)
    replaces = os.path.lexists(target)
    if replaces:
        _rename(target.rename, previous)
    try:
        _rename(staging.rename, target)
    except BaseException:
        if replaces and not os.path.lexists(target):
            _rename(previous.rename, target)
        raise
    _sync_names(target.parent)
    if replaces:
        # The new contents are in place: leftovers of the old ones are no reason to fail.
        with suppress(OSError):
            _discard(previous, target)


def _discard(previous: Path, target: Path) -> None:
    """Remove an old folder, renamed first, so that no half of it counts."""
    from concurrent.futures import ThreadPoolExecutor

    def remove(path: Path) -> None:
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path, ignore_errors=True)
        else:
            with suppress(OSError):
                path.unlink()

    rubbish = helper(target, f"partial-{secrets.token_hex(4)}")
    _rename(previous.rename, rubbish)
    with ThreadPoolExecutor(THREADS) as pool:
        list(pool.map(remove, rubbish.iterdir()))
    shutil.rmtree(rubbish, ignore_errors=True)


def _sweep_folders(target: Path, ours: Callable[[str], bool]) -> None:
    """Remove partial folders next to the target that killed runs have left, and that hold nothing of anybody else."""
    for path in _find_partial(target):
        with suppress(OSError):
            if path.is_dir() and not path.is_symlink():
                entries = list(path.rglob("*"))
                files = (entry for entry in entries if entry.is_symlink() or not entry.is_dir())
                if _is_left(path, entries) and all(ours(file.relative_to(path).as_posix()) for file in files):
                    shutil.rmtree(path, ignore_errors=True)


def _is_left(folder: Path, entries: list[Path]) -> bool:
    """Return whether no process writes into a partial folder any more.

    One of this machine holds a lock on it as long as it lives; where that cannot be known, an hour has to pass.
    """
    old = time.time() - max(entry.lstat().st_mtime for entry in (folder, *entries)) > STALE
    if old or sys.platform == "win32" or f"partial-{_HOST}" not in folder.name:
        return old
    import fcntl

    with _open_folder(folder) as handle:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            return False
        return True


def _find_partial(target: Path) -> list[Path]:
    """Return partial files and folders next to the target."""
    pattern = re.compile(re.escape(helper(target, "partial-").name) + "[0-9a-f]{8}")
    with suppress(OSError):
        return [path for path in target.parent.iterdir() if pattern.fullmatch(path.name)]
    return []


def _sync(folder: Path) -> None:
    """Flush the files of a folder, its subfolders and their names to disk.

    At once, as a file system writes what several threads wait for together, in about the time that one file takes.
    """
    from concurrent.futures import ThreadPoolExecutor

    paths = [folder, *folder.rglob("*")]
    folders = [path for path in paths if path.is_dir()]
    with ThreadPoolExecutor(THREADS) as pool:
        # errors are raised here
        list(pool.map(_sync_file, set(paths).difference(folders)))
        list(pool.map(_sync_names, folders))


def _sync_file(path: Path) -> None:
    """Flush the contents of a file to disk."""
    with path.open("r+b") as file:
        os.fsync(file.fileno())


def _sync_names(folder: Path) -> None:
    """Flush the names in a folder to disk, where the system can."""
    if sys.platform == "win32":
        return
    # Some network file systems refuse this.
    with suppress(OSError), _open_folder(folder) as handle:
        os.fsync(handle)
