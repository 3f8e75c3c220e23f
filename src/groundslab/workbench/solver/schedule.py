"""What the solver is to solve: the job that waits, the run that goes on, the latest results."""

from __future__ import annotations

import itertools
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from groundslab.messages import Message
from groundslab.workbench.editing.diagnostics import issues_to_json
from groundslab.workbench.solver.cost import USUAL_RATE, measure_rate
from groundslab.workbench.solver.runs import Job, Latest, Result

if TYPE_CHECKING:
    from groundslab.workbench.events import Event
    from groundslab.workbench.solver.answer import Answer

Notify = Callable[[str, dict[str, Any]], None]


@dataclass(slots=True)
class ActiveRun:
    """The run that the process works on, and what it has told of it."""

    job: Job
    is_cancelled: bool = False
    announces_latest: bool = False  # whether the latest result is announced again once the run is stopped
    kill_at: float | None = None  # when the process is killed unless the run stops before
    progress: dict[str, Any] | None = None
    preview: tuple[dict[str, Any], bytes] | None = None  # its event and its scene


class Schedule:
    """At most one run and one job that waits; notifies of the events in the server's interface.

    Whoever calls holds the lock, unless the method takes it.
    """

    def __init__(self, notify: Notify) -> None:
        self.lock = threading.RLock()
        self.waiting: Job | None = None
        self.active: ActiveRun | None = None
        self.results: Latest[Result] = Latest()
        #: Unknowns times combinations that this machine solves in a second, as the last run told.
        self.rate = USUAL_RATE
        self._notify = notify
        self._numbers = itertools.count(1)

    def submit(
        self, text: str, version: int, fingerprint: object, delay: float, force: bool, accuracy: str = ""
    ) -> int:
        """Let a text wait in place of all earlier ones and return the number of its run.

        A model that is being solved, or was solved last, is not solved again unless that is forced.
        """
        active, latest = self.active, self.results.latest
        if active is not None and not active.is_cancelled and active.job.fingerprint == fingerprint:
            active.job.version, self.waiting = version, None
            if active.preview is not None:
                active.preview[0]["version"] = version
                self._notify("preview", active.preview[0])
            if latest is not None and latest.run == active.job.run:
                latest.version = version
                self._notify(*latest.event)
            return active.job.run
        is_known = latest is not None and latest.fingerprint == fingerprint and not latest.is_provisional
        is_solved = is_known and not force
        if active is not None:
            active.is_cancelled, active.announces_latest = True, is_solved
        if is_solved and latest is not None:
            latest.version, self.waiting = version, None
            self._notify(*latest.event)
            return latest.run
        self.waiting = Job(next(self._numbers), version, text, fingerprint, time.monotonic() + delay, accuracy)
        return self.waiting.run

    def cancel(self) -> None:
        """Have the current run stopped and drop the waiting job."""
        waiting, self.waiting = self.waiting, None
        if self.active is not None:
            self.active.is_cancelled = True
        if waiting is not None:
            self._notify("cancelled", {"run": waiting.run})

    @property
    def current(self) -> Job | None:
        """The job that is being solved or waits; takes the lock."""
        with self.lock:
            return self.active.job if self.active is not None and self.active.kill_at is None else self.waiting

    def get_preview(self, run: int) -> bytes | None:
        """Return the latest scene of a run that has not ended yet, None if there is none; takes the lock."""
        with self.lock:
            preview = None if self.active is None else self.active.preview
            return preview[1] if preview is not None and preview[0]["run"] == run else None

    def get_current_events(self) -> list[Event]:
        """Return the events that describe the present state; takes the lock."""
        with self.lock:
            latest, active = self.results.latest, self.active
            events: list[Event] = [] if latest is None else [latest.event]
            if active is not None and active.kill_at is None:
                events.append(("solving", active.job.to_json()))
                if active.progress is not None:
                    events.append(("progress", active.progress))
                if active.preview is not None:
                    events.append(("preview", active.preview[0]))
            return events

    @property
    def due(self) -> float | None:
        """The time of the next action, None if there is none."""
        if self.active is not None:
            return self.active.kill_at
        return None if self.waiting is None else self.waiting.due

    def begin(self, now: float) -> Job | None:
        """Return the waiting job, whose run begins, None if none is due."""
        job = self.waiting
        if job is None or now < job.due:
            return None
        self.waiting, self.active = None, ActiveRun(job)
        self._notify("solving", job.to_json())
        return job

    def stop(self, active: ActiveRun, deadline: float) -> None:
        """Announce that the current run is cancelled; it is to stop until a deadline."""
        active.kill_at, active.progress = deadline, None
        self._notify("cancelled", {"run": active.job.run})
        again, active.announces_latest = active.announces_latest, False
        if again and self.results.latest is not None:
            self._notify(*self.results.latest.event)

    def tell_of_report(self, run: int, title: str, share: float) -> None:
        """Announce which chapter of a report is made, and the share that is made."""
        self._notify("making", {"run": run, "text": title, "share": share})

    def handle(self, kind: str, run: int, rest: list[Any], content: bytes) -> None:
        """Handle the process's message about a run; of one that is being stopped only its end counts."""
        active = self.active
        if active is None or run != active.job.run:
            return
        job, is_stopping = active.job, active.kill_at is not None
        if kind == "progress":
            if not is_stopping:
                active.progress = {"run": run, "text": rest[0], "share": rest[1], "details": rest[2]}
                self._notify("progress", active.progress)
        elif kind == "preview":
            if not active.is_cancelled:
                active.preview = job.to_json() | {"words": rest[0], "figures": rest[1]}, content
                self._notify("preview", active.preview[0])
        elif kind == "provisional":
            if not active.is_cancelled:
                active.preview = None
                self._notify(*self._add(job, rest[0], content).event)
        elif active.is_cancelled:
            if not is_stopping:  # it ended before it could be stopped
                self.stop(active, 0.0)
            self.finish()
        elif kind == "refused":
            self.finish("refused", job.to_json() | {"message": rest[0], "issues": issues_to_json(rest[1])})
        else:
            self.finish(*self._add(job, rest[0], content).event)

    def _add(self, job: Job, answer: Answer, scene: bytes) -> Result:
        """Keep the results of a job in place of earlier ones of the same run."""
        before = self.results.get(job.run)
        update = 0 if before is None else before.update + 1
        result = Result(job.run, job.version, job.fingerprint, answer, scene, job.text, update)
        self.results.add(job.run, result)
        if not result.is_provisional:
            self.rate = measure_rate(answer) or self.rate
        return result

    def finish(self, event: str = "", data: dict[str, Any] | None = None) -> None:
        """Finish the current run, with an event unless it was announced when the run was stopped."""
        self.active = None
        if event:
            self._notify(event, data or {})

    def fail(self, how: str, gives_up: bool) -> None:
        """Refuse the run whose process has ended by itself, or the waiting job if no process is started any more."""
        job = None if self.active is None or self.active.kill_at is not None else self.active.job
        if self.active is None and gives_up:
            job, self.waiting = self.waiting, None
        if job is None:
            self.finish()
            return
        message = Message("the solver ended unexpectedly ({how}); no part of the case is lost", how=how)
        self.finish("refused", job.to_json() | {"message": message, "issues": []})
