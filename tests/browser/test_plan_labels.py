"""The picture of a result in a real browser: labels that cover nothing, a section by one drag, the full width."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.browsing import Bench, Server

pytestmark = pytest.mark.slow

LOADS = "".join(
    f'[[loads]]\nkind = "point"\nx = "{x / 4 - 2.875} m"\ny = "{y / 4 - 1.875} m"\nP = "{10 + x + y} kN"\n\n'
    for x in range(24)
    for y in range(16)
)
#: How many pairs of labels cover each other by more than the rounding of a font's size, and the labels.
COVERED = """() => {
  const labels = [...document.querySelectorAll(".result .gs-overlay .moving .label")];
  const boxes = labels.map((label) => label.getBoundingClientRect());
  let covered = 0;
  boxes.forEach((a, i) => boxes.slice(i + 1).forEach((b) => {
    if (a.left + 1 < b.right && b.left + 1 < a.right && a.top + 1 < b.bottom && b.top + 1 < a.bottom) covered += 1;
  }));
  return { covered, texts: labels.map((label) => label.textContent) };
}"""
ELEMENTS = "document.querySelectorAll('.result .gs-overlay .moving *').length"


def test_labels_of_hundreds_of_loads_cover_none(server: Server, bench: Bench, case: Path) -> None:
    """384 loads have labels where there is space, drawn as few elements; both extremes are named, and numbers shown."""
    case.write_text(case.read_text().replace("[mesh]", f"{LOADS}[mesh]"))
    bench.open(server.start(case))
    bench.wait_solved()
    seen: dict[str, object] = {}

    def is_drawn() -> bool:
        seen.update(bench.page.evaluate(COVERED))
        return any(str(text).startswith("P = ") for text in seen["texts"])  # type: ignore[attr-defined]

    bench.until(is_drawn)
    texts = seen["texts"]
    assert isinstance(texts, list)
    assert seen["covered"] == 0
    assert {text.split(" ")[0] for text in texts} >= {"max", "min", "P"}
    assert 10 < len(texts) < 384
    assert bench.page.evaluate(ELEMENTS) < len(texts) + 80
    bench.page.get_by_role("button", name="Numbers").click()
    numbers = bench.page.locator(".result .gs-overlay .number")
    bench.wait_equal(numbers.count, 0)


def test_a_section_is_cut_by_one_drag_and_results_take_the_full_width(server: Server, bench: Bench, case: Path) -> None:
    """A drag between two points cuts a section and moves nothing; F hides the model and shows it again."""
    bench.open(server.start(case))
    bench.wait_solved()
    page = bench.page
    page.locator(".stage-bar").get_by_role("button", name="Section", exact=True).click()
    plan = page.locator(".result .gs-plan")
    box = plan.bounding_box()
    assert box is not None
    middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    ruler = page.locator(".result .gs-overlay .figure").first.text_content()
    page.mouse.move(middle[0] - 80, middle[1])
    page.mouse.down()
    page.mouse.move(middle[0] + 20, middle[1], steps=4)
    page.mouse.move(middle[0] + 80, middle[1] + 3)
    page.keyboard.down("Shift")
    page.mouse.move(middle[0] + 90, middle[1] + 4)
    page.mouse.up()
    page.keyboard.up("Shift")
    title = page.locator(".chart-bar .gs-chart-title")
    bench.until(lambda: " to (" in title.inner_text(), title.inner_text)
    ends = [text.split(", ")[1] for text in title.inner_text().split("along ")[1].replace(")", "").split(" to ")]
    assert ends[0].split(" ")[0] == ends[1].split(" ")[0]
    bench.wait_equal(page.locator(".gs-overlay .cut").count, 1)
    assert page.locator(".result .gs-overlay .figure").first.text_content() == ruler
    half = box["width"]
    page.keyboard.press("f")
    bench.until(lambda: (plan.bounding_box() or {"width": 0})["width"] > 1.5 * half)
    assert page.locator(".model").is_hidden()
    page.keyboard.press("F")
    bench.until(lambda: page.locator(".model").is_visible())
