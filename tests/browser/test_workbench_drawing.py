"""Drawings in a real browser: a case from chosen layers, and a drawing below the plan."""

from __future__ import annotations

import tomllib
from pathlib import Path

import ezdxf
import pytest

from helpers.browsing import Bench, Server
from helpers.reactions import write_case

pytestmark = pytest.mark.slow


@pytest.fixture
def drawing(tmp_path: Path) -> Path:
    """Return a drawing in centimeters, which it does not say: a slab with a cut corner, a column, an axis."""
    document = ezdxf.new("R2010", units=0)
    space = document.modelspace()
    corners = [(100, 100), (1300, 100), (1300, 600), (900, 900), (100, 900)]
    space.add_lwpolyline(corners, close=True, dxfattribs={"layer": "A-SLAB"})
    column = [(480, 480), (520, 480), (520, 520), (480, 520)]
    space.add_lwpolyline(column, close=True, dxfattribs={"layer": "A-COL"})
    space.add_line((733, 50), (733, 950), dxfattribs={"layer": "A-AXIS"})
    space.add_line((50, 347), (1350, 347), dxfattribs={"layer": "A-AXIS"})
    path = tmp_path / "floor.dxf"
    document.saveas(path)
    return path


def _open(bench: Bench, name: str) -> None:
    """Choose a file in the dialog for opening."""
    bench.page.keyboard.press("Control+o")
    bench.page.get_by_role("option", name=name).dblclick()


def _hold(bench: Bench, layer: str, what: str) -> None:
    """Say what a layer holds."""
    bench.page.get_by_label(f"content of layer {layer}").select_option(what)


def test_a_case_from_layers_that_are_chosen(server: Server, bench: Bench, case: Path, drawing: Path) -> None:
    """Unit and outline must be chosen; the new case is unsaved, has a report, and is solved once it is filled in."""
    bench.open(server.start(case, by_itself=False))
    _open(bench, drawing.name)
    dialog = bench.page.locator(".drawing-dialog")
    bench.wait_seen(".drawing-dialog .messages", "Choose the drawing's unit")
    make = dialog.get_by_role("button", name="Create case")
    assert make.is_disabled()
    dialog.get_by_label("drawing unit").select_option("cm")
    bench.wait_seen(".drawing-dialog .messages", "Choose the layer with the outline.")
    _hold(bench, "A-AXIS", "outline")
    make.click()
    bench.wait_seen(".drawing-dialog .messages", "lines that close end to end")
    _hold(bench, "A-AXIS", "")
    _hold(bench, "A-SLAB", "outline")
    _hold(bench, "A-COL", "columns")
    dialog.get_by_label("origin").select_option("centered")
    make.click()
    bench.wait_seen(".drawing-report pre", "outline: 12 m x 8 m")
    bench.page.get_by_role("button", name="Close", exact=True).click()
    bench.wait_seen(".file-title", "untitled")
    bench.wait_text('kind = "self weight"')
    data = tomllib.loads(bench.text())
    assert data["plate"]["outline"]["points"][:2] == [["-6 m", "-4 m"], ["6 m", "-4 m"]]
    assert (data["columns"][0]["x"], data["columns"][0]["width_x"]) == ("-2 m", "0.4 m")
    assert case.read_text().startswith('title = "A small slab"')
    # what no drawing holds is as in a new case, but for the thickness
    assert (data["plate"]["E"], data["ground"]["kind"], data["loads"][0]["kind"]) == ("30 GPa", "vlasov", "self weight")
    bench.fill("300 mm", "plate", "thickness")
    bench.wait_text('thickness = "300 mm"')
    bench.solve()


def test_what_is_drawn_snaps_to_a_drawing_below_the_plan(
    server: Server, bench: Bench, case: Path, drawing: Path
) -> None:
    """An intersection is met exactly; the drawing can be moved, hidden and removed; the case has none of it."""
    bench.open(server.start(case, by_itself=False))
    before = bench.text()
    _open(bench, drawing.name)
    dialog = bench.page.locator(".drawing-dialog")
    dialog.get_by_label("drawing unit").select_option("cm")
    dialog.get_by_role("button", name="Only show under the plan").click()
    underlay = bench.page.locator(".drawing .underlay")
    underlay.wait_for(state="attached")
    bar = bench.page.get_by_role("button", name="Underlay")
    bar.click()
    for axis, value in (("x", "-7"), ("y", "-4.5")):
        field = bench.page.get_by_label(f"{axis} of the drawing's origin on the plan")
        field.fill(value)
        field.press("Enter")
    bar.click()
    bench.page.locator(".drawing").focus()
    bench.page.keyboard.press("0")
    bench.tool("column")
    bench.click(0.36, -1.06)  # the axes cross at (7.33, 3.47) m of the drawing
    bench.until(lambda: len(tomllib.loads(bench.text())["columns"]) == 2)
    column = tomllib.loads(bench.text())["columns"][1]
    assert (column["x"], column["y"]) == ("0.33 m", "-1.03 m")
    bar.click()
    bench.page.locator(".underlay-fields").get_by_label("shown").uncheck()
    underlay.wait_for(state="detached")
    bench.page.get_by_role("button", name="Remove", exact=True).first.click()
    bar.wait_for(state="hidden")
    bench.page.keyboard.press("Control+z")
    bench.until(lambda: bench.text() == before)


def test_a_slab_of_a_saf_file_becomes_a_case(server: Server, bench: Bench, tmp_path: Path) -> None:
    """The slabs are listed, the one on ground first; the report says what was read."""
    pytest.importorskip("openpyxl")
    from helpers import saf_files

    saf_files.write(tmp_path / "house.xlsx", saf_files.house())
    bench.open(server.start(write_case(tmp_path), by_itself=False))
    bench.page.keyboard.press("Control+o")
    bench.page.get_by_role("option", name="house.xlsx").dblclick()
    dialog = bench.page.locator(".slab-dialog")
    dialog.get_by_label("slab", exact=True).select_option("S6: 5 m by 12 m at 0 m, on ground")
    dialog.get_by_role("button", name="Create case").click()
    bench.wait_seen(".drawing-report", "StructuralSurfaceMember S6: plate")
    bench.page.locator(".drawing-report").get_by_role("button", name="Close").click()
    bench.wait_text('name = "S6"', 'kind = "pasternak"')
