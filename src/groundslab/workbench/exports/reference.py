"""Results that the user keeps as a reference, to subtract them from later ones: in files that end with the server."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

from groundslab.errors import InputError, Issue

#: References that are kept, as each page may have one.
MOST = 4


class KeptReferences:
    """The files of results that were kept, by their runs, each in a folder that nobody else can read."""

    def __init__(self) -> None:
        self._folders: dict[int, tempfile.TemporaryDirectory[str]] = {}

    def keep(self, run: int, save: Callable[[str], object]) -> None:
        """Keep the results of a run, which `save` writes into a file; raises InputError."""
        folder = tempfile.TemporaryDirectory(prefix="groundslab-")
        try:
            save(str(_inside(folder)))
        except BaseException:
            folder.cleanup()
            raise
        # provisional results of the run may have been kept before
        if before := self._folders.pop(run, None):
            before.cleanup()
        self._folders[run] = folder
        while len(self._folders) > MOST:
            self._folders.pop(next(iter(self._folders))).cleanup()

    def find(self, run: int | None) -> str:
        """Return the file of a run, "" of none; raises InputError if it is not kept."""
        if run is None:
            return ""
        if run not in self._folders:
            hint = "keep other results as the reference"
            raise InputError([Issue("minus", "a reference that is not kept any more", "one that is kept", hint)])
        return str(_inside(self._folders[run]))

    def clear(self) -> None:
        """Keep none any more."""
        while self._folders:
            self._folders.popitem()[1].cleanup()


def _inside(folder: tempfile.TemporaryDirectory[str]) -> Path:
    """Return the file in a folder."""
    return Path(folder.name) / "results"
