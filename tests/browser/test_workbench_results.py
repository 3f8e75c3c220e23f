"""The results in a real browser: tables in tabs, what their cells lead to, and what is picked in the picture."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.browsing import Bench, Server
from helpers.two_combinations import open_two

pytestmark = pytest.mark.slow


def test_tables_are_shown_sorted_filtered_and_followed(server: Server, bench: Bench, case: Path) -> None:
    """A tab shows its table; a head sorts, words filter, a cell leads to its combination and its field."""
    open_two(server, bench, case)
    page = bench.page
    result = page.locator(".result")
    result.get_by_role("tab", name="Envelope").click()
    table = page.locator(".result-table:visible")
    table.get_by_text("moment m", exact=False).first.wait_for()
    page.get_by_label("Filter rows").locator("visible=true").fill("pressure")
    bench.wait_seen(".table-count:visible", "of")
    row = table.locator("tbody tr[data-place]").first
    bench.until(lambda: "pressure" in row.inner_text())
    row.get_by_text("light").last.click()  # without the uniform load the slab lifts, and presses more at the corner
    bench.until(lambda: page.get_by_label("Field").input_value() == "pressure")
    chosen = "document.querySelector('.combination-choice').selectedOptions[0].textContent"
    bench.until(lambda: "light" in page.evaluate(chosen))
    bench.wait_equal(page.locator(".gs-overlay .place").count, 1)
    result.get_by_role("tab", name="Combinations").click()
    table.get_by_text("light").first.wait_for()
    head = table.get_by_role("columnheader", name="sum of loads")
    rows = table.locator("tbody tr[data-place]")
    first = {"ascending": "light", "descending": "heavy"}  # 200 kN, and 240 kN more
    for direction, name in first.items():
        head.get_by_role("button").click()
        bench.until(lambda direction=direction: head.get_attribute("aria-sort") == direction)
        bench.until(lambda name=name: rows.first.inner_text().startswith(name), lambda: rows.first.inner_text())


def test_what_is_picked_is_selected_and_marked(server: Server, bench: Bench, case: Path) -> None:
    """A column that is clicked in the result is selected in the model, and its row in the table marks it, too."""
    open_two(server, bench, case)
    page = bench.page
    page.locator(".result").get_by_role("tab", name="Columns").click()
    page.locator(".result-table:visible").get_by_text("A1").first.click()
    bench.wait_seen(".properties h3", "olumn A1")
    page.wait_for_selector(".gs-overlay .selected circle", state="attached")
    page.locator(".drawing").press("Escape")
    bench.until(lambda: page.locator(".gs-overlay .selected").count() == 0)


def test_tabs_are_reached_by_keys_on_a_small_screen(server: Server, bench: Bench, case: Path) -> None:
    """At 1280 x 650 every tab can be reached by arrow keys and is then in view; what has no content is not offered."""
    bench.page.set_viewport_size({"width": 1280, "height": 650})
    open_two(server, bench, case)
    page = bench.page
    tabs = page.locator(".lower [role=tab]:visible")
    names = [text.rstrip("✓") for text in tabs.all_inner_texts()]
    assert "Supports" not in names
    assert {"Combinations", "Envelope", "Columns", "Ground", "Mesh and errors"} <= set(names)
    tabs.first.focus()
    inside = """() => {
        const [tab, bar] = [document.activeElement, document.querySelector('.lower .tabs')];
        const [a, b] = [tab.getBoundingClientRect(), bar.getBoundingClientRect()];
        return [tab.getAttribute('aria-selected'), a.left >= b.left - 1 && a.right <= b.right + 1];
    }"""
    for _ in names:
        page.keyboard.press("ArrowRight")
        bench.until(lambda: page.evaluate(inside) == ["true", True], lambda: str(page.evaluate(inside)))


def test_grounds_without_layers_cannot_be_compared(server: Server, bench: Bench, case: Path) -> None:
    """Springs alone have no continuum to compare them with: that is said in words, and can be tried again."""
    open_two(server, bench, case)
    bench.page.locator(".result").get_by_role("tab", name="Ground").click()
    bench.page.get_by_role("button", name="Compare ground models").click()
    bench.wait_seen(".comparison-words:visible", "without layers of soil")
    bench.page.get_by_role("button", name="Compare ground models").wait_for()


def test_an_alternative_is_taken_into_the_case(server: Server, bench: Bench, case: Path) -> None:
    """Thicknesses are tried beside the solver; one is put into the case as one step of undo."""
    open_two(server, bench, case)
    page = bench.page
    page.locator(".result").get_by_role("tab", name="Alternatives").click()
    page.get_by_role("button", name="Try alternatives").click()
    choice = page.get_by_label("Alternative", exact=True)
    choice.wait_for(timeout=120_000)
    name = next(each for each in choice.locator("option").all_inner_texts() if each.endswith("thicker"))
    page.locator(".result-table:visible").get_by_text("concrete").wait_for()
    choice.select_option(name)
    page.get_by_role("button", name="Take it").click()
    bench.wait_text('thickness = "300 mm"  # as on the drawing')
    page.get_by_role("button", name="Take it").wait_for(state="hidden")
    page.keyboard.press("Control+z")
    bench.wait_text('thickness = "250 mm"  # as on the drawing')


def test_a_section_that_was_cut_is_kept_as_line_and_as_strip(server: Server, bench: Bench, case: Path) -> None:
    """Two clicks cut a section; one button adds it to the case, another a strip, whose moments are a table then."""
    open_two(server, bench, case)
    page = bench.page
    result = page.locator(".result")
    result.get_by_role("button", name="Section", exact=True).click()
    box = page.locator(".gs-plan").bounding_box()
    for share in (0.4, 0.6):
        page.mouse.click(box["x"] + share * box["width"], box["y"] + 0.5 * box["height"])
    result.get_by_role("button", name="Add section line").click()
    bench.wait_text("[[output.lines]]", 'name = "line 1"')
    result.get_by_label("Width of the strip").fill("1.5 m")
    result.get_by_role("button", name="Add strip").click()
    bench.wait_text("[[output.strips]]", 'name = "strip 1"', 'width = "1.5 m"')
    bench.wait_solved()
    result.get_by_role("tab", name="Strips").click()
    page.locator(".result-table:visible").get_by_text("strip 1").first.wait_for()


def test_a_reference_stands_beside_the_next_result(server: Server, bench: Bench, case: Path) -> None:
    """A kept result is compared with that of a thicker slab; both figures are those that each summary showed."""
    open_two(server, bench, case)
    page = bench.page
    before = bench.largest("largest settlement")
    page.get_by_role("button", name="Keep as reference").click()
    bench.click(2.9, 1.9)  # the slab
    bench.fill("350 mm", "plate", "thickness")
    page.keyboard.press("Tab")
    bench.wait_text('"350 mm"')
    bench.wait_solved()
    after = bench.largest("largest settlement")
    assert after != before
    page.locator(".result").get_by_role("tab", name="Reference").click()
    cells = (
        page.locator(".certificates:visible tr", has_text="largest settlement").first.locator("td").all_inner_texts()
    )
    assert [float(text) for text in cells[:2]] == [before, after]
    # the picture of the reference has its own scale
    picture = page.get_by_role("button", name="Show reference")
    largest = "parseFloat(document.querySelector('.gs-scale').textContent.match(/max ([\\d.]+)/)[1])"
    now = page.evaluate(largest)
    picture.click()
    bench.wait_equal(lambda: page.evaluate(largest), pytest.approx(before, rel=1e-3))
    bench.wait_equal(page.locator(".preview-over:visible").inner_text, "Reference")
    picture.click()
    bench.wait_equal(lambda: page.evaluate(largest), now)
    assert cells[3] == f"{100 * (after - before) / before:+.1f} %".replace("-", "\N{MINUS SIGN}")


def test_results_in_customary_units(server: Server, bench: Bench, case: Path) -> None:
    """A case that asks for US units has kip in tables and feet in the picture; what is typed keeps its own units."""
    case.write_text(case.read_text() + '\n[project]\nunits = "US"\n')
    bench.open(server.start(case))
    bench.wait_solved()
    page = bench.page
    result = page.locator(".result")
    result.get_by_role("tab", name="Combinations").click()
    heads = page.locator(".result-table:visible thead")
    bench.until(lambda: "[kip]" in heads.inner_text(), heads.inner_text)
    assert "[in]" in heads.inner_text()
    figures = page.locator(".result .gs-overlay .figure")
    bench.until(lambda: "x [ft]" in figures.all_inner_texts() or "x [ft]" in figures.all_text_contents())
    assert "[in]" in page.locator(".gs-legend-title").first.inner_text()
    page.locator(".result .gs-plan, .result canvas").first.click(position={"x": 200, "y": 150})
    bench.until(lambda: " ft, y " in page.locator(".gs-values-at").first.inner_text())
