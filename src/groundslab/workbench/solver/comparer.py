"""Compares models of the ground of a case, or alternatives to its design, in a process of its own.

So neither results that the solver keeps nor runs of edits wait for it, and a comparison is cancelled at once.
"""

from __future__ import annotations

import threading
import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal

from groundslab.errors import GroundslabError
from groundslab.messages import Label, Message, Name
from groundslab.workbench.child_process import ChildProcess, explain_error, set_up_child
from groundslab.workbench.solver.runs import Latest
from groundslab.workbench.solver.schedule import Notify

if TYPE_CHECKING:
    from groundslab.analysis.ground_comparison.comparison import GroundComparison
    from groundslab.study.alternatives.comparison import DesignComparison

#: Number of grounds that are compared.
GROUNDS = 5

#: What is compared, which is the name of its table.
Kind = Literal["comparison", "alternatives"]
#: Told with words and a share before each part of a comparison.
OnBegin = Callable[[str, float], None]


@dataclass(frozen=True, slots=True)
class Compared:
    """A comparison: its table as data for the page, and the cases that can be taken from it by their names."""

    table: dict[str, Any]
    cases: dict[str, str] = field(default_factory=dict)


#: Compares what a text describes; the folder is that of the case.
Task = Callable[[str, Path, OnBegin], Compared]


class Comparer:
    """Makes one comparison at a time; notifies of "comparing", "compared" and "not compared"."""

    def __init__(self, notify: Notify, tasks: Mapping[Kind, Task] | None = None) -> None:
        self._notify = notify
        self._tasks = tasks or TASKS
        self._lock = threading.RLock()
        self._process: ChildProcess | None = None
        self._run = 0
        self._kind: Kind = "comparison"
        self._compared: dict[Kind, Latest[Compared]] = {kind: Latest() for kind in TASKS}

    def start(self, kind: Kind, run: int, text: str, folder: Path) -> None:
        """Compare what a run's text describes, in place of a comparison that is on its way."""
        with self._lock:
            self.cancel()
            self._kind, self._run = kind, run
            self._process = ChildProcess("groundslab comparison", main, self._tasks[kind], text, folder)
            self._tell("comparing", text="", share=0.0)
            threading.Thread(target=self._receive, args=(self._process,), name="comparison", daemon=True).start()

    def cancel(self) -> None:
        """Stop the comparison, if there is one."""
        with self._lock:
            process, self._process = self._process, None
            if process is not None:
                process.kill()
                self._tell("not compared", message="")

    def get(self, kind: Kind, run: int) -> Compared | None:
        """Return the comparison of a run, None if there is none."""
        with self._lock:
            return self._compared[kind].get(run)

    def list_kinds(self, run: int) -> list[Kind]:
        """Return what has been compared of a run."""
        with self._lock:
            return [kind for kind, runs in self._compared.items() if run in runs]

    def _tell(self, name: str, **about: Any) -> None:
        """Notify of the present comparison."""
        self._notify(name, {"kind": self._kind, "run": self._run, **about})

    def _receive(self, process: ChildProcess) -> None:
        """Pass on the messages of a process until it ends."""
        word = "progress"
        while word == "progress":
            try:
                word, *rest = process.pipe.recv()
            except (EOFError, OSError):
                word, rest = "failed", [Label("the comparison ended unexpectedly")]
            with self._lock:
                if process is not self._process:
                    break
                self._handle(word, rest)
        process.close()

    def _handle(self, word: str, rest: list[Any]) -> None:
        """Handle a message of the present process."""
        if word == "progress":
            text, share = rest
            self._tell("comparing", text=text, share=share)
            return
        self._process = None
        if word == "compared":
            self._compared[self._kind].add(self._run, rest[0])
            self._tell("compared")
        else:
            self._tell("not compared", message=rest[0])


def compare_grounds(text: str, folder: Path, on_begin: OnBegin) -> Compared:
    """Return the comparison of a case's grounds, as the report lays it out; raises GroundslabError."""
    from groundslab.analysis.ground_comparison import comparison
    from groundslab.case import casefile

    begun = 0

    def tell(kind: str) -> None:
        nonlocal begun
        words = Message("Ground {number} of {count}: {kind}", number=begun + 1, count=GROUNDS, kind=kind)
        on_begin(words, begun / GROUNDS)
        begun += 1

    model = casefile.from_table(casefile.tables(text), folder)
    return Compared(grounds_to_json(comparison.compare_grounds(model, on_begin=tell)))


def grounds_to_json(comparison: GroundComparison) -> dict[str, Any]:
    """Return a comparison of grounds as a table for the page."""
    from groundslab.views.report.ground_models import layout_rows
    from groundslab.workbench.solver.tables import table_to_json

    return table_to_json("comparison", layout_rows(comparison))


def compare_designs(text: str, folder: Path, on_begin: OnBegin) -> Compared:
    """Return the comparison of alternatives to a case's design, and their cases; raises GroundslabError."""
    from groundslab.study.alternatives.comparison import compare_texts

    begun = 0

    def tell(name: str, left: int) -> None:
        nonlocal begun
        count = begun + 1 + left
        words = Message("Alternative {number} of {count}: {name}", number=begun + 1, count=count, name=Name(name))
        on_begin(words, begun / count)
        begun += 1

    comparison = compare_texts(text, folder, tell)
    return Compared(designs_to_json(comparison), {design.name: design.text for design in comparison.alternatives})


def designs_to_json(comparison: DesignComparison) -> dict[str, Any]:
    """Return a comparison of designs as a table for the page."""
    from groundslab.study.alternatives.rows import layout_rows
    from groundslab.workbench.solver.tables import table_to_json

    return table_to_json("alternatives", layout_rows(comparison))


TASKS: Mapping[Kind, Task] = MappingProxyType({"comparison": compare_grounds, "alternatives": compare_designs})


def main(pipe: Connection, task: Task, text: str, folder: Path) -> None:
    """Compare once and send ("progress", text, share), then ("compared", comparison) or ("failed", message)."""
    set_up_child()
    try:
        pipe.send(("compared", task(text, folder, lambda words, share: pipe.send(("progress", words, share)))))
    except GroundslabError as error:
        pipe.send(("failed", str(error)))
    except Exception as error:
        traceback.print_exc()
        pipe.send(("failed", explain_error(error)))
