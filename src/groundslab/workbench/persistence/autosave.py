"""Unsaved work on the disk: written with every change, offered again by the next start, gone after a save.

It lies beside the case as ``.case.toml.unsaved`` (with a number if such work of an earlier run is there already), or,
where that folder cannot be written to or the document has no file, in the user's state folder. Its first line is a
comment that says what it is; the rest is the text, so that it can be read and solved as it is.
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
from groundslab.storage import atomic
from groundslab.workbench.editing.document import Document
from groundslab.workbench.persistence import files
from groundslab.workbench.persistence.lock import Lock

HEAD = "# unsaved work of groundslab: "
#: Age [s] after which a file left half written is nobody's.
STALE = 60.0
LARGEST = 5 * casefile.LARGEST  # bytes of such a file: a character has up to four


@dataclass(frozen=True, slots=True)
class Kept:
    """Unsaved work: where it is kept, when it was written, on which content of which file it builds."""

    path: Path
    when: str
    document: Document
    file: str | None
    base: str | None  # digest of the file's content, None where there was no file


def read(path: Path) -> Kept | None:
    """Return the work that a file keeps, None if it keeps none; links are not followed."""
    try:
        if path.is_symlink():
            return None
        head, _, text = files.read(path, LARGEST).decode("utf-8").partition("\n")
        about: dict[str, Any] = json.loads(head.removeprefix(HEAD))
        document = Document(text, about["newline"], about["mark"])
        return Kept(path, about["when"], document, about["file"], about["base"]) if head.startswith(HEAD) else None
    except (OSError, ValueError, KeyError, TypeError):
        return None


class Keeper:
    """Keeps the unsaved work of one document, and finds what earlier runs have kept of it."""

    def __init__(self, file: Path | None, state: Path) -> None:
        """Keep work on a file, or on a document without one; state is the folder for what has no other place."""
        self.file = None if file is None else Path(os.path.realpath(file))
        self.folder = state / "unsaved"
        self.path: Path | None = None
        self._lock: Lock | None = None

    def keep(self, document: Document, base: str | None) -> None:
        """Write the work, whole and down to the disk; raises OSError if no place takes it."""
        about = {
            "file": None if self.file is None else str(self.file),
            "when": datetime.now(UTC).isoformat(timespec="seconds"),
            "base": base,
            "newline": document.newline,
            "mark": document.mark,
        }
        content = f"{HEAD}{json.dumps(about)}\n{document.text}".encode()
        failure: OSError | None = None
        if self.path is not None:
            atomic.sweep(self.path, STALE)
        for path in chain([] if self.path is None else [self.path], self._places()):
            try:
                atomic.write(path, content, private=True)
            except OSError as error:
                failure = error
                continue
            self.path = path
            return
        raise failure or OSError("no place for unsaved work")

    def drop(self) -> None:
        """Remove the work, which is saved or taken back."""
        if self.path is not None:
            with suppress(OSError):
                self.path.unlink()
            self.path = None
        self.release()

    def release(self) -> None:
        """Leave the work, if there is any, for the next start to offer."""
        if self._lock is not None:
            self._lock.release(remove=True)
            self._lock = None

    def offers(self) -> list[Kept]:
        """Return what earlier runs have kept of the document, the latest first."""
        found = [kept for path in self._earlier() if path != self.path and (kept := read(path)) is not None]
        own = str(self.file) if self.file is not None else None
        return sorted((kept for kept in found if kept.file == own), key=lambda kept: kept.when, reverse=True)

    def _places(self) -> Iterator[Path]:
        """Yield where the work could be kept: names that are free."""
        if self.file is None:
            name = f"untitled-{secrets.token_hex(4)}"
            self.release()
            self._lock = Lock.take(self.folder / f"{name}.lock", {})[0]
            yield self.folder / f"{name}.unsaved"
            return
        for folder, stem in self._homes():
            for number in range(1, 1000):
                path = atomic.helper(folder / stem, "unsaved" if number == 1 else f"unsaved-{number}")
                if not os.path.lexists(path):
                    yield path
                    break

    def _homes(self) -> list[tuple[Path, str]]:
        """Return the folders in which work on the file may lie, with its name there."""
        assert self.file is not None
        aside = f"{self.file.name}-{files.digest(os.fsencode(self.file))[:12]}"
        return [(self.file.parent, self.file.name), (self.folder, aside)]

    def _earlier(self) -> Iterator[Path]:
        """Yield the files in which earlier runs may have kept work; what another run is at is left out."""
        if self.file is None:
            with suppress(OSError):
                for path in self.folder.glob("untitled-*.unsaved"):
                    lock = Lock.take(path.with_suffix(".lock"), {})[0]
                    if lock is not None:
                        lock.release(remove=True)
                        yield path
            return
        for folder, stem in self._homes():
            pattern = re.compile(re.escape(atomic.helper(folder / stem, "unsaved").name) + r"(-[0-9]+)?")
            with suppress(OSError):
                yield from [path for path in folder.iterdir() if pattern.fullmatch(path.name)]


def remove(kept: Kept) -> None:
    """Remove work that is not needed any more, if its folder can be written to."""
    with suppress(OSError):
        kept.path.unlink()


def decline(kept: Kept) -> None:
    """Put work aside that is not wanted: it is offered no more, but the latest such is still there."""
    name = re.sub(r"(^untitled-[0-9a-f]+)?\.unsaved(-[0-9]+)?$", _declined, kept.path.name)
    aside = kept.path.with_name(name)
    with suppress(OSError):
        # nothing but other such work is replaced
        if not os.path.lexists(aside) or read(aside) is not None:
            atomic.replace(kept.path, aside)


def _declined(match: re.Match[str]) -> str:
    return f"{'untitled' if match[1] else ''}.unsaved-declined"
