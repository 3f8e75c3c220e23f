"""The newest state of the document is solved in a process of its own, as soon as the user pauses.

One thread looks after everything: it starts the process, hands it what is to be solved, stops what is not wanted any
more, and passes on what the process says. A run that is stopped is over for the pages at once; the process is left a
moment to stop between two steps of the analysis, and ended if that takes too long. A process that ends by itself is
told of and replaced.
"""

from __future__ import annotations

import itertools
import multiprocessing
import signal
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing import connection
from typing import TYPE_CHECKING, Any

from groundslab.errors import InputError, Issue
from groundslab.workbench.editing.diagnostics import issues_to_json
from groundslab.workbench.solver import process as worker
from groundslab.workbench.solver.process import Answer

if TYPE_CHECKING:
    from groundslab.workbench.events import Event

#: A run begins when nothing has changed for so long [s].
DELAY = 0.2
#: A run that does not stop by itself for so long is ended with its process [s].
GRACE = 0.5
#: Results that are kept for pages which still show the one before.
KEPT = 2
#: A process that ends so often before it has prepared is not started again until there is something new to solve.
MOST_STARTS = 3
ENDS = "the server ends"

Tell = Callable[[str, dict[str, Any]], None]


@dataclass(slots=True)
class Job:
    """Something to solve: its run's number, the document's version, the text, and what it means, to be compared."""

    run: int
    version: int
    text: str
    meaning: object
    due: float


@dataclass(slots=True)
class Result:
    """The results of a run; version is the latest one that means the same."""

    run: int
    version: int
    meaning: object
    answer: Answer
    scene: bytes


@dataclass(slots=True)
class _Process:
    """The process that solves, the pipe to it, the number up to which runs are to stop; whether it can be trusted."""

    process: Any
    pipe: connection.Connection
    stop: Any
    ready: bool = False
    proven: bool = False


@dataclass(slots=True)
class _Wishes:
    """What others want of the thread that looks after everything."""

    job: Job | None = None
    cancel: bool = False
    close: bool = False
    told_again: bool = False  # whether the latest results are told of when the run that is in the way is stopped
    reports: dict[int, list[Future[bytes]]] = field(default_factory=dict)
    file: str = ""  # what the case is called in a report


class Solver:
    """Solves what is wanted, newest first; tells events as in the server's interface."""

    def __init__(
        self,
        tell: Tell,
        task: worker.Task = worker.solve,
        prepare: Callable[[worker.Progress], None] | None = worker.warm,
    ) -> None:
        self._tell = tell
        self._task = task
        self._prepare = prepare
        self._context = multiprocessing.get_context("spawn")
        self._numbers = itertools.count(1)
        self._lock = threading.RLock()
        self._wishes = _Wishes()
        self._running: Job | None = None
        self._stopping: float | None = None  # when the process is ended, if the run does not stop before
        self._asked: list[int] = []  # runs whose reports the process has been asked for
        self._process: _Process | None = None
        self._failed_starts = 0
        self._results: dict[int, Result] = {}
        self._progress: dict[str, Any] | None = None
        self._inside, self._outside = multiprocessing.Pipe(duplex=False)
        self._thread = threading.Thread(target=self._look_after, name="solver", daemon=True)
        self._thread.start()

    def want(self, text: str, version: int, meaning: object, delay: float = DELAY, again: bool = False) -> int:
        """Have a text solved in place of all that was wanted before; return the run's number.

        What is being solved or was solved last and means the same is not solved anew, unless it is to be again.
        """
        with self._lock:
            running, latest = self._running, self.latest
            stays = running is not None and self._stopping is None and not self._wishes.cancel
            if running is not None and stays and running.meaning == meaning:
                running.version, self._wishes.job = version, None
                return running.run
            if not again and latest is not None and latest.meaning == meaning:
                latest.version, self._wishes.job = version, None
                self._wishes.cancel = self._wishes.told_again = running is not None
                self._wake()
                self._tell("solved", _told(latest))
                return latest.run
            job = Job(next(self._numbers), version, text, meaning, time.monotonic() + delay)
            self._wishes.job, self._wishes.cancel, self._wishes.told_again = job, running is not None, False
            self._failed_starts = 0
        self._wake()
        return job.run

    def cancel(self) -> None:
        """Stop what is being solved, and forget what was to be."""
        with self._lock:
            waiting, self._wishes.job, self._wishes.cancel = self._wishes.job, None, self._running is not None
            if waiting is not None:
                self._tell("cancelled", {"run": waiting.run})
        self._wake()

    def forget(self) -> None:
        """Stop, and drop all results: they belong to another document."""
        self.cancel()
        with self._lock:
            self._results.clear()

    @property
    def latest(self) -> Result | None:
        """The results of the latest run that has any."""
        with self._lock:
            return next(reversed(self._results.values()), None)

    def result(self, run: int) -> Result | None:
        """Return the results of a run, None if they are not there or not kept any more."""
        with self._lock:
            return self._results.get(run)

    @property
    def running(self) -> tuple[int, int] | None:
        """The run that is being solved, or is to be, and its version."""
        with self._lock:
            job = self._running if self._running is not None and self._stopping is None else self._wishes.job
            return None if job is None else (job.run, job.version)

    def status(self) -> list[Event]:
        """Return the events that say how things stand."""
        with self._lock:
            events: list[Event] = []
            if self.latest is not None:
                events.append(("solved", _told(self.latest)))
            if self._running is not None and self._stopping is None:
                events.append(("solving", {"run": self._running.run, "version": self._running.version}))
                if self._progress is not None:
                    events.append(("progress", self._progress))
            return events

    def report(self, run: int, file: str, patience: float = 600.0) -> bytes:
        """Return the report on a run, waiting for it; file names the case in it. Raises InputError if it fails."""
        future: Future[bytes] = Future()
        with self._lock:
            if self._wishes.close:
                raise _no_report(ENDS)
            self._wishes.reports.setdefault(run, []).append(future)
            self._wishes.file = file
        self._wake()
        try:
            return future.result(patience)
        except TimeoutError:
            raise _no_report("it takes too long") from None

    def close(self) -> None:
        """End the process and the thread."""
        with self._lock:
            self._wishes.close = True
        self._wake()
        self._thread.join()

    def _wake(self) -> None:
        with self._lock, suppress(OSError):
            self._outside.send_bytes(b"!")

    def _look_after(self) -> None:
        """Do what is to be done until the solver is closed."""
        while not self._wishes.close:
            with self._lock:
                self._do_what_is_due()
                ready_for = self._pause()
                sources: list[Any] = [self._inside]
                if self._process is not None:
                    sources += [self._process.pipe, self._process.process.sentinel]
            found = connection.wait(sources, ready_for)
            if self._inside in found:
                self._inside.recv_bytes()
            process = self._process
            if process is not None and process.pipe in found:
                self._hear(process)
            elif process is not None and process.process.sentinel in found:
                self._ended(process)
        with self._lock:
            self._end_process(ENDS)
            self._fail_reports(ENDS)

    def _do_what_is_due(self) -> None:
        """Start, stop, hand over."""
        wishes, now = self._wishes, time.monotonic()
        if self._running is not None:
            if wishes.cancel and self._stopping is None:
                self._stop(self._running.run, now + GRACE)
            if self._stopping is not None and now >= self._stopping:
                self._end_process()
                self._over()
        else:
            wishes.cancel = False
        if self._process is None and self._failed_starts < MOST_STARTS:
            self._start_process()
        process = self._process
        if process is None:
            self._fail_reports("the solver cannot be started")
        if process is None or not process.ready or self._running is not None:
            return
        for run in list(wishes.reports):
            if run not in self._asked:
                self._asked.append(run)
                with suppress(OSError):
                    process.pipe.send(("report", run, wishes.file))
        if wishes.job is not None and now >= wishes.job.due:
            self._running, wishes.job = wishes.job, None
            about = {"run": self._running.run, "version": self._running.version}
            self._tell("solving", about)
            with suppress(OSError):  # of a process that has just ended, which will be noticed
                process.pipe.send(("solve", self._running.run, self._running.text))

    def _stop(self, run: int, deadline: float) -> None:
        """Tell that the run is cancelled, and have the process stop it until the deadline."""
        self._stopping, self._progress = deadline, None
        assert self._process is not None
        self._process.stop.value = run
        again, self._wishes.told_again = self._wishes.told_again, False
        self._tell("cancelled", {"run": run})
        if again and self.latest is not None:
            self._tell("solved", _told(self.latest))

    def _pause(self) -> float | None:
        """Return how long nothing is due [s], None if nothing is at all."""
        times = []
        if self._stopping is not None:
            times.append(self._stopping)
        if self._wishes.job is not None and self._running is None:
            times.append(self._wishes.job.due)
        return max(0.0, min(times) - time.monotonic()) if times else None

    def _start_process(self) -> None:
        """Start a process that solves."""
        here, there = self._context.Pipe()
        stop = self._context.RawValue("q", 0)
        arguments = (there, stop, self._task, self._prepare)
        process = self._context.Process(target=worker.main, args=arguments, name="groundslab solver", daemon=True)
        process.start()
        there.close()  # so that the end of the process is the end of the pipe
        self._process = _Process(process, here, stop)

    def _end_process(self, why: str = "the solver was stopped; solve again") -> None:
        """End the process without asking it; why is told to those who wait for reports."""
        if self._process is not None:
            self._process.process.kill()
            self._process.process.join()
            self._process.process.close()
            self._process.pipe.close()
            self._process = None
            self._fail_reports(why)

    def _hear(self, process: _Process) -> None:
        """Take in what the process says."""
        try:
            word, *rest = process.pipe.recv()
            content = process.pipe.recv_bytes() if word == "solved" or (word == "report" and not rest[1]) else b""
        except (EOFError, OSError):
            self._ended(process)
            return
        with self._lock:
            if word == "ready":
                process.ready = True
            elif word == "warm":
                process.proven, self._failed_starts = True, 0
            elif word == "report":
                self._reported(rest[0], rest[1], content)
            elif self._running is not None and rest[0] == self._running.run:
                self._heard_of_run(self._running, word, rest[1:], content)

    def _heard_of_run(self, job: Job, word: str, rest: list[Any], content: bytes) -> None:
        """Take in what the process says about the run; of one that is to stop only that it is over."""
        if word == "progress":
            if self._stopping is None:
                self._progress = {"run": job.run, "text": rest[0], "share": rest[1]}
                self._tell("progress", self._progress)
        elif self._stopping is not None:
            self._over()
        elif self._wishes.cancel:  # it ended before it could be stopped
            self._stop(job.run, 0.0)
            self._over()
        elif word == "refused":
            issues = issues_to_json(rest[1])
            self._over("refused", {"run": job.run, "version": job.version, "message": rest[0], "faults": issues})
        else:
            result = Result(job.run, job.version, job.meaning, rest[0], content)
            self._results[job.run] = result
            while len(self._results) > KEPT:
                del self._results[next(iter(self._results))]
            self._over("solved", _told(result))

    def _over(self, word: str = "", about: dict[str, Any] | None = None) -> None:
        """Note that a run is over, and tell it unless that has been done when it was stopped."""
        self._running = self._stopping = self._progress = None
        self._wishes.cancel = self._wishes.told_again = False
        if word:
            self._tell(word, about or {})

    def _ended(self, process: _Process) -> None:
        """Tell that the process has ended by itself, so that another one can be started."""
        with self._lock:
            process.process.join()
            how = _how(process.process.exitcode)
            self._failed_starts += not process.proven
            self._end_process()
            job = self._running
            if job is not None and self._stopping is not None:
                self._over()
                return
            if job is None and self._failed_starts >= MOST_STARTS:
                job, self._wishes.job = self._wishes.job, None
            if job is not None:
                message = f"the solver ended unexpectedly ({how}); nothing of the case is lost"
                self._over("refused", {"run": job.run, "version": job.version, "message": message, "faults": []})

    def _reported(self, run: int, message: str, content: bytes) -> None:
        """Hand a report, or why there is none, to those who wait for it."""
        if run in self._asked:
            self._asked.remove(run)
        for future in self._wishes.reports.pop(run, []):
            if message:
                future.set_exception(_no_report(message))
            else:
                future.set_result(content)

    def _fail_reports(self, why: str) -> None:
        """Tell those who wait for reports that there will be none."""
        for run in list(self._wishes.reports):
            self._reported(run, why, b"")


def _told(result: Result) -> dict[str, Any]:
    """Return the event that tells of results, and in words what fails in the design."""
    design = result.answer.summary.get("design", {})
    return {
        "run": result.run,
        "version": result.version,
        "seconds": result.answer.seconds,
        "design": design["headline"] if design.get("status") in ("fails", "attention") else "",
        "refused": result.answer.refused,
    }


def _no_report(why: str) -> InputError:
    return InputError([Issue("the report", why, "results that are kept")])


def _how(code: int | None) -> str:
    """Return in words how a process ended."""
    if code is None or code >= 0:
        return f"exit code {code}"
    with suppress(ValueError):
        name = signal.Signals(-code).name
        return f"{name}, perhaps because the memory was used up" if name == "SIGKILL" else name
    return f"signal {-code}"
