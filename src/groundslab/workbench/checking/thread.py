"""Checks the newest document in a child process, so that no text can keep the server from answering."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.messages import Message, Name
from groundslab.workbench.checking import parsing
from groundslab.workbench.checking.bounded_process import (
    BoundedProcess,
    CallFailure,
    Interrupted,
    MemoryLimit,
    TimeLimit,
)
from groundslab.workbench.checking.parsing import CheckResult
from groundslab.workbench.checking.revision import Revision
from groundslab.workbench.editing import diagnostics, merge
from groundslab.workbench.editing.document import Document, Edit
from groundslab.workbench.editing.merge import Comparison

#: Time in which a text must be checked [s].
CHECK_LIMIT = 20.0
#: Time in which an edit must be applied, less than after which a page gives up waiting for the server [s].
EDIT_LIMIT = 10.0


class Checker:
    """Checks the latest submitted revision; edits have priority.

    A thread of the checker calls ``on_found`` with the revision and its data as soon as they are known, then with the
    result.
    """

    def __init__(
        self, on_found: Callable[[Revision], None], caller: BoundedProcess | None = None, seconds: float = CHECK_LIMIT
    ) -> None:
        self._on_found = on_found
        self._caller = caller or BoundedProcess(parsing.warm_up)
        self._seconds = seconds
        self._changed = threading.Condition()
        self._submitted: Revision | None = None
        self._parsed = 0  # the latest version whose data are known
        self._checked = 0  # the latest version that has been checked
        self._edits = 0  # number of edits in progress
        self._closed = False
        self._thread = threading.Thread(target=self._run, name="checker", daemon=True)
        self._thread.start()

    def submit(self, revision: Revision) -> None:
        """Submit a revision in place of all earlier ones."""
        with self._changed:
            self._submitted = revision
            self._changed.notify_all()

    def wait(self, version: int, seconds: float, for_data: float = 0.0) -> None:
        """Wait until a version has been checked, at most so long, and perhaps longer for its data alone."""
        with self._changed:
            self._changed.wait_for(lambda: self._closed or self._parsed >= version, for_data)
            self._changed.wait_for(lambda: self._closed or self._checked >= version, seconds)

    def apply_edits(self, document: Document, edits: Sequence[Edit]) -> Document:
        """Return the document after some edits; raises InputError if one of them is invalid."""
        if all(edit.get("op") == "text" for edit in edits):
            return document.apply(edits)  # nothing is parsed for these
        with self._changed:
            self._edits += 1
        try:
            changed: Document = self._caller.call(parsing.apply_edits, document, edits, seconds=EDIT_LIMIT)
            return changed
        except CallFailure as error:
            hint = "edit the text instead, or undo the last step"
            issue = Issue(
                "the edit",
                Message("{file} that cannot be read ({error})", file="a case", error=str(error)),
                "one that can be",
                hint,
            )
            raise InputError([issue]) from None
        finally:
            with self._changed:
                self._edits -= 1
                self._changed.notify_all()

    def compare(self, base: str | None, mine: str, theirs: str) -> Comparison:
        """Return how the text of a file differs from mine, unmerged if that takes too long."""
        with self._changed:
            self._edits += 1
        try:
            compared: Comparison = self._caller.call(merge.compare, base, mine, theirs, seconds=EDIT_LIMIT)
            return compared
        except CallFailure as error:
            return Comparison([f"({error})"], None)
        finally:
            with self._changed:
                self._edits -= 1
                self._changed.notify_all()

    def close(self) -> None:
        """End the thread and the process."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()
        self._caller.close()
        self._thread.join()

    def _run(self) -> None:
        """Check submitted revisions until the checker is closed."""
        limits: dict[str, Any] = {
            "seconds": self._seconds,
            "needed": lambda: self._submitted is None and not self._edits,
        }
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._closed or (self._submitted is not None and not self._edits))
                if self._closed or self._submitted is None:
                    return
                revision, self._submitted = self._submitted, None
            try:
                revision = replace(revision, data=self._caller.call(parsing.parse, revision.document, **limits))
                self._on_found(revision)
                self._mark_done(parsed=revision.version)
                result = self._caller.call(parsing.check, revision.document, revision.folder, **limits)
            except Interrupted:
                with self._changed:
                    self._submitted = self._submitted or revision
                continue
            except Exception as error:
                result = _explain_failure(error)
            self._on_found(replace(revision, result=result))
            self._mark_done(parsed=revision.version, checked=revision.version)

    def _mark_done(self, parsed: int, checked: int = 0) -> None:
        """Let threads continue that wait for a version."""
        with self._changed:
            self._parsed, self._checked = parsed, max(checked, self._checked)
            self._changed.notify_all()


def _explain_failure(error: Exception) -> CheckResult:
    """Return the result for a text that could not be checked."""
    hint = "undo the last step, or look for very large counts or lengths"
    if isinstance(error, TimeLimit):
        issue = Issue(
            "the description",
            Message("{file} that takes {time} to read", file="a case", time=str(error)),
            "one that can be read",
            hint,
        )
    elif isinstance(error, MemoryLimit):
        memory = Message("{file} that takes too much memory to read ({error})", file="a case", error=str(error))
        issue = Issue("the description", memory, "a smaller one", hint)
    else:
        unreadable = Message(
            "{file} that cannot be read ({error})", file="a case", error=Name(f"{type(error).__name__}: {error}")
        )
        issue = Issue("the description", unreadable, "one that can be read", "undo the last step")
    return CheckResult("", (issue,), diagnostics.issues_to_json([issue]), None)
