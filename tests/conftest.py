"""What holds for all tests: what "auto" solves with, which are quick, what each took; the same examples always."""

from __future__ import annotations

import gc
import os
import signal
from collections import Counter
from collections.abc import Generator, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from groundslab.solvers import factorization

#: What --record has written of all tests, as a comment says there.
LENGTHY = Path(__file__).with_name("lengthy.txt")
#: Test functions that take longer are recorded [s].
QUICK = 0.2
#: How long this process and those that it has started had computed when the last step of a test ended [s].
COMPUTED = pytest.StashKey[float]()
#: How long those that it has ended had, and those that go on from test to test, such as a browser [s].
ENDED, GOING_ON = pytest.StashKey[float](), pytest.StashKey[float]()


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the options of these tests."""
    parser.addoption("--solver", choices=["pardiso", "cholmod", "superlu"], help='the solver that "auto" takes')
    parser.addoption("--quick", action="store_true", help=f"leave out slow tests and those of {LENGTHY.name}")
    parser.addoption("--record", type=Path, metavar="FILE", help="write which test functions take long, and how long")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Keep quick tests only, if that is asked for."""
    if config.getoption("--quick"):
        lengthy = {line.split()[-1] for line in LENGTHY.read_text(encoding="utf-8").splitlines()}
        left_out = {each for each in items if each.get_closest_marker("slow") or _function(each.nodeid) in lengthy}
        config.hook.pytest_deselected(items=[each for each in items if each in left_out])
        items[:] = [each for each in items if each not in left_out]


def pytest_collection_finish(session: pytest.Session) -> None:
    """Let what has been imported and collected, which lives to the end, never be looked through for garbage again."""
    session.stash[COMPUTED], session.stash[ENDED] = sum(os.times()[:4]), sum(os.times()[2:4])
    gc.collect()
    gc.freeze()
    gc.set_threshold(100_000, 50, 100)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Add to a report how long was computed, which does not depend on what else the machine does as much."""
    report = yield
    stash = item.session.stash
    times = os.times()
    ended = times.children_user + times.children_system
    # what goes on is asked after tests in a browser, and when something has ended, which may be what went on
    known = stash.get(GOING_ON, 0.0)
    if "browser" in getattr(item, "fixturenames", ()) or (known and ended != stash[ENDED]):
        stash[GOING_ON] = _going_on()
    stash[ENDED] = ended
    computed = times.user + times.system + ended + stash.get(GOING_ON, 0.0)
    report.computed = computed - stash[COMPUTED]
    stash[COMPUTED] = computed
    return report


def _going_on() -> float:
    """Return how long the processes that this one has started, and that have not ended, have computed so far [s]."""
    taken = 0.0
    with suppress(ImportError):
        import psutil

        for process in psutil.Process().children(recursive=True):
            with suppress(psutil.Error):
                taken += sum(process.cpu_times()[:4])
    return taken


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    """Write how long test functions computed with all of their parameters, the longest first."""
    if path := config.getoption("--record"):
        seconds = Counter[str]()
        for report in (report for reports in terminalreporter.stats.values() for report in reports):
            if hasattr(report, "computed"):
                seconds[_function(report.nodeid)] += report.computed
        path.parent.mkdir(parents=True, exist_ok=True)
        lines = (f"{taken:7.2f} {name}\n" for name, taken in seconds.most_common() if taken > QUICK)
        path.write_text("".join(lines), encoding="utf-8")


def _function(nodeid: str) -> str:
    """Return the name of a test without its parameters."""
    return nodeid.partition("[")[0]


def pytest_configure(config: pytest.Config) -> None:
    """Let "auto" be the solver asked for."""
    if name := config.getoption("--solver"):
        factorization.automatic = lambda: str(name)
    # Hypothesis since 6.131 also draws constants from all modules that happen to be loaded, so that a test's examples
    # would depend on the tests before it in the same process; it has no setting for that
    with suppress(ImportError, AttributeError):
        from hypothesis.internal.conjecture import providers

        nothing = providers._local_constants
        providers._get_local_constants = lambda: nothing


@pytest.fixture
def interruptible() -> Iterator[None]:
    """Let Ctrl-C end the processes that a test starts, also where a shell runs the tests in the background.

    Such a shell has them ignore it, and a process ignores what the one that starts it ignores.
    """
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)
