"""Solves the newest state of the document in a child process as soon as the user pauses.

One thread runs an event loop: it starts the process, sends it jobs, stops runs that are superseded, and passes on the
messages of the process. A run that is stopped is over for the pages at once; the process has a moment to stop between
two steps of the analysis, a longer one if it holds results and nothing else is to be solved, and is killed otherwise. A
process that crashes is reported and replaced.
"""

from __future__ import annotations

import threading
import time
from contextlib import suppress
from multiprocessing import Pipe, connection
from typing import Any

from groundslab.messages import Label
from groundslab.workbench.solver import process
from groundslab.workbench.solver.process import View
from groundslab.workbench.solver.runs import ViewRequests, make_view_error
from groundslab.workbench.solver.schedule import Notify, Schedule
from groundslab.workbench.solver.worker import Worker

#: A run begins after so long without a change [s].
DELAY = 0.05
#: A run that has not stopped after so long is killed with its process [s].
GRACE = 0.5
#: So long [s] if nothing is to be solved instead: what it has told of earlier meshes, and their tables, end with it.
KEEPING = 20.0
#: A process that fails so often before it is ready is not started again until there is a new job.
MAX_STARTS = 3
CLOSING, STOPPED = Label("the server ends"), Label("the solver was stopped; solve again")


class Solver:
    """Solves the latest job; a thread of its own talks to the process and follows the schedule."""

    def __init__(
        self, notify: Notify, task: process.Task = process.solve, prepare: process.Prepare | None = process.warm_up
    ) -> None:
        self.schedule = Schedule(notify)
        #: The combination that is looked at, of which a run shows a preview; None if several are.
        self.shown: str | None = ""
        #: The accuracy that is asked for in place of that of the case, "" for that.
        self.accuracy = ""
        self._task = task
        self._prepare = prepare
        self._lock = self.schedule.lock
        self._views = ViewRequests()
        self._worker: Worker | None = None
        self._failed_starts = 0
        self._closing = False
        self._wake_receiver, self._wake_sender = Pipe(duplex=False)
        self._thread = threading.Thread(target=self._event_loop, name="solver", daemon=True)
        self._thread.start()

    def submit(self, text: str, version: int, fingerprint: object, delay: float = DELAY, force: bool = False) -> int:
        """Submit a text in place of all earlier ones and return the number of its run.

        A model that is being solved, or was solved last, is not solved again unless that is forced.
        """
        with self._lock:
            run = self.schedule.submit(text, version, fingerprint, delay, force, self.accuracy)
            if self.schedule.waiting is not None:
                self._failed_starts = 0
        self._wake()
        return run

    def cancel(self) -> None:
        """Stop the current run and drop the waiting job."""
        with self._lock:
            self.schedule.cancel()
        self._wake()

    def reset(self) -> None:
        """Stop, and drop all results, which belong to another document."""
        self.cancel()
        with self._lock:
            self.schedule.results.clear()

    def make_view(self, view: View, timeout: float = 600.0) -> bytes:
        """Wait for a report or a table and return it; raises InputError on failure."""
        with self._lock:
            if self._closing:
                raise make_view_error(view[0], CLOSING)
            future = self._views.add(view)
        self._wake()
        try:
            return future.result(timeout)
        except TimeoutError:
            raise make_view_error(view[0], Label("it takes too long")) from None

    def close(self) -> None:
        """End the process and the thread."""
        with self._lock:
            self._closing = True
        self._wake()
        self._thread.join()

    def _wake(self) -> None:
        with self._lock, suppress(OSError):
            self._wake_sender.send_bytes(b"!")

    def _event_loop(self) -> None:
        while not self._closing:
            with self._lock:
                self._act()
                due, worker = self.schedule.due, self._worker
            sources: list[Any] = [self._wake_receiver]
            if worker is not None:
                sources += [worker.pipe, worker.sentinel]
            ready = connection.wait(sources, None if due is None else max(0.0, due - time.monotonic()))
            if self._wake_receiver in ready:
                self._wake_receiver.recv_bytes()
            if worker is not None and worker.pipe in ready:
                self._receive(worker)
            elif worker is not None and worker.sentinel in ready:
                self._handle_exit(worker)
        with self._lock:
            self._kill(CLOSING)
            self._views.fail(CLOSING)

    def _act(self) -> None:
        """Stop the run, start the process and send it requests, as far as these are due."""
        schedule, active, now = self.schedule, self.schedule.active, time.monotonic()
        if active is not None:
            if active.is_cancelled and active.kill_at is None:
                assert self._worker is not None
                self._worker.stop(active.job.run)
                keeps = schedule.waiting is None and schedule.results.latest is not None
                schedule.stop(active, now + (KEEPING if keeps else GRACE))
            elif active.kill_at is not None and schedule.waiting is not None:
                active.kill_at = min(active.kill_at, schedule.waiting.due + GRACE)
            if active.kill_at is not None and now >= active.kill_at:
                self._kill(STOPPED)
                schedule.finish()
        if self._worker is None and self._failed_starts < MAX_STARTS:
            self._worker = Worker(self._task, self._prepare)
        if self._worker is None:
            self._views.fail(Label("the solver cannot be started"))
        elif self._worker.is_ready and (schedule.active is None or schedule.active.kill_at is None):
            messages: list[tuple[Any, ...]] = list(self._views.take_unsent())
            job, latest = schedule.begin(now) if schedule.active is None else None, schedule.results.latest
            if job is not None:
                before = None if latest is None else latest.answer.first
                messages.append(("solve", job.run, job.text, self.shown, before, job.accuracy))
            self._worker.send(messages)

    def _receive(self, worker: Worker) -> None:
        """Receive a message of the process."""
        message = worker.receive()
        if message is None:
            self._handle_exit(worker)
            return
        kind, rest, content = message
        with self._lock:
            if kind == "ready":
                worker.is_ready = True
            elif kind == "warm":
                worker.has_started, self._failed_starts = True, 0
            elif kind == "view":
                self._views.finish(rest[0], rest[1], content)
            elif kind == "making":
                self.schedule.tell_of_report(*rest)
            else:
                self.schedule.handle(kind, rest[0], rest[1:], content)

    def _handle_exit(self, worker: Worker) -> None:
        """Report that the process has ended by itself."""
        with self._lock:
            how = worker.wait_for_end()
            self._failed_starts += not worker.has_started
            self._kill(STOPPED)
            self.schedule.fail(how, self._failed_starts >= MAX_STARTS)

    def _kill(self, reason: str) -> None:
        """Kill the process; views that are waited for fail with a reason."""
        if self._worker is not None:
            self._worker.kill()
            self._worker = None
            self._views.fail(reason)
