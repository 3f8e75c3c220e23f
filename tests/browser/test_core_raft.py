"""A raft with a core of walls from nothing, by mouse and keyboard: every click, key and entry counts as an action."""

from __future__ import annotations

import math
import tomllib
from typing import Any

import pytest

from groundslab.model.combinations import list_combinations
from groundslab.model.model import Model
from groundslab.model.shapes import Rectangle
from helpers.browsing import Bench, Server
from helpers.hands import Hands, all_loads, begin, forces_of, model_of

pytestmark = pytest.mark.slow

#: An engineer with the data at hand needs fewer actions than this.
FEW_FOR_A_CORE = 270
#: Combinations of the raft with a core: limit state, and factors of cases.
COMBINATIONS = {
    "ULS 1": ("ultimate", {"G": 1.35, "Q": 1.5}),
    "ULS Wx": ("ultimate", {"G": 1.35, "Q": 1.05, "Wx": 1.5}),
    "ULS Wy min": ("ultimate", {"G": 1.0, "Wy": -1.5}),
    "flood, wind": ("accidental", {"G": 1.0, "Wx": 0.2, "flood": 1.0}),
    "UPL flood": ("uplift", {"G": 0.95, "flood": 1.05}),
    "characteristic": ("characteristic", {"G": 1.0, "Q": 1.0, "Wx": 0.6}),
    "quasi-permanent": ("quasi-permanent", {"G": 1.0, "Q": 0.3}),
}
CASES = ("G", "Q", "Wx", "Wy", "flood")
#: Its boreholes: places, and what differs of their layers.
BOREHOLES: tuple[tuple[tuple[float, float], dict[str, str], dict[str, str], dict[str, str]], ...] = (
    ((0.0, 12.0), {}, {"E_bottom": "65 MPa"}, {"E": "95 MPa"}),
    ((-13.0, -10.0), {"E": "18 MPa", "thickness": "2 m"}, {"E_bottom": "60 MPa", "thickness": "6 m"}, {"E": "90 MPa"}),
)


def _add_cases(hands: Hands) -> None:
    """Add permanent and live loads with their combinations, then wind and flood, which take part where it is said."""
    page = hands.page
    name, kind = page.get_by_label("name of a new case"), page.get_by_label("type of a new case")
    hands.tab("Load cases")
    hands.enter("G", name)
    hands.keys("Enter")
    hands.enter("variable B: offices", kind)
    hands.enter("Q", name)
    hands.keys("Enter")
    hands.bench.wait_text('category = "B"')
    for n, (combination, (state, _)) in enumerate(COMBINATIONS.items()):
        hands.click(page.get_by_role("button", name="+ combination"))
        hands.enter(combination, page.locator(f'[data-key="name-{n}"]'))
        if state != "ultimate":
            hands.enter(state, page.locator(f'[data-key="state-{n}"]'))
    hands.enter("wind actions", kind)
    for each in CASES[2:4]:
        hands.enter(each, name)
        hands.keys("Enter")
    hands.enter("accidental", kind)
    hands.enter("flood", name)
    hands.keys("Enter")
    for n in (3, 4):
        hands.enter("wind", page.get_by_label(f"group of case {n}"))
    for n, (_, factors) in enumerate(COMBINATIONS.values()):
        for k, case in enumerate(CASES):
            if factors.get(case, 0.0) != (1.0 if k < 2 else 0.0):
                hands.enter(f"{factors.get(case, 0):g}", page.locator(f'[data-key="factor-{n}-{k}"]'))
    hands.table("cases")
    hands.fill_down("Hx", 2, ("740 kN",))
    hands.fill_down("Hy", 3, ("940 kN",))


def _add_zones(hands: Hands) -> None:
    """Draw where the slab is thicker, and the opening in it, whose sides the pointer does not meet exactly."""
    hands.tab("Plan")
    hands.line("t", (-6.0, -5.0), (6.0, 5.0))
    hands.fill({"thickness": "1.4 m"}, "plate", "zones", 0)
    hands.line("o", (0.5, -1.2), (2.9, 1.2))
    hands.bench.wait_text("[[plate.openings]]")
    hands.pair(("0.5 m", "2.9 m"), "plate", "openings", 0, "x")
    hands.pair(("-1.2 m", "1.2 m"), "plate", "openings", 0, "y")


def _add_columns(hands: Hands) -> None:
    """Add columns at the corners, along the edges and inside on grids; two of them are round."""
    hands.tab("Plan")
    hands.enter("Q", hands.page.locator(".case-choice > select"))
    for x, y, spacing_x, spacing_y, width_x, width_y, live, dead in (
        ("-13.6", "-10.6", "27.2", "21.2", "500 mm", "500 mm", "250", "700"),
        ("-6.8", "-10.65", "2x6.8", "21.3", "800 mm", "400 mm", "500", "1300"),
        ("-13.65", "-3.6", "27.3", "7.2", "400 mm", "800 mm", "500", "1300"),
        ("-9", "-6.2", "18", "12.4", "600 mm", "600 mm", "900", "2200"),
    ):
        place = {"x": x, "y": y, "spacing_x": spacing_x, "spacing_y": spacing_y}
        before = hands.bench.text()
        hands.generate("columns", {**place, "width_x": width_x, "width_y": width_y, "P": live, "P_2": dead})
        hands.bench.until(lambda before=before: hands.bench.text() != before)
    hands.table("columns")
    hands.cell("cx", 16)
    hands.keys("Shift+ArrowDown", "Shift+ArrowRight", "Delete")
    hands.fill_down("d", 16, ("0.7 m", "0.7 m"))


def _add_walls(hands: Hands) -> None:
    """Draw two walls, enter their loads, and add both again, turned about the middle, where wind acts the other way."""
    hands.tab("Plan")
    hands.line("w", (-4.0, -3.0), (-4.0, 3.0))
    hands.bench.wait_text('name = "W1"')
    hands.fill({"thickness": "300 mm"}, "walls", 0)
    hands.line("w", (-4.0, -3.0), (4.0, -3.0))
    hands.table("loads line")
    wind = ("229.17 kN/m", "291.67 kN/m")
    hands.fill_down("case", 0, ("G", "Q", "Wx", "G", "Q", "Wy"))
    loads = (("550 kN/m", "200 kN/m", f"-{each}") for each in wind)
    hands.fill_down("q", 0, (q for three in loads for q in three))
    hands.fill_down("wall", 0, ["W1"] * 3 + ["W2"] * 3)
    hands.tab("Plan")
    hands.page.locator(".drawing").focus()
    hands.keys("v")
    hands.actions += 1
    hands.bench.drag((5.0, -3.5), (-5.0, 3.5))
    hands.keys("r")
    for key, value in {"angle": "180", "x": "0", "y": "0"}.items():
        hands.enter(value, hands.page.locator(f'.action-dialog [data-key="{key}"] input'))
    hands.click(hands.page.locator('.action-dialog [data-key="copy"] input'))
    hands.keys("Enter")
    hands.bench.wait_text('wall = "W4"')
    hands.table("loads line")
    hands.fill_down("q", 8, wind[:1])
    hands.fill_down("q", 11, wind[1:])


def _add_areas(hands: Hands) -> None:
    """Add loads on the entire slab, and the water below its thick middle."""
    hands.tab("Plan")
    for case, q in (("G", "1.5 kPa"), ("Q", "5 kPa"), ("flood", "-25 kPa")):
        n = len(all_loads(hands.bench))
        hands.enter(case, hands.page.locator(".case-choice > select"))
        hands.click(hands.page.get_by_role("button", name="+ uniform load"))
        hands.bench.until(lambda n=n: len(all_loads(hands.bench)) == n + 1)
        hands.fill({"q": q}, "loads", n)
    hands.line("a", (-6.0, -5.0), (6.0, 5.0))
    hands.bench.wait_text('kind = "patch"')
    hands.fill({"q": "-5 kPa"}, "loads", n + 1)


def _add_ground(hands: Hands) -> None:
    """Enter three layers and their strength, and place two boreholes that differ from them."""
    layers: tuple[dict[str, str], ...] = (
        {"E": "15 MPa", "nu": "0.35", "thickness": "3 m"},
        {"E": "45 MPa", "E_bottom": "60 MPa", "thickness": "5 m"},
        {"E": "90 MPa", "thickness": "6 m"},
    )
    hands.tab("Form")
    hands.click(hands.page.locator('[data-section="ground"]').get_by_role("button", name="Add Layer"))
    hands.bench.until(lambda: len(tomllib.loads(hands.bench.text())["ground"]["layers"]) == 3)
    for n, layer in enumerate(layers):
        hands.fill(layer, "ground", "layers", n)
    hands.tab("Plan")
    hands.page.locator(".drawing").focus()
    hands.keys("h")
    # the first one has the layers of the ground, the others those of the first
    for n, (place, *changes) in enumerate(BOREHOLES):
        hands.click_at(*place)
        hands.bench.until(lambda n=n: len(tomllib.loads(hands.bench.text()).get("boreholes", [])) == n + 1)
        for k, values in enumerate(changes):
            hands.fill(values, "boreholes", n, "layers", k)


def _add_checks(hands: Hands) -> None:
    """Enter limits, the strength of the soil, the mesh and bars."""
    hands.tab("Form")
    for name in ("limits", "mesh"):
        hands.open_section(name)
    for name in ("soil_strength", "reinforcement"):
        hands.add_section(name)
        hands.bench.wait_text(f"[{name}]")
    lengths = {"settlement": "50 mm", "differential_settlement": "25 mm"}
    hands.fill({**lengths, "angular_distortion": "0.002", "tilt": "0.002"}, "limits")
    hands.fill({"pressure": "300 kPa", "contact_share": "0.95"}, "limits")
    hands.fill({"phi": "28", "c": "5 kPa", "unit_weight": "10 kN/m^3", "overburden": "15 kPa"}, "soil_strength")
    hands.fill({"size": "0.6 m", "accuracy": "15 %"}, "mesh")
    hands.fill({"annex": "Germany", "exposure": "XC2"}, "reinforcement")
    hands.pair(("45 mm", "40 mm"), "reinforcement", "cover")
    # the axes of the bars, which follow from the cover, are emptied one after the other
    for layer, n in (("bottom", 0), ("bottom", 1), ("top", 0), ("top", 1)):
        before = hands.bench.text()
        hands.enter("", hands.bench.field("reinforcement", layer).locator("input").nth(n))
        hands.bench.until(lambda before=before: hands.bench.text() != before)
    for layer in ("bottom x", "bottom y", "top x", "top y"):
        hands.click(hands.page.get_by_role("button", name=f"Add {layer}"))
        key = layer.replace(" ", "_")
        hands.fill({"diameter": "20 mm", "spacing": "150 mm"}, "reinforcement", key)
        hands.bench.wait_text(f'{key} = {{diameter = "20 mm", spacing = "150 mm"}}')


def test_a_raft_with_a_core(server: Server, bench: Bench) -> None:
    """18 columns and four walls of a core on three layers, wind in two cases, flood, seven combinations."""
    hands = begin(server, bench)
    hands.fill({"length_x": "28 m", "length_y": "22 m", "thickness": "0.9 m", "E": "33 GPa"}, "plate")
    _add_cases(hands)
    _add_columns(hands)
    _add_walls(hands)
    _add_zones(hands)
    _add_areas(hands)
    _add_ground(hands)
    _add_checks(hands)
    print(f"actions for a raft with a core: {hands.actions}")
    assert hands.actions < FEW_FOR_A_CORE

    model = model_of(bench)
    _check_slab(model)
    _check_loads(model)
    made = {each.name: (each.limit_state, dict(each.factors)) for each in list_combinations(model)}
    assert made == COMBINATIONS


def _check_slab(model: Model) -> None:
    """Compare slab, ground, columns and walls with what was to be entered."""
    assert (model.plate.sides, model.plate.thickness, model.plate.E) == ((28.0, 22.0), 0.9, 33e9)
    [zone], [opening] = model.plate.zones, model.plate.openings
    assert (zone.thickness, zone.shape) == (1.4, Rectangle(kind="rectangle", x=(-6.0, 6.0), y=(-5.0, 5.0)))
    assert opening == Rectangle(kind="rectangle", x=(0.5, 2.9), y=(-1.2, 1.2))
    middle = (45e6, 60e6, 0.3, 5.0)
    assert _layers(model.ground) == [(15e6, None, 0.35, 3.0), middle, (90e6, None, 0.3, 6.0)]
    assert {(each.x, each.y): _layers(each) for each in model.boreholes} == {
        (-13.0, -10.0): [(18e6, None, 0.35, 2.0), (45e6, 60e6, 0.3, 6.0), (90e6, None, 0.3, 6.0)],
        (0.0, 12.0): [(15e6, None, 0.35, 3.0), (45e6, 65e6, 0.3, 5.0), (95e6, None, 0.3, 6.0)],
    }
    inside = {(x, y) for x in (-9.0, 9.0) for y in (-6.2, 6.2)}
    edges = {(x, y) for x in (-6.8, 0.0, 6.8) for y in (-10.65, 10.65)}
    sides = {(x, y) for x in (-13.65, 13.65) for y in (-3.6, 3.6)}
    corners = {(x, y) for x in (-13.6, 13.6) for y in (-10.6, 10.6)}
    places = [(column.x, column.y) for column in model.columns]
    assert (len(places), set(places)) == (18, inside | edges | sides | corners)
    assert [(column.x, column.y) for column in model.columns if column.diameter == 0.7] == [(-9.0, 6.2), (9.0, 6.2)]
    assert [wall.thickness for wall in model.walls] == [0.3] * 4
    assert sorted(_lengths(model).values()) == [6.0, 6.0, 8.0, 8.0]
    bars = model.reinforcement
    assert (bars.annex, bars.exposure, bars.cover) == ("Germany", "XC2", (0.045, 0.04))
    layers = (bars.bottom_x, bars.bottom_y, bars.top_x, bars.top_y)
    assert [(each.diameter, each.spacing) for each in layers] == [(0.02, 0.15)] * 4
    assert (model.limits.settlement, model.limits.contact_share) == (0.05, 0.95)
    assert (model.soil_strength.phi, model.soil_strength.overburden) == (28.0, 15e3)
    assert (model.mesh.size, model.mesh.accuracy) == (0.6, 0.15)


def _layers(ground: Any) -> list[tuple[float, float | None, float, float]]:
    return [(layer.E, layer.E_bottom, layer.nu, layer.thickness) for layer in ground.layers]


def _lengths(model: Model) -> dict[str, float]:
    """Return the lengths of straight walls by their names [m]."""
    return {wall.name: math.dist(wall.points[0], wall.points[-1]) for wall in model.walls}


def _check_loads(model: Model) -> None:
    """Compare the loads of each case with sums by hand."""
    assert [case.name for case in model.cases] == list(CASES)
    assert [case.category for case in model.cases] == [None, "B", *["wind"] * 2, None]
    assert [case.group for case in model.cases[2:4]] == ["wind"] * 2
    assert [(case.H_x, case.H_y) for case in model.cases[2:4]] == [(740e3, 0), (0, 940e3)]
    assert forces_of(model, "G") == 4 * 700e3 + 10 * 1300e3 + 4 * 2200e3
    assert forces_of(model, "Q") == 4 * 250e3 + 10 * 500e3 + 4 * 900e3
    lengths, middles = _lengths(model), {wall.name: _middle(wall.points) for wall in model.walls}
    lines = [load for load in model.loads if load.kind == "line"]
    sums = {name: sum(load.q * lengths[load.wall] for load in lines if load.case == name) for name in CASES}
    assert sums == {**dict.fromkeys(CASES, 0.0), "G": 28 * 550e3, "Q": 28 * 200e3}
    # the couple of the wind, positive if it presses larger x or y down
    couples = {
        name: [
            sum(load.q * lengths[load.wall] * middles[load.wall][n] for load in lines if load.case == name)
            for n in (0, 1)
        ]
        for name in CASES[2:4]
    }
    by_x, by_y = 2 * 4 * 6 * 229.17e3, 2 * 3 * 8 * 291.67e3
    expected = {"Wx": [by_x, 0], "Wy": [0, by_y]}
    assert couples == {name: pytest.approx(values) for name, values in expected.items()}
    whole = [(load.case, load.q) for load in model.loads if load.kind == "uniform"]
    assert whole == [("G", 1.5e3), ("Q", 5e3), ("flood", -25e3)]
    [patch] = [load for load in model.loads if load.kind == "patch"]
    assert (patch.case, patch.q, patch.x, patch.y) == ("flood", -5e3, (-6.0, 6.0), (-5.0, 5.0))
    assert [load.case for load in model.loads if load.kind == "self weight"] == ["G"]


def _middle(points: Any) -> tuple[float, float]:
    (x, y), (x2, y2) = points
    return (x + x2) / 2, (y + y2) / 2
