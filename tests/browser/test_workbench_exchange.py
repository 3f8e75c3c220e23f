"""Files of other programs in a real browser: a slab of a building is opened, solved, and exported."""

from __future__ import annotations

import tomllib
from pathlib import Path

import ezdxf
import pytest

import groundslab as gs
from groundslab.case import casefile
from helpers.browsing import Bench, Server

pytest.importorskip("ifcopenshell")
pytest.importorskip("openpyxl")
from helpers.ifc_files import Building, turned

pytestmark = pytest.mark.slow


@pytest.fixture
def building(tmp_path: Path) -> Path:
    """A raft of 6 m by 4 m far from the origin with two columns and a wall, and a floor above it."""
    house = Building("mm")
    house.slab("Floor", place=turned(0, z=3.3))
    house.slab("Raft", place=turned(0, x=100, y=50))
    square = house.profile("IfcRectangleProfileDef", XDim=0.4, YDim=0.4)
    for name, x in (("C1", 101), ("C2", 105)):
        house.add("IfcColumn", name, square, 3.0, turned(0, x=x, y=51))
    house.add("IfcWall", "W1", house.profile("IfcRectangleProfileDef", XDim=4, YDim=0.2), 3.0, turned(0, x=103, y=53))
    return house.write(tmp_path / "house.ifc")


def test_from_a_building_to_a_plan_and_a_model(
    server: Server, bench: Bench, building: Path, case: Path, tmp_path: Path
) -> None:
    """The chosen slab, filled in and solved, comes back from SAF and from the plan as it is in the case."""
    bench.open(server.start(case, by_itself=False))
    bench.page.keyboard.press("Control+o")
    bench.page.get_by_role("option", name=building.name).dblclick()
    dialog = bench.page.locator(".slab-dialog")
    dialog.wait_for()
    words = [text.split(": ", 1) for text in dialog.locator("select").first.locator("option").all_inner_texts()]
    assert [name for name, _ in words] == ["Raft", "Floor"]
    assert words[0][1] == "6 m by 4 m, top at 0 m, storey: Ground floor, columns: 2, walls: 1"
    dialog.get_by_label("origin").select_option("centered")
    dialog.get_by_role("button", name="Create case").click()
    bench.wait_seen(".drawing-report pre", "another slab")
    bench.page.locator(".drawing-report").get_by_role("button", name="Close").click()
    bench.wait_seen(".file-title", "untitled")
    for key, value in (("E", "30 GPa"), ("nu", "0.2")):
        bench.fill(value, "plate", key)
    bench.wait_text("nu = 0.2")
    bench.page.get_by_role("button", name="+ self-weight").click()
    bench.tab("Form")
    bench.page.locator("""[data-path='["ground","kind"]'] select""").select_option("Winkler")
    bench.wait_text('kind = "winkler"')
    bench.solve()
    model = casefile.loads(bench.text())
    assert [(column.name, column.x, column.y) for column in model.columns] == [("C1", -2, -1), ("C2", 2, -1)]

    plan = ezdxf.readfile(bench.export("plan.dxf", tmp_path)).modelspace()
    [outline] = plan.query('LWPOLYLINE[layer=="OUTLINE"]')
    assert {(round(x, 6), round(y, 6)) for x, y in outline.get_points("xy")} == {(-3, -2), (-3, 2), (3, -2), (3, 2)}
    assert len(plan.query('LWPOLYLINE[layer=="COLUMNS"]')) == 2
    assert {"C1", "C2"} <= {text.dxf.text for text in plan.query("TEXT")}

    saf = bench.export("saf.xlsx", tmp_path)
    bench.wait_seen(".drawing-report pre", "section forces along edges")
    bench.page.locator(".drawing-report").get_by_role("button", name="Close").click()
    read = gs.read_saf(saf).model
    assert read.plate.bounds == pytest.approx(model.plate.bounds)
    assert (read.plate.thickness, read.plate.E) == pytest.approx((0.3, 30e9))
    assert [(column.name, column.x, column.y) for column in read.columns] == [("C1", -2, -1), ("C2", 2, -1)]
    assert [wall.name for wall in read.walls] == [wall.name for wall in model.walls]
    assert tomllib.loads(bench.text())["plate"]["thickness"] == "0.3 m"
