"""Three foundations from nothing, by mouse and keyboard: every click, key and entry counts as an action."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import ezdxf
import pytest

from groundslab import solve
from groundslab.case import casefile
from groundslab.model.combinations import list_combinations, place_patterns
from groundslab.model.model import Model
from groundslab.model.shapes import Circle, Polygon
from helpers.browsing import Bench, Server

pytestmark = pytest.mark.slow

#: An engineer with a data sheet of the racks and the forklift needs no more for a warehouse's floor.
MOST_ACTIONS_OF_A_WAREHOUSE = 60


@dataclass
class Hands:
    """What a user does in the workbench, counted."""

    bench: Bench
    actions: int = 0

    @property
    def page(self) -> Any:
        """The page."""
        return self.bench.page

    def click(self, locator: Any) -> None:
        """Click on something."""
        self.actions += 1
        locator.click()

    def keys(self, *keys: str) -> None:
        """Press keys, each a chord."""
        for key in keys:
            self.actions += 1
            self.page.keyboard.press(key)

    def type(self, text: str) -> None:
        """Type a text where the focus is, and Enter."""
        self.actions += 1
        self.page.keyboard.type(text)
        self.keys("Enter")

    def enter(self, value: str, locator: Any) -> None:
        """Type a value into a field, or choose it."""
        self.actions += 1
        if locator.evaluate("(element) => element.tagName") == "SELECT":
            locator.select_option(label=value)
        else:
            locator.fill(value)

    def fill(self, values: dict[str, str], *path: str | int) -> None:
        """Enter values of keys below a path."""
        for key, value in values.items():
            self.enter(value, self.bench.field(*path, key).locator("input, select").first)

    def tab(self, name: str) -> None:
        """Choose a view of the model."""
        self.actions += 1
        self.bench.tab(name)

    def generate(self, tool: str, values: dict[str, str]) -> None:
        """Open a generator by its button, enter values, and end with Enter."""
        self.click(self.page.locator(f'.tool[data-tool="{tool}"]'))
        for key, value in values.items():
            self.enter(value, self.page.locator(f'.action-dialog [data-key="{key}"] :is(input, select)'))
        self.keys("Enter")

    def draw(self, tool: str, places: Iterable[str]) -> None:
        """Draw with a tool by typed places."""
        self.page.locator(".drawing").focus()
        self.keys(tool)
        for place in places:
            self.type(place)

    def add_case(self, name: str, action: str = "permanent", others: str = "") -> None:
        """Add a load case in the plan, to which new loads belong; the first one says where others belong."""
        self.click(self.page.get_by_role("button", name="+ case"))
        self.page.get_by_label("name of the new load case").wait_for()
        self.type(name)
        self.actions += 1
        self.page.get_by_label("action of the new load case").select_option(action)
        if others:
            self.actions += 1
            self.page.get_by_label("loads without a case", exact=True).select_option(others)
        self.bench.wait_text(f'name = "{name}"', f'action = "{action}"')

    def table(self, name: str) -> None:
        """Choose a table."""
        self.actions += 1
        self.page.get_by_label("table", exact=True).select_option(name)

    def cell(self, row: int, column: str, value: str) -> None:
        """Enter a value into a cell of the table, by the column's head, or the end of it."""
        heads: list[str] = []

        def is_there() -> bool:
            heads[:] = _heads(self.bench)
            return any(head.endswith(column) for head in heads)

        self.bench.until(is_there, lambda: f"{column} in {heads}")
        head = column if column in heads else next(head for head in heads if head.endswith(column))
        cells = self.page.locator("table.sheet tbody tr").nth(row).locator("td")
        self.click(cells.nth(heads.index(head) - 1))
        self.type(value)

    def open_section(self, name: str) -> None:
        """Open a section of the form."""
        self.click(self.page.locator(f'[data-section="{name}"] > summary'))

    def add_section(self, name: str) -> None:
        """Open a section of the form, and add it with what it starts from."""
        self.open_section(name)
        self.click(self.page.locator(f'[data-section="{name}"] .sub-head').get_by_role("button", name="Add").first)


def begin(server: Server, bench: Bench) -> Hands:
    """Open a new case, and remove the self-weight that it begins with."""
    bench.open(server.start(None))
    hands = Hands(bench)
    hands.click(bench.page.locator("label:has(#autosolve)").first)
    hands.click(bench.page.locator(".chips .chip").first)
    hands.click(bench.page.locator(".property-acts").get_by_role("button", name="Remove"))
    bench.until(lambda: "\n[[loads]]" not in bench.text())
    return hands


def model_of(bench: Bench) -> Model:
    """Return the model, which has no issue."""
    issues = bench.page.locator(".issue-list")
    bench.until(lambda: "No errors" in bench.seen(".issue-count"), lambda: str(issues.text_content()))
    return casefile.loads(bench.text())


def forces_of(model: Model, case: str) -> float:
    """Return the sum of the point loads of a case [N]."""
    loads = place_patterns(model).loads
    return sum(load.P for load in loads if load.kind == "point" and load.case == case)


def test_a_warehouse_floor(server: Server, bench: Bench) -> None:
    """Twelve rack legs, a forklift along the edge, curling, combinations and reinforcement in less than 60 actions."""
    hands = begin(server, bench)
    hands.fill({"length_x": "24 m", "length_y": "24 m", "thickness": "200 mm", "E": "33 GPa"}, "plate")
    hands.add_case("floor")
    hands.click(bench.page.get_by_role("button", name="+ self-weight"))
    bench.wait_text('kind = "self weight"')
    rack = {"P": "45", "width_x": "100 mm", "width_y": "100 mm", "bay": "3", "depth": "1", "x": "-8", "y": "-6"}
    hands.generate("racks", {**rack, "case": "new load case"})
    bench.wait_text('kind = "rack"')
    path = {"x": "11.3", "y": "-11", "x2": "11.3", "y2": "11", "step": "5.5"}
    hands.generate("vehicle", {"front": "120", "rear": "0", **path, "case": "new load case"})
    bench.wait_text('kind = "vehicle"')
    hands.add_case("curling", "variable")
    hands.tab("Tables")
    hands.table("loads temperature")
    hands.click(bench.page.get_by_role("button", name="Add row"))
    bench.wait_text('kind = "temperature"')
    hands.cell(0, "case", "curling")
    hands.tab("Form")
    hands.fill({"kind": "winkler", "k": "50 MPa/m"}, "ground")
    hands.add_section("combine")
    hands.add_section("reinforcement")
    bench.wait_text('concrete = "C30/37"')
    assert hands.actions < MOST_ACTIONS_OF_A_WAREHOUSE

    model = model_of(bench)
    assert model.plate.sides == (24.0, 24.0)
    assert forces_of(model, "racks") == 12 * 45e3
    # at five positions, each a case of its own
    positions = [case.name for case in place_patterns(model).cases if case.name.startswith("vehicle")]
    assert len(positions) == 5
    assert {forces_of(model, name) for name in positions} == {120e3}
    assert len(list_combinations(model)) > 20


def test_a_house_raft(server: Server, bench: Bench) -> None:
    """An L of 12 x 10 m on three layers and two boreholes, under walls and columns with wind, solved."""
    hands = begin(server, bench)
    hands.draw("b", ("0;0", "12;0", "12;5", "7;5", "7;10", "0;10"))
    hands.keys("Enter")
    bench.wait_text('kind = "polygon"')
    hands.fill({"thickness": "300 mm", "E": "31 GPa"}, "plate")
    hands.add_case("G")
    hands.click(bench.page.get_by_role("button", name="+ self-weight"))
    bench.wait_text('kind = "self weight"')
    grid = {"spacing_x": "3x2,5", "spacing_y": "", "width_x": "300 mm", "width_y": "300 mm", "P": "160", "case": "G"}
    hands.generate("columns", {"x": "2.5", "y": "2.5", **grid})
    bench.wait_text('name = "D1"')
    hands.generate("columns", {"x": "3.5", "y": "5", "spacing_x": "", "spacing_y": "2.5"})
    bench.wait_text('name = "A3"')
    walls = ("0.15;0.15", "11.85;0.15", "11.85;4.85", "6.85;4.85", "6.85;9.85", "0.15;9.85", "0.15;0.15")
    hands.draw("l", walls)
    hands.keys("Enter")
    bench.wait_text('kind = "line"')
    hands.fill({"q": "45 kN/m"}, "loads", 7)
    bench.wait_text('q = "45 kN/m"')
    hands.draw("h", ("1;9", "12;1"))
    bench.wait_text('name = "B2"')
    for name in ("Q", "W"):
        hands.add_case(name, "variable")
    hands.tab("Tables")
    hands.table("cases")
    for column, value in {"ψ0": "0.6", "ψ1": "0.2", "ψ2": "0"}.items():
        hands.cell(2, column, value)
    # the imposed loads of the columns are copies of the permanent ones, and wind lifts two of them
    hands.table("loads point")
    bench.page.locator("table.sheet").focus()
    hands.keys("Control+a", "Control+d")
    bench.until(lambda: len(_loads(bench, "point")) == 12)
    for row in range(6, 12):
        hands.cell(row, "case", "Q")
        hands.cell(row, "force P", "70")
    bench.until(lambda: bench.text().count('P = "70 kN"') == 6)
    model = model_of(bench)
    assert forces_of(model, "G") == 6 * 160e3
    assert forces_of(model, "Q") == 6 * 70e3
    # wind lifts the corner columns
    hands.tab("Plan")
    hands.enter("W", bench.page.locator(".case-choice > select"))
    hands.click(bench.page.locator('.tool[data-tool="point load"]'))
    for place in ((10.0, 2.5), (3.5, 7.5)):
        hands.actions += 1
        bench.click(*place)
        bench.until(lambda: len(_loads(bench, "point")) > 12)
    bench.until(lambda: len(_loads(bench, "point")) == 14)
    hands.tab("Tables")
    for row in (12, 13):
        hands.cell(row, "force P", "-120")
    bench.until(lambda: forces_of(casefile.loads(bench.text()), "W") == -240e3)
    hands.tab("Form")
    hands.add_section("combine")
    hands.open_section("mesh")
    hands.fill({"size": "0.6 m"}, "mesh")
    bench.wait_text('size = "0.6 m"')
    hands.keys("F9")
    bench.wait_solved()
    model = model_of(bench)
    # the walls run 0.15 m within the outline
    [wall] = _loads(bench, "line")
    assert len(wall["points"]) == 7
    corners = ((0.0, 0.0), (12.0, 0.0), (12.0, 5.0), (7.0, 5.0), (7.0, 10.0), (0.0, 10.0))
    assert model.plate.outline == Polygon(kind="polygon", points=corners)
    assert len(model.boreholes) == 2
    # the combination that is shown at first has the largest sum of factors
    heaviest = max(list_combinations(model), key=lambda combination: sum(dict(combination.factors).values()))
    [shown] = solve(model.replace(combine=None, combinations=(heaviest,))).values()
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
    bench.open(server.start(case))
    hands = Hands(bench)
    hands.click(bench.page.locator("label:has(#autosolve)").first)
    hands.keys("Control+o")
    hands.actions += 1
    bench.page.get_by_role("option", name="tank.dxf").dblclick()
    dialog = bench.page.locator(".drawing-dialog")
    for layer, what in (("BASE", "outline"), ("WALL", "line loads")):
        hands.enter(what, dialog.get_by_label(f"content of layer {layer}"))
    hands.enter("center of the slab", dialog.get_by_label("origin"))
    hands.click(dialog.get_by_role("button", name="Create case"))
    bench.wait_seen(".drawing-report pre", "outline")
    hands.click(bench.page.get_by_role("button", name="Close", exact=True))
    hands.fill({"thickness": "400 mm", "E": "33 GPa", "nu": "0.2"}, "plate")
    bench.wait_text('thickness = "400 mm"', "nu = 0.2\n")
    hands.add_case("tank", others="in it")
    hands.click(bench.page.get_by_role("button", name="+ self-weight"))
    bench.wait_text('kind = "self weight"')
    hands.add_case("water", "variable")
    # a circle is dragged from its center with Ctrl
    hands.click(bench.page.locator('.tool[data-tool="area load"]'))
    bench.page.keyboard.down("Control")
    hands.actions += 1
    bench.drag((0.0, 0.0), (7.75, 0.0))
    bench.page.keyboard.up("Control")
    bench.wait_text('kind = "area"')
    area = next(n for n, load in enumerate(_all_loads(bench)) if load["kind"] == "area")
    hands.fill({"q": "70 kPa"}, "loads", area)
    hands.enter("7.75 m", bench.field("loads", area, "shape", "radius").locator("input").first)
    hands.add_case("groundwater", "variable")
    hands.click(bench.page.get_by_role("button", name="+ uniform load"))
    bench.wait_text('kind = "uniform"')
    hands.fill({"q": "-15 kPa"}, "loads", area + 1)
    hands.tab("Form")
    hands.fill({"kind": "vlasov"}, "ground")
    bench.wait_text('kind = "vlasov"')
    hands.add_section("combine")
    hands.open_section("mesh")
    hands.fill({"size": "1 m"}, "mesh")
    bench.wait_text('size = "1 m"')
    model = model_of(bench)
    hands.keys("F9")
    bench.wait_solved()

    assert model.plate.outline == Circle(kind="circle", radius=8.0)
    own = {
        "tank": math.pi * 8**2 * 0.4 * 25e3 + 2 * math.pi * 7.75 * 85e3,
        "water": math.pi * 7.75**2 * 70e3,
        "groundwater": -math.pi * 8**2 * 15e3,
    }
    found = {load.kind: load for load in model.loads}
    assert found["line"].shape == Circle(kind="circle", radius=7.75)
    assert found["area"].shape == Circle(kind="circle", radius=7.75)
    weights = {
        combination: sum(factor * own[name] for name, factor in combination.factors)
        for combination in list_combinations(model)
    }
    heaviest = max(weights, key=weights.__getitem__)
    [results] = solve(model.replace(combine=None, combinations=(heaviest,), reinforcement=None)).values()
    assert results.certificate.load == pytest.approx(weights[heaviest], rel=2e-3)


def _heads(bench: Bench) -> list[str]:
    return [text.strip() for text in bench.page.locator("table.sheet thead th").all_inner_texts()]


def _loads(bench: Bench, kind: str) -> list[dict[str, Any]]:
    return [load for load in _all_loads(bench) if load.get("kind") == kind]


def _all_loads(bench: Bench) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = tomllib.loads(bench.text()).get("loads", [])
    return found
