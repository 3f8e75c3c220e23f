"""Reads the newest document in a process of its own, so that no text can keep the server from answering."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.workbench.checking import parsing
from groundslab.workbench.checking.bounded_process import (
    BoundedProcess,
    Caller,
    Interrupted,
    MemoryLimit,
    ProcessEnded,
    TimeLimit,
)
from groundslab.workbench.checking.parsing import Reading
from groundslab.workbench.editing import diagnostics
from groundslab.workbench.editing.document import Document, Edit

#: A text that takes longer to be read or checked is refused [s].
READING = 20.0
#: An edit that takes longer is refused; less than the time after which a page gives the server up [s].
EDITING = 10.0

OnData = Callable[[int, dict[str, Any] | None], None]
OnRead = Callable[[int, Reading], None]


class Reader:
    """Reads what is wanted, newest first; edits go before.

    `on_data` gets a version's data as soon as they are known, `on_read` what it means, both on a thread of the reader.
    """

    def __init__(
        self, on_data: OnData, on_read: OnRead, caller: Caller | None = None, seconds: float = READING
    ) -> None:
        self._on_data = on_data
        self._on_read = on_read
        self._caller = caller or BoundedProcess(parsing.prepare)
        self._seconds = seconds
        self._changed = threading.Condition()
        self._wanted: tuple[int, Document] | None = None
        self._parsed = 0  # the latest version whose data are known
        self._read = 0  # the latest version that has been read
        self._edits = 0  # so many are under way
        self._closed = False
        self._thread = threading.Thread(target=self._serve, name="reader", daemon=True)
        self._thread.start()

    def want(self, version: int, document: Document) -> None:
        """Have a document read in place of all before."""
        with self._changed:
            self._wanted = version, document
            self._changed.notify_all()

    def wait(self, version: int, seconds: float, for_data: float = 0.0) -> None:
        """Wait until a version or a later one has been read, at most so long; for its data alone perhaps longer."""
        with self._changed:
            self._changed.wait_for(lambda: self._closed or self._parsed >= version, for_data)
            self._changed.wait_for(lambda: self._closed or self._read >= version, seconds)

    def edited(self, document: Document, edits: Sequence[Edit]) -> Document:
        """Return the document after some edits; raises InputError if one of them cannot be."""
        if all(edit.get("op") == "text" for edit in edits):
            return document.edited(edits)  # nothing is read for these
        with self._changed:
            self._edits += 1
        try:
            changed: Document = self._caller.call(parsing.edited, document, edits, seconds=EDITING)
            return changed
        except (TimeLimit, MemoryLimit, ProcessEnded, Interrupted) as error:
            hint = "edit the text instead, or undo the last step"
            issue = Issue("the edit", f"a case that cannot be read ({error})", "one that can be", hint)
            raise InputError([issue]) from None
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

    def _serve(self) -> None:
        """Read what is wanted until the reader is closed."""
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._closed or (self._wanted is not None and not self._edits))
                if self._closed or self._wanted is None:
                    return
                (version, document), self._wanted = self._wanted, None
            try:
                self._on_data(version, self._caller.call(parsing.parse, document, **self._limits()))
                self._note(parsed=version)
                found = self._caller.call(parsing.understand, document, **self._limits())
            except Interrupted:
                with self._changed:
                    self._wanted = self._wanted or (version, document)
                continue
            except Exception as error:
                found = _unread(error)
            self._on_read(version, found)
            self._note(parsed=version, read=version)

    def _note(self, parsed: int, read: int = 0) -> None:
        """Let those go on who wait for a version."""
        with self._changed:
            self._parsed, self._read = parsed, max(read, self._read)
            self._changed.notify_all()

    def _limits(self) -> dict[str, Any]:
        return {"seconds": self._seconds, "wanted": lambda: self._wanted is None and not self._edits}


def _unread(error: Exception) -> Reading:
    """Return what is said of a text that could not be read."""
    hint = "undo the last step, or look for very large counts or lengths"
    if isinstance(error, TimeLimit):
        found = Issue("the description", f"a case that takes {error} to read", "one that can be read", hint)
    elif isinstance(error, MemoryLimit):
        found = Issue("the description", f"a case that takes too much memory to read ({error})", "a smaller one", hint)
    else:
        given = f"a case that cannot be read ({type(error).__name__}: {error})"
        found = Issue("the description", given, "one that can be read", "undo the last step")
    return Reading("", (found,), diagnostics.issues_to_json([found]), None)
