"""A document that is being worked on, with its file and what is saved of it automatically."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from groundslab.messages import Message
from groundslab.workbench.editing.document import Document
from groundslab.workbench.editing.undo import History
from groundslab.workbench.persistence import autosave, files
from groundslab.workbench.persistence.autosave import Autosave
from groundslab.workbench.persistence.lock import Lock
from groundslab.workbench.server.case_file import CaseFile


class WorkingCopy:
    """The document, its file, the steps that can be undone, and the unsaved work of earlier runs."""

    def __init__(self, document: Document, file: CaseFile, state: Path) -> None:
        """Begin without steps; state is the user's folder for unsaved work."""
        self.document, self.file, self.history = document, file, History()
        self._state = state
        self._autosave = Autosave(file.path, state)
        self.autosave_error = ""
        self.offers = self._autosave.find_earlier()
        for offer in list(self.offers):
            if file.base is not None and offer.document.to_bytes() == document.to_bytes():
                autosave.remove(offer)  # it was saved in the end
                self.offers.remove(offer)

    def to_json(self) -> dict[str, Any]:
        """Return file and history as data for the page."""
        return {
            "file": None if self.file.path is None else str(self.file.path),
            "dirty": self.document.to_bytes() != self.file.content,
            "can_undo": bool(self.history.done),
            "can_redo": bool(self.history.undone),
            "undo_text": self.history.undo_label,
            "redo_text": self.history.redo_label,
            "offer": self.offers[0].to_json(self.file.base) if self.offers else None,
            "unkept": self.autosave_error,
            "outside": self.file.has_changed(),
        }

    def set_document(self, document: Document) -> None:
        """Replace the document, which is saved automatically."""
        self.document = document
        self.autosave_error = ""
        if document.to_bytes() == self.file.content:
            self._autosave.discard()
        else:
            try:
                self._autosave.write(document, self.file.base)
            except OSError as error:
                self.autosave_error = Message(
                    "unsaved work cannot be written to the disk: {error}", error=files.describe_error(error)
                )

    def save(self, target: Path, overwrite: bool, lock: Callable[[Path], Lock]) -> None:
        """Write the document to its file or another one, which ``lock`` locks; raises Conflict and InputError."""
        present = self.file
        self.file = present.save(target, self.document.to_bytes(), overwrite, lock)
        self._autosave.discard()
        if self.file is not present:
            present.close()
            self._autosave = Autosave(target, self._state)
            self.offers = self._autosave.find_earlier()
        self.history.close_step()
        self.autosave_error = ""

    def leave(self) -> None:
        """Leave file and unsaved work for another document; work without a file counts as declined."""
        kept = self.release()
        work = autosave.read_unsaved(Path(kept)) if kept and self.file.path is None else None
        if work is not None:
            autosave.decline(work)

    def release(self) -> str:
        """Leave file and unsaved work; return the path of the latter, empty if there is none."""
        self._autosave.release()
        self.file.close()
        return "" if self._autosave.path is None else str(self._autosave.path)
