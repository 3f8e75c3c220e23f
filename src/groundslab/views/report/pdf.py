"""The report's page as PDF, printed by a browser of the machine that Playwright drives."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager, ExitStack
from typing import TYPE_CHECKING, Any

from groundslab.errors import InputError, Issue
from groundslab.optional import import_optional

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page, Playwright

#: Browsers by the names of their programs, and by those that Playwright knows installed ones by.
PROGRAMS, CHANNELS = ("chromium", "chromium-browser", "google-chrome", "microsoft-edge"), ("msedge", "chrome")
#: What is folded on the screen begins with this; its words are escaped, so that nothing else does.
FOLDED = '<details class="folded"'
INSTEAD = "a report without the ending .pdf opens in any browser, which can print it"


class Printer:
    """A browser that starts, and opens an empty page, while the report is made; it prints in a thread of its own.

    Playwright refuses to wait where an event loop runs, such as in a notebook, and is used by the thread that started
    it.
    """

    def __init__(self) -> None:
        started_by = _import_playwright().sync_playwright
        self._thread = ThreadPoolExecutor(1)
        self._open = ExitStack()
        self._browser = self._thread.submit(self._start, started_by)
        self._page = self._thread.submit(self._open_page)

    def __enter__(self) -> Printer:
        """Return the printer."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close the browser."""
        self._thread.submit(self._open.close).result()
        self._thread.shutdown()

    def wait(self) -> None:
        """Return when the browser is there; raise InputError if there is none, or Playwright is missing."""
        self._browser.result()

    def print_page(self, html: str) -> bytes:
        """Return a page as PDF, its headings as bookmarks."""
        return self._thread.submit(_print, self._page.result(), html).result()

    def _start(self, started_by: Callable[[], AbstractContextManager[Playwright]]) -> Browser:
        playwright = self._open.enter_context(started_by())
        return self._open.enter_context(_launch(playwright))

    def _open_page(self) -> Page:
        return self._browser.result().new_page(java_script_enabled=False, offline=True)


def unfold(html: str) -> str:
    """Return a page with all of its tables open: on paper nothing can be."""
    return html.replace(FOLDED, f"{FOLDED} open")


def _print(page: Page, html: str) -> bytes:
    """Return a page as PDF, written into one of the browser."""
    page.set_content(unfold(html))
    return page.pdf(prefer_css_page_size=True, print_background=True, outline=True, tagged=True)


def _import_playwright() -> Any:
    return import_optional("playwright.sync_api", "which prints by a browser", "pdf", INSTEAD)


def _launch(playwright: Playwright) -> Browser:
    """Return the first browser that can be started."""
    from playwright.sync_api import Error

    for way in _ways():
        try:
            return playwright.chromium.launch(**way)
        except Error:
            continue
    hint = f"install one of them; {INSTEAD}"
    raise InputError([Issue("browser", "none that can be started", "Edge, Chrome or Chromium", hint)])


def _ways() -> Iterator[dict[str, Any]]:
    """Yield how browsers may be started: programs on the path, installed ones, and Playwright's own."""
    yield from ({"executable_path": path} for path in map(shutil.which, PROGRAMS) if path)
    yield from ({"channel": channel} for channel in CHANNELS)
    yield {}
