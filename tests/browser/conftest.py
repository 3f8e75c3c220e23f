"""Fixtures for tests in a browser, and a loud line where there is none."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from helpers.browsing import ARGUMENTS, PATIENCE, SMALL, Bench, Server, SharedServer, chromium, missing
from helpers.firefox import missing_firefox

SCREEN = {"width": 1366, "height": 768}


def pytest_terminal_summary(terminalreporter: Any) -> None:
    """Say loudly that the page was not tried."""
    if missing():
        terminalreporter.write_line(f"THE TESTS IN A BROWSER DID NOT RUN: {missing()}", red=True, bold=True)
    if missing_firefox():
        terminalreporter.write_line(f"THE TEST IN FIREFOX DID NOT RUN: {missing_firefox()}", red=True, bold=True)


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """A browser without a window; skips where there is none."""
    if missing():
        pytest.skip(f"THE TESTS IN A BROWSER DID NOT RUN: {missing()}")
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium(), args=ARGUMENTS)
        yield browser
        browser.close()


@pytest.fixture(scope="session")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """The workbench that shows each test's own case."""
    server = SharedServer(tmp_path_factory.mktemp("server"))
    yield server
    server.stop()


@pytest.fixture
def own_server(tmp_path: Path) -> Iterator[Server]:
    """A server for one test, which may end it; it is not started yet."""
    server = Server(tmp_path / "state")
    yield server
    server.stop()


@pytest.fixture
def case(tmp_path: Path) -> Path:
    """A case file of a small slab."""
    path = tmp_path / "slab.toml"
    path.write_text(SMALL)
    return path


@dataclass
class Tab:
    """A tab, whose errors the test collects."""

    page: Any
    bench: Bench | None = None

    def begin(self) -> Bench:
        """Return the tab, whose errors the present test collects."""
        self.page.set_viewport_size(SCREEN)
        self.bench = Bench(self.page)
        return self.bench

    def listen(self) -> None:
        """Tell the present test of errors of the page."""
        self.page.on("pageerror", lambda error: self._add(str(error)))
        self.page.on("console", lambda line: self._add(line.text) if _is_error(line) else None)

    def _add(self, error: str) -> None:
        if self.bench is not None:
            self.bench.errors.append(error)


def _new_context(browser: Any) -> Any:
    """Return a new context, in which the tour was taken."""
    context = browser.new_context(viewport=SCREEN, accept_downloads=True)
    context.set_default_timeout(PATIENCE)
    context.add_init_script("try { localStorage.setItem('groundslab-tour', 'taken'); } catch {}")
    return context


@pytest.fixture
def tabs(browser: Any) -> Iterator[Any]:
    """Return what opens a new tab; errors on the page fail the test in the end."""
    context = _new_context(browser)
    benches: list[Bench] = []

    def open_tab() -> Bench:
        tab = Tab(context.new_page())
        tab.listen()
        benches.append(tab.begin())
        return benches[-1]

    yield open_tab
    errors = [error for bench in benches for error in bench.errors]
    context.close()
    assert errors == []


def _is_error(line: Any) -> bool:
    """Whether a line of the console tells of an error of the page; a server that is away is none."""
    return line.type == "error" and not re.search(r"net::ERR_|Failed to load resource", line.text)


@pytest.fixture
def bench(tabs: Any) -> Bench:
    """One tab, which no test before has left anything in; errors on the page fail the test in the end."""
    opened: Bench = tabs()
    return opened


@pytest.fixture
def own_bench(tabs: Any) -> Bench:
    """A tab of the test's own, in which it may run scripts before those of the page."""
    opened: Bench = tabs()
    return opened
