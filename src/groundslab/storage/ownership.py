"""Recognizes files written by groundslab by their content: no others are ever replaced or removed."""

from __future__ import annotations

import os
import re
import stat
import tomllib
from collections.abc import Callable, Collection, Iterator
from pathlib import Path, PurePosixPath

from groundslab.errors import InputError, Issue
from groundslab.storage import bounded
from groundslab.storage.atomic import LITTER, check_name

#: Bytes of a file's beginning that are looked at.
LOOK = 8192
#: Longest header line of a table, and largest case file, that are read [bytes].
LONGEST_HEADER, LARGEST_CASE = 1_000_000, 10_000_000
#: Largest figure in PDF that is read [bytes]; none of groundslab is as large.
LARGEST_FIGURE = 200_000_000


def is_figure(path: Path) -> bool:
    """Return whether a file is a figure (PDF, SVG or PNG) that groundslab wrote, unchanged since."""
    start = _read_start(path)
    if start.startswith(b"\x89PNG\r\n\x1a\n"):
        return b"tEXtSoftware\x00groundslab " in start
    if start.startswith(b"%PDF-"):
        content = bounded.read_whole(path, LARGEST_FIGURE)
        return content.count(b"%%EOF") == 1 and re.search(rb"<< /Creator \(groundslab [^)]*\)", content) is not None
    creator = rb"<dc:creator>\s*<cc:Agent>\s*<dc:title>groundslab "
    return b"<svg" in start and re.search(creator, start) is not None


def is_page(path: Path, what: str = "") -> bool:
    """Return whether a file is a page that groundslab wrote, one of a kind ("report", "study") if that is named."""
    return f'<meta name="generator" content="groundslab {what}'.encode() in _read_start(path)


def has_expected_content(path: Path) -> bool:
    """Return whether a file holds what groundslab writes into files whose names end like that."""
    test = _KINDS.get(path.suffix)
    try:
        return test is not None and test(path)
    except OSError:
        return False


def strangers(folder: Path, names: Collection[str]) -> list[str]:
    """Return the paths in a folder and its subfolders that groundslab did not write.

    It wrote files (no links) under these names with the content that belongs to the name; files of file managers do
    not count.
    """
    folders = {above.as_posix() for name in names for above in PurePosixPath(name).parents}
    return sorted(_strangers(folder, "", names, folders))


def check_replaceable(path: str | Path, ours: Callable[[Path], bool], what: str) -> Path:
    """Return the full path, links followed, if a file may be written there; else raise InputError saying why not.

    The name must be free, or that of a file that is ``ours``; ``what`` says in words what such a file is. Touches
    nothing, so that it can be called before long work.
    """
    target = Path(os.path.realpath(path))
    hint = "choose another name; nothing was changed"
    try:
        check_name(target)
        mode = target.stat().st_mode if os.path.lexists(target) else None
        if mode is None:
            return _require_folder(path, target)
        if stat.S_ISREG(mode):
            if ours(target):
                return _require_folder(path, target)
            expected = f"{what}, or a name that is free"
            raise InputError([Issue(str(path), "a file that groundslab did not write", expected, hint)])
        obstacle = "a folder" if stat.S_ISDIR(mode) else "something that is neither a file nor a folder"
    except OSError as error:
        obstacle = error.strerror or str(error)
    raise InputError([Issue(str(path), obstacle, "a file, or a name that is free", hint)])


def _require_folder(path: str | Path, target: Path) -> Path:
    """Return the target if its folder can be written to; else raise InputError."""
    if not target.parent.is_dir():
        raise InputError([Issue(str(path), f"no folder {target.parent}", "a name in a folder that is there")])
    if not os.access(target.parent, os.W_OK | os.X_OK):
        raise InputError([Issue(str(target.parent), "a folder without leave to write", "one that can be written to")])
    return target


def _strangers(folder: Path, below: str, names: Collection[str], folders: Collection[str]) -> Iterator[str]:
    """Yield the paths in a folder that are neither our files nor folders that hold some."""
    for path in folder.iterdir():
        name = below + path.name
        plain = path.is_file() and not path.is_symlink()
        if name in folders and path.is_dir() and not path.is_symlink():
            yield from _strangers(path, f"{name}/", names, folders)
        elif not (plain and (path.name in LITTER or (name in names and has_expected_content(path)))):
            yield name


def _read_start(path: Path, count: int = LOOK) -> bytes:
    with path.open("rb") as file:
        return file.read(count)


def _begins_with(pattern: bytes) -> Callable[[Path], bool]:
    """Return a test whether a file's beginning matches a pattern."""
    return lambda path: re.match(pattern, _read_start(path), re.DOTALL) is not None


def _is_case(path: Path) -> bool:
    try:
        return "plate" in tomllib.loads(_read_start(path, LARGEST_CASE).decode())
    except (ValueError, RecursionError):
        return False


def _is_table(path: Path) -> bool:
    head, end, _ = _read_start(path, LONGEST_HEADER).partition(b"\n")
    return end == b"\n" and b"," in head and b"\0" not in head


_KINDS: dict[str, Callable[[Path], bool]] = {
    ".vtu": _begins_with(rb'.*<VTKFile type="UnstructuredGrid"'),
    ".pvd": _begins_with(rb'.*<VTKFile type="Collection"'),
    # a zip archive whose first member is the first array that is written
    ".npz": _begins_with(rb"PK\x03\x04.{26}plate\.nodes\.npy"),
    ".json": _begins_with(rb'\{\s*"program":\s*"groundslab"'),
    ".toml": _is_case,
    ".csv": _is_table,
    ".html": is_page,
    **dict.fromkeys((".png", ".pdf", ".svg"), is_figure),
}
