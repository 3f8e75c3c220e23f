"""Help at hand: keys, decimal commas, progress; and the page on small screens."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from helpers.browsing import Bench, Server

pytestmark = pytest.mark.slow


def test_keys_are_listed_and_work(server: Server, bench: Bench, case: Path) -> None:
    """A question mark shows the keys, with those of the tools, and is text where one types; Escape closes the list."""
    bench.open(server.start(case, by_itself=False))
    drawing = bench.page.locator(".drawing")
    drawing.press("?")
    dialog = bench.page.get_by_role("dialog", name="Keyboard shortcuts")
    dialog.get_by_text("Point load", exact=True).wait_for()
    bench.page.keyboard.press("Escape")
    dialog.wait_for(state="detached")
    bench.tab("Form")
    bench.field("title").locator("input").focus()
    bench.page.keyboard.type("?")
    assert dialog.count() == 0


def test_a_decimal_comma_and_a_bare_number(server: Server, bench: Bench, case: Path) -> None:
    """The file gets a point and the unit that stood there, the field shows both; what may be thousands is refused."""
    bench.open(server.start(case, by_itself=False))
    bench.tab("Form")
    thickness = bench.field("plate", "thickness").locator("input")
    thickness.fill("312,5")
    thickness.press("Tab")
    bench.wait_text('thickness = "312.5 mm"  # as on the drawing')
    bench.wait_equal(thickness.input_value, "312.5 mm")
    bench.fill("1,500", "plate", "thickness")
    bench.wait_seen(".issue-count", "1 error")
    assert 'thickness = "1,500"' in bench.text()


def find_overflow(page: Any) -> list[str]:
    """Return what does not fit on the page: the page itself, and children of the bar beyond it or on a second line."""
    found: list[str] = page.evaluate(
        """() => {
          const { scrollWidth, clientWidth, scrollHeight, clientHeight } = document.documentElement;
          const found = scrollWidth > clientWidth || scrollHeight > clientHeight ? ["the page"] : [];
          const bar = document.querySelector(".top").getBoundingClientRect();
          for (const each of document.querySelectorAll(".top > *, .top button, .top a")) {
            const box = each.getBoundingClientRect();
            const isOut = box.left < 0 || box.right > clientWidth || box.top < bar.top || box.bottom > bar.bottom;
            if (isOut || box.height > 40) found.push(each.outerHTML.slice(0, 80));
          }
          return found;
        }"""
    )
    return found


def test_small_screens_hold_the_page(server: Server, bench: Bench, case: Path) -> None:
    """Nothing of the bar wraps or is cut off, and the page itself does not scroll."""
    bench.open(server.start(case))
    bench.wait_solved()
    for width, height in ((1280, 650), (1024, 768)):
        bench.page.set_viewport_size({"width": width, "height": height})
        bench.wait_equal(lambda: find_overflow(bench.page), [])
