"""Solves the newest state of the document in a child process as soon as the user pauses.

One thread runs an event loop: it starts the process, sends it jobs, stops runs that are superseded, and passes on the
messages of the process. A run that is stopped is over for the pages at once; the process has a moment to stop between
two steps of the analysis and is killed otherwise. A process that crashes is reported and replaced.
"""

from __future__ import annotations

import itertools
import signal
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing import Pipe, connection
from typing import TYPE_CHECKING, Any

from groundslab.workbench.child_process import CONTEXT, ChildProcess
from groundslab.workbench.editing.diagnostics import issues_to_json
from groundslab.workbench.solver import process as worker
from groundslab.workbench.solver.process import View
from groundslab.workbench.solver.runs import Job, Result, ViewRequests, make_view_error

if TYPE_CHECKING:
    from groundslab.workbench.events import Event

#: A run begins after so long without a change [s].
DELAY = 0.05
#: A run that has not stopped after so long is killed with its process [s].
GRACE = 0.5
#: No preview is made where the last run took no longer than this [s].
QUICK = 0.5
#: Number of results that are kept, for pages that still show the previous one.
MAX_RESULTS = 2
#: A process that fails so often before it is ready is not started again until there is a new job.
MAX_STARTS = 3
CLOSING = "the server ends"

Notify = Callable[[str, dict[str, Any]], None]


@dataclass(slots=True)
class _Process:
    """The process that solves; runs up to the number in ``stop`` are to be stopped."""

    child: ChildProcess
    stop: Any
    is_ready: bool = False
    has_started: bool = False


@dataclass(slots=True)
class _Requests:
    """Requests of other threads to the event loop."""

    job: Job | None = None
    cancel: bool = False
    close: bool = False
    notify_again: bool = False  # whether the latest result is announced again once the current run is stopped
    views: ViewRequests = field(default_factory=ViewRequests)


class Solver:
    """Solves the latest job; notifies of the events in the server's interface."""

    def __init__(
        self,
        notify: Notify,
        task: worker.Task = worker.solve,
        prepare: Callable[[worker.Progress], None] | None = worker.warm_up,
    ) -> None:
        self._notify = notify
        self._task = task
        self._prepare = prepare
        self._numbers = itertools.count(1)
        self._lock = threading.RLock()
        self._requests = _Requests()
        self._running: Job | None = None
        self._kill_at: float | None = None  # when the process is killed unless the run stops before
        self._process: _Process | None = None
        self._failed_starts = 0
        self._results: dict[int, Result] = {}
        self._progress: dict[str, Any] | None = None
        self._preview: tuple[dict[str, Any], bytes] | None = None  # its event and its scene
        #: The combination that is looked at, of which a run shows a preview; None if several are.
        self.shown: str | None = ""
        self._wake_receiver, self._wake_sender = Pipe(duplex=False)
        self._thread = threading.Thread(target=self._event_loop, name="solver", daemon=True)
        self._thread.start()

    def submit(self, text: str, version: int, fingerprint: object, delay: float = DELAY, force: bool = False) -> int:
        """Submit a text in place of all earlier ones and return the number of its run.

        A model that is being solved, or was solved last, is not solved again unless that is forced.
        """
        with self._lock:
            requests, running, latest = self._requests, self._running, self.latest
            continues = self._kill_at is None and not requests.cancel
            if running is not None and continues and running.fingerprint == fingerprint:
                running.version, requests.job = version, None
                return running.run
            if not force and latest is not None and latest.fingerprint == fingerprint:
                latest.version, requests.job = version, None
                requests.cancel = requests.notify_again = running is not None
                self._wake()
                self._notify("solved", latest.to_json())
                return latest.run
            job = Job(next(self._numbers), version, text, fingerprint, time.monotonic() + delay)
            requests.job, requests.cancel, requests.notify_again = job, running is not None, False
            self._failed_starts = 0
        self._wake()
        return job.run

    def cancel(self) -> None:
        """Stop the current run and drop the waiting job."""
        with self._lock:
            waiting, self._requests.job, self._requests.cancel = self._requests.job, None, self._running is not None
            if waiting is not None:
                self._notify("cancelled", {"run": waiting.run})
        self._wake()

    def reset(self) -> None:
        """Stop, and drop all results, which belong to another document."""
        self.cancel()
        with self._lock:
            self._results.clear()

    @property
    def latest(self) -> Result | None:
        """The latest result."""
        with self._lock:
            return next(reversed(self._results.values()), None)

    def get_result(self, run: int) -> Result | None:
        """Return the result of a run, None if there is none or it is no longer kept."""
        with self._lock:
            return self._results.get(run)

    def get_preview(self, run: int) -> bytes | None:
        """Return the latest scene of a run that has not ended yet, None if there is none."""
        with self._lock:
            return self._preview[1] if self._preview is not None and self._preview[0]["run"] == run else None

    @property
    def current(self) -> Job | None:
        """The job that is being solved or waits."""
        with self._lock:
            return self._running if self._running is not None and self._kill_at is None else self._requests.job

    def get_current_events(self) -> list[Event]:
        """Return the events that describe the present state."""
        with self._lock:
            events: list[Event] = []
            if self.latest is not None:
                events.append(("solved", self.latest.to_json()))
            if self._running is not None and self._kill_at is None:
                events.append(("solving", self._running.to_json()))
                if self._progress is not None:
                    events.append(("progress", self._progress))
                if self._preview is not None:
                    events.append(("preview", self._preview[0]))
            return events

    def make_view(self, view: View, timeout: float = 600.0) -> bytes:
        """Wait for a report or a table and return it; raises InputError on failure."""
        with self._lock:
            if self._requests.close:
                raise make_view_error(view[0], CLOSING)
            future = self._requests.views.add(view)
        self._wake()
        try:
            return future.result(timeout)
        except TimeoutError:
            raise make_view_error(view[0], "it takes too long") from None

    def close(self) -> None:
        """End the process and the thread."""
        with self._lock:
            self._requests.close = True
        self._wake()
        self._thread.join()

    def _wake(self) -> None:
        with self._lock, suppress(OSError):
            self._wake_sender.send_bytes(b"!")

    def _event_loop(self) -> None:
        while not self._requests.close:
            with self._lock:
                self._handle_requests()
                timeout = self._compute_wait()
                process = self._process
            sources: list[Any] = [self._wake_receiver]
            if process is not None:
                sources += [process.child.pipe, process.child.sentinel]
            ready = connection.wait(sources, timeout)
            if self._wake_receiver in ready:
                self._wake_receiver.recv_bytes()
            if process is not None and process.child.pipe in ready:
                self._receive(process)
            elif process is not None and process.child.sentinel in ready:
                self._handle_exit(process)
        with self._lock:
            self._kill_process(CLOSING)
            self._requests.views.fail(CLOSING)

    def _handle_requests(self) -> None:
        """Stop the run, start the process and send it requests, as far as these are due."""
        requests, now = self._requests, time.monotonic()
        if self._running is not None:
            if requests.cancel and self._kill_at is None:
                self._stop(self._running.run, now + GRACE)
            if self._kill_at is not None and now >= self._kill_at:
                self._kill_process("the solver was stopped; solve again")
                self._finish_run()
        else:
            requests.cancel = False
        if self._process is None and self._failed_starts < MAX_STARTS:
            stop = CONTEXT.RawValue("q", 0)
            child = ChildProcess("groundslab solver", worker.main, stop, self._task, self._prepare)
            self._process = _Process(child, stop)
        process = self._process
        if process is None:
            requests.views.fail("the solver cannot be started")
        if process is None or not process.is_ready or self._running is not None:
            return
        messages: list[tuple[Any, ...]] = list(requests.views.take_unsent())
        if requests.job is not None and now >= requests.job.due:
            job, requests.job = requests.job, None
            self._running = job
            self._notify("solving", job.to_json())
            slow = self.latest is None or self.latest.answer.seconds > QUICK
            messages.append(("solve", job.run, job.text, self.shown if slow else None))
        with suppress(OSError):  # of a process that has just ended, which the event loop will notice
            for message in messages:
                process.child.pipe.send(message)

    def _stop(self, run: int, deadline: float) -> None:
        """Announce that a run is cancelled, and have the process stop it until a deadline."""
        self._kill_at, self._progress = deadline, None
        assert self._process is not None
        self._process.stop.value = run
        again, self._requests.notify_again = self._requests.notify_again, False
        self._notify("cancelled", {"run": run})
        if again and self.latest is not None:
            self._notify("solved", self.latest.to_json())

    def _compute_wait(self) -> float | None:
        """Return the time until the next action is due [s], None if there is none."""
        times = [] if self._kill_at is None else [self._kill_at]
        if self._requests.job is not None and self._running is None:
            times.append(self._requests.job.due)
        return max(0.0, min(times) - time.monotonic()) if times else None

    def _kill_process(self, reason: str) -> None:
        """Kill the process; views that are waited for fail with a reason."""
        if self._process is not None:
            self._process.child.close()
            self._process = None
            self._requests.views.fail(reason)

    def _receive(self, process: _Process) -> None:
        """Receive a message of the process."""
        pipe = process.child.pipe
        try:
            kind, *rest = pipe.recv()
            content = pipe.recv_bytes() if kind in ("preview", "solved") or (kind == "view" and not rest[1]) else b""
        except (EOFError, OSError):
            self._handle_exit(process)
            return
        with self._lock:
            if kind == "ready":
                process.is_ready = True
            elif kind == "warm":
                process.has_started, self._failed_starts = True, 0
            elif kind == "view":
                self._requests.views.finish(rest[0], rest[1], content)
            elif self._running is not None and rest[0] == self._running.run:
                self._handle_run_message(self._running, kind, rest[1:], content)

    def _handle_run_message(self, job: Job, kind: str, rest: list[Any], content: bytes) -> None:
        """Handle a message about the current run; of one that is being stopped only its end counts."""
        if kind == "progress":
            if self._kill_at is None:
                self._progress = {"run": job.run, "text": rest[0], "share": rest[1]}
                self._notify("progress", self._progress)
        elif kind == "preview":
            if self._kill_at is None and not self._requests.cancel:
                self._preview = job.to_json() | {"words": rest[0]}, content
                self._notify("preview", self._preview[0])
        elif self._kill_at is not None:
            self._finish_run()
        elif self._requests.cancel:  # it ended before it could be stopped
            self._stop(job.run, 0.0)
            self._finish_run()
        elif kind == "refused":
            self._finish_run("refused", job.to_json() | {"message": rest[0], "issues": issues_to_json(rest[1])})
        else:
            result = Result(job.run, job.version, job.fingerprint, rest[0], content, job.text)
            self._results[job.run] = result
            while len(self._results) > MAX_RESULTS:
                del self._results[next(iter(self._results))]
            self._finish_run("solved", result.to_json())

    def _finish_run(self, event: str = "", data: dict[str, Any] | None = None) -> None:
        """Finish the current run, with an event unless it was announced when the run was stopped."""
        self._running = self._kill_at = self._progress = self._preview = None
        self._requests.cancel = self._requests.notify_again = False
        if event:
            self._notify(event, data or {})

    def _handle_exit(self, process: _Process) -> None:
        """Report that the process has ended by itself."""
        with self._lock:
            process.child.join()
            how = _describe_exit(process.child.exitcode)
            self._failed_starts += not process.has_started
            self._kill_process("the solver was stopped; solve again")
            job = self._running
            if job is not None and self._kill_at is not None:
                self._finish_run()
                return
            if job is None and self._failed_starts >= MAX_STARTS:
                job, self._requests.job = self._requests.job, None
            if job is not None:
                message = f"the solver ended unexpectedly ({how}); no part of the case is lost"
                self._finish_run("refused", job.to_json() | {"message": message, "issues": []})


def _describe_exit(code: int | None) -> str:
    """Return how a process ended, in words."""
    if code is None or code >= 0:
        return f"exit code {code}"
    with suppress(ValueError):
        name = signal.Signals(-code).name
        return f"{name}, perhaps because the memory was used up" if name == "SIGKILL" else name
    return f"signal {-code}"
