"""Reading of tables of reactions in child processes, as they come from others and may take any time and memory."""

from __future__ import annotations

import threading
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

from groundslab.case.reactions import Choices, import_into
from groundslab.errors import InputError, Issue
from groundslab.workbench.checking.bounded_process import MEMORY, BoundedProcess, CallFailure

#: Time in which a table must be read [s].
READ_LIMIT = 60.0
#: Changes that the page lists.
LISTED = 500


@dataclass(frozen=True, slots=True)
class ReactionPreview:
    """The text of the case with the loads of a table; changes, sums by case and remarks in words, a line each."""

    text: str
    changes: tuple[str, ...]
    sums: tuple[str, ...]
    remarks: tuple[str, ...]


class ReactionReader:
    """Reads one table at a time, each in a process of its own, which then ends."""

    def __init__(self, seconds: float = READ_LIMIT, memory: int = MEMORY) -> None:
        self._seconds, self._memory = seconds, memory
        self._lock = threading.Lock()

    def read(self, path: Path, text: str, folder: Path | None, choices: Choices) -> ReactionPreview:
        """Return what a table changes in the case of a text, whose folder may be known; raises InputError."""
        with self._lock:
            caller = BoundedProcess(load_libraries, self._memory)
            try:
                preview: ReactionPreview = caller.call(
                    preview_reactions, path, text, folder, choices, seconds=self._seconds
                )
                return preview
            except CallFailure as error:
                found, hint = f"a table that cannot be read ({error})", "save only the cases that are needed"
                raise InputError([Issue(str(path), found, "a smaller one", hint)]) from None
            finally:
                caller.close()


def load_libraries() -> None:
    """Load what reading needs, before memory is limited."""
    for name in ("shapely", "openpyxl"):
        with suppress(ImportError):  # an issue of the reading itself
            import_module(name)


def preview_reactions(path: Path, text: str, folder: Path | None, choices: Choices) -> ReactionPreview:
    """Return what a table changes in a case."""
    made = import_into(text, folder, path, choices)
    changes = [str(change) for change in made.changes]
    if len(changes) > LISTED:
        changes[LISTED:] = [f"{len(changes) - LISTED} more"]
    return ReactionPreview(made.text, tuple(changes), tuple(map(str, made.sums)), made.remarks)
