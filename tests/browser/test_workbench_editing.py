"""Editing several items of the plan at once in a real browser: selecting, repeating, turning, copying, removing."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from helpers.browsing import Bench, Server

pytestmark = pytest.mark.slow


def _data(bench: Bench) -> dict[str, Any]:
    return tomllib.loads(bench.text())


def _places(bench: Bench) -> list[tuple[str, str]]:
    return [(each["x"], each["y"]) for each in _data(bench)["columns"]]


def _enter(bench: Bench, **values: str) -> None:
    """Fill in the dialog of an action and confirm it."""
    for name, value in values.items():
        bench.page.locator(f'.action-dialog [name="{name}"]').fill(value)
    bench.page.locator('.action-dialog [type="submit"]').click()


def test_one_rack_leg_becomes_twelve_that_are_edited_together(server: Server, bench: Bench, case: Path) -> None:
    """A column with its load is repeated in rows and columns; all loads get another size in one step of undo."""
    bench.open(server.start(case, by_itself=False))
    before = bench.text()
    bench.drag((-2.6, 1.6), (-1.4, 0.4))
    bench.wait_seen(".properties h3", "1 column, 1 load selected")
    bench.page.keyboard.press("y")
    ghosts = bench.page.locator(".ghosts [data-kind=column]")
    dialog = bench.page.locator(".action-dialog")
    dialog.locator('[name="columns"]').fill("4")
    dialog.locator('[name="rows"]').fill("3")
    dialog.locator('[name="dy"]').fill("wide")
    bench.wait_seen(".action-message", 'dy: found "wide", expected a length such as "1.5 m"')
    dialog.locator('[name="dy"]').fill("-0,8 m")
    dialog.locator('[name="dx"]').fill("120 cm")
    bench.until(lambda: ghosts.count() == 11)
    dialog.locator('[name="dy"]').press("Enter")
    bench.until(lambda: len(_data(bench)["columns"]) == 12)
    columns, loads = _data(bench)["columns"], _data(bench)["loads"]
    assert [each["column"] for each in loads] == [each["name"] for each in columns]
    assert len({each["name"] for each in columns}) == 12
    assert (columns[-1]["x"], columns[-1]["y"]) == ("1.6 m", "-0.6 m")

    bench.page.locator(".drawing").focus()
    bench.page.keyboard.press("Control+a")
    bench.wait_seen(".properties h3", "12 columns, 12 loads selected")
    bench.page.keyboard.press("Escape")
    bench.wait_seen(".properties h3", "Slab")
    # from right to left the band takes what it touches: the first two columns of two rows
    bench.drag((-0.3, 1.6), (-2.1, 0.1))
    bench.wait_seen(".properties h3", "4 columns, 4 loads selected")
    bench.page.keyboard.press("Control+z")
    bench.until(lambda: bench.text() == before)


def test_fields_of_several_items_are_changed_in_one_step(server: Server, bench: Bench, case: Path) -> None:
    """Shift adds to the selection; a common field that differs says so, and is set for all at once."""
    text = case.read_text()
    case.write_text(text + '\n[[columns]]\nname = "A2"\nx = "2 m"\ny = "1 m"\nwidth_x = "30 cm"\nwidth_y = "400 mm"\n')
    bench.open(server.start(case, by_itself=False))
    before = bench.text()
    bench.click(-2.0, 1.0)
    bench.page.keyboard.down("Shift")
    bench.click(2.0, 1.0)
    bench.page.keyboard.up("Shift")
    bench.wait_seen(".properties h3", "2 columns selected")
    width = bench.field("columns", 0, "width_x").locator("input")
    bench.wait_equal(width.input_value, "")
    bench.wait_equal(lambda: width.get_attribute("placeholder"), "different values")
    bench.wait_equal(bench.field("columns", 0, "width_y").locator("input").input_value, "400 mm")
    bench.fill("350 mm", "columns", 0, "width_x")
    bench.until(lambda: [each["width_x"] for each in _data(bench)["columns"]] == ["350 mm", "350 mm"])
    assert bench.text() == before.replace('"30 cm"', '"350 mm"').replace('width_x = "400 mm"', 'width_x = "350 mm"')
    drawing = bench.page.locator(".drawing")
    drawing.focus()
    drawing.press("Control+z")
    bench.until(lambda: bench.text() == before)
    bench.drag((2.0, 1.0), (2.0, 0.0))
    bench.until(lambda: _places(bench) == [("-2 m", "0 m"), ("2 m", "0 m")])
    bench.wait_seen(".last-edit", "move 2 columns")
    drawing.press("Delete")
    bench.until(lambda: "columns" not in _data(bench))
    assert "loads" not in _data(bench)
    drawing.press("Control+z")
    drawing.press("Control+z")
    bench.until(lambda: bench.text() == before)


def test_items_go_from_one_workbench_to_another(
    server: Server, own_server: Server, tabs: Any, case: Path, tmp_path: Path
) -> None:
    """Copied tables are TOML text; pasted ones get free names, and loads stand on the pasted columns."""
    other_case = tmp_path / "other.toml"
    other_case.write_text(case.read_text())
    one, two = tabs().open(server.start(case, by_itself=False)), tabs().open(own_server.start(other_case))
    one.page.bring_to_front()
    one.drag((-2.6, 1.6), (-1.4, 0.4))
    one.wait_seen(".properties h3", "1 column, 1 load selected")
    one.page.keyboard.press("Control+c")
    one.wait_seen(".drawing-hint", "1 column, 1 load copied")
    two.page.bring_to_front()
    two.click(1.0, -0.5)
    two.page.keyboard.press("Control+v")
    two.until(lambda: len(_data(two)["columns"]) == 2)
    data = _data(two)
    assert data["columns"][1]["name"] == data["loads"][1]["column"] == "A2"
    assert (data["columns"][1]["x"], data["columns"][1]["y"]) == ("1 m", "-0.5 m")
    # in a text field the keys keep their meaning
    name = two.page.locator(".properties input").first
    name.focus()
    two.page.keyboard.press("Control+v")
    two.page.keyboard.press("Escape")
    assert len(_data(two)["columns"]) == 2
    two.page.locator(".drawing").focus()
    two.page.keyboard.press("Control+z")


def test_what_is_turned_and_mirrored_is_written_exactly(server: Server, bench: Bench, case: Path) -> None:
    """A turned patch load becomes a polygon; a column gets an angle; a mirror image is a copy."""
    case.write_text(
        case.read_text() + '\n[[loads]]\nkind = "patch"\nq = "20 kPa"\nx = ["1 m", "2 m"]\ny = ["0 m", "1 m"]\n'
    )
    bench.open(server.start(case, by_itself=False))
    bench.click(1.5, 0.3)
    bench.page.keyboard.press("r")
    _enter(bench, angle="45", x="1 m", y="0 m")
    bench.until(lambda: _data(bench)["loads"][1]["kind"] == "area")
    shape = _data(bench)["loads"][1]["shape"]
    half = "0.707106781 m"
    assert shape["points"] == [
        ["1 m", "0 m"],
        ["1.707106781 m", half],
        ["1 m", "1.414213562 m"],
        ["0.292893219 m", half],
    ]
    bench.page.keyboard.press("Escape")
    bench.click(-2.0, 1.0)
    bench.page.keyboard.press("r")
    _enter(bench, angle="30", x="-2 m", y="1 m")
    bench.until(lambda: _data(bench)["columns"][0].get("angle") == 30)
    bench.page.keyboard.press("i")
    _enter(bench, x="0")
    bench.until(lambda: _places(bench) == [("-2 m", "1 m"), ("2 m", "1 m")])
    bench.wait_seen(".last-edit", "mirror: copy column A1")


def test_a_slab_is_drawn_by_typed_lengths_and_places(server: Server, bench: Bench) -> None:
    """Places and lengths are typed while drawing; at 1280 x 650 every tool can be seen; a case is added in the plan."""
    bench.page.set_viewport_size({"width": 1280, "height": 650})
    bench.open(server.start(None, by_itself=False))
    page = bench.page
    seen = "() => { const e = document.querySelector('.tools'); return e.scrollHeight <= e.clientHeight; }"
    page.wait_for_function(seen)
    bench.tool("slab")
    page.keyboard.type("-1,5; -1")
    page.keyboard.press("Enter")
    page.mouse.move(*bench.pixel(1.0, -1.0))
    page.keyboard.type("3.25")
    page.keyboard.press("Enter")
    page.keyboard.type("1.75;2")
    page.keyboard.press("Enter")
    page.keyboard.press("Enter")
    bench.wait_text('points = [["-1.5 m", "-1 m"], ["1.75 m", "-1 m"], ["1.75 m", "2 m"]]')
    page.get_by_role("button", name="+ case").click()
    page.get_by_label("name of the new load case").fill("live")
    page.get_by_label("name of the new load case").press("Enter")
    page.get_by_label("action of the new load case").select_option("variable")
    page.get_by_label("loads without a case", exact=True).select_option("apart")
    bench.wait_text('name = "live"', 'name = "permanent"', 'action = "variable"')
    bench.tool("point load")
    bench.click(1.0, -0.5)
    bench.wait_text('case = "live"')


def test_walls_are_drawn_and_loads_stand_along_them(server: Server, bench: Bench, case: Path) -> None:
    """W draws a wall of the usual thickness; a load that names it stands along it."""
    case.write_text(case.read_text() + '\n[[loads]]\nkind = "line"\nq = "20 kN/m"\nwall = "W1"\n')
    bench.open(server.start(case, by_itself=False))
    bench.page.locator(".drawing").focus()
    bench.page.keyboard.press("w")
    bench.drag((-2.0, -1.0), (1.0, -1.0))
    bench.until(lambda: "walls" in _data(bench))
    assert _data(bench)["walls"] == [
        {"name": "W1", "thickness": "250 mm", "points": [["-2 m", "-1 m"], ["1 m", "-1 m"]]}
    ]
    bench.page.wait_for_selector(".symbol.wall", state="attached")
    bench.page.wait_for_selector('.symbol.load[data-path*="loads"] path.wall', state="attached")


def test_beams_are_drawn_as_the_one_before(server: Server, bench: Bench, case: Path) -> None:
    """The first beam has a usual section, a further one that of the last."""
    bench.open(server.start(case, by_itself=False))
    bench.tool("beam")
    bench.drag((-2.0, -1.0), (1.0, -1.0))
    bench.until(lambda: "beams" in _data(bench))
    (beam,) = _data(bench)["beams"]
    assert beam["name"] == "B1"
    assert beam["points"] == [["-2 m", "-1 m"], ["1 m", "-1 m"]]
    assert beam["section"] == {"kind": "rectangle", "width": "400 mm", "height": "800 mm"}
    bench.page.wait_for_selector(".symbol.beam", state="attached")


def test_plates_are_drawn_and_joined(server: Server, bench: Bench, case: Path) -> None:
    """A further plate beside the slab is drawn and joined to it; a circle is drawn where the mesh is finer."""
    # without it nothing would press the further plate down
    case.write_text(case.read_text() + '\n[[loads]]\nkind = "uniform"\nq = "5 kPa"\n')
    bench.open(server.start(case, by_itself=False))
    view = bench.page.locator(".drawing").get_attribute("data-view")
    bench.page.mouse.move(*bench.pixel(0.0, 0.0))
    bench.page.mouse.wheel(0, 600)
    bench.until(lambda: bench.page.locator(".drawing").get_attribute("data-view") != view)
    bench.tool("plate")
    bench.drag((3.0, -2.0), (5.0, 2.0))
    bench.until(lambda: "plates" in _data(bench))
    plate = _data(bench)["plates"][0]
    assert plate["outline"] == {"kind": "rectangle", "x": ["3 m", "5 m"], "y": ["-2 m", "2 m"]}
    assert (plate["thickness"], plate["E"], plate["nu"]) == ("250 mm", "30 GPa", 0.2)
    bench.tool("joint")
    bench.click(3.0, 0.7)
    bench.until(lambda: "joints" in _data(bench))
    assert _data(bench)["joints"] == [{"kind": "hinge", "between": [_data(bench)["plate"]["name"], plate["name"]]}]
    bench.page.wait_for_selector(".symbol.joint", state="attached")
    bench.tool("refinement")
    bench.page.keyboard.down("Control")
    bench.drag((0.0, 0.0), (1.0, 0.0))
    bench.page.keyboard.up("Control")
    bench.until(lambda: "refine" in _data(bench)["mesh"])
    assert _data(bench)["mesh"]["refine"][0]["shape"] == {
        "kind": "circle",
        "centre": ["0 m", "0 m"],
        "radius": "1 m",
    }
    bench.solve()
    bench.wait_seen(".issue-count", "No errors")
