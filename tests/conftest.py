"""An option for all tests: the direct solver that stands for "auto"."""

from __future__ import annotations

import pytest

from groundslab.solvers import factorization


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add --solver, with which the tests run as where another solver is all that there is."""
    parser.addoption("--solver", choices=["pardiso", "cholmod", "superlu"], help='the solver that "auto" takes')


def pytest_configure(config: pytest.Config) -> None:
    """Let "auto" be the solver asked for."""
    if name := config.getoption("--solver"):
        factorization.automatic = lambda: str(name)
