"""Fixtures for tests in a browser, and a loud line where there is none."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

from helpers.browsing import ARGUMENTS, PATIENCE, SMALL, Bench, Server, SharedServer, chromium, missing
from helpers.firefox import missing_firefox


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


@pytest.fixture(scope="session")
def window(browser: Any) -> Iterator[Any]:
    """The window of all tabs; its first one, of no test, keeps the process of the pages, which takes long to start."""
    context = browser.new_context(viewport={"width": 1366, "height": 768}, accept_downloads=True)
    context.set_default_timeout(PATIENCE)
    context.add_init_script("try { localStorage.setItem('groundslab-tour', 'taken'); } catch {}")
    context.new_page()
    yield context
    context.close()


@pytest.fixture
def tabs(window: Any, server: Server) -> Iterator[Any]:
    """Return what opens a new tab; errors on the page fail the test in the end."""
    benches: list[Bench] = []
    sites: set[str] = set()

    def open_tab() -> Bench:
        bench = Bench(window.new_page())
        bench.page.on("framenavigated", lambda frame: sites.add(_site(frame.url)))
        bench.page.on("pageerror", lambda error: bench.errors.append(str(error)))
        bench.page.on("console", lambda line: bench.errors.append(line.text) if _is_error(line) else None)
        benches.append(bench)
        return bench

    yield open_tab
    errors = [error for bench in benches for error in bench.errors]
    first, *others = window.pages
    if server.url and first.url == "about:blank":
        first.goto(f"{_site(server.url)}/icon.svg")
    for page in others:
        page.close()
    _forget(first, sites)
    assert errors == []


def _site(url: str) -> str:
    """Return the part of an address to which the browser's memory belongs."""
    parts = urlsplit(url)
    return f"{parts.scheme}://{parts.netloc}"


def _forget(page: Any, sites: Iterable[str]) -> None:
    """Make the browser forget what sites have stored."""
    session = page.context.new_cdp_session(page)
    for site in sites:
        session.send("Storage.clearDataForOrigin", {"origin": site, "storageTypes": "all"})
    session.detach()


def _is_error(line: Any) -> bool:
    """Whether a line of the console tells of an error of the page; a server that is away is none."""
    return line.type == "error" and not re.search(r"net::ERR_|Failed to load resource", line.text)


@pytest.fixture
def bench(tabs: Any) -> Bench:
    """One tab."""
    opened: Bench = tabs()
    return opened
