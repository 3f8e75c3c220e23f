"""The document, edited in steps; each of its versions is saved automatically, announced and checked."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from threading import RLock

from groundslab.messages import Label
from groundslab.workbench.checking.bounded_process import BoundedProcess
from groundslab.workbench.checking.revision import Revision
from groundslab.workbench.checking.thread import Checker
from groundslab.workbench.editing.document import Document, Edit
from groundslab.workbench.events import Hub
from groundslab.workbench.persistence import autosave
from groundslab.workbench.server.case_file import Conflict
from groundslab.workbench.server.working_copy import WorkingCopy

#: Longest time that an answer waits for the document to be checked; pages ask again afterwards [s].
CHECK_WAIT = 0.5
#: The same for its data alone, which form and drawing need [s].
DATA_WAIT = 2.0


class Editor:
    """The working copy and its present revision, both guarded by the lock."""

    def __init__(
        self,
        lock: RLock,
        copy: WorkingCopy,
        hub: Hub,
        follow: Callable[[Revision], None],
        caller: BoundedProcess | None = None,
    ) -> None:
        """Begin with a working copy; follow takes each revision, and again as it is checked, which caller does."""
        self._lock, self._hub, self._follow = lock, hub, follow
        self.checker = Checker(self._set_found, caller)
        self.revision = Revision(0, copy.document)
        self.begin(copy)

    def begin(self, copy: WorkingCopy) -> None:
        """Continue with another working copy."""
        with self._lock:
            self.copy = copy
            self.revision = Revision(self.revision.version, copy.document)  # whose plan is unknown
            self._set_document(copy.document)

    def edit(self, edits: Sequence[Edit], label: str, base: int | None, merges: bool = False) -> None:
        """Apply all edits or none; raises Conflict if base is an old version, InputError for invalid edits."""
        while True:
            with self._lock:
                before = self.revision
            if base is not None and base != before.version:
                raise Conflict("version")
            after = self.checker.apply_edits(before.document, edits)
            with self._lock:
                if before.version != self.revision.version:
                    continue  # another edit was faster
                if after.text != before.document.text:
                    self.copy.history.record(before.document.text, label or Label("Edit"), merges)
                    self._set_document(after)
            return

    def undo(self) -> None:
        """Undo the latest step, if there is one."""
        with self._lock:
            self._set_text(self.copy.history.undo(self.copy.document.text))

    def redo(self) -> None:
        """Redo the step that was undone last, if there is one."""
        with self._lock:
            self._set_text(self.copy.history.redo(self.copy.document.text))

    def restore(self, accept: bool) -> None:
        """Restore unsaved work of an earlier run, as a step that can be undone, or decline it."""
        with self._lock:
            if not self.copy.offers:
                return
            offer, before = self.copy.offers.pop(0), self.copy.document
            if accept:
                # a file that has changed since the work began must not be overwritten unasked
                self.copy.file.base = offer.base
                if offer.document.text != before.text:
                    self.copy.history.record(before.text, Label("Restore unsaved work"))
                self._set_document(offer.document)
                if not self.copy.autosave_error:
                    autosave.remove(offer)
            else:
                autosave.decline(offer)
            self.publish_state()

    def take(self, document: Document, label: str) -> None:
        """Take another document in place of the present one, as a step that can be undone."""
        with self._lock:
            before = self.copy.document
            if document.text != before.text:
                self.copy.history.record(before.text, label)
            self._set_document(document)

    def follow_file(self) -> None:
        """Check again if the document names a file beside its own, which has moved to another folder."""
        with self._lock:
            file, data = self.copy.file.path, self.revision.data or {}
            named = isinstance(data.get("building"), dict) and "file" in data["building"]
            if named and file is not None and file.parent != self.revision.folder:
                self._set_document(self.copy.document)

    def publish_state(self) -> None:
        """Announce that the state has changed, though not the document."""
        self._hub.publish(*self.revision.event)

    def _set_text(self, text: str | None) -> None:
        """Go to another text of the history, if there is one."""
        if text is not None:
            self._set_document(replace(self.copy.document, text=text))

    def _set_document(self, document: Document) -> None:
        """Replace the document by a new revision."""
        file = self.copy.file.path
        folder = None if file is None else file.parent
        before = self.revision
        self.revision = Revision(
            before.version + 1, document, folder, earlier_data=before.readable, earlier_plan=before.plan
        )
        self._follow(self.revision)
        self.checker.submit(self.revision)
        self.copy.set_document(document)
        self.publish_state()

    def _set_found(self, revision: Revision) -> None:
        """Set what has been found in a revision, unless there is a newer one."""
        with self._lock:
            if revision.version == self.revision.version:
                self.revision = revision
                self._follow(revision)
