"""A folder of results, written whole or not at all.

Three folders stand side by side in one parent while results are written:

    NAME                    the results, always whole
    .NAME.partial-<random>  results in the making, or old ones on their way out: worthless after a crash
    .NAME.previous          the results that NAME held, whole, for the moment between two renames

A crash leaves NAME as it was, or complete and new, or absent with .NAME.previous beside it, which
``recover`` mends.
"""

from __future__ import annotations

import json
import os
import re
import secrets
import shutil
import time
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab.errors import Fault, InputError

if TYPE_CHECKING:
    from collections.abc import Callable

    from groundslab.results import Results

#: Files that file managers put into any folder that is looked at.
LITTER = frozenset({".DS_Store", "Thumbs.db", "desktop.ini"})
#: Age after which a folder left half written is removed [s].
STALE = 3600.0


def write(results: Results, folder: str | Path, *, plot: bool = False) -> Path:
    """Write all files of the results into the folder, in place of earlier ones there, and return the folder.

    The folder may be missing, empty, or hold only what groundslab wrote; anything else raises InputError.
    """
    target = check(folder)
    _sweep(target)
    staging = _beside(target, "partial-" + secrets.token_hex(4))
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        staging.mkdir()
        _fill(results, staging, plot)
        _sync(staging)
        _swap(staging, target)
    except OSError as error:
        raise _unwritable(target, error) from error
    finally:
        shutil.rmtree(staging, ignore_errors=True)
    return target


def check(folder: str | Path) -> Path:
    """Return the folder's full path if results may be written there; else raise InputError saying why not.

    Puts back earlier results first if a crash has left them aside. Touches nothing else, so that it can be
    asked before a long analysis.
    """
    target = _resolve(folder)
    recover(target)
    try:
        faults = _in_the_way(target)
    except OSError as error:
        raise _unwritable(target, error) from error
    if faults:
        raise InputError(faults)
    return target


def recover(folder: str | Path) -> bool:
    """Put back the results that a crash has left aside; return whether there were any to put back.

    If the newer results are in place, the older ones are removed.
    """
    target = _resolve(folder)
    previous = _beside(target, "previous")
    try:
        if not previous.is_dir() or _foreign(previous):
            return False
        if target.is_dir() and not any(target.iterdir()):
            target.rmdir()
        if not os.path.lexists(target):
            _rename(previous, target)
            return True
        if _files(target) and not _foreign(target):
            _discard(previous, target)
    except OSError as error:
        raise _unwritable(target, error) from error
    return False


def _in_the_way(target: Path) -> list[Fault]:
    """Return what speaks against writing results into the folder."""
    previous = _beside(target, "previous")
    if os.path.lexists(previous):
        return [Fault(str(previous), "something that is in the way", "a name that is free", "move it away")]
    room = next(parent for parent in target.parents if os.path.lexists(parent))
    if not room.is_dir():
        return [Fault(str(target), f"{room}, which is a file", "a place where a folder can be made")]
    if not os.access(room, os.W_OK | os.X_OK):
        return [Fault(str(room), "a folder without leave to write", "one that can be written to")]
    if not os.path.lexists(target):
        return []
    if not target.is_dir():
        return [Fault(str(target), "a file", "a folder, or a name that is free", "choose another")]
    # Replacing it would leave the shell standing in a folder that is gone.
    with suppress(OSError):
        if target.samefile(os.curdir):
            return [Fault(str(target), "the folder that you stand in", "another one", "name a folder inside it")]
    expected = "a folder that is missing, empty, or holds only results of groundslab"
    mend = "move it away or choose another folder; nothing was changed"
    return [
        Fault(str(target / name), "something that groundslab did not write", expected, mend)
        for name in _foreign(target)
    ]


def _fill(results: Results, folder: Path, plot: bool) -> None:
    """Write every file; the summary, which names them all, comes last."""
    from groundslab import casefile
    from groundslab.views import archive, picture, summary, vtu

    writers: dict[str, Callable[[Results, Path], object]] = {
        "plate.vtu": vtu.write_plate,
        "ground.vtu": vtu.write_ground,
        "results.npz": archive.write,
        "case.toml": lambda results, path: _write_text(path, casefile.to_toml(results.model)),
    }
    if plot:
        writers["picture.png"] = picture.write
    # A summary that cannot be made stops everything before the large files are written.
    text = summary.json_text(results, [*writers, "summary.json"])
    for name, writer in writers.items():
        writer(results, folder / name)
    _write_text(folder / "summary.json", text + "\n")


def _write_text(path: Path, text: str) -> None:
    """Write text as UTF-8 with plain line ends."""
    path.write_text(text, encoding="utf-8", newline="\n")


def _swap(staging: Path, target: Path) -> None:
    """Put the staged folder in the target's place; the old contents stay until the new ones are there."""
    previous = _beside(target, "previous")
    replaces = os.path.lexists(target)
    if replaces:
        _rename(target, previous)
    try:
        _rename(staging, target)
    except BaseException:
        if replaces and not os.path.lexists(target):
            _rename(previous, target)
        raise
    _sync_entries(target.parent)
    if replaces:
        # The results are in place; what is left over of the old ones is no reason to fail.
        with suppress(OSError):
            _discard(previous, target)


def _rename(old: Path, new: Path) -> None:
    """Rename a folder, with patience for Windows, where a virus scanner may hold new files for a moment."""
    for pause in (0.05, 0.1, 0.2, 0.4, 0.8) if os.name == "nt" else ():
        with suppress(PermissionError):
            old.rename(new)
            return
        time.sleep(pause)
    old.rename(new)


def _discard(previous: Path, target: Path) -> None:
    """Remove the old results, renamed to something worthless first, so that no half of them counts."""
    rubbish = _beside(target, "partial-" + secrets.token_hex(4))
    _rename(previous, rubbish)
    shutil.rmtree(rubbish, ignore_errors=True)


def _sync(folder: Path) -> None:
    """Make sure that the files of a folder and their names are on the disk."""
    for path in folder.iterdir():
        with path.open("r+b") as file:
            os.fsync(file.fileno())
    _sync_entries(folder)


def _sync_entries(folder: Path) -> None:
    """Make sure that the names in a folder are on the disk, where the system can do that."""
    if os.name != "posix":
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        # Some network file systems refuse this.
        with suppress(OSError):
            os.fsync(handle)
    finally:
        os.close(handle)


def _sweep(target: Path) -> None:
    """Remove folders that earlier runs, killed more than an hour ago, left half written beside the target."""
    pattern = re.compile(re.escape(f".{target.name}.partial-") + "[0-9a-f]{8}")
    with suppress(OSError):
        for path in target.parent.iterdir():
            if pattern.fullmatch(path.name) and path.is_dir() and not path.is_symlink():
                newest = max(entry.lstat().st_mtime for entry in (path, *path.iterdir()))
                if time.time() - newest > STALE:
                    shutil.rmtree(path, ignore_errors=True)


def _foreign(folder: Path) -> list[str]:
    """Return the names in a folder that groundslab did not write there."""
    names = sorted(path.name for path in folder.iterdir())
    ours = set(_files(folder)) | LITTER
    return [name for name in names if name not in ours or not _plain(folder / name)]


def _files(folder: Path) -> list[str]:
    """Return the names of the files that groundslab wrote into a folder, according to the summary there."""
    try:
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        files = summary["files"] if summary["program"] == "groundslab" else []
        return [name for name in files if isinstance(name, str)]
    except (OSError, ValueError, KeyError, TypeError):
        return []


def _plain(path: Path) -> bool:
    """Return whether a path is a file, and no link to one."""
    return path.is_file() and not path.is_symlink()


def _beside(target: Path, suffix: str) -> Path:
    """Return the path of a helper folder beside the target."""
    return target.with_name(f".{target.name}.{suffix}")


def _resolve(folder: str | Path) -> Path:
    """Return the full path without links, so that the folder itself is replaced and not a link to it."""
    target = Path(os.path.realpath(folder))
    try:
        loop = target.is_symlink() or any(parent.is_symlink() for parent in target.parents)
    except OSError:
        loop = True
    if loop:
        raise InputError([Fault(str(folder), "a link that leads back to itself", "a folder, or a name that is free")])
    if not target.name:
        raise InputError([Fault(str(folder), "the root of the file system", "a folder of its own for the results")])
    return target


def _unwritable(target: Path, error: OSError) -> InputError:
    """Return the error for a folder that cannot be written; earlier results there are untouched."""
    got = error.strerror or str(error)
    mend = "close programs that use the folder, make room, or choose another; earlier results are as they were"
    return InputError([Fault(str(target), got, "a folder that can be written", mend)])
