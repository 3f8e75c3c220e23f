"""Racks, vehicles and columns on axes, made by numbers in a real browser."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.browsing import SMALL, Bench, Server

pytestmark = pytest.mark.slow


def test_twelve_legs_are_one_step(server: Server, bench: Bench, case: Path) -> None:
    """A key opens the dialog, the plan shows the legs, one change adds them, and one undo takes them away."""
    bench.open(server.start(case, by_itself=False))
    page, drawing = bench.page, bench.page.locator(".drawing")
    drawing.focus()
    drawing.press("k")
    dialog = page.get_by_role("dialog", name="Racks")
    dialog.get_by_label("load per leg").fill("62,5")
    dialog.get_by_label("bay width").fill("0.8")
    dialog.get_by_label("first leg x").fill("-2 m")
    bench.until(lambda: "12 legs." in dialog.inner_text(), dialog.inner_text)
    bench.until(lambda: page.evaluate("document.querySelector('.drawing .ghosts').childElementCount") > 0)
    dialog.get_by_label("bays").fill("none")
    bench.until(lambda: 'found "none", expected a whole number' in dialog.inner_text(), dialog.inner_text)
    bench.until(dialog.get_by_role("button", name="Racks").is_disabled)
    dialog.get_by_label("bays").fill("5")
    page.keyboard.press("Enter")
    bench.wait_text('P = "62.5 kN"', "frames = 6", 'pattern = "rack"', 'case = "racks"')
    # what was there before has a load case of its own now
    assert bench.text().count("[[cases]]") == 2
    bench.solve()
    drawing.press("Control+z")
    bench.until(lambda: "[[patterns]]" not in bench.text() and "[[cases]]" not in bench.text(), bench.text)


def test_a_vehicle_moves_along_a_path(server: Server, bench: Bench, case: Path) -> None:
    """Two axles on a path, each position solved; columns on axes stand where the slab is, and the axes are drawn."""
    start, end = SMALL.index("[[columns]]"), SMALL.index("[[loads]]")
    case.write_text(SMALL[:start] + SMALL[end:].replace('column = "A1"', 'x = "-2 m"\ny = "1 m"'), encoding="utf-8")
    bench.open(server.start(case))
    page = bench.page
    bench.tool("vehicle")
    dialog = page.get_by_role("dialog", name="Vehicle")
    for label, value in (("from x", "-2"), ("to x", "2"), ("wheelbase", "0.8"), ("step", "2")):
        dialog.get_by_label(label).fill(value)
    bench.until(lambda: "3 positions" in dialog.inner_text(), dialog.inner_text)
    dialog.get_by_role("button", name="Vehicle").click()
    bench.wait_text('kind = "vehicle"', 'step = "2 m"')
    bench.wait_solved()
    names = page.locator(".combination-choice").inner_text()
    assert "0.00 m" in names
    assert "4.00 m" in names
    bench.tool("columns")
    dialog = page.get_by_role("dialog", name="Columns")
    for label, value in (
        ("first x", "-2.5"),
        ("first y", "-1.5"),
        ("spacing in x", "2x2,5 5"),
        ("spacing in y", "3"),
    ):
        dialog.get_by_label(label).fill(value)
    bench.until(lambda: "6 columns. 2 outside the slab" in dialog.inner_text(), dialog.inner_text)
    page.keyboard.press("Enter")
    bench.wait_text('name = "C2"')
    # the axes on which they stand
    names = "[...document.querySelectorAll('.axis-label')].map((each) => each.textContent)"
    bench.until(lambda: page.evaluate(names) == ["A", "B", "C", "1", "2"], lambda: str(page.evaluate(names)))
    page.locator(".drawing").press("z")
    bench.until(lambda: page.evaluate(names) == [])
    bench.wait_solved()
