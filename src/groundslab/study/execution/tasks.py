"""Which variants the workers of Dask get next, and which of them bring workers down.

A task is one variant, or as many as take a fraction of a second, since the scheduler needs milliseconds for each task.

A worker that dies takes along all that it was given, and does not say which variant it died of. All of them are
suspects: they are solved last, one at a time, with nothing else running. Only a variant that workers die of then is
given up; all others get their rows.
"""

from __future__ import annotations

import signal
from collections import Counter, deque
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

from groundslab.study.execution.variant import Row, WorkerFailure

if TYPE_CHECKING:
    from groundslab.study.sampling.designs import Variant

#: Variants that are solved faster share a task up to this time [s], and while each thread has so many tasks to come.
TASK_SECONDS = 0.2
TASKS_TO_COME = 4
#: Workers that must die of a variant, with nothing else running, before it is given up: one may die by chance.
DEATHS_ALONE = 2


@dataclass(frozen=True, slots=True)
class Loss:
    """Why a task ended without rows, though perhaps none of its variants is to blame."""

    message: str
    deaths: int = 0  # workers that died of it, one after the other; 0: one that lives had no memory left


#: What a task has come to.
Outcome: TypeAlias = "Sequence[Row | WorkerFailure] | Loss"


class Tasks:
    """The variants that are to be solved, those that a worker may have died of last."""

    def __init__(self, variants: Sequence[Variant]) -> None:
        self.left = deque(variants)
        self.suspects: deque[Variant] = deque()
        self.seconds = TASK_SECONDS  # that the latest variants took, in the mean
        self._tried: Variant | None = None  # the suspect that is solved now
        self._deaths = Counter[int]()  # by number of the variant, with nothing else running

    def next(self, count: int, threads: int, idle: bool) -> list[Sequence[Variant]]:
        """Return the variants of so many further tasks, or fewer, for a number of threads; idle: none has a task."""
        if not self.left and self.suspects and idle:
            self._tried = self.suspects.popleft()
            return [[self._tried]]
        size = max(1, int(min(TASK_SECONDS / self.seconds, len(self.left) / (TASKS_TO_COME * threads))))
        tasks: list[Sequence[Variant]] = []
        while self.left and len(tasks) < count:
            tasks.append([self.left.popleft() for _ in range(min(size, len(self.left)))])
        return tasks

    def finish(self, variants: Sequence[Variant], outcome: Outcome) -> Sequence[Row | WorkerFailure]:
        """Return the outcomes of a task's variants, without those that are to be solved again."""
        suspect, self._tried = self._tried, None
        if not isinstance(outcome, Loss):
            if seconds := [row.seconds for row in outcome if isinstance(row, Row)]:
                self.seconds += (max(1e-3, sum(seconds) / len(seconds)) - self.seconds) / 8
            return outcome
        if suspect is None:
            self.suspects += variants
            return []
        self._deaths[suspect.number] += outcome.deaths
        deaths = self._deaths[suspect.number]
        if 0 < deaths < DEATHS_ALONE:
            self.suspects.append(suspect)
            return []
        died = f"{deaths} workers died of it with nothing else running: " if deaths else ""
        return [WorkerFailure(suspect.number, died + outcome.message)]


def describe_exit(code: int | None, memory: float) -> str:
    """Return in words how a worker's process ended; its share of the memory [bytes]. None: nobody knows."""
    if code is None:
        return "perhaps out of memory"
    if code == -signal.SIGTERM:
        return f"more memory than a worker's share of {memory / 2**30:.3g} GiB"
    if code < 0:
        name = signal.Signals(-code).name
        return f"{name}, perhaps out of memory" if name == "SIGKILL" else name
    return f"exit code {code}"
