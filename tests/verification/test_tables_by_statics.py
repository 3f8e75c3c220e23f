"""Tables of a solved raft with columns, a pile and three combinations, against statics and direct calls."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.design.codes.en1992_2004.bending import Axes, slab
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.en1992_2004.perimeter_demand import RectangularColumn, demand
from groundslab.design.demands.design_moments import wood_armer
from groundslab.errors import NoEquilibrium
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.tables.envelopes import fields_of_envelope
from groundslab.views.tables.result_tables import tables_of
from groundslab.views.tables.table import Table

MODEL = Model(
    title="A small raft",
    plate={"length_x": 8, "length_y": 6, "thickness": 0.4, "E": 30e9, "nu": 0.2},
    ground={"kind": "winkler", "k": 20e6},
    mesh={"size": 0.25},
    columns=[
        {"name": "A", "x": -2, "y": 0.5, "width_x": 0.4, "width_y": 0.4},
        {"name": "B", "x": 2, "y": 0, "diameter": 0.5},
    ],
    supports=[{"kind": "point", "name": "pile", "x": 3, "y": 2, "stiffness": 50e6, "acts": "in compression"}],
    cases=[{"name": "G"}, {"name": "Q", "action": "variable"}],
    loads=[
        {"kind": "self weight", "unit_weight": 25e3, "case": "G"},
        {"kind": "point", "column": "A", "P": 500e3, "case": "G"},
        {"kind": "point", "column": "B", "P": 300e3, "case": "G"},
        {"kind": "point", "column": "A", "P": 200e3, "case": "Q"},
        {"kind": "patch", "q": 20e3, "x": (-4, -2), "y": (-3, 3), "case": "Q"},
        {"kind": "line", "q": 30e3, "points": [(-3, 1), (3, 1)], "case": "Q"},
    ],
    combinations=[
        {"name": "ULS", "factors": {"G": 1.35, "Q": 1.5}},
        {"name": "upside down", "factors": {"G": -1.0}},
        {"name": "in use", "limit_state": "characteristic", "factors": {"G": 1.0, "Q": 1.0}},
    ],
    output={
        "points": [{"name": "P", "x": 0.3, "y": -0.2}],
        "lines": [{"name": "L", "start": (-4, 0), "end": (4, 0)}],
        "strips": [{"name": "all", "start": (-4, 0), "end": (4, 0), "width": 6, "stations": 9}],
    },
    reinforcement={
        "f_ck": 30e6,
        "f_yk": 500e6,
        "bottom": (0.05, 0.06),
        "top": (0.04, 0.055),
        "averaging": {"at_columns": "peak", "at_walls": "peak"},  # areas of single nodes are compared
    },
)
#: Own weight 8 x 6 x 0.4 x 25 = 480, with the columns 1280 kN; column 200, patch 20 x 12 = 240, line 30 x 6 = 180.
G, Q = 1280, 620


@pytest.fixture(scope="module")
def combined() -> Results:
    """Return the solved combinations."""
    return groundslab.solve(MODEL)


@pytest.fixture(scope="module")
def tables(combined: Results) -> dict[str, Table]:
    """Return all thirteen tables by name."""
    found = {table.name: table for table in tables_of(combined)}
    assert len(found) == 14
    return found


def rows(table: Table, **where: Any) -> list[dict[str, Any]]:
    """Return the rows of a table whose cells are these."""
    names = [column.name for column in table.columns]
    found = [dict(zip(names, cells, strict=True)) for cells in table.rows()]
    return [each for each in found if all(each[key] == value for key, value in where.items())]


@pytest.mark.slow
def test_sums_of_loads(combined: Results, tables: dict[str, Table]) -> None:
    """The sums are those worked out by hand, and one combination cannot be: everything pushes up."""
    assert isinstance(combined.refused["upside down"], NoEquilibrium)
    uls, down, use = rows(tables["combinations"])
    assert uls["sum of loads"] == pytest.approx(1.35 * G + 1.5 * Q)
    assert use["sum of loads"] == pytest.approx(G + Q)
    assert down["outcome"].startswith("FOUNDATION FAILS: ")
    for each in (uls, use):
        assert each["reaction"] == pytest.approx(each["sum of loads"], rel=1e-6)


@pytest.mark.slow
def test_pile_and_pressure_carry_the_loads(combined: Results, tables: dict[str, Table]) -> None:
    """The pile's force is 50 MN/m times its settlement; with the pressure over the area it is the sum of the loads."""
    (pile,) = rows(tables["supports"], combination="ULS")
    assert pile["force"] == pytest.approx(50 * pile["greatest settlement"])
    plate = combined["ULS"].plate
    assert pile["force"] + plate.contact_force.sum() / 1e3 == pytest.approx(1.35 * G + 1.5 * Q, rel=1e-6)


@pytest.mark.slow
def test_strips_are_in_equilibrium(combined: Results, tables: dict[str, Table]) -> None:
    """Forces across the whole width at x = 1 m are those of the loads and the pressure beyond it."""
    (one,) = rows(tables["strips"], combination="in use", s=5.0)
    plate = combined["in use"].plate
    assert one["width on the plate"] == pytest.approx(6)
    (pile,) = rows(tables["supports"], combination="in use")
    # beyond x = 1: self-weight 10 x 3 x 6, column B, 2 m of the line load; levers about x = 1
    load, moment = 180 + 300 + 60, -(180 * 1.5 + 300 * 1 + 60 * 1)
    # pressure of Winkler springs, k w, by its exact integral over the elements
    share = np.array([1, 1, 1, 1, 4, 4, 4, 4, 16]) / 36 * 0.25**2
    right = plate.elements[plate.nodes[plate.elements[:, 8], 0] > 1]
    p, x = 20e3 * plate.settlement[right] * share, plate.nodes[right][..., 0]
    by_statics = load - p.sum() - pile["force"], moment + (p * (x - 1)).sum() + pile["force"] * 2
    assert one["shear"] == pytest.approx(by_statics[0], rel=1e-3)
    assert one["moment"] == pytest.approx(by_statics[1], rel=1e-3)


def test_points_and_lines(combined: Results, tables: dict[str, Table]) -> None:
    """Values at the point are the result's own; the line ends where the plate does."""
    for name in ("ULS", "in use"):
        (point,) = rows(tables["points"], combination=name)
        plate = combined[name].plate
        assert point["settlement w"] == pytest.approx(1e3 * plate.value_at("settlement", 0.3, -0.2))
        m = [plate.value_at(f"moment_{of}", 0.3, -0.2) for of in ("x", "y", "xy")]
        assert point["design moment bottom y"] == pytest.approx(wood_armer(*map(np.array, m)).bottom_y / 1e3)
        line = rows(tables["lines"], combination=name)
        assert (line[0]["s"], line[-1]["s"], line[-1]["x"]) == (0, pytest.approx(8), pytest.approx(4))
        middle = next(each for each in line if abs(each["x"]) < 1e-9)
        # a node's force is the mean of k w by its shape function: k w itself, but for the bend of w in an element
        assert middle["pressure p"] == pytest.approx(20 * middle["settlement w"], rel=1e-3)


@pytest.mark.slow
def test_columns(combined: Results, tables: dict[str, Table]) -> None:
    """Loads by hand; punching as called directly; V_Ed is the field of shear forces around the column, too."""
    a, b = rows(tables["columns"], combination="ULS")
    assert (a["load"], b["load"]) == pytest.approx((1.35 * 500 + 1.5 * 200, 1.35 * 300))
    w = [combined["ULS"].plate.value_at("settlement", x, y) * 1e3 for x, y in ((-2, 0.5), (2, 0))]
    assert (a["settlement"], b["settlement"]) == pytest.approx(w)
    assert a["angular distortion"] == pytest.approx(abs(w[1] - w[0]) / np.hypot(4, 0.5))
    d = 0.4 - 0.055
    # inside around A: self-weight, half of the patch, and the line load between y = 1 and its perimeter
    column = RectangularColumn(-2, 0.5, 0.4, 0.4)
    inside = demand(combined["ULS"].plate, column, d, 975e3)
    chord = 2 * (0.2 + np.sqrt((2 * d) ** 2 - 0.3**2))
    others = 1.35 * 10 * inside.area + 1.5 * 20 * inside.area / 2 + 1.5 * 30 * chord
    assert a["other loads inside"] == pytest.approx(others, rel=1e-3)
    assert (a["d"], a["u"]) == pytest.approx((345, inside.u))
    assert a["pressure inside"] == pytest.approx(inside.pressure_inside / 1e3)
    assert a["V_Ed"] == pytest.approx(975 + others - inside.pressure_inside / 1e3, rel=1e-3)
    # the pressure's moments about the column, and those of the loads beside its axes, make beta of 6.51
    c, r = 0.4, 2 * d
    side = (np.arange(400) + 0.5) / 400 * (c + 2 * r) - (c / 2 + r)
    x, y = (each.ravel() for each in np.meshgrid(side, side))
    under = np.hypot(np.maximum(abs(x) - c / 2, 0), np.maximum(abs(y) - c / 2, 0)) < r
    x, y = x[under], y[under]
    force = 20e3 * combined["ULS"].plate.value_at("settlement", x - 2, y + 0.5) * (side[1] - side[0]) ** 2
    patch, line = 1.5 * 20 * inside.area / 2, 1.5 * 30 * chord
    M_x = force @ x + patch * np.abs(x).mean()
    M_y = force @ y - line * 0.5
    W = c**2 / 2 + c**2 + 4 * c * d + 16 * d**2 + 2 * np.pi * d * c
    beta = 1 + 0.6 * np.hypot(M_x, M_y) * inside.u / (a["V_Ed"] * W)
    assert a["beta"] - 1 == pytest.approx(beta - 1, rel=0.01)
    assert a["v_Ed"] == pytest.approx(beta * a["V_Ed"] / 1e3 / (inside.u * d), rel=1e-4)
    # what the loads inside amount to shows in the shear forces, which know nothing of the sums above
    assert a["V_Ed"] == pytest.approx(inside.shear / 1e3, rel=2e-3)


def test_reinforcement(combined: Results, tables: dict[str, Table]) -> None:
    """Areas are those of direct calls for the one ultimate combination that is solved."""
    plate = combined["ULS"].plate
    moments = wood_armer(plate.moment_x, plate.moment_y, plate.moment_xy)
    direct = slab(moments, 0.4, Axes(0.05, 0.06, 0.04, 0.055), Concrete(30e6), Steel(500e6))
    fields = fields_of_envelope(combined)
    for layer in ("bottom x", "bottom y", "top x", "top y"):
        (one,) = rows(tables["reinforcement"], layer=layer)
        area = getattr(direct, layer.replace(" ", "_")) * 1e4
        assert one["required area"] == pytest.approx(area.max())
        assert one["combination"] == "ULS"
        assert fields[f"reinforcement {layer} [cm2/m]"] == pytest.approx(area)


def test_envelope_and_extremes_agree(tables: dict[str, Table]) -> None:
    """With one solved combination in each limit state the envelope is that combination's extremes."""
    for state, name in (("ultimate", "ULS"), ("characteristic", "in use")):
        for one in rows(tables["extremes"], combination=name):
            (envelope,) = rows(tables["envelope"], **{"limit state": state}, quantity=one["quantity"])
            assert all(envelope[key] == value for key, value in one.items() if key != "combination")
            assert envelope["combination of the greatest"] == name
