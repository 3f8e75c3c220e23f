"""Tasks side by side: the order of what is heard and returned, what is raised, tasks that nobody waits for."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

from groundslab.analysis.tasks.parallel import run_parallel

Report = Callable[[str], None]
PATIENCE = 120.0  # seconds, on a machine that has other things to do


def test_order_is_that_of_the_tasks_whichever_lane_is_faster() -> None:
    """The first lane's first task ends last; it is heard and yielded first all the same, and each lane has a thread."""
    others, begun, threads = threading.Event(), list[int](), dict[str, int]()

    def task(name: str, waits: bool) -> Callable[[Report], str]:
        def run(report: Report) -> str:
            threads[name] = threading.get_ident()
            report(f"{name} begins")
            if waits:
                assert others.wait(PATIENCE)
            elif name == "d":
                others.set()
            report(f"{name} ends")
            return name

        return run

    heard: list[str] = []
    lanes = [[task("a", True), task("c", False)], [task("b", False), task("d", False)]]
    found = list(run_parallel(lanes, heard.append, lambda: begun.append(threading.get_ident())))
    assert found == ["a", "b", "c", "d"]
    assert heard == [f"{name} {word}" for name in "abcd" for word in ("begins", "ends")]
    assert threads["a"] == threads["c"] != threads["b"] == threads["d"]
    assert set(begun) == {threads["a"], threads["b"]}
    assert threading.get_ident() not in begun


def test_what_a_task_raises_is_raised_where_it_is_waited_for() -> None:
    """What others returned before it is there; nothing of the later ones is."""

    def fails(report: Report) -> int:
        report("now")
        raise MemoryError("full")

    heard: list[str] = []
    each = run_parallel([[lambda _: 1, lambda _: 3], [fails]], heard.append, lambda: None)
    assert next(each) == 1
    with pytest.raises(MemoryError, match="full"):
        next(each)
    assert heard == ["now"]


def test_tasks_end_when_nobody_waits() -> None:
    """A task that is under way ends with its next report, one that has not begun does not begin."""
    under_way, ended, later = threading.Event(), list[str](), list[str]()

    def long(report: Report) -> int:
        try:
            while True:
                report("on and on")
                under_way.set()
        finally:
            ended.append("long")

    lanes = [[lambda _: 1], [long, lambda _: later.append("never")]]
    each = run_parallel(lanes, lambda _: None, lambda: None)
    assert next(each) == 1
    assert under_way.wait(PATIENCE)
    each.close()
    assert ended == ["long"]
    assert later == []
