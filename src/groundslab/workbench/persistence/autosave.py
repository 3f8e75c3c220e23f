"""Automatic saving of unsaved work: written with every change, offered by the next start, removed after a save.

The file is ``.case.toml.unsaved`` beside the case (with a number if an earlier run left one there), or in the user's
state folder if the case's folder cannot be written to or the document has no file. Its first line is a comment with
metadata; the rest is the text, so that the file is itself a valid case.
"""

from __future__ import annotations

import json
import os
import re
import secrets
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import chain
from pathlib import Path
from typing import Any

from groundslab.case import casefile
from groundslab.storage import atomic, bounded
from groundslab.workbench.editing.document import Document
from groundslab.workbench.persistence import files
from groundslab.workbench.persistence.lock import Lock

HEAD = "# unsaved work of groundslab: "
#: Age after which a partly written file counts as abandoned [s].
STALE = 60.0
MAX_SIZE = 5 * casefile.LARGEST  # bytes of such a file: a character has up to four


@dataclass(frozen=True, slots=True)
class UnsavedWork:
    """Unsaved work: where it is saved, when it was written, and the file that it changes."""

    path: Path
    when: str
    document: Document
    file: str | None
    base: str | None  # digest of the file's content that it builds on, None if there was no file

    def to_json(self, base: str | None) -> dict[str, Any]:
        """Return the work as data for the page; ``base`` is the digest of the file as it is now."""
        return {"file": self.file, "when": self.when, "kept": str(self.path), "changed": self.base != base}


def read_unsaved(path: Path) -> UnsavedWork | None:
    """Return the unsaved work in a file, None if there is none; links are not followed."""
    try:
        if path.is_symlink():
            return None
        head, _, text = bounded.read_regular(path, MAX_SIZE).decode("utf-8").partition("\n")
        about: dict[str, Any] = json.loads(head.removeprefix(HEAD))
        document = Document(text, about["newline"], about["mark"])
        return (
            UnsavedWork(path, about["when"], document, about["file"], about["base"]) if head.startswith(HEAD) else None
        )
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None


class Autosave:
    """Saves the unsaved work on one document, and finds that of earlier runs."""

    def __init__(self, file: Path | None, state: Path) -> None:
        """Save work on a file, or on a document without one; state is the fallback folder."""
        self.file = None if file is None else Path(os.path.realpath(file))
        self.folder = state / "unsaved"
        self.path: Path | None = None
        self._lock: Lock | None = None

    def write(self, document: Document, base: str | None) -> None:
        """Write the work to the disk atomically; raises OSError if that fails everywhere."""
        about = {
            "file": None if self.file is None else str(self.file),
            "when": datetime.now(UTC).isoformat(timespec="seconds"),
            "base": base,
            "newline": document.newline,
            "mark": document.has_bom,
        }
        content = f"{HEAD}{json.dumps(about)}\n{document.text}".encode()
        failure: OSError | None = None
        if self.path is not None:
            atomic.sweep(self.path, STALE)
        for path in chain([] if self.path is None else [self.path], self._generate_free_paths()):
            try:
                if path.parent == self.folder:
                    self.folder.mkdir(parents=True, exist_ok=True, mode=0o700)
                atomic.write(path, content, private=True)
            except OSError as error:
                failure = error
                continue
            self.path = path
            return
        raise failure or OSError("no place for unsaved work")

    def discard(self) -> None:
        """Remove the work, which is saved or undone."""
        if self.path is not None:
            with suppress(OSError):
                self.path.unlink()
            self.path = None
        self.release()

    def release(self) -> None:
        """Stop saving and leave the work for the next start to offer."""
        if self._lock is not None:
            self._lock.release()
            self._lock = None

    def find_earlier(self) -> list[UnsavedWork]:
        """Return the unsaved work of earlier runs on the document, the latest first."""
        unsaved = [work for path in self._find_earlier_paths() if path != self.path and (work := read_unsaved(path))]
        own_file = str(self.file) if self.file is not None else None
        return sorted((work for work in unsaved if work.file == own_file), key=lambda work: work.when, reverse=True)

    def _generate_free_paths(self) -> Iterator[Path]:
        """Yield unused paths for the work, the preferred one first."""
        if self.file is None:
            name = f"untitled-{secrets.token_hex(4)}"
            self.release()
            self._lock = Lock.acquire(self.folder / f"{name}.lock", {})[0]
            yield self.folder / f"{name}.unsaved"
            return
        for folder, stem in self._list_locations():
            for number in range(1, 1000):
                path = atomic.helper(folder / stem, "unsaved" if number == 1 else f"unsaved-{number}")
                if not os.path.lexists(path):
                    yield path
                    break

    def _list_locations(self) -> list[tuple[Path, str]]:
        """Return the folders for work on the file, each with the file's name there."""
        assert self.file is not None
        aside = f"{self.file.name}-{files.compute_digest(os.fsencode(self.file))[:12]}"
        return [(self.file.parent, self.file.name), (self.folder, aside)]

    def _find_earlier_paths(self) -> Iterator[Path]:
        """Yield the possible files of earlier runs, without those of runs that go on."""
        if self.file is None:
            with suppress(OSError):
                for path in self.folder.glob("untitled-*.unsaved"):
                    lock = Lock.acquire(path.with_suffix(".lock"), {})[0]
                    if lock is not None:
                        lock.release()
                        yield path
            return
        for folder, stem in self._list_locations():
            pattern = re.compile(re.escape(atomic.helper(folder / stem, "unsaved").name) + r"(-[0-9]+)?")
            with suppress(OSError):
                yield from [path for path in folder.iterdir() if pattern.fullmatch(path.name)]


def remove(work: UnsavedWork) -> None:
    """Remove unsaved work that is no longer needed, if its folder can be written to."""
    with suppress(OSError):
        work.path.unlink()


def decline(work: UnsavedWork) -> None:
    """Rename unsaved work that the user declined, so that it is not offered again; only the latest is kept."""
    kind = "untitled" if work.path.name.startswith("untitled-") else ""
    stem = re.sub(r"(^untitled-[0-9a-f]+)?\.unsaved(-[0-9]+)?$", kind, work.path.name)
    aside = work.path.with_name(f"{stem}.unsaved-declined")
    with suppress(OSError):
        # nothing else is replaced
        if not os.path.lexists(aside) or read_unsaved(aside) is not None:
            atomic.replace(work.path, aside)
