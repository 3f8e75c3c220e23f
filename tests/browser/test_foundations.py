"""Three foundations from nothing, by mouse and keyboard: every click, key and entry counts as an action."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path
from typing import Any

import ezdxf
import pytest

from groundslab import solve
from groundslab.case import casefile
from groundslab.model.combinations import list_combinations, place_patterns
from groundslab.model.shapes import Circle, Polygon
from helpers.browsing import Bench, Server
from helpers.hands import Hands, all_loads, begin, forces_of, model_of

pytestmark = pytest.mark.slow

#: An engineer with the data at hand needs fewer actions than these.
FEW_FOR_A_RAFT, FEW_FOR_A_FLOOR, FEW_FOR_A_TANK = 80, 35, 20


def test_a_warehouse_floor(server: Server, bench: Bench) -> None:
    """64 legs of racks, a forklift on its path, heat from above, combinations and reinforcement."""
    hands = begin(server, bench)
    hands.fill({"length_x": "24 m", "length_y": "12 m", "thickness": "200 mm"}, "plate")
    hands.generate("racks", {"racks": "back to back", "bays": "7", "rows": "2", "x": "-9.5", "y": "-4"})
    bench.wait_text('kind = "rack"')
    path = {"class": "FL3", "x": "-9", "x2": "9", "step": "3"}
    hands.generate("vehicle", {**path, "case": "new load case"})
    bench.wait_text('kind = "vehicle"')
    hands.add_case("temperature changes")
    hands.click(bench.page.get_by_role("button", name="+ temperature"))
    bench.wait_text('kind = "temperature"')
    hands.tab("Form")
    hands.fill({"kind": "winkler", "k": "50 MPa/m"}, "ground")
    hands.add_section("combine")
    hands.add_section("reinforcement")
    bench.wait_text('concrete = "C30/37"')
    assert hands.actions < FEW_FOR_A_FLOOR

    model = model_of(bench)
    assert model.plate.sides == (24.0, 12.0)
    assert [case.name for case in model.cases] == ["permanent", "racks", "vehicle", "T"]
    legs = [load for load in place_patterns(model).loads if load.kind == "point" and load.case == "racks"]
    assert (len(legs), forces_of(model, "racks")) == (64, 64 * 60e3)
    # the front axle of a forklift FL3 at seven positions, each a case of its own
    positions = [case.name for case in place_patterns(model).cases if case.name.startswith("vehicle")]
    assert len(positions) == 7
    assert {forces_of(model, name) for name in positions} == {63e3}
    assert {load.case for load in model.loads} == {"permanent", "T"}
    assert len(list_combinations(model)) > 20


def test_a_house_raft(server: Server, bench: Bench) -> None:
    """An L with ten columns on three layers and two boreholes, under walls, live and wind loads, solved."""
    hands = begin(server, bench)
    corners = ((0.0, 0.0), (16.0, 0.0), (16.0, 7.0), (10.0, 7.0), (10.0, 12.0), (0.0, 12.0))
    hands.draw("b", (f"{x:g};{y:g}" for x, y in corners))
    hands.keys("Enter")
    bench.wait_text('kind = "polygon"')
    hands.fill({"thickness": "600 mm"}, "plate")
    hands.add_case("permanent")
    hands.add_case("variable A: homes")
    # of the grid's twelve places two are off the slab
    grid = {"x": "1", "y": "1", "spacing_x": "4 6 4", "spacing_y": "2x5", "P": "350", "P_2": "900"}
    hands.generate("columns", grid)
    bench.wait_text('name = "B3"')
    hands.enter("G", bench.page.locator(".case-choice > select"))
    hands.line("l", (1.0, 1.0), (1.0, 11.0))
    bench.wait_text('kind = "line"')
    hands.fill({"q": "40 kN/m"}, "loads", 21)
    hands.line("l", (5.0, 1.0), (15.0, 1.0))
    # wind lifts two columns: a load has the size of the one before
    hands.add_case("wind actions")
    hands.click(bench.page.locator('.tool[data-tool="point load"]'))
    hands.click_at(15.0, 1.0)
    bench.wait_text('case = "W"')
    hands.fill({"P": "-120 kN"}, "loads", 23)
    hands.click_at(1.0, 11.0)
    bench.until(lambda: forces_of(casefile.loads(bench.text()), "W") == -240e3)
    hands.tab("Form")
    hands.click(bench.page.locator('[data-section="ground"]').get_by_role("button", name="Add Layer"))
    bench.until(lambda: len(tomllib.loads(bench.text())["ground"]["layers"]) == 3)
    hands.fill({"E": "120 MPa"}, "ground", "layers", 2)
    hands.add_section("combine")
    hands.add_section("reinforcement")
    hands.open_section("mesh")
    hands.fill({"size": "2 m"}, "mesh")
    hands.tab("Plan")
    hands.click(bench.page.locator('.tool[data-tool="borehole"]'))
    for n, place in enumerate(((2.0, 9.0), (14.0, 3.0)), start=1):
        hands.click_at(*place)
        bench.wait_text(f'\nname = "BH{n}"')  # comments have such names
    hands.fill({"thickness": "3 m"}, "boreholes", 1, "layers", 0)
    bench.until(lambda: tomllib.loads(bench.text())["boreholes"][1]["layers"][0]["thickness"] == "3 m")
    hands.keys("F9")
    bench.wait_solved()
    assert hands.actions < FEW_FOR_A_RAFT

    model = model_of(bench)
    assert model.plate.outline == Polygon(kind="polygon", points=corners)
    assert [forces_of(model, name) for name in ("G", "Q", "W")] == [10 * 900e3, 10 * 350e3, -240e3]
    assert {column.name for column in model.columns} >= {"A1", "D2", "B3"}
    assert [(load["q"], load["case"]) for load in _loads(bench, "line")] == [("40 kN/m", "G")] * 2
    assert [len(borehole.layers) for borehole in model.boreholes] == [3, 3]
    assert model.reinforcement is not None
    # the combination that is shown at first has the largest sum of factors
    heaviest = max(list_combinations(model), key=lambda combination: sum(dict(combination.factors).values()))
    one = model.replace(combine=None, combinations=(heaviest,), reinforcement=None)
    [shown] = solve(one).values()
    bench.until(lambda: bench.largest("largest settlement") == pytest.approx(1e3 * shown.plate.settlement.max(), 1e-3))


def test_a_tank_from_a_drawing(server: Server, bench: Bench, tmp_path: Path) -> None:
    """The base is a circle of the drawing, its wall a line load; water is drawn, uplift is a load of its own."""
    drawing = ezdxf.new()
    drawing.units = ezdxf.units.M
    drawing.modelspace().add_circle((20, 10), 8, dxfattribs={"layer": "BASE"})
    drawing.modelspace().add_circle((20, 10), 7.75, dxfattribs={"layer": "WALL"})
    drawing.modelspace().add_text("85 kN/m", dxfattribs={"layer": "WALL"}).set_placement((27.8, 10))
    case = tmp_path / "tank.toml"
    drawing.saveas(tmp_path / "tank.dxf")
    case.write_text('[plate]\nlength_x = "1 m"\n', encoding="utf-8")
    bench.open(server.start(case, by_itself=False))
    hands = Hands(bench)
    hands.keys("Control+o")
    hands.actions += 1
    bench.page.get_by_role("option", name="tank.dxf").dblclick()
    dialog = bench.page.locator(".drawing-dialog")
    hands.enter("line loads", dialog.get_by_label("content of layer WALL"))
    hands.click(dialog.get_by_role("button", name="Create case"))
    bench.wait_seen(".drawing-report pre", "outline")
    hands.click(bench.page.get_by_role("button", name="Close", exact=True))
    hands.fill({"thickness": "400 mm"}, "plate")
    bench.wait_text('thickness = "400 mm"', 'kind = "self weight"')
    hands.add_case("permanent")
    hands.add_case("variable, other")
    # a circle is dragged from its center with Ctrl, here to the wall
    hands.click(bench.page.locator('.tool[data-tool="area load"]'))
    bench.page.keyboard.down("Control")
    hands.actions += 1
    bench.drag((20.0, 10.0), (27.75, 10.0))
    bench.page.keyboard.up("Control")
    bench.wait_text('kind = "area"')
    area = next(n for n, load in enumerate(all_loads(bench)) if load["kind"] == "area")
    hands.fill({"q": "70 kPa"}, "loads", area)
    hands.add_case("variable, other")
    hands.click(bench.page.get_by_role("button", name="+ uniform load"))
    bench.wait_text('kind = "uniform"')
    hands.fill({"q": "-15 kPa"}, "loads", area + 1)
    bench.wait_text('q = "-15 kPa"')
    hands.tab("Load cases")
    hands.enter("by EN 1990, 6.10", bench.page.get_by_label("how combinations are made"))
    bench.wait_text("[combine]")
    assert hands.actions < FEW_FOR_A_TANK
    # solved by itself from now on, here on a coarse mesh
    hands.tab("Form")
    hands.open_section("mesh")
    hands.fill({"size": "2 m"}, "mesh")
    bench.page.locator("label:has(#autosolve)").first.click()
    bench.wait_seen(".combination-choice", "ULS 1")

    model = model_of(bench)
    center = (20.0, 10.0)
    assert model.plate.outline == Circle(kind="circle", centre=center, radius=8.0)
    own = {
        "G": math.pi * 8**2 * 0.4 * 25e3 + 2 * math.pi * 7.75 * 85e3,
        "Q": math.pi * 7.75**2 * 70e3,
        "Q 2": -math.pi * 8**2 * 15e3,
    }
    found = {load.kind: load for load in model.loads}
    assert found["line"].shape == Circle(kind="circle", centre=center, radius=7.75)
    assert found["area"].shape == Circle(kind="circle", centre=center, radius=7.75)
    weights = {
        combination: sum(factor * own[name] for name, factor in combination.factors)
        for combination in list_combinations(model)
    }
    heaviest = max(weights, key=weights.__getitem__)
    [results] = solve(model.replace(combine=None, combinations=(heaviest,), mesh={"size": 2.0})).values()
    assert results.certificate.load == pytest.approx(weights[heaviest], rel=2e-3)


def _loads(bench: Bench, kind: str) -> list[dict[str, Any]]:
    return [load for load in all_loads(bench) if load.get("kind") == kind]
