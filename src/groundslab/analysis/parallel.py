"""Tasks on several threads, in lanes: what they report and what they return is heard in the order of the tasks."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from queue import SimpleQueue
from threading import Event
from typing import TypeVar

Said = TypeVar("Said")
Returned = TypeVar("Returned")


class Stopped(Exception):
    """Nobody waits for a task any more."""


def side_by_side(
    lanes: Sequence[Sequence[Callable[[Callable[[Said], None]], Returned]]],
    hear: Callable[[Said], None],
    begin: Callable[[], None],
) -> Iterator[Returned]:
    """Yield what the tasks of all lanes return: the first of each lane, then the second of each, and so on.

    Each lane is a thread, which calls begin and then its tasks one after the other with what they report by. hear is
    told on the thread that asks, while it waits for the task that reports. Whatever a task raises is raised there too.
    Once it is asked no more, a task ends with its next report.
    """
    stop = Event()

    def run(task: Callable[[Callable[[Said], None]], Returned], said: SimpleQueue[Said | None]) -> Returned:
        def report(what: Said) -> None:
            if stop.is_set():
                raise Stopped
            said.put(what)

        try:
            return task(report)
        finally:
            said.put(None)

    with ExitStack() as stack:
        pools = [stack.enter_context(ThreadPoolExecutor(1, initializer=begin)) for _ in lanes]
        under_way = []
        for turn in range(max(map(len, lanes))):
            for pool, tasks in zip(pools, lanes, strict=True):
                if turn < len(tasks):
                    said = SimpleQueue[Said | None]()
                    under_way.append((said, pool.submit(run, tasks[turn], said)))
        stack.callback(lambda: [future.cancel() for _, future in under_way])
        stack.callback(stop.set)
        for said, future in under_way:
            for what in iter(said.get, None):
                hear(what)
            yield future.result()
