"""Places of generated loads picked in the plan, classes of forklifts, and distances, in a real browser."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.browsing import Bench, Server

pytestmark = pytest.mark.slow

POLYGON = """
[[plate.openings]]
kind = "polygon"
points = [["1 m", "-0.5 m"], ["2 m", "-0.5 m"], ["2 m", "0.5 m"], ["1 m", "0.5 m"]]
"""

DISTANCES = """() => [...document.querySelectorAll('.drawing .dimension')].map((each) => each.textContent).sort()"""


def test_twelve_legs_take_few_actions_with_the_mouse(server: Server, bench: Bench, case: Path) -> None:
    """Two fields, one click on the plan and one on the button; one undo takes all legs away."""
    bench.open(server.start(case, by_itself=False))
    page = bench.page
    page.get_by_role("button", name="Racks").click()
    dialog = page.get_by_role("dialog", name="Racks")
    dialog.get_by_label("bay width").fill("0,8")
    dialog.get_by_role("button", name="Pick on plan").click()
    bench.click(-2, -1)
    bench.wait_equal(dialog.get_by_label("first leg x").input_value, "-2 m")
    bench.wait_equal(dialog.get_by_label("first leg y").input_value, "-1 m")
    # nothing was selected by that click, and Enter makes what is shown
    bench.until(lambda: "12 legs." in dialog.inner_text(), dialog.inner_text)
    page.keyboard.press("Enter")
    bench.wait_text('pattern = "rack"', '"-2 m"', "frames = 6")
    page.locator(".drawing").press("Control+z")
    bench.until(lambda: "rack" not in bench.text(), bench.text)


def test_a_forklift_of_a_class_drives_from_place_to_place(server: Server, bench: Bench, case: Path) -> None:
    """A class fills in the fields, wrong values are marked, two clicks are the path, Escape ends picking and dialog."""
    bench.open(server.start(case, by_itself=False))
    page = bench.page
    page.get_by_role("button", name="Vehicle").click()
    dialog = page.get_by_role("dialog", name="Vehicle")
    forklift, front = dialog.get_by_label("forklift"), dialog.get_by_label("front axle")
    forklift.select_option("FL2")
    bench.wait_equal(front.input_value, "40 kN")
    bench.wait_equal(dialog.get_by_label("track width").input_value, "0.95 m")
    front.fill("much")
    bench.wait_equal(forklift.input_value, "custom")
    bench.wait_equal(lambda: front.get_attribute("aria-invalid"), "true")
    bench.until(lambda: 'front axle: found "much"' in dialog.inner_text(), dialog.inner_text)
    forklift.select_option("FL2")
    bench.wait_equal(lambda: front.get_attribute("aria-invalid"), "false")
    dialog.get_by_role("button", name="Pick on plan").click()
    bench.click(-2, -1)
    bench.click(2, 1)
    bench.wait_equal(dialog.get_by_label("to y").input_value, "1 m")
    bench.wait_equal(dialog.get_by_label("from x").input_value, "-2 m")
    dialog.get_by_role("button", name="Vehicle").click()
    bench.wait_text('P = "20 kN"', 'y = "-0.475 m"', 'points = [["-2 m", "-1 m"], ["2 m", "1 m"]]')
    page.get_by_role("button", name="Vehicle").click()
    dialog.get_by_role("button", name="Pick on plan").click()
    page.keyboard.press("Escape")
    bench.until(lambda: not dialog.is_visible())
    bench.click(-2, 1)
    bench.until(lambda: page.evaluate(DISTANCES) == ["1 m", "1 m", "3 m", "5 m"], lambda: page.evaluate(DISTANCES))


def test_a_length_is_typed_while_a_column_is_dragged(server: Server, bench: Bench, case: Path) -> None:
    """The column goes by that length along x, since the pointer is nearly in line; releasing adds nothing to it."""
    bench.open(server.start(case, by_itself=False))
    page = bench.page
    page.mouse.move(*bench.pixel(-2, 1))
    page.mouse.down()
    page.mouse.move(*bench.pixel(-1, 1.02))
    page.mouse.move(*bench.pixel(0, 1.05))
    page.keyboard.type("3,25")
    bench.wait_seen(".drawing-hint", "3,25 — Enter: move here")
    page.keyboard.press("Enter")
    bench.wait_text('x = "1.25 m"', 'y = "1 m"')
    page.mouse.move(*bench.pixel(2, 0))
    page.mouse.up()
    page.locator(".drawing").press("Control+z")
    bench.wait_text('x = "-2 m"', 'y = "1 m"')


def test_an_edge_is_bent_into_an_arc(server: Server, bench: Bench, case: Path) -> None:
    """With Ctrl the middle of an edge is dragged to a place of the arc; on the way back the edge is straight again."""
    case.write_text(case.read_text() + POLYGON)
    bench.open(server.start(case, by_itself=False))
    page = bench.page
    bench.click(1.9, 0)
    bench.until(lambda: page.locator(".handle.add").count() == 4)
    page.keyboard.down("Control")
    bench.drag((2, 0), (2.5, 0))
    page.keyboard.up("Control")
    # half the chord is 0.5 m, the arc rises by 0.5 m, counter-clockwise
    bench.wait_text("bulges = [0, 1]")
    bench.until(lambda: page.locator(".handle.bend").count() == 1)
    bench.drag((2.5, 0), (2, 0))
    bench.wait_text("bulges = [0, 0]")
    page.locator(".drawing").press("Control+z")
    page.locator(".drawing").press("Control+z")
    bench.until(lambda: "bulges" not in bench.text(), bench.text)
