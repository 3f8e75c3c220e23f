"""Texts are read in a process of their own: whatever they hold, the server answers."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("filelock")
from groundslab.case import casefile
from groundslab.errors import InputError
from groundslab.workbench.checking import parsing
from groundslab.workbench.checking import thread as checkers
from groundslab.workbench.checking.bounded_process import (
    BoundedProcess,
    Interrupted,
    MemoryLimit,
    ProcessEnded,
    TimeLimit,
)
from groundslab.workbench.checking.parsing import CheckResult
from groundslab.workbench.checking.revision import Revision
from groundslab.workbench.checking.thread import Checker
from groundslab.workbench.editing.document import Document
from groundslab.workbench.events import Hub
from groundslab.workbench.server.session import Session
from groundslab.workbench.solver.thread import Solver
from helpers import workers

pytestmark = pytest.mark.slow

PATIENCE = 120.0


@pytest.fixture
def process() -> Iterator[BoundedProcess]:
    """Return a process with little memory."""
    made = BoundedProcess(memory=1_000_000_000)
    yield made
    made.close()


class Checks:
    """A checker and its results."""

    def __init__(self, seconds: float = checkers.CHECK_LIMIT) -> None:
        self.found: dict[int, CheckResult] = {}
        self.checker = Checker(self._keep, None, seconds)

    def _keep(self, found: Revision) -> None:
        if found.result is not None:
            self.found[found.version] = found.result

    def check(self, version: int, text: str) -> CheckResult:
        """Return what a text means."""
        self.checker.submit(Revision(version, Document(text)))
        self.checker.wait(version, PATIENCE)
        return self.found[version]


@pytest.fixture
def checks() -> Iterator[Checks]:
    """Return a checker in a process of its own."""
    made = Checks()
    yield made
    made.checker.close()


def test_a_call_returns_or_raises_what_the_function_does(process: BoundedProcess) -> None:
    """Values and errors come back; an error that cannot be pickled comes as its words."""
    assert process.call(max, 1, 2, seconds=PATIENCE) == 2
    with pytest.raises(InputError, match=r"mesh\.size"):
        process.call(workers.obey, "issue", print, seconds=PATIENCE)
    with pytest.raises(RuntimeError, match="local"):
        process.call(workers.unusual, seconds=PATIENCE)


def test_a_call_has_limits(process: BoundedProcess, tmp_path: Path) -> None:
    """Too long, too much memory, too large an answer, an end: each is an error, and the next call has a new process."""
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


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory is limited on Linux only")
def test_native_code_that_ends_the_process(process: BoundedProcess, tmp_path: Path) -> None:
    """A process that dies with its memory used up had too little; another one is told with how it ended."""
    assert process.call(workers.has_numpy, seconds=PATIENCE)
    with pytest.raises(ProcessEnded, match="SIGSEGV, perhaps for lack of memory"):
        process.call(workers.crash, seconds=PATIENCE)
    with pytest.raises(ProcessEnded, match="exit code 3"):
        process.call(workers.end, seconds=PATIENCE)
    filled, seen = tmp_path / "filled", tmp_path / "seen"

    def needed() -> bool:
        # by the time that it is asked again the process was looked at
        if (tmp_path / "once").exists():
            seen.touch()
        if filled.exists():
            (tmp_path / "once").touch()
        return True

    with pytest.raises(MemoryLimit, match=r"more than 1 GB \(SIGSEGV\)"):
        process.call(workers.fill_and_crash, str(filled), str(seen), seconds=PATIENCE, needed=needed)
    assert process.call(max, 1, 2, seconds=PATIENCE) == 2


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory is limited on Linux only")
def test_native_code_that_fails_without_saying_why(process: BoundedProcess) -> None:
    """With its memory used up the process had too little; with little used it is a defect, which is told as it is."""
    with pytest.raises(SystemError, match="without exception set"):
        process.call(workers.fail_in_native_code, 0.1, seconds=PATIENCE)
    with pytest.raises(MemoryLimit, match="more than 1 GB"):
        process.call(workers.fail_in_native_code, 0.97, seconds=PATIENCE)


def test_a_call_that_is_not_wanted_is_ended(process: BoundedProcess, tmp_path: Path) -> None:
    """It is interrupted long before its limit; closing ends what is under way."""
    with pytest.raises(Interrupted):
        process.call(workers.slow, str(tmp_path / "never"), seconds=PATIENCE, needed=lambda: False)
    begun, ended = threading.Event(), threading.Event()

    def needed() -> bool:
        begun.set()
        return True

    def call() -> None:
        with pytest.raises(ProcessEnded):
            process.call(workers.slow, str(tmp_path / "never"), seconds=PATIENCE, needed=needed)
        ended.set()

    thread = threading.Thread(target=call)
    thread.start()
    assert begun.wait(PATIENCE)
    process.close()
    thread.join(PATIENCE)
    assert ended.is_set()
    with pytest.raises(ProcessEnded, match="the server ends"):
        process.call(max, 1, 2, seconds=PATIENCE)


def test_what_a_text_means(checks: Checks) -> None:
    """The plan of one that describes a model; equal fingerprints for equal models; issues with lines for others."""
    first = checks.check(1, casefile.starter())
    assert (first.issues, first.issues_json) == ((), [])
    assert first.plan is not None
    assert checks.check(2, casefile.starter() + "# a comment\n").fingerprint == first.fingerprint != ""
    changed = casefile.starter().replace('thickness = "250 mm"', 'thickness = "300 mm"')
    assert checks.check(3, changed).fingerprint not in ("", first.fingerprint)
    wrong = checks.check(4, casefile.starter().replace('"250 mm"', '"250"'))
    assert (wrong.fingerprint, wrong.plan) == ("", None)
    assert wrong.issues_json[0]["path"] == ["plate", "thickness"]
    assert wrong.issues_json[0]["line"] == 1 + casefile.starter().split("\n").index('thickness = "250 mm"')


def test_remarks_on_a_case_without_issues(checks: Checks) -> None:
    """A load that acts in no combination is told with its place and line, and the case can be solved all the same."""
    cases = '[[cases]]\nname = "G"\n[[cases]]\nname = "Q"\naction = "variable"\n'
    loads = '[[loads]]\nkind = "uniform"\nq = "5 kPa"\ncase = "Q"\n'
    used = '[[combinations]]\nname = "U"\nfactors = {Q = 1.5}\n'
    text = casefile.starter().replace('# case = "permanent"', 'case = "G"', 1) + cases + loads + used
    found = checks.check(1, text)
    assert found.fingerprint
    (remark,) = found.remarks_json
    line = 1 + text.split("\n").index('name = "G"') - 1
    assert remark == {
        "location": "cases[1]",
        "path": ["cases", 0],
        "words": 'case "G" acts in no combination: its load is left out (150 kN)',
        "doubtful": True,
        "line": line,
    }
    assert checks.check(2, casefile.starter()).remarks_json == []


def test_edits_go_before_a_text_that_takes_long(checks: Checks, monkeypatch: pytest.MonkeyPatch) -> None:
    """An edit is done while a text is being read for ever, and the text after it is read."""
    monkeypatch.setattr(parsing, "check", workers.check_slowly)
    slow = Document(casefile.starter() + "# slow\n")
    checks.checker.submit(Revision(1, slow))
    edit = {"op": "set", "path": ["plate", "nu"], "value": 0.3}
    assert "nu = 0.3\n" in checks.checker.apply_edits(slow, [edit]).text
    assert checks.check(2, casefile.starter()).plan is not None
    assert list(checks.found) == [2]


def test_a_text_that_takes_too_long_or_too_much(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is refused with words that say why; the next one is read by a new process."""
    checks = Checks(seconds=0.3)
    try:
        with monkeypatch.context() as patch:
            patch.setattr(parsing, "check", workers.check_slowly)
            found = checks.check(1, casefile.starter() + "# slow\n")
            assert "longer than 0.3 s" in found.issues[0].found
            assert (found.fingerprint, found.plan, found.issues_json[0]["location"]) == ("", None, "the description")
        assert checks.check(2, casefile.starter()).plan is not None
    finally:
        checks.checker.close()
    assert "more than 2 GB" in checkers._explain_failure(MemoryLimit("more than 2 GB")).issues[0].found
    assert "ProcessEnded" in checkers._explain_failure(ProcessEnded("it ended")).issues[0].found


def test_a_text_that_takes_long_holds_nobody_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """While it is read the server answers, edits and undoes; what stood before is read again at once."""
    monkeypatch.setattr(parsing, "check", workers.check_slowly)
    hub = Hub()
    session = Session(hub, Solver(hub.publish, workers.obey, None), tmp_path, "http://127.0.0.1")
    # it would take for ever
    session.editor.checker._seconds = 2 * PATIENCE
    try:
        session.editor.checker.wait(1, PATIENCE)
        assert session.get_state()["plan"] is not None
        start = time.monotonic()
        text = casefile.starter() + "# slow\n"
        session.editor.edit([{"op": "text", "value": text}], "Text", 1)
        state = session.get_state()
        assert (state["text"], state["checking"], state["issues"]) == (text, True, [])
        assert state["plan"] is not None, "the plan of before is shown meanwhile"
        with pytest.raises(InputError, match="still being checked"):
            session.solve()
        session.list_folder()
        session.editor.edit([{"op": "set", "path": ["title"], "value": "new"}], "Title", 2)
        assert session.get_state()["checking"] is True
        session.editor.undo()
        session.editor.undo()
        assert time.monotonic() - start < PATIENCE
        session.editor.checker.wait(5, PATIENCE)
        state = session.get_state()
        assert (state["version"], state["checking"], state["text"]) == (5, False, casefile.starter())
        assert state["data"]["plate"]["thickness"] == "250 mm"
    finally:
        session.close()
