"""What holds for all tests: the solver that stands for "auto", examples that are always the same; interrupts."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import suppress

import pytest

from groundslab.solvers import factorization


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add --solver, with which the tests run as where another solver is all that there is."""
    parser.addoption("--solver", choices=["pardiso", "cholmod", "superlu"], help='the solver that "auto" takes')


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
