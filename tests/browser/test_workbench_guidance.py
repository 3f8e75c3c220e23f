"""Guidance: repairs of issues, the meaning of fields, examples, the documentation, the tour, a focus that is seen."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from helpers.accessibility import AXE, find_violations
from helpers.browsing import PATIENCE, SMALL, Bench, Server
from helpers.paths import ROOT

HELP = ROOT / "src" / "groundslab" / "workbench" / "help" / "static"
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not HELP.is_dir(), reason="documentation and examples are not copied (make pages)"),
]
WRONG = SMALL.replace("thickness =", "thicknes =") + '\n[beyond]\nwidth = "2 m"\n'


@pytest.fixture
def newcomer(browser: Any) -> Iterator[Bench]:
    """A tab of a browser that has never seen the workbench."""
    context = browser.new_context(viewport={"width": 1280, "height": 650})
    context.set_default_timeout(PATIENCE)
    yield Bench(context.new_page())
    context.close()


def check_axe(page: Any, part: str = "html") -> None:
    """Find no violation of the rules of accessibility on a page or a part of it, where axe is installed."""
    if AXE.is_file():
        assert find_violations(page, part) == []


def test_an_issue_is_repaired_with_one_click(server: Server, bench: Bench, case: Path) -> None:
    """Below the field and in the list of issues; the comment stays, and one undo brings the text back."""
    case.write_text(WRONG)
    bench.open(server.start(case, by_itself=False))
    bench.tab("Form")
    bench.wait_seen(".issue-count", "3 errors")  # the missing thickness too
    check_axe(bench.page, ".model")
    bench.page.locator(".form").get_by_role("button", name="Rename to thickness").click()
    bench.wait_text('thickness = "250 mm"  # as on the drawing')
    bench.wait_seen(".issue-count", "1 error")
    bench.page.locator(".issue-list summary").click()
    bench.page.locator(".issue-list").get_by_role("button", name="Remove width").click()
    bench.wait_seen(".issue-count", "No errors")
    assert "width =" not in bench.text()
    undo = bench.page.get_by_role("button", name="undo")
    bench.until(lambda: "remove width" in undo.get_attribute("title"))
    undo.click()
    bench.wait_text('width = "2 m"')
    undo.click()
    bench.wait_text("thicknes =")
    assert bench.text() == WRONG


COVERED = """() => {
  const field = document.activeElement.getBoundingClientRect();
  const help = document.querySelector('.field-help:not([hidden])')?.getBoundingClientRect();
  return help !== undefined && field.bottom > help.top && field.top < help.bottom;
}"""


def test_a_field_with_the_focus_is_explained(server: Server, bench: Bench, case: Path) -> None:
    """Meaning, unit and range stand at the foot with a drawing, never over the field, and are read out with it."""
    bench.page.set_viewport_size({"width": 1280, "height": 650})
    bench.open(server.start(case, by_itself=False))
    bench.tab("Form")
    thickness = bench.field("plate", "thickness").locator("input")
    thickness.focus()
    panel = bench.page.locator(".panel:not([hidden]) .field-help")
    panel.get_by_text("length, such as 0.4 m").wait_for()
    bench.wait_equal(panel.locator(".lit text").text_content, "t")
    described = thickness.get_attribute("aria-describedby").split()[0]
    assert "thickness" in bench.page.locator(f"#{described}").inner_text().lower()
    check_axe(bench.page, ".model")
    for _ in range(25):
        bench.page.keyboard.press("Tab")
        assert not bench.page.evaluate(COVERED)
    thickness.focus()
    panel.get_by_role("button", name="hide field help").click()
    bench.field("plate", "E").locator("input").focus()
    panel.wait_for(state="hidden")


def test_f1_opens_the_place_of_a_key(server: Server, bench: Bench, case: Path) -> None:
    """The documentation opens in a tab of its own, from this server, at the row of the key; its links work."""
    bench.open(server.start(case, by_itself=False))
    bench.tab("Form")
    bench.field("ground", "k").locator("input").focus()
    with bench.page.context.expect_page() as opened:
        bench.page.keyboard.press("F1")
    page = opened.value
    row = page.locator("tr:target")
    row.wait_for()
    assert "ground.k" in row.inner_text()
    assert row.evaluate("row => { const { top } = row.getBoundingClientRect(); return top >= 0 && top < innerHeight; }")
    check_axe(page, "tr:target")
    page.get_by_role("link", name="The workbench", exact=True).click()
    page.get_by_role("heading", name="The workbench").wait_for()
    check_axe(page)
    assert page.url.startswith(f"http://127.0.0.1:{server.port}/docs/workbench")


def test_a_new_case_from_an_example(server: Server, bench: Bench) -> None:
    """The list has a picture and a line about each; the case opened is the file to the byte, without a name."""
    bench.open(server.start(None, by_itself=False))
    bench.page.get_by_role("button", name="New", exact=True).click()
    dialog = bench.page.get_by_role("dialog", name="New case")
    cards = dialog.get_by_role("list", name="examples").get_by_role("button")
    cards.first.wait_for()
    bench.wait_equal(cards.count, len(list((ROOT / "examples").glob("*.toml"))))
    bench.until(lambda: dialog.locator(".thumbnail .slab").count() >= cards.count())
    check_axe(bench.page, "dialog[open]")
    dialog.get_by_role("button", name="Slab over a cavity").press("Enter")
    bench.wait_text('title = "Slab over a cavity"')
    assert bench.text() == (ROOT / "examples" / "void.toml").read_text()
    bench.wait_equal(bench.page.locator(".file-title").inner_text, "untitled")


def test_a_new_case_is_seen_entirely(server: Server, bench: Bench, case: Path) -> None:
    """Whatever the zoom of the case before was, in plan and result; what was left is not offered again."""
    bench.open(server.start(case))
    bench.wait_solved()

    def start_again() -> str:
        bench.page.get_by_role("button", name="New", exact=True).click()
        bench.page.get_by_role("button", name="Empty").click()
        leave = bench.page.get_by_role("button", name="Don't save")
        bench.until(lambda: leave.is_visible() or bench.seen(".file-title") == "untitled")
        if leave.is_visible():
            leave.click()
        bench.wait_equal(bench.page.locator(".file-title").inner_text, "untitled")
        bench.wait_solved()
        return str(bench.page.locator(".drawing").get_attribute("data-view"))

    whole = start_again()
    picture = bench.page.locator(".result .stage-place")
    seen = bench.still(picture)
    for selector in (".drawing", ".result .stage-place"):
        box = bench.page.locator(selector).bounding_box()
        bench.page.mouse.move(box["x"] + box["width"] / 3, box["y"] + box["height"] / 3)
        bench.page.mouse.wheel(0, -600)
    bench.until(lambda: bench.page.locator(".drawing").get_attribute("data-view") != whole)
    bench.tab("Text")
    bench.page.locator(".code-input").fill(bench.text() + "\n# changed\n")
    bench.page.wait_for_selector(".unsaved:not(:empty)")
    bench.tab("Plan")
    assert bench.still(picture) != seen
    start_again()
    bench.wait_equal(lambda: bench.page.locator(".drawing").get_attribute("data-view"), whole)
    assert bench.page.get_by_role("dialog").count() == 0
    bench.page.mouse.move(0, 0)
    assert bench.still(picture) == seen


PLACES = """() => {
  const [spot, box] = ['.tour-spot', '.tour-box'].map((each) => document.querySelector(each).getBoundingClientRect());
  const apart = box.left >= spot.right || box.right <= spot.left || box.top >= spot.bottom || box.bottom <= spot.top;
  const inside = box.left >= 0 && box.top >= 0 && box.right <= innerWidth && box.bottom <= innerHeight;
  return { apart, inside, corner: [spot.left, spot.top] };
}"""


def stands_beside(page: Any, control: str) -> bool:
    """Return whether the tour's box is on the page, beside its spot, and that is around a control."""
    places, box = page.evaluate(PLACES), page.locator(control).bounding_box()
    is_around = (box["x"] - 4, box["y"] - 4) == pytest.approx(places["corner"], abs=1)
    return bool(places["apart"] and places["inside"] and is_around)


def test_the_tour_at_the_first_start(server: Server, newcomer: Bench, case: Path) -> None:
    """Five steps by keyboard, each beside its control; it comes once, and again from the list of keys."""
    page = newcomer.open(server.start(case)).page
    dialog = page.locator("dialog.tour")
    titles = {
        "Draw the slab": '.tool[data-tool="slab"]',
        "Describe the ground": '[data-section="ground"] > summary',
        "Add loads": '.tool[data-tool="point load"]',
        "Solve and review the results": ".solve",
        "Save and export": ".top .export",
    }
    for number, (title, control) in enumerate(titles.items(), start=1):
        dialog.get_by_role("heading", name=title).wait_for()
        newcomer.until(lambda number=number: f"{number} of 5" in dialog.inner_text(), dialog.inner_text)
        newcomer.until(lambda control=control: stands_beside(page, control), lambda: str(page.evaluate(PLACES)))
        if number == 1:
            check_axe(page, "dialog.tour")
        page.keyboard.press("Enter")
    dialog.wait_for(state="detached")
    newcomer.open(page.url)
    assert dialog.count() == 0
    page.locator(".drawing").press("?")
    page.get_by_role("button", name="Tour").click()
    dialog.get_by_role("heading", name="Draw the slab").wait_for()
    page.keyboard.press("Escape")
    dialog.wait_for(state="detached")


MARKED = """() => {
  const each = document.activeElement;
  if (each === document.body) return "";
  // a switch shows the focus at its knob
  const marks = [each, each.nextElementSibling].filter((node) => node !== null).map((node) => getComputedStyle(node));
  const isMarked = ({ outlineStyle, outlineWidth, boxShadow }) =>
    (outlineStyle !== "none" && parseFloat(outlineWidth) > 0) || boxShadow !== "none";
  return marks.some(isMarked) ? "" : each.outerHTML.slice(0, 120);
}"""


def test_the_focus_is_seen_everywhere(server: Server, bench: Bench, case: Path) -> None:
    """Whatever Tab reaches in plan and form has an outline or a shadow while it has the focus."""
    bench.open(server.start(case, by_itself=False))
    for tab in ("Plan", "Form"):
        bench.tab(tab)
        for _ in range(60):
            bench.page.keyboard.press("Tab")
            assert bench.page.evaluate(MARKED) == ""
