"""Pictures of results in a real browser: differences, and what is written beside supports, walls and bars."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.browsing import Bench, Server

pytestmark = pytest.mark.slow

TWO = """
[[cases]]
name = "G"

[[cases]]
name = "Q"

[[loads]]
case = "G"
kind = "uniform"
q = "100 kPa"

[[loads]]
case = "Q"
kind = "uniform"
q = "10 kPa"

[[combinations]]
name = "heavy"
limit_state = "characteristic"
factors = {G = 1.0, Q = 1.0}

[[combinations]]
name = "light"
limit_state = "characteristic"
factors = {G = 1.0}
"""


def open_two(server: Server, bench: Bench, case: Path) -> None:
    """Open a case with two combinations and wait for its results."""
    text = case.read_text().replace('column = "A1"\nP', 'case = "G"\ncolumn = "A1"\nP')
    case.write_text(text + TWO)
    bench.open(server.start(case))
    bench.wait_solved()


def test_a_combination_and_a_reference_are_subtracted(server: Server, bench: Bench, case: Path, tmp_path: Path) -> None:
    """10 kPa on 20 MPa/m settle 0.5 mm; the picture says what minus what, is exported, and follows edits."""
    open_two(server, bench, case)
    page = bench.page
    minus, label = page.get_by_label("Minus", exact=True), page.locator(".difference-over")
    assert label.is_hidden()
    minus.select_option("combination light")
    bench.until(label.is_visible)
    assert label.inner_text() == "1 heavy minus 2 light"
    notes = page.locator(".gs-legend-notes").first
    bench.until(lambda: "max 0.500" in notes.inner_text(), notes.inner_text)
    assert "[mm]" in page.locator(".gs-legend-title").first.inner_text()
    drawn = bench.export("plan.svg", tmp_path)
    assert drawn.name.endswith("-settlement-difference.svg")
    page.get_by_role("button", name="Keep as reference").click()
    minus.locator("option", has_text="minus the reference").wait_for(state="attached")
    minus.select_option("reference")
    bench.wait_equal(label.inner_text, "1 heavy minus the reference")
    bench.until(lambda: "max 0\n" in notes.inner_text(), notes.inner_text)
    bench.tab("Text")
    page.locator(".code-input").fill(bench.text().replace('k = "20 MPa/m"', 'k = "40 MPa/m"'))
    bench.until(lambda: "min \N{MINUS SIGN}" in notes.inner_text(), notes.inner_text)
    assert label.inner_text() == "1 heavy minus the reference"
    minus.select_option("")
    bench.until(label.is_hidden)
