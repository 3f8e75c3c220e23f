"""The plan on a tablet: a finger selects, drags and moves the view, two zoom."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from helpers.browsing import PATIENCE, Bench, Server

pytestmark = pytest.mark.slow

STEPS = 8


def test_fingers_select_drag_move_and_zoom(server: Server, browser: Any, case: Path) -> None:
    """Each gesture does what it does on other plans; on 1024 x 768 no button is cut off."""
    context = browser.new_context(has_touch=True, viewport={"width": 1024, "height": 768})
    context.set_default_timeout(PATIENCE)
    context.add_init_script("try { localStorage.setItem('groundslab-tour', 'taken'); } catch {}")
    page = context.new_page()
    bench = Bench(page).open(server.start(case))
    bench.wait_solved()
    session = context.new_cdp_session(page)

    def drag(*fingers: tuple[tuple[float, float], tuple[float, float]]) -> None:
        """Move fingers from one pixel to another each."""
        for step in range(STEPS + 1):
            places = [[a + (b - a) * step / STEPS for a, b in zip(*finger, strict=True)] for finger in fingers]
            kind = "touchStart" if step == 0 else "touchMove"
            points = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(places)]
            session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        session.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    def view() -> list[float]:
        """Return the middle of what is seen [m], and the pixels of a meter."""
        return [float(word) for word in page.locator(".drawing").get_attribute("data-view").split()]

    page.touchscreen.tap(*bench.pixel(-2, 1))
    bench.wait_seen(".property-head h3", "olumn A1")
    cut = """() => [...document.querySelectorAll(".property-head button, .stage-bar button, .top button")]
        .filter((each) => each.checkVisibility() && each.getBoundingClientRect().right > (
            each.closest(".model") ? document.querySelector(".model") : document.body).getBoundingClientRect().right)
        .map((each) => each.textContent)"""
    bench.wait_equal(lambda: page.evaluate(cut), [])
    drag((bench.pixel(-2, 1), bench.pixel(-1, 0)))
    bench.wait_seen(".last-edit", "move column A1")
    column = tomllib.loads(bench.text())["columns"][0]
    assert abs(float(column["x"].split()[0]) + 1) < 0.3
    assert abs(float(column["y"].split()[0])) < 0.3

    x, y, scale = view()
    start = bench.pixel(2, -1)
    drag((start, (start[0] - 40, start[1])))
    bench.until(lambda: abs(view()[0] - x - 40 / scale) < 0.3, lambda: str(view()))
    assert view()[1:] == [y, scale]
    middle = bench.pixel(1, 0)
    left, right = (middle[0] - 30, middle[1]), (middle[0] + 30, middle[1])
    drag((left, (left[0] - 30, left[1])), (right, (right[0] + 30, right[1])))
    bench.until(lambda: view()[2] > 1.5 * scale, lambda: str(view()))
    context.close()
