"""The report as PDF: its page, printed by a browser of the machine that Playwright drives."""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Any

from groundslab._version import __version__
from groundslab.errors import InputError, Issue
from groundslab.results.results import CombinationResult, Results
from groundslab.storage import atomic
from groundslab.storage.ownership import check_replaceable
from groundslab.views.report.html import MARK, render_report

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Playwright

    from groundslab.model.outputs import Chapter

#: Browsers by the names of their programs, and by those that Playwright knows installed ones by.
PROGRAMS, CHANNELS = ("chromium", "chromium-browser", "google-chrome", "microsoft-edge"), ("msedge", "chrome")
#: What follows the end of the file, by which it is known.
TAIL = f"% {MARK} "
MISSING = (
    "install Edge, Chrome or Chromium; or open the report that is made without --pdf in any browser, and print that"
)


def write_pdf(
    results: CombinationResult | Results,
    path: str | Path,
    *,
    text: str | None = None,
    file: str = "case.toml",
    chapters: Sequence[Chapter] | None = None,
) -> Path:
    """Write the report of results as PDF, pages numbered, with the headings as bookmarks.

    Parameters
    ----------
    results : CombinationResult or Results
        Results of one or of several combinations.
    path : str or Path
        File to write; an existing file is replaced only if it is such a report.
    text : str, optional
        Text of the case file, which the report quotes; without it, the model is written out.
    file : str, default "case.toml"
        Name of the case file.
    chapters : sequence of str, optional
        The chapters beside the first page; by default those of ``report.chapters`` of the case. The viewer is none of
        them on paper.

    Returns
    -------
    Path
        The path of the report.

    Raises
    ------
    InputError
        If the file cannot be written, or if Playwright (extra `pdf`) or a browser is missing.
    GroundslabError
        If a result is not finite, or this installation lacks the report's script.

    Examples
    --------
    >>> import groundslab
    >>> results = groundslab.solve(groundslab.load("case.toml"))
    >>> path = groundslab.write_pdf(results, "report.pdf")
    """
    target = check(path)
    wanted = render_report(results, text=text, file=file, chapters=_on_paper(results, chapters))
    # in a thread of its own, as Playwright refuses to wait where an event loop runs, such as in a notebook
    with ThreadPoolExecutor(1) as pool:
        content = pool.submit(_print, wanted).result()
    atomic.write(target, content + f"{TAIL}{__version__}\n".encode())
    return Path(path)


def check(path: str | Path) -> Path:
    """Return the full path if a report may be written there as PDF; else raise InputError saying why not."""
    return check_replaceable(path, _is_report, "a report of groundslab")


def _on_paper(results: CombinationResult | Results, chapters: Sequence[Chapter] | None) -> list[Chapter]:
    """Return the chapters without the viewer."""
    return [each for each in (results.model.report.chapters if chapters is None else chapters) if each != "viewer"]


def _print(html: str) -> bytes:
    """Return a page as PDF."""
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        hint = "pip install groundslab[pdf]; or print the report that is made without --pdf from a browser"
        raise InputError([Issue("playwright", "nothing that can be imported", "Playwright", hint)]) from None
    with sync_playwright() as playwright, _launch(playwright) as browser:
        page = browser.new_page(java_script_enabled=False, offline=True)
        page.set_content(html)
        return page.pdf(prefer_css_page_size=True, print_background=True, outline=True, tagged=True)


def _launch(playwright: Playwright) -> Browser:
    """Return the first browser that can be started."""
    from playwright.sync_api import Error

    for way in _ways():
        try:
            return playwright.chromium.launch(**way)
        except Error:
            continue
    raise InputError([Issue("browser", "none that can be started", "Edge, Chrome or Chromium", MISSING)])


def _ways() -> Iterator[dict[str, Any]]:
    """Yield how browsers may be started: programs on the path, installed ones, and Playwright's own."""
    yield from ({"executable_path": found} for found in map(shutil.which, PROGRAMS) if found)
    yield from ({"channel": channel} for channel in CHANNELS)
    yield {}


def _is_report(path: Path) -> bool:
    """Return whether a file is a report that groundslab wrote as PDF."""
    content = path.read_bytes()
    return content.startswith(b"%PDF-") and TAIL.encode() in content[-200:]
