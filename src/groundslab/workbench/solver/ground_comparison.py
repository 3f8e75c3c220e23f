"""Compares models of the ground of a case in a process of its own.

So neither results that the solver keeps nor runs of edits wait for it, and a comparison is cancelled at once.
"""

from __future__ import annotations

import json
import threading
import traceback
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import TYPE_CHECKING, Any

from groundslab.errors import GroundslabError
from groundslab.workbench.child_process import ChildProcess, set_up_child
from groundslab.workbench.solver.runs import Latest
from groundslab.workbench.solver.schedule import Notify

if TYPE_CHECKING:
    from groundslab.analysis.ground_comparison.comparison import GroundComparison

#: Number of grounds that are compared.
GROUNDS = 5

#: Compares the grounds of a text, calling a function with each kind before it is solved; returns JSON.
Task = Callable[[str, Callable[[str], None]], bytes]


class GroundComparer:
    """Compares grounds for one run at a time; notifies of "comparing", "compared" and "not compared"."""

    def __init__(self, notify: Notify, task: Task | None = None) -> None:
        self._notify = notify
        self._task = task or compare
        self._lock = threading.RLock()
        self._process: ChildProcess | None = None
        self._run = 0
        self._found: Latest[bytes] = Latest()

    def start(self, run: int, text: str) -> None:
        """Compare the grounds of a run's text, in place of a comparison that is on its way."""
        with self._lock:
            self.cancel()
            self._run, self._process = run, ChildProcess("groundslab grounds", main, self._task, text)
            self._notify("comparing", {"run": run, "text": "begins", "share": 0.0})
            threading.Thread(target=self._receive, args=(run, self._process), name="grounds", daemon=True).start()

    def cancel(self) -> None:
        """Stop the comparison, if there is one."""
        with self._lock:
            process, self._process = self._process, None
            if process is not None:
                process.kill()
                self._notify("not compared", {"run": self._run, "message": ""})

    def get(self, run: int) -> bytes | None:
        """Return the comparison of a run as JSON, None if there is none."""
        with self._lock:
            return self._found.get(run)

    def _receive(self, run: int, process: ChildProcess) -> None:
        """Pass on the messages of a process until it ends."""
        kind = "progress"
        while kind == "progress":
            try:
                kind, *rest = process.pipe.recv()
            except (EOFError, OSError):
                kind, rest = "failed", ["the comparison ended unexpectedly"]
            with self._lock:
                if process is not self._process:
                    break
                self._handle(run, kind, rest)
        process.close()

    def _handle(self, run: int, kind: str, rest: list[Any]) -> None:
        """Handle a message of the present process."""
        if kind == "progress":
            text, share = rest
            self._notify("comparing", {"run": run, "text": text, "share": share})
            return
        self._process = None
        if kind == "compared":
            self._found.add(run, rest[0])
            self._notify("compared", {"run": run})
        else:
            self._notify("not compared", {"run": run, "message": rest[0]})


def compare(text: str, on_begin: Callable[[str], None]) -> bytes:
    """Return the comparison of a case's grounds as JSON, as the report lays it out; raises GroundslabError."""
    from groundslab.analysis.ground_comparison.comparison import compare_grounds
    from groundslab.case import casefile

    return to_json(compare_grounds(casefile.loads(text), on_begin=on_begin))


def to_json(comparison: GroundComparison) -> bytes:
    """Return a comparison as a table for the page."""
    from groundslab.views.report.ground_models import layout_rows
    from groundslab.workbench.solver.tables import table_to_json

    return json.dumps(table_to_json("comparison", layout_rows(comparison))).encode()


def main(pipe: Connection, task: Task, text: str) -> None:
    """Compare once and send ("progress", text, share), then ("compared", content) or ("failed", message)."""
    set_up_child()
    begun = 0

    def on_begin(kind: str) -> None:
        nonlocal begun
        pipe.send(("progress", f"{begun + 1} of {GROUNDS}, {kind}", begun / GROUNDS))
        begun += 1

    try:
        pipe.send(("compared", task(text, on_begin)))
    except GroundslabError as error:
        pipe.send(("failed", str(error)))
    except Exception as error:
        traceback.print_exc()
        pipe.send(("failed", f"an error in groundslab itself: {type(error).__name__}: {error}"))
