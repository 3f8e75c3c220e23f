"""An option for all tests: the direct solver that stands for "auto"; a fixture for tests that interrupt processes."""

from __future__ import annotations

import signal
from collections.abc import Iterator

import pytest

from groundslab.solvers import factorization


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add --solver, with which the tests run as where another solver is all that there is."""
    parser.addoption("--solver", choices=["pardiso", "cholmod", "superlu"], help='the solver that "auto" takes')


def pytest_configure(config: pytest.Config) -> None:
    """Let "auto" be the solver asked for."""
    if name := config.getoption("--solver"):
        factorization.automatic = lambda: str(name)


@pytest.fixture
def interruptible() -> Iterator[None]:
    """Let Ctrl-C end the processes that a test starts, also where a shell runs the tests in the background.

    Such a shell has them ignore it, and a process ignores what the one that starts it ignores.
    """
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)
