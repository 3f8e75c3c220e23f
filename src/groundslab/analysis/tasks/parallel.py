"""Tasks on several threads whose reports and results arrive in the order of the tasks."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from queue import SimpleQueue
from threading import Event
from typing import TypeVar

Report = TypeVar("Report")
Result = TypeVar("Result")


class Cancelled(Exception):
    """The caller no longer waits for the task."""


def run_parallel(
    lanes: Sequence[Sequence[Callable[[Callable[[Report], None]], Result]]],
    on_report: Callable[[Report], None],
    initialize: Callable[[], None],
) -> Iterator[Result]:
    """Yield the results of the tasks of all lanes: the first of each lane, then the second of each, and so on.

    Each lane is a thread, which calls `initialize` and then its tasks one after the other with a function to report by.
    `on_report` is called on the caller's thread while it waits for the task that reports, and exceptions of tasks are
    raised there. When the iteration is closed, running tasks end with their next report.
    """
    from threadpoolctl import ThreadpoolController  # type: ignore[import-untyped,unused-ignore]

    stop = Event()

    def run(task: Callable[[Callable[[Report], None]], Result], reports: SimpleQueue[Report | None]) -> Result:
        def report(item: Report) -> None:
            if stop.is_set():
                raise Cancelled
            reports.put(item)

        try:
            if stop.is_set():  # the one before has ended because nobody waits, and this one is not canceled yet
                raise Cancelled
            return task(report)
        finally:
            reports.put(None)

    with ExitStack() as stack:
        # NumPy's products are small here: further threads of theirs would only take the cores from the lanes
        stack.enter_context(ThreadpoolController().select(internal_api="openblas").limit(limits=1))
        pools = [stack.enter_context(ThreadPoolExecutor(1, initializer=initialize)) for _ in lanes]
        submitted = []
        for turn in range(max(map(len, lanes))):
            for pool, tasks in zip(pools, lanes, strict=True):
                if turn < len(tasks):
                    reports = SimpleQueue[Report | None]()
                    submitted.append((reports, pool.submit(run, tasks[turn], reports)))
        stack.callback(lambda: [future.cancel() for _, future in submitted])
        stack.callback(stop.set)
        for reports, future in submitted:
            for item in iter(reports.get, None):
                on_report(item)
            yield future.result()
