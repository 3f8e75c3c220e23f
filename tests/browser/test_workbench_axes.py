"""Axes of the building in a real browser, moved with what hangs on them; rings, walls on edges and strips drawn."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from groundslab.analysis.driver import solve
from groundslab.case import casefile
from helpers.browsing import SMALL, Bench, Server

pytestmark = pytest.mark.slow

BUBBLES = "() => [...document.querySelectorAll('circle.axis-name')].map((each) => each.dataset.axis)"

MIDDLE = """async (name) => {
  await new Promise(requestAnimationFrame);
  await new Promise(requestAnimationFrame);
  const box = document.querySelector(`circle.axis-name[data-axis="${name}"]`).getBoundingClientRect();
  return [box.x + box.width / 2, box.y + box.height / 2];
}"""


def _places(bench: Bench) -> list[tuple[str, float, float]]:
    """Return the columns of the case that the page shows."""
    return [(column.name, column.x, column.y) for column in casefile.loads(bench.text()).columns]


def _bubble(bench: Bench, name: str) -> tuple[float, float]:
    """Return where the bubble of an axis is on the screen, in the view that the next frame shows."""
    x, y = bench.page.evaluate(MIDDLE, name)
    return float(x), float(y)


def _make_axes(bench: Bench, **values: str) -> None:
    """Make axes by the dialog."""
    bench.tool("axes")
    dialog = bench.page.get_by_role("dialog", name="Axes")
    for label, value in values.items():
        dialog.get_by_label(label.replace("_", " ")).fill(value)
    dialog.get_by_role("button", name="Axes").click()


def test_an_axis_moves_with_its_columns(server: Server, bench: Bench, case: Path) -> None:
    """Columns made on the crossings follow an axis that is dragged, in one step, which one undo takes back."""
    start, end = SMALL.index("[[columns]]"), SMALL.index("[[loads]]")
    bare = SMALL[:start] + SMALL[end:].replace('column = "A1"', 'x = "0 m"\ny = "1 m"')
    case.write_text(bare, encoding="utf-8")
    bench.open(server.start(case, by_itself=False))
    _make_axes(bench, first_x="-2", first_y="-1", spacing_in_x="2x2", spacing_in_y="2")
    bench.wait_text("[[axes]]", 'distances = "2 x 2 m"', 'at = "B/2"')  # the force stood where B and 2 cross
    bench.wait_equal(lambda: bench.page.evaluate(BUBBLES), ["A", "B", "C", "1", "2"])
    bench.tool("columns")
    dialog = bench.page.get_by_role("dialog", name="Columns")
    dialog.locator("[name=on]").select_option("crossings of axes")
    dialog.get_by_label("load per column", exact=True).fill("0")
    bench.until(lambda: "6 columns." in dialog.inner_text(), dialog.inner_text)
    dialog.get_by_role("button", name="Columns").click()
    bench.wait_text('name = "B2"', 'at = "C/1"')
    before = _places(bench)
    assert ("B2", 0.0, 1.0) in before
    x, y = _bubble(bench, "B")
    (x0, _), (x1, _) = bench.pixels((0, 0), (0.5, 0))
    bench.page.mouse.move(x, y)
    bench.page.mouse.down()
    bench.page.mouse.move(x + (x1 - x0) / 2, y, steps=3)
    bench.page.mouse.move(x + x1 - x0, y + 3, steps=3)
    bench.page.mouse.up()
    bench.wait_text('distances = "2.5 m, 1.5 m"')
    after = _places(bench)
    assert [(name, x + 0.5 * name.startswith("B"), y) for name, x, y in before] == after
    bench.wait_seen(".properties h3", "axes 1")
    bench.solve()
    bench.page.locator(".drawing").press("Control+z")
    bench.until(lambda: 'distances = "2 x 2 m"' in bench.text(), bench.text)
    assert _places(bench) == before


def test_a_column_leaves_its_axes_and_comes_back(server: Server, bench: Bench, case: Path) -> None:
    """A column that is dragged off has a place of its own, and hangs on the crossing where it is dropped."""
    bench.open(server.start(case, by_itself=False))
    _make_axes(bench, first_x="-2", first_y="-1", spacing_in_x="2x2", spacing_in_y="2")
    bench.wait_text('at = "A/2"')
    bench.drag((-2, 1), (-1.2, 0.4))
    bench.until(lambda: _places(bench) != [("A1", -2.0, 1.0)], bench.text)
    assert "at =" not in bench.text()
    [(_, x, y)] = _places(bench)
    bench.drag((x, y), (0.02, -0.98))
    bench.wait_text('at = "B/1"')
    assert _places(bench) == [("A1", 0.0, -1.0)]
    # without its axes it stays where it is
    bench.page.mouse.click(*_bubble(bench, "C"))
    bench.wait_seen(".properties h3", "axes 1")
    bench.page.locator(".drawing").press("Delete")
    bench.until(lambda: "at =" not in bench.text(), bench.text)
    assert _places(bench) == [("A1", 0.0, -1.0)]


POLAR = """
[[axes]]
kind = "ray"
angles = [0, 45, 90]

[[axes]]
kind = "ring"
distances = "1 m, 0.9 m"
"""


def test_rays_turn_and_rings_grow_with_their_columns(server: Server, bench: Bench, case: Path) -> None:
    """A ray is turned by its bubble, a ring resized by a handle and by a typed radius; each is one undo."""
    text = SMALL.replace('x = "-2 m"\ny = "1 m"', 'at = "2/A"')
    assert 'at = "2/A"' in text
    case.write_text(text + POLAR, encoding="utf-8")
    bench.open(server.start(case, by_itself=False))
    bench.wait_equal(lambda: bench.page.evaluate(BUBBLES), ["1", "2", "3", "A", "B"])
    x, y = _bubble(bench, "2")
    [(x0, y0), (x1, y1)] = bench.pixels((0, 0), (0.5, math.sqrt(0.75)))
    away = math.hypot(x - x0, y - y0) / math.hypot(x1 - x0, y1 - y0)
    bench.page.mouse.move(x, y)
    bench.page.mouse.down()
    bench.page.mouse.move(x0 + away * (x1 - x0), y0 + away * (y1 - y0), steps=5)
    bench.until(lambda: bench.page.locator("text.tip").text_content() == "2: 60°", bench.text)
    bench.page.mouse.up()
    bench.wait_text("angles = [0, 60, 90]")
    [(_, x, y)] = _places(bench)
    assert (x, y) == pytest.approx((0.5, math.sqrt(0.75)))
    # the family is selected: its rings have handles
    bench.page.mouse.click(*_bubble(bench, "A"))
    bench.wait_seen(".properties h3", "axes 2")
    bench.drag((-1, 0), (-1.2, 0.02))
    bench.wait_text('distances = "1.2 m, 0.7 m"')
    bench.page.mouse.move(*_bubble(bench, "A"))
    bench.page.mouse.down()
    bench.page.keyboard.type("1.5")
    bench.page.keyboard.press("Enter")
    bench.page.mouse.up()
    bench.wait_text('distances = "1.5 m, 0.4 m"')
    [(_, x, y)] = _places(bench)
    assert (x, y) == pytest.approx((0.75, 1.5 * math.sqrt(0.75)))
    for before in ('distances = "1.2 m, 0.7 m"', 'distances = "1 m, 0.9 m"', "angles = [0, 45, 90]"):
        bench.page.locator(".drawing").press("Control+z")
        bench.until(lambda before=before: before in bench.text(), bench.text)


def test_names_of_axes_are_changed_with_what_hangs_on_them(server: Server, bench: Bench, case: Path) -> None:
    """Renamed in the properties, and in the form made fewer: references follow, one undo takes each back."""
    bench.open(server.start(case, by_itself=False))
    _make_axes(bench, first_x="-2", first_y="-1", spacing_in_x="2x2", spacing_in_y="2")
    bench.wait_text('at = "A/2"')
    bench.wait_seen(".properties h3", "axes 1")
    first = bench.page.locator(""".properties [data-path='["axes",0,"first"]'] input""")
    first.fill("L")
    first.press("Enter")
    bench.wait_text('first = "L"', 'at = "L/2"')
    bench.wait_equal(lambda: bench.page.evaluate(BUBBLES), ["L", "M", "N", "1", "2"])
    bench.page.locator(".drawing").press("Control+z")
    bench.until(lambda: 'at = "A/2"' in bench.text() and 'first = "A"' in bench.text(), bench.text)
    rows = bench.page.locator(""".properties [data-path='["axes",0,"names"]'] input""")
    rows.fill("X, Y, Z")
    rows.press("Enter")
    bench.wait_text('names = ["X", "Y", "Z"]', 'at = "X/2"')
    assert _places(bench) == [("A1", -2.0, 1.0)]


def test_axes_are_taken_from_columns(server: Server, bench: Bench, case: Path) -> None:
    """Columns in rows become axes of their names, and hang on them; one off the rows stays and hides nothing."""
    size = 'width_x = "300 mm"\nwidth_y = "300 mm"\n'
    places = {"A2": (-2, 1), "B1": (0, -1), "B2": (0, 1), "C9": (1.3, 0.35), "D7": (2.2, -0.7)}
    columns = "".join(
        f'[[columns]]\nname = "{name}"\nx = "{x} m"\ny = "{y} m"\n{size}' for name, (x, y) in places.items()
    )
    text = SMALL.replace("[[loads]]", f"{columns}\n[[loads]]", 1).replace('y = "1 m"', 'y = "-1 m"', 1)
    case.write_text(text, encoding="utf-8")
    bench.open(server.start(case, by_itself=False))
    bench.tool("axes")
    dialog = bench.page.get_by_role("dialog", name="Axes")
    dialog.locator("[name=kind]").select_option("columns")
    bench.until(lambda: "4 parts" in dialog.inner_text(), dialog.inner_text)
    dialog.get_by_role("button", name="Axes").click()
    bench.wait_text('at = "A/1"', 'at = "B/2"', 'name = "D7"')
    bench.wait_equal(lambda: bench.page.evaluate(BUBBLES), ["A", "B", "1", "2"])
    assert bench.text().count("at = ") == 4


def test_rings_edges_and_strips_are_drawn(server: Server, bench: Bench, case: Path) -> None:
    """Ctrl draws a ring load, whose sum is 2 pi r q; a click on an edge a wall, and a drag a strip."""
    case.write_text(SMALL.replace("length_x", 'name = "slab"\nlength_x'), encoding="utf-8")
    bench.open(server.start(case, by_itself=False))
    bench.tool("line load")
    bench.page.keyboard.down("Control")
    bench.drag((0.5, 0), (1.5, 0))
    bench.page.keyboard.up("Control")
    bench.wait_text("radius", 'kind = "line"', 'kind = "circle"')
    model = casefile.loads(bench.text())
    load = model.loads[-1]
    assert load.shape.radius == pytest.approx(1.0, abs=1e-9)
    total = 200e3 + 2 * math.pi * load.q  # the force on the column, and 2 pi r q
    (solved,) = solve(model).results.values()
    assert solved.certificate.load == pytest.approx(total, rel=1e-9)
    bench.solve()
    assert bench.largest("sum of the loads") == pytest.approx(total / 1e3, rel=1e-3)
    bench.tool("edge wall")
    bench.click(3, 0.3)
    bench.wait_text("[[walls]]", 'edge = "right"')
    bench.page.locator(".drawing").press("Escape")
    bench.tool("strip")
    bench.drag((-2, -1), (2, -1))
    bench.wait_text("[[output.strips]]", 'width = "1 m"')
    bench.tool("borehole")
    bench.click(1, 1)
    bench.wait_text('name = "BH1"')
