"""One document in the workbench: edited, saved automatically, checked, solved, and shown on any number of pages."""

from __future__ import annotations

import threading
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.workbench.checking.bounded_process import BoundedProcess
from groundslab.workbench.checking.drawings import DrawingReader
from groundslab.workbench.checking.parsing import CheckResult
from groundslab.workbench.checking.thread import Checker
from groundslab.workbench.editing.document import Document, Edit
from groundslab.workbench.editing.undo import History
from groundslab.workbench.events import Event, Hub
from groundslab.workbench.persistence import autosave, files
from groundslab.workbench.persistence.autosave import Autosave, UnsavedWork
from groundslab.workbench.server import case_file
from groundslab.workbench.server.case_file import CaseFile, Conflict
from groundslab.workbench.solver.ground_comparison import GroundComparer
from groundslab.workbench.solver.process import OUTDATED
from groundslab.workbench.solver.thread import DELAY, Solver

State = dict[str, Any]
#: Longest time that an answer waits for the document to be checked; pages ask again afterwards [s].
CHECK_WAIT = 0.5
#: The same for its data alone, which form and drawing need [s].
DATA_WAIT = 2.0


class Session:
    """The document, its undo history, its file, and the solver that follows it."""

    _history: History
    _case_file: CaseFile
    _autosave: Autosave

    def __init__(self, hub: Hub, solver: Solver, state: Path, url: str, caller: BoundedProcess | None = None) -> None:
        """Begin with a new document; state is the user's folder for unsaved work and locks; caller checks texts."""
        self.hub = hub
        self.solver = solver
        self.comparer = GroundComparer(hub.publish)
        self._checker = Checker(self._set_data, self._set_check_result, caller)
        self._drawings = DrawingReader()
        self._data: dict[str, Any] | None = None
        self._check_result: CheckResult | None = None  # None while the document is being checked
        self._plan: dict[str, Any] | None = None  # the previous one while the document is being checked
        self._state = state
        self._lock_file = partial(case_file.lock_file, state=state, url=url)
        self._lock = threading.RLock()
        self._version = 0
        self._autosolve = True
        self._begin_new()

    def get_state(self) -> State:
        """Return all that a page shows of the document; waits a moment for it to be checked."""
        self._checker.wait(self._version, CHECK_WAIT, DATA_WAIT)
        with self._lock:
            document, history, result, path = self._document, self._history, self._check_result, self._case_file.path
            job = self.solver.current
            return {
                "version": self._version,
                "text": document.text,
                "data": self._data,
                "checking": result is None,
                "issues": [] if result is None else result.issues_json,
                "remarks": [] if result is None else result.remarks_json,
                "plan": self._plan,
                "file": None if path is None else str(path),
                "dirty": document.to_bytes() != self._case_file.content,
                "can_undo": bool(history.done),
                "can_redo": bool(history.undone),
                "undo_text": history.undo_label,
                "redo_text": history.redo_label,
                "offer": self._offers[0].to_json(self._case_file.base) if self._offers else None,
                "autosolve": self._autosolve,
                "run": None if job is None else job.to_json(),
                "unkept": self._autosave_error,
                "outside": self._case_file.has_changed(),
            }

    def get_current_events(self) -> list[Event]:
        """Return the events that describe the present state."""
        with self._lock:
            return [("state", {"version": self._version}), *self.solver.get_current_events()]

    def edit(self, edits: Sequence[Edit], label: str, base: int | None, merges: bool = False) -> State:
        """Apply all edits or none; raises Conflict if base is an old version, InputError for invalid edits."""
        while True:
            with self._lock:
                if base is not None and base != self._version:
                    raise Conflict("version")
                before, version = self._document, self._version
            after = self._checker.apply_edits(before, edits)
            with self._lock:
                if version != self._version:
                    continue  # another edit was faster
                if after.text != before.text:
                    self._history.record(before.text, label or "Edit", merges)
                    self._set_document(after)
            return self.get_state()

    def undo(self) -> State:
        """Undo the latest step, if there is one."""
        with self._lock:
            self._set_text(self._history.undo(self._document.text))
        return self.get_state()

    def redo(self) -> State:
        """Redo the step that was undone last, if there is one."""
        with self._lock:
            self._set_text(self._history.redo(self._document.text))
        return self.get_state()

    def save(self, name: str | None, overwrite: bool) -> State:
        """Write the document to its file or another one.

        Raises Conflict if the file has been changed by another program, exists or is open elsewhere, InputError if it
        cannot be written.
        """
        with self._lock:
            target, present = case_file.resolve_target(name, self._case_file), self._case_file
            self._case_file = present.save(target, self._document.to_bytes(), overwrite, self._lock_file)
            self._autosave.discard()
            if self._case_file is not present:
                present.close()
                self._autosave = Autosave(target, self._state)
                self._offers = self._autosave.find_earlier()
            self._history.close_step()
            self._autosave_error = ""
            self.hub.publish("saved", {"file": str(target)})
            self._publish_state()
        return self.get_state()

    def open(self, name: str) -> State:
        """Open a file in place of the document, whose unsaved work stays; raises InputError and Conflict."""
        with self._lock:
            target = case_file.resolve_path(name, self._case_file.folder)
            content, offers = case_file.read_content(target), Autosave(target, self._state).find_earlier()
            if content is None and not offers:
                hint = f"groundslab new {target.name} makes one" if files.try_check(target.parent.is_dir) else ""
                raise InputError([Issue(str(target), "no file of that name", "a case file", hint)])
            # unsaved work whose file is gone takes its place
            document = Document.from_bytes(content, str(target)) if content is not None else offers[0].document
            present = self._case_file
            is_own = target == present.path
            opened = CaseFile(target, content, present.lock if is_own else self._lock_file(target))
            if not is_own:
                present.close()
            self._autosave.release()
            self._begin(document, opened)
        return self.get_state()

    def new(self, text: str | None = None) -> State:
        """Begin a new document, with a text or the usual one; the unsaved work on the previous one stays."""
        with self._lock:
            self._autosave.release()
            self._case_file.close()
            self._begin_new(text)
        return self.get_state()

    def survey_drawing(self, name: str) -> dict[str, Any]:
        """Return what the layers of a drawing hold; raises InputError."""
        return self._drawings.survey(case_file.resolve_path(name, self._case_file.folder))

    def open_drawing(
        self, name: str, layers: Mapping[str, str], unit: str | None, centered: bool, gap: str
    ) -> dict[str, Any]:
        """Begin a new document made from a drawing, and return its state with the report; raises InputError."""
        path = case_file.resolve_path(name, self._case_file.folder)
        made = self._drawings.convert(path, layers, unit, centered, gap)
        with self._lock:
            self._autosave.release()
            self._case_file.close()
            self._begin(Document(made.text), CaseFile(None, None))
        return {"state": self.get_state(), "report": made.report, "origin": made.origin}

    def restore(self, accept: bool) -> State:
        """Restore unsaved work of an earlier run, as a step that can be undone, or decline it."""
        with self._lock:
            if self._offers:
                offer = self._offers.pop(0)
                if accept:
                    self._accept(offer)
                else:
                    autosave.decline(offer)
                self._publish_state()
        return self.get_state()

    def solve(self) -> int:
        """Solve the document at once and return the run; raises InputError with its issues if it has any."""
        self._checker.wait(self._version, CHECK_WAIT)
        with self._lock:
            if self._check_result is None:
                found, hint = "a case that is still being checked", "wait until it has been checked"
                raise InputError([Issue("the description", found, "a checked one", hint)])
            if self._check_result.issues:
                raise InputError(self._check_result.issues)
            return self._submit(self._check_result, delay=0.0, force=True)

    def set_autosolve(self, on: bool) -> None:
        """Solve after every change, or only on request."""
        with self._lock:
            self._autosolve = on
            if on and self._check_result is not None and self._check_result.fingerprint:
                self._submit(self._check_result, delay=0.0)
            self._publish_state()

    def list_folder(self, folder: str | None = None) -> dict[str, Any]:
        """Return the case files and folders in a folder, by default that of the document."""
        with self._lock:
            present = self._case_file.folder
            return files.list_folder(case_file.resolve_path(folder, present) if folder else present)

    def write_report(self, run: int) -> tuple[str, bytes]:
        """Return a name for the report on a run, and its content."""
        path = self._case_file.path or Path("case.toml")
        kind = OUTDATED if self._is_outdated(run) else "report"
        return f"{path.stem}-report.html", self.solver.make_view((kind, run, path.name))

    def _is_outdated(self, run: int) -> bool:
        """Return whether the document describes another model by now than that of a run."""
        result = self.solver.get_result(run)
        with self._lock:
            if result is None or result.text == self._document.text:
                return False
            return self._check_result is None or self._check_result.fingerprint != result.fingerprint

    def write_archive(self, run: int) -> tuple[str, bytes]:
        """Return a name for the archive of case, results and report of a run, and its content."""
        path = self._case_file.path or Path("case.toml")
        return f"{path.stem}-results.zip", self.solver.make_view(("archive", run, path.name))

    def close(self) -> str:
        """End; return the path of unsaved work, empty if there is none."""
        self._checker.close()
        with self._lock:
            self.hub.close()
            self.comparer.cancel()
            self.solver.close()
            self._autosave.release()
            self._case_file.close()
            return "" if self._autosave.path is None else str(self._autosave.path)

    def _begin_new(self, text: str | None = None) -> None:
        document = Document(casefile.starter() if text is None else text)
        self._begin(document, CaseFile(None, document.to_bytes()))

    def _begin(self, document: Document, file: CaseFile) -> None:
        """Begin with a document, without undo history."""
        self.comparer.cancel()
        self.solver.reset()
        self._case_file = file
        self._history = History()
        self._autosave = Autosave(file.path, self._state)
        self._offers = self._autosave.find_earlier()
        for offer in list(self._offers):
            if file.base is not None and offer.document.to_bytes() == document.to_bytes():
                autosave.remove(offer)  # it was saved in the end
                self._offers.remove(offer)
        self._plan = None
        self._set_document(document)

    def _accept(self, offer: UnsavedWork) -> None:
        """Continue with unsaved work."""
        before = self._document
        # a file that has changed since the work began must not be overwritten unasked
        self._case_file.base = offer.base
        if offer.document.text != before.text:
            self._history.record(before.text, "Restore unsaved work")
        self._set_document(offer.document)
        if not self._autosave_error:
            autosave.remove(offer)

    def _set_document(self, document: Document) -> None:
        """Replace the document: it is saved automatically, announced and checked, then solved."""
        self._document = document
        self._version += 1
        self._data = self._check_result = None
        self._checker.submit(self._version, document)
        self._autosave_error = ""
        if document.to_bytes() == self._case_file.content:
            self._autosave.discard()
        else:
            try:
                self._autosave.write(document, self._case_file.base)
            except OSError as error:
                self._autosave_error = f"unsaved work cannot be written to the disk: {files.describe_error(error)}"
        self._publish_state()

    def _set_text(self, text: str | None) -> None:
        """Go to another text of the history, if there is one."""
        if text is not None:
            self._set_document(replace(self._document, text=text))

    def _set_data(self, version: int, data: dict[str, Any] | None) -> None:
        """Set the data of a version."""
        with self._lock:
            if version == self._version:
                self._data = data

    def _set_check_result(self, version: int, result: CheckResult) -> None:
        """Set the result of checking a version, and solve it."""
        with self._lock:
            if version == self._version:
                self._check_result, self._plan = result, result.plan
                if self._autosolve and result.fingerprint:
                    self._submit(result)

    def _submit(self, result: CheckResult, delay: float = DELAY, force: bool = False) -> int:
        return self.solver.submit(self._document.text, self._version, result.fingerprint, delay, force)

    def _publish_state(self) -> None:
        self.hub.publish("state", {"version": self._version})
