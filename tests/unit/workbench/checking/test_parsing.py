"""Texts are read in a process of their own: whatever they hold, the server answers."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.workbench.checking import parsing
from groundslab.workbench.checking import thread as readers
from groundslab.workbench.checking.bounded_process import (
    BoundedProcess,
    Interrupted,
    MemoryLimit,
    ProcessEnded,
    TimeLimit,
)
from groundslab.workbench.checking.parsing import Reading
from groundslab.workbench.checking.thread import Reader
from groundslab.workbench.editing.document import Document
from groundslab.workbench.events import Hub
from groundslab.workbench.server.session import Session
from groundslab.workbench.solver.thread import Solver
from helpers import workers

pytestmark = pytest.mark.slow

PATIENCE = 60.0


@pytest.fixture
def process() -> Iterator[BoundedProcess]:
    """Return a process with little memory."""
    made = BoundedProcess(memory=1_000_000_000)
    yield made
    made.close()


class Readings:
    """A reader and what it has found."""

    def __init__(self, seconds: float = readers.READING) -> None:
        self.found: dict[int, Reading] = {}
        self.reader = Reader(lambda *_: None, self.found.__setitem__, None, seconds)

    def read(self, version: int, text: str) -> Reading:
        """Return what a text means."""
        self.reader.want(version, Document(text))
        self.reader.wait(version, PATIENCE)
        return self.found[version]


@pytest.fixture
def readings() -> Iterator[Readings]:
    """Return a reader in a process of its own."""
    made = Readings()
    yield made
    made.reader.close()


def test_a_call_returns_or_raises_what_the_function_does(process: BoundedProcess) -> None:
    """Values and errors come back; an error that cannot be pickled comes as its words."""
    assert process.call(max, 1, 2, seconds=PATIENCE) == 2
    with pytest.raises(InputError, match=r"mesh\.size"):
        process.call(workers.obey, "fault", print, seconds=PATIENCE)
    with pytest.raises(RuntimeError, match="local"):
        process.call(workers.unusual, seconds=PATIENCE)


def test_a_call_has_limits(process: BoundedProcess, tmp_path: Path) -> None:
    """Too long, too much memory, too large an answer, an end: each is told, and the next call has a new process."""
    with pytest.raises(TimeLimit, match=r"longer than 0\.1 s"):
        process.call(workers.slow, str(tmp_path / "never"), seconds=0.1)
    assert process.call(max, 1, 2, seconds=PATIENCE) == 2
    with pytest.raises(ProcessEnded):
        process.call(workers.end, seconds=PATIENCE)
    with pytest.raises(MemoryLimit, match="100 MB"):
        process.call(workers.large, seconds=PATIENCE)
    assert process.call(max, 1, 2, seconds=PATIENCE) == 2


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory is limited on Linux only")
def test_a_call_has_a_limit_of_memory(process: BoundedProcess) -> None:
    """A function that takes memory without end is stopped at the limit, and the next call has a new process."""
    with pytest.raises(MemoryLimit, match="1 GB"):
        process.call(workers.grow, seconds=PATIENCE)
    assert process.call(max, 1, 2, seconds=PATIENCE) == 2


def test_a_call_that_is_not_wanted_is_ended(process: BoundedProcess, tmp_path: Path) -> None:
    """It is interrupted long before its limit; closing ends what is under way."""
    with pytest.raises(Interrupted):
        process.call(workers.slow, str(tmp_path / "never"), seconds=PATIENCE, wanted=lambda: False)
    begun, ended = threading.Event(), threading.Event()

    def wanted() -> bool:
        begun.set()
        return True

    def call() -> None:
        with pytest.raises(ProcessEnded):
            process.call(workers.slow, str(tmp_path / "never"), seconds=PATIENCE, wanted=wanted)
        ended.set()

    thread = threading.Thread(target=call)
    thread.start()
    assert begun.wait(PATIENCE)
    process.close()
    thread.join(PATIENCE)
    assert ended.is_set()
    with pytest.raises(ProcessEnded, match="the server ends"):
        process.call(max, 1, 2, seconds=PATIENCE)


def test_what_a_text_means(readings: Readings) -> None:
    """The plan of one that describes a model; equal meaning for equal models; faults with lines for others."""
    first = readings.read(1, casefile.starter())
    assert (first.issues, first.listed) == ((), [])
    assert first.plan is not None
    assert readings.read(2, casefile.starter() + "# a comment\n").meaning == first.meaning != ""
    changed = casefile.starter().replace('thickness = "250 mm"', 'thickness = "300 mm"')
    assert readings.read(3, changed).meaning not in ("", first.meaning)
    wrong = readings.read(4, casefile.starter().replace('"250 mm"', '"250"'))
    assert (wrong.meaning, wrong.plan) == ("", None)
    assert wrong.listed[0]["path"] == ["plate", "thickness"]
    assert wrong.listed[0]["line"] == 1 + casefile.starter().split("\n").index('thickness = "250 mm"')


def test_edits_go_before_a_text_that_takes_long(readings: Readings, monkeypatch: pytest.MonkeyPatch) -> None:
    """An edit is done while a text is being read for ever, and the text after it is read."""
    monkeypatch.setattr(parsing, "understand", workers.read_slowly)
    slow = Document(casefile.starter() + "# slow\n")
    readings.reader.want(1, slow)
    edit = {"op": "set", "path": ["plate", "nu"], "value": 0.3}
    assert "nu = 0.3\n" in readings.reader.edited(slow, [edit]).text
    assert readings.read(2, casefile.starter()).plan is not None
    assert list(readings.found) == [2]


def test_a_text_that_takes_too_long_or_too_much(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is refused with words that say why; the next one is read by a new process."""
    readings = Readings(seconds=0.3)
    try:
        with monkeypatch.context() as patch:
            patch.setattr(parsing, "understand", workers.read_slowly)
            found = readings.read(1, casefile.starter() + "# slow\n")
            assert "longer than 0.3 s" in found.issues[0].found
            assert (found.meaning, found.plan, found.listed[0]["where"]) == ("", None, "the description")
        assert readings.read(2, casefile.starter()).plan is not None
    finally:
        readings.reader.close()
    assert "more than 2 GB" in readers._unread(MemoryLimit("more than 2 GB")).issues[0].found
    assert "ProcessEnded" in readers._unread(ProcessEnded("it ended")).issues[0].found


def test_a_text_that_takes_long_holds_nobody_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """While it is read the server answers, edits and undoes; what stood before is read again at once."""
    monkeypatch.setattr(parsing, "understand", workers.read_slowly)
    hub = Hub()
    session = Session(hub, Solver(hub.tell, workers.obey, None), tmp_path, "http://127.0.0.1")
    try:
        session._reader.wait(1, PATIENCE)
        assert session.state()["plan"] is not None
        start = time.monotonic()
        text = casefile.starter() + "# slow\n"
        state = session.edit([{"op": "text", "value": text}], "Text", 1)
        assert (state["text"], state["checking"], state["faults"]) == (text, True, [])
        assert state["plan"] is not None, "the plan of before is shown meanwhile"
        with pytest.raises(InputError, match="still being checked"):
            session.solve()
        session.listing(None)
        assert session.edit([{"op": "set", "path": ["title"], "value": "new"}], "Title", 2)["checking"] is True
        session.undo()
        session.undo()
        assert time.monotonic() - start < readers.READING / 2
        session._reader.wait(5, PATIENCE)
        state = session.state()
        assert (state["version"], state["checking"], state["text"]) == (5, False, casefile.starter())
        assert state["data"]["plate"]["thickness"] == "250 mm"
    finally:
        session.close()
