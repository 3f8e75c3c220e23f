"""The workbench in Firefox: a case is solved, drawn in, changed and read, with the figures that Chromium shows."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from helpers.browsing import SMALL, Bench, Server
from helpers.firefox import Firefox, missing_firefox, run_firefox

pytestmark = pytest.mark.slow

SOLVED = """document.querySelector(".result-status:is([data-state=fresh], [data-state=failing])") !== null
  && document.querySelector(".result[aria-busy='false'] .result-full:not([hidden])") !== null"""
TEXT = "document.querySelector('.code-input').value"
#: Where a place of the plan is on the screen, in the view that the next frame shows.
PIXEL = """new Promise((done) => requestAnimationFrame(() => {{
  const drawing = document.querySelector(".drawing");
  const {{ left, top, width, height }} = drawing.getBoundingClientRect();
  const [cx, cy, scale] = drawing.dataset.view.split(" ").map(Number);
  done([left + width / 2 + ({x} - cx) * scale, top + height / 2 - ({y} - cy) * scale]);
}}))"""
DESIGN = """
[[cases]]
name = "dead"

[combine]
sets = ["ultimate"]

[reinforcement]
concrete = "C30/37"
steel = "B500B"
bottom = ["40 mm", "50 mm"]
top = ["40 mm", "50 mm"]
"""


@pytest.fixture(scope="module")
def firefox(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Firefox]:
    """Firefox without a window; skips where there is none."""
    if missing_firefox():
        pytest.skip(f"THE TEST IN FIREFOX DID NOT RUN: {missing_firefox()}")
    with run_firefox(tmp_path_factory.mktemp("firefox")) as firefox:
        yield firefox


def test_a_case_in_firefox(server: Server, firefox: Firefox, bench: Bench, case: Path) -> None:
    """What a user does works in Firefox without an error in its console, and its figures read as Chromium's."""
    case.write_text(SMALL.replace('column = "A1"', 'column = "A1"\ncase = "dead"') + DESIGN)
    firefox.open(server.start(case))
    firefox.until("document.querySelector('.drawing[data-view]') !== null")
    firefox.click("dialog.tour button.quiet")  # a new user is offered the tour
    firefox.until(SOLVED)
    assert firefox.read("document.querySelectorAll('.drawing path, .drawing rect').length") > 5

    firefox.click('.tool[data-tool="point load"]')
    firefox.click_at(*firefox.read(PIXEL.format(x=1, y=-1)))
    firefox.until(f"{TEXT}.split('[[loads]]').length === 3")
    firefox.click('.tool[data-tool="select"]')
    firefox.click('[data-path=\'["loads",1,"P"]\'] input')
    firefox.press("Control+a", "7", "5", " ", "k", "N", "Enter")
    firefox.until(f"""{TEXT}.includes('P = "75 kN"')""")
    firefox.until(SOLVED)

    bench.open(server.url)
    for name, rows in (("Summary", ".figures"), ("Checks", ".table-box:not([hidden]) tbody")):
        tab = f"[...document.querySelectorAll('.result [role=tab]')].find((it) => it.textContent.startsWith('{name}'))"
        firefox.click(f"#{firefox.read(f'{tab}.id')}")
        bench.page.locator(".result").get_by_role("tab", name=name).click()
        words = f"[...document.querySelectorAll('.result {rows} tr')].map((row) => row.textContent)"
        shown = firefox.until(f"({words}).length > 1 && {words}")
        bench.wait_equal(lambda words=words: bench.page.evaluate(words), shown)
    firefox.click("button.export")
    firefox.until("document.querySelector('dialog.export-dialog[open]') !== null")
    assert firefox.errors == []
