"""What a solver's process does in tests: it takes orders from the text instead of solving it.

Each such process imports this module: what takes long to import is imported where it is used.
"""

from __future__ import annotations

import mmap
import os
import signal
import sys
import threading
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab.errors import GroundslabError, InputError, Issue
from groundslab.workbench.solver.answer import Answer
from groundslab.workbench.solver.process import Progress, Solved

if TYPE_CHECKING:
    from groundslab.views.report.table_layout import TableLayout
    from groundslab.workbench.checking.parsing import CheckResult
    from groundslab.workbench.editing.document import Document


def obey(text: str, progress: Progress) -> tuple[Answer, bytes, Solved]:
    """Do what the text's last order says, else its first word; a file ends waiting when it is there."""
    word, _, file = text.rpartition("order: ")[2].partition(" ")
    if word == "wait":
        while not Path(file).exists():
            progress("waits", None)
            time.sleep(0.005)
    elif word == "preview":
        progress.show("of " + (progress.shown or "nothing"), {"name": progress.shown}, b"coarse")
        while not Path(file).exists():
            progress("waits", None)
            time.sleep(0.005)
    elif word == "provisional":
        words = ("first", "second")
        for number, name in enumerate(words):
            tables = {"words": partial(_table, text, name)}
            answer = Answer(0.0, {}, {"text": name}, ("words",), f"mesh {number + 1}")
            progress.keep(answer, name.encode(), Solved(text, None, tables, text))
            while not Path(f"{file}.{name}").exists():
                progress("waits", None)
                time.sleep(0.005)
    elif word in ("stuck", "keeping"):
        if word == "keeping":
            tables = {"words": partial(_table, text, "kept")}
            progress.keep(
                Answer(0.0, {}, {"text": word}, ("words",), "mesh 1"), b"scene", Solved(text, None, tables, text)
            )
        progress("sticks", None)
        Path(f"{file}.stuck").touch()  # from now on it does not listen
        while not Path(file).exists():
            time.sleep(0.005)
    elif word == "die":
        os.kill(os.getpid(), signal.SIGKILL if hasattr(signal, "SIGKILL") else signal.SIGTERM)
    elif word == "leave":
        os._exit(3)
    elif word == "issue":
        raise InputError([Issue("mesh.size", '"1 mm"', "a larger size")])
    elif word == "refuse":
        raise GroundslabError("no")
    elif word == "memory":
        raise MemoryError
    elif word == "bug":
        raise ZeroDivisionError("by zero")
    progress("half", 0.5)
    tables = {"words": partial(_table, text, word)}
    return Answer(0.0, {}, {"text": text}, tuple(tables)), text.encode() * 1000, Solved(text, None, tables, text)


def _table(title: str, word: str) -> TableLayout:
    """Return a table of one word."""
    from groundslab.views.report.table_layout import Cell, TableLayout, headers

    return TableLayout(title, headers("word"), ((Cell(word),),))


def prepare_for_ever(progress: Progress) -> None:
    """Go on until there is something to do."""
    while True:
        progress("prepares", None)
        time.sleep(0.005)


class Broken:
    """Ends the process that is handed it, before that has begun."""

    def __call__(self, progress: Progress) -> None:
        """Never come to this."""

    def __reduce__(self) -> tuple[object, ...]:
        """Be an exit where it is unpickled."""
        return os._exit, (4,)


class Inline:
    """Calls functions at once in the process of the tests, where they can be replaced."""

    def call(self, function: Callable[..., Any], *arguments: Any, **_: Any) -> Any:
        """Return what the function returns."""
        return function(*arguments)

    def close(self) -> None:
        """Do nothing."""


def slow(file: str) -> str:
    """Return when a file is there."""
    while not Path(file).exists():
        time.sleep(0.005)
    return file


def grow() -> int:
    """Take memory without end."""
    kept = []
    while True:
        kept.append(bytes(10_000_000))


def large() -> bytes:
    """Return a large answer."""
    return bytes(101_000_000)


def end() -> None:
    """End the process."""
    os._exit(3)


def fill_and_crash(filled: str, seen: str) -> None:
    """Take nearly all memory, wait until that is seen, and end as native code does that gets no more."""
    import resource

    most, _ = resource.getrlimit(resource.RLIMIT_AS)
    used = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0]) * resource.getpagesize()
    with mmap.mmap(-1, int(0.97 * (most - used))):
        Path(filled).touch()
        slow(seen)
        crash()


def fail_in_native_code(share: float) -> None:
    """Take a share of the memory that is left, and raise what an extension leaves that fails without saying why."""
    import resource

    most, _ = resource.getrlimit(resource.RLIMIT_AS)
    used = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0]) * resource.getpagesize()
    with mmap.mmap(-1, int(share * (most - used))):
        raise SystemError("error return without exception set")


def crash() -> None:
    """End as native code does that fails."""
    os.kill(os.getpid(), signal.SIGSEGV)


def has_numpy() -> bool:
    """Return whether NumPy was loaded before this was called."""
    return "numpy" in sys.modules


def unusual() -> None:
    """Raise an error that cannot be pickled."""

    class Local(Exception):
        pass

    raise Local("local")


def check_slowly(document: Document, folder: Path | None = None) -> CheckResult:
    """Return what a text means; one with "# slow" takes for ever."""
    from groundslab.workbench.checking import parsing

    while "# slow" in document.text:
        time.sleep(0.005)
    return parsing.check(document, folder)


def wait_forever(tell: Callable[[str], None]) -> None:
    """Tell the number of this process, and then wait for what never comes: a task of an assistant."""
    tell(str(os.getpid()))
    threading.Event().wait()


def end_at_once(_: Callable[[str], None]) -> None:
    """End this process: a task of an assistant."""
    os._exit(3)


def print_and_fail(_: Callable[[str], None]) -> None:
    """Print to standard output, which is not a task's to use, and fail: a task of an assistant."""
    print("noise", flush=True)
    raise ZeroDivisionError("by zero")
