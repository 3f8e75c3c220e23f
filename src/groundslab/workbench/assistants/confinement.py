"""Paths within one folder: what an assistant names lies in it, whatever links there are."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from groundslab.errors import InputError, Issue
from groundslab.schema.wording import describe, listed

#: Entries of a folder of results that are looked at, at most.
MAX_ENTRIES = 100_000
#: Names that are listed where one is not found, at most.
MOST_NAMES = 20


def resolve(root: Path, name: str, key: str) -> Path:
    """Return the full path, without links, of a name in a folder, which is a full path itself.

    Raises InputError, whose issue is at ``key``, for what lies outside.
    """
    if "\0" in name:
        raise InputError([Issue(key, "a name with a zero character", "the name of a file")])
    path = Path(os.path.realpath(root / name))
    if not path.is_relative_to(root):
        hint = "give a path relative to this server's folder; links that lead out of it are not followed"
        raise InputError([Issue(key, describe(name), "a path within the folder", hint)])
    return path


def resolve_case(root: Path, name: str) -> Path:
    """Return the full path of a case file, which exists; raises InputError with the names of those that do."""
    path = resolve(root, name, "case")
    if not path.is_file():
        raise InputError([Issue("case", describe(name), "a case file in the folder", _names(_cases(root)))])
    return path


def resolve_results(root: Path, name: str) -> Path:
    """Return the full path of a folder of results, in which no link leads out; raises InputError."""
    path = resolve(root, name, "results")
    if not (path / "summary.json").is_file():
        names = (file.parent.relative_to(root).as_posix() for file in root.glob("*/summary.json"))
        raise InputError(
            [Issue("results", describe(name), "a folder of results that solve has written", _names(names))]
        )
    for number, entry in enumerate(path.rglob("*")):
        if number >= MAX_ENTRIES:
            raise InputError([Issue("results", f"more than {MAX_ENTRIES:,} files", "a folder of results alone")])
        if entry.is_symlink():
            resolve(root, str(entry), "results")
    return path


def require_below(root: Path, path: Path, key: str) -> None:
    """Raise InputError if a path is the folder itself, which is not to be replaced."""
    if path == root:
        raise InputError([Issue(key, "the folder itself", "a name within it")])


def require_same(root: Path, path: Path, key: str) -> None:
    """Raise InputError if a full path leads elsewhere by now: links may have been put there since it was resolved."""
    if resolve(root, str(path), key) != path:
        hint = "a link was put into the path meanwhile; nothing was written"
        raise InputError([Issue(key, describe(path.relative_to(root).as_posix()), "the same place as before", hint)])


def _cases(root: Path) -> Iterator[str]:
    """Yield the TOML files in a folder and one below."""
    for pattern in ("*.toml", "*/*.toml"):
        yield from (path.relative_to(root).as_posix() for path in root.glob(pattern))


def _names(names: Iterator[str]) -> str:
    """Return the first of some names in words, empty if there are none."""
    first = sorted(names)[:MOST_NAMES]
    return f"there is {listed(first)}" if first else ""
