"""One document in the workbench: edited, saved automatically, checked, solved, and shown on any number of pages."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, Literal

from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.exchange.reactions import Choices
from groundslab.messages import Label, Message, Name
from groundslab.workbench.checking.bounded_process import BoundedProcess
from groundslab.workbench.checking.drawings import ConvertedDrawing, DrawingReader
from groundslab.workbench.checking.reactions import ReactionPreview, ReactionReader
from groundslab.workbench.checking.saf import ConvertedSlab
from groundslab.workbench.checking.slabs import SlabReader
from groundslab.workbench.editing.document import Document
from groundslab.workbench.editing.merge import Comparison
from groundslab.workbench.events import Event, Hub
from groundslab.workbench.exports.files import Exported
from groundslab.workbench.persistence import files
from groundslab.workbench.persistence.autosave import Autosave
from groundslab.workbench.server import case_file
from groundslab.workbench.server.analyses import Analyses
from groundslab.workbench.server.case_file import CaseFile, Conflict
from groundslab.workbench.server.editor import CHECK_WAIT, DATA_WAIT, Editor
from groundslab.workbench.server.working_copy import WorkingCopy
from groundslab.workbench.solver.thread import Solver

State = dict[str, Any]


class Session:
    """The document that is open, its editor, and the analyses that follow it."""

    def __init__(self, hub: Hub, solver: Solver, state: Path, url: str, caller: BoundedProcess | None = None) -> None:
        """Begin with a new document; state is the user's folder for unsaved work and locks; caller checks texts."""
        self.hub = hub
        self._lock = threading.RLock()
        self.analyses = Analyses(self._lock, hub, solver)
        self._drawings = DrawingReader()
        self._reactions = ReactionReader()
        self._slabs = SlabReader()
        self._state = state
        self._lock_file = partial(case_file.lock_file, state=state, url=url)
        document = Document(casefile.starter())
        copy = WorkingCopy(document, CaseFile(None, document.to_bytes()), state)
        self.editor = Editor(self._lock, copy, hub, self.analyses.follow, caller)

    @property
    def file(self) -> CaseFile:
        """The file of the document."""
        return self.editor.copy.file

    def get_state(self) -> State:
        """Return all that a page shows of the document; waits a moment for it to be checked."""
        editor = self.editor
        editor.checker.wait(editor.revision.version, CHECK_WAIT, DATA_WAIT)
        with self._lock:
            return editor.revision.to_json() | editor.copy.to_json() | self.analyses.to_json()

    def get_current_events(self) -> list[Event]:
        """Return the events that describe the present state."""
        with self._lock:
            return [self.editor.revision.event, *self.analyses.solver.schedule.get_current_events()]

    def list_folder(self, folder: str | None = None) -> dict[str, Any]:
        """Return the case files and folders in a folder, by default that of the document."""
        present = self.file.folder
        return files.list_folder(case_file.resolve_path(folder, present) if folder else present)

    def save(self, name: str | None, overwrite: bool) -> None:
        """Write the document to its file or another one.

        Raises Conflict if the file has been changed by another program, exists or is open elsewhere, InputError if it
        cannot be written.
        """
        with self._lock:
            target = case_file.resolve_target(name, self.file)
            self.editor.copy.save(target, overwrite, self._lock_file)
            self.hub.publish("saved", {"file": str(target)})
            self.editor.follow_file()
            self.editor.publish_state()

    def open(self, name: str) -> None:
        """Open a file in place of the document, whose unsaved work stays; raises InputError and Conflict."""
        with self._lock:
            present = self.file
            target = case_file.resolve_path(name, present.folder)
            content, offers = case_file.read_content(target), Autosave(target, self._state).find_earlier()
            if content is None and not offers:
                hint = (
                    Message("{command} makes one", command=Name(f"groundslab new {target.name}"))
                    if files.try_check(target.parent.is_dir)
                    else ""
                )
                raise InputError([Issue(str(target), "no file of that name", "a case file", hint)])
            # unsaved work whose file is gone takes its place
            document = Document.from_bytes(content, str(target)) if content is not None else offers[0].document
            if target == present.path:
                lock, present.lock = present.lock, None
            else:
                lock = self._lock_file(target)
            self._begin(document, CaseFile(target, content, lock))

    def compare_file(self) -> tuple[str, Comparison]:
        """Return the digest of the file as it is now, and how its text differs from the document; raises InputError."""
        with self._lock:
            content, theirs = self._read_file()
            file, mine = self.file, self.editor.copy.document.text
        is_known = file.content is not None and files.compute_digest(file.content) == file.base
        base = Document.from_bytes(file.content or b"", str(file.path)).text if is_known else None
        return files.compute_digest(content), self.editor.checker.compare(base, mine, theirs.text)

    def take_file(self, which: Literal["theirs", "mine", "merged"], digest: str) -> None:
        """Let the text of the file, that of the document, or both merged count from now on, as a step of undo.

        Raises Conflict if the file is no longer the one with the digest, or cannot be merged, and InputError.
        """
        before = self.editor.copy.document.text
        compared, comparison = self.compare_file()
        merged = comparison.merged if which == "merged" else None
        with self._lock:
            content, theirs = self._read_file()
            is_same = digest == compared == files.compute_digest(content)
            if which == "merged" and self.editor.copy.document.text != before:
                is_same = False  # edited while it was merged
            if not is_same or (which == "merged" and merged is None):
                changed, hint = "a file that has changed again", "look at the difference again"
                raise Conflict("changed", [Issue(str(self.file.path), changed, "the file that was compared", hint)])
            self.file.adopt(content)
            if which == "theirs":
                self.editor.take(theirs, Label("Reload from disk"))
            elif merged is not None:
                self.editor.take(replace(theirs, text=merged), Label("Merge with the file"))
            else:
                self.editor.take(self.editor.copy.document, "")

    def _read_file(self) -> tuple[bytes, Document]:
        """Return the file as it is now; raises InputError."""
        path = self.file.path
        content = None if path is None else case_file.read_content(path)
        if content is None:
            raise InputError([Issue(str(path or "file"), "no file any more", "the file of the case", "save the case")])
        return content, Document.from_bytes(content, str(path))

    def new(self, text: str | None = None) -> None:
        """Begin a new document, with a text or the usual one; unsaved work on the file of the previous one stays."""
        document = Document(casefile.starter() if text is None else text)
        self._begin(document, CaseFile(None, document.to_bytes()))

    def survey_drawing(self, name: str) -> dict[str, Any]:
        """Return the contents of a drawing's layers; raises InputError."""
        return self._drawings.survey(case_file.resolve_path(name, self.file.folder))

    def open_drawing(
        self, name: str, layers: Mapping[str, str], unit: str | None, centered: bool, gap: str, union: bool
    ) -> ConvertedDrawing:
        """Begin a new document made from a drawing, and return that; raises InputError."""
        path = case_file.resolve_path(name, self.file.folder)
        converted = self._drawings.convert(path, layers, unit, centered, gap, union)
        self._begin(Document(converted.text), CaseFile(None, None))
        return converted

    def survey_slabs(self, name: str) -> list[dict[str, Any]]:
        """Return the slabs of a SAF file or a building, none if a workbook is another one; raises InputError."""
        return self._slabs.survey(case_file.resolve_path(name, self.file.folder))

    def open_slab(self, name: str, slab: str, centered: bool, aligned: bool) -> ConvertedSlab:
        """Begin a new document made from a slab of a file, and return that; raises InputError."""
        converted = self._slabs.convert(case_file.resolve_path(name, self.file.folder), slab, centered, aligned)
        self._begin(Document(converted.text), CaseFile(None, None))
        return converted

    def import_reactions(self, name: str, choices: Choices, base: int | None) -> ReactionPreview:
        """Return what a table of reactions changes; take it as a step of undo into the version that is given, if any.

        Raises InputError, and Conflict if there is a newer version.
        """
        revision = self.editor.revision
        if base not in (None, revision.version):
            raise case_file.Conflict("version")
        folder = None if self.file.path is None else self.file.folder
        preview = self._reactions.read(
            case_file.resolve_path(name, self.file.folder), revision.document.text, folder, choices
        )
        if base is not None:
            self.editor.edit([{"op": "text", "value": preview.text}], Label("Import reactions"), base)
        return preview

    def solve(self) -> int:
        """Solve the document at once and return the run; raises InputError with its issues if it has any."""
        self.editor.checker.wait(self.editor.revision.version, CHECK_WAIT)
        return self.analyses.solve()

    def write_saf(self, untitled: Path) -> tuple[str, Exported]:
        """Return a name for the document in the Structural Analysis Format, and the file; raises InputError."""
        self.editor.checker.wait(self.editor.revision.version, CHECK_WAIT)
        return self.analyses.write_saf(self.file.path or untitled)

    def close(self) -> str:
        """End; return the path of unsaved work, empty if there is none."""
        self.editor.checker.close()
        with self._lock:
            self.hub.close()
            self.analyses.close()
            return self.editor.copy.release()

    def _begin(self, document: Document, file: CaseFile) -> None:
        """Begin with a document in place of the present one, without undo history.

        Unsaved work is offered with its file only: one who begins something new wants nothing else.
        """
        with self._lock:
            self.editor.copy.leave()
            self.analyses.reset()
            self.hub.publish("opened", {})
            copy = WorkingCopy(document, file, self._state)
            if file.path is None:
                copy.offers.clear()
            self.editor.begin(copy)
