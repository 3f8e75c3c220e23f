"""Discretization errors in tables: each value's own, of the combination that it belongs to, by its change."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.model.model import Model
from groundslab.results.results import CombinationResult, Comparison, Results
from groundslab.views.report.html import render_report
from groundslab.views.report.table_layout import layout_table
from groundslab.views.tables.errors import EXTREMES, VALUES
from groundslab.views.tables.result_tables import tables_of
from groundslab.views.tables.table import Table
from helpers import synthetic
from helpers.pages import page

pytestmark = pytest.mark.slow

STEEL = {"f_ck": "30 MPa", "f_yk": "500 MPa", "bottom": ("40 mm", "50 mm"), "top": ("30 mm", "45 mm")}
#: Of what is half its error again on elements twice as large, the change is the error that is left.
HALVED = 0.5


def slab(size: float, **changes: Any) -> Model:
    """Return a slab with a line support and all that tables can be asked for, two ultimate combinations."""
    across = {"start": (-3, 0.2), "end": (3, 0.4)}
    parts: dict[str, Any] = {
        "plate": {"length_x": 6, "length_y": 4, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "loads": [
            {"kind": "patch", "q": 60e3, "x": (-2, 0), "y": (-1, 1), "case": "G"},
            {"kind": "point", "column": "A", "P": 4e5, "case": "Q"},
            {"kind": "point", "column": "B", "P": 2e5, "case": "Q"},
        ],
        "cases": [{"name": "G"}, {"name": "Q", "action": "variable"}],
        "combinations": [
            {"name": "most", "factors": {"G": 1.35, "Q": 1.5}},
            {"name": "least", "factors": {"G": 1.0, "Q": 0.5}},
        ],
        "supports": [{"kind": "line", "name": "wall", "points": [(-3, -2), (3, -2)], "stiffness": 1e8}],
        "columns": [
            {"name": "A", "x": -1.1, "y": 0.1, "width_x": 0.5, "width_y": 0.5},
            {"name": "B", "x": 1.5, "y": 0.5, "diameter": 0.5},
        ],
        "walls": [{"name": "W", "thickness": 0.2, "points": [(-2, 1), (2, 1)]}],
        "output": {
            "points": [{"name": "P", "x": 0.3, "y": 0.2}],
            "lines": [{"name": "L", **across}],
            "strips": [{"name": "S", "width": 1, "stations": 5, **across}],
        },
        "reinforcement": STEEL,
        "mesh": {"size": size},
    }
    return Model(**parts | changes)


def tables(size: float) -> dict[str, Table]:
    """Return all tables: of the slab, below it on a continuum, of a rib, a frame above, a joint between two slabs."""
    left, right = ({"kind": "rectangle", "x": x, "y": (-2, 2)} for x in ((-3, 0), (0, 3)))
    sheet = {"thickness": 0.3, "E": 30e9, "nu": 0.2}
    none: dict[str, Any] = {"supports": [], "columns": [], "walls": [], "output": {}, "reinforcement": None}
    joined: dict[str, Any] = {
        "plate": {"name": "left", "outline": left, **sheet},
        "plates": [{"name": "right", "outline": right, **sheet}],
        "joints": [{"kind": "hinge", "between": ("left", "right")}],
        "loads": [
            {"kind": "patch", "q": q, "x": x, "y": (-1, 1), "case": case}
            for case, q, x in (("G", 40e3, (-2.5, 0)), ("G", 40e3, (0, 2.5)), ("Q", 60e3, (-2, 0)))
        ],
    }
    deep = slab(size, ground={"kind": "continuum", "half_space": {"E": 20e6, "nu": 0.3}})
    section = {"kind": "rib", "width": 0.3, "height": 0.4, "effective_width": 1.0}
    beams = [{"name": "R", "points": [(-3, 1.5), (3, 1.5)], "section": section}]
    loads = [{"kind": "patch", "q": 90e3, "x": (-2, 0), "y": (0, 2), "case": case} for case in "GQ"]
    walls = [{"name": "H", "thickness": 0.25, "height": 1.0, "points": [(-3, -1), (3, -1)]}]
    ribbed = slab(size, **none | {"reinforcement": STEEL, "beams": beams, "walls": walls, "loads": loads})
    bar = {"kind": "rectangle", "width": 0.3, "height": 0.6}
    frame = {"storeys": [3.0], "E": 30e9, "beams": [{"through": ["A", "B", "W"], "section": bar}]}
    framed = slab(size, output={}, reinforcement=None, building=frame)
    models = slab(size, **none, **joined), deep, ribbed, framed, slab(size)
    return {each.name: each for model in models for each in tables_of(groundslab.solve(model))}


@pytest.fixture(scope="module")
def coarse() -> dict[str, Table]:
    """Return tables on elements of 0.5 m."""
    return tables(0.5)


@pytest.fixture(scope="module")
def fine() -> dict[str, Table]:
    """Return the same tables on elements of 0.25 m."""
    return tables(0.25)


def shares(table: Table) -> dict[str, float]:
    """Return the largest error of each column of values, over the largest of them."""
    found = {}
    for column in table.columns:
        errors = [error for error in column.values if isinstance(error, float)]
        if column.error_of and errors:
            values = [abs(value) for value in table[column.error_of] if isinstance(value, float)]
            found[column.error_of] = max(errors) / max(max(values), 1e-30)
    return found


@pytest.mark.parametrize("name", ["extremes", "envelope", *(name for name in VALUES if not name.endswith("_punching"))])
def test_errors_fall_with_the_size_of_elements(coarse: dict[str, Table], fine: dict[str, Table], name: str) -> None:
    """Each table has errors that are more than rounding and less than the values, smaller on elements half as large."""
    before, after = shares(coarse[name]), shares(fine[name])
    assert set(before) <= {*VALUES.get(name, ("least", "greatest")), *(EXTREMES if name == "combinations" else ())}
    assert before.keys() == after.keys()
    assert before
    if name in ("extremes", "envelope"):  # of many quantities, some of which have no limit as the mesh is refined
        heads = ("quantity", "greatest", "error of the greatest")
        rows = (zip(*(tables[name][head] for head in heads), strict=True) for tables in (coarse, fine))
        for (quantity, value, error), (_, _, left) in zip(*rows, strict=True):
            if quantity in ("settlement w", "moment m_x", "moment m_y"):
                assert 0 < left < error < 0.6 * value, quantity  # type: ignore[operator]
        return
    assert max(before.values()) > 1e-6
    assert sum(after.values()) < 0.8 * sum(before.values())


def test_least_gap_and_pressure_are_exact(coarse: dict[str, Table]) -> None:
    """Where the plate touches there is no gap, and where it has lifted no pressure, on either mesh."""
    for quantity in ("gap g", "pressure p"):
        one = row(coarse["extremes"], combination="most", quantity=quantity)
        assert one["least"] == one["error of the least"] == 0
        assert one["error of the greatest"] > 0


def test_true_error_of_a_strip(coarse: dict[str, Table], fine: dict[str, Table]) -> None:
    """The largest moment across a strip is as near to that on the finer mesh as its error says."""
    values, other = (np.array(each["strips"]["moment"], dtype=float) for each in (coarse, fine))
    at = int(np.argmax(np.abs(values)))
    error = coarse["strips"]["error of moment"][at]
    assert isinstance(error, float)
    assert 0 < abs(values[at] - other[at]) < 1.5 * error < 0.5 * abs(values[at])


def made(name: str, size: float, change: float, q: float = HALVED, **parts: Any) -> CombinationResult:
    """Return made-up results with moments m_x times a size, smaller by a share of themselves on the coarser mesh."""
    found = synthetic.results(4, combination=name, limit_state="ultimate", **parts)
    plate = replace(found.plate, moment_x=size * found.plate.moment_x)
    before = replace(plate, moment_x=(1 - change) * plate.moment_x)
    other = Comparison(
        before, found.elements, found.ground, found.supports, found.constants, energy_error=0.02, reduction=q
    )
    return replace(found, plate=plate, comparison=other)


def two(**changes: Any) -> Results:
    """Return results of two combinations, the larger of which changes by less."""
    model = slab(0.5, plate={"length_x": 9.6, "length_y": 7.2, "thickness": 0.6, "E": 30e9, "nu": 0.2}, supports=[])
    model = model.replace(**changes)
    found = {"most": made("most", 5.0, 0.04, model=model), "least": made("least", 1.0, 0.5, model=model)}
    return Results(model, model.combinations, found, {})


def row(found: Table, **where: Any) -> dict[str, Any]:
    """Return the one row of a table whose cells are these."""
    names = [column.name for column in found.columns]
    (one,) = [
        each
        for each in (dict(zip(names, cells, strict=True)) for cells in found.rows())
        if all(each[key] == value for key, value in where.items())
    ]
    return one


def test_governing_combination_decides() -> None:
    """The envelope and the reinforcement have the error of the combination that governs, in the value's unit."""
    found = {each.name: each for each in tables_of(two())}
    greatest = row(found["envelope"], quantity="moment m_x")
    assert greatest["combination of the greatest"] == "most"
    assert greatest["greatest"] == pytest.approx(500)
    assert greatest["error of the greatest"] == pytest.approx(0.04 * 500)
    assert row(found["envelope"], quantity="moment m_y")["error of the greatest"] == 0
    assert row(found["extremes"], quantity="moment m_x", combination="least")["error of the greatest"] == pytest.approx(
        50
    )
    steel = row(found["reinforcement"], layer="bottom x")
    assert (steel["combination"], steel["governed by"]) == ("most", "moment")
    assert steel["design moment"] == pytest.approx(500, abs=1)
    assert steel["error of design moment"] == pytest.approx(0.04 * 500, rel=1e-2)
    # with the lever of the forces nearly the same, an area changes as its moment does
    assert steel["error of required area"] == pytest.approx(0.04 * steel["required area"], rel=0.05)


def test_extremes_of_columns_have_the_errors_of_their_rows(coarse: dict[str, Table]) -> None:
    """The greatest settlement of a column has the error that it has in the combination where it is greatest."""
    rows, extremes = coarse["columns"], coarse["column_envelope"]
    assert len(extremes) == 2
    for at, name in enumerate(extremes["column"]):
        own = [i for i, other in enumerate(rows["column"]) if other == name]
        for quantity in ("settlement", "v_Ed"):
            most = max(own, key=lambda i: rows[quantity][i] or 0.0)
            assert extremes[f"greatest {quantity}"][at] == rows[quantity][most]
            assert extremes[f"error of greatest {quantity}"][at] == rows[f"error of {quantity}"][most]
            assert (extremes[f"error of greatest {quantity}"][at] or 0.0) > 0
    shown = [column.name for column in extremes.columns if not column.error_of]
    assert shown == [column.name for column in extremes.columns][: len(shown)]


def test_without_a_coarser_mesh_there_are_none() -> None:
    """No column of errors without one; where only another combination has one, the cells are empty."""
    of = two()
    alone = replace(of, results={name: replace(each, comparison=None) for name, each in of.results.items()})
    assert not [column.name for table in tables_of(alone) for column in table.columns if "error" in column.name]
    mixed = {each.name: each for each in tables_of(replace(of, results=of.results | {"most": alone["most"]}))}
    assert mixed["points"]["error of moment m_x"][0] is None
    assert mixed["points"]["error of moment m_x"][1] == pytest.approx(0.5 * mixed["points"]["moment m_x"][1])  # type: ignore[operator]
    assert row(mixed["envelope"], quantity="moment m_x")["error of the greatest"] is None
    assert set(mixed["reinforcement"]["error of required area"]) == {None}


def test_meshes_that_cannot_be_coarser() -> None:
    """On one element each way there is no coarser mesh, and no error."""
    tables = tables_of(groundslab.solve(slab(0.5, mesh={"counts": (1, 1)}, supports=[])))
    assert not [column for table in tables for column in table.columns if column.error_of]


def test_what_differs_by_another_neighbour_is_not_compared() -> None:
    """With another worst neighbor on the coarser mesh, the settlement difference has no error; the distortion has."""
    columns = [{"name": name, "x": x, "y": 0, "diameter": 0.4} for name, x in (("A", 0), ("B", 2), ("C", -2))]
    of = two(columns=columns, loads=[{"kind": "uniform", "q": 1e3, "case": "G"}])
    changed, bent = {}, {"most": -1e-5, "least": 1e-5}
    for name, each in of.results.items():
        assert each.comparison is not None
        x = each.plate.nodes[:, 0]
        plate = replace(each.plate, settlement=1e-2 + 1e-3 * x + 1e-5 * x**2)
        other = replace(each.comparison, plate=replace(plate, settlement=1e-2 + 0.9e-3 * x + bent[name] * x**2))
        changed[name] = replace(each, plate=plate, comparison=other)
    found = {each.name: each for each in tables_of(replace(of, results=changed))}["columns"]
    a, same = (row(found, combination=name, column="A") for name in ("most", "least"))
    assert a["worst neighbour"] == same["worst neighbour"] == "B"
    assert a["error of settlement difference"] is None
    assert a["error of angular distortion"] == pytest.approx(1.02 - 0.92)
    assert same["error of settlement difference"] == pytest.approx(2 * (1.02 - 0.92))


def test_largest_deflection_is_compared_by_size() -> None:
    """A largest deflection as far up on the coarser mesh as it is down on the finer one has no error; tilts have."""
    of = two()
    each = of["most"]
    assert each.comparison is not None
    plate = replace(each.plate, settlement=each.plate.settlement + 1e-3 * each.plate.nodes[:, 0])
    other = replace(each.comparison, plate=replace(plate, settlement=-plate.settlement))
    tables = tables_of(replace(of, results=of.results | {"most": replace(each, plate=plate, comparison=other)}))
    one = row({table.name: table for table in tables}["tilt"], combination="most")
    assert one["error of largest deflection"] == pytest.approx(0, abs=1e-9)
    assert one["error of tilt along x"] == pytest.approx(2 * one["tilt along x"])
    assert one["tilt along x"] == pytest.approx(1)


def test_csv_and_report() -> None:
    """In CSV a column of its own in the value's unit, at the right; in the report in percent under the value."""
    of = two()
    points = {each.name: each for each in tables_of(of)}["points"]
    header, first, *_ = points.csv().splitlines()
    names, cells = header.split(","), first.split(",")
    at = names.index("error of moment m_x [kNm/m]")
    assert at > names.index("design moment top y [kNm/m]")
    assert float(cells[at]) == pytest.approx(0.04 * float(cells[names.index("moment m_x [kNm/m]")]))
    shown = layout_table(points)
    assert not [head for head in shown.heads if "error" in head.text]
    place = [head.text for head in shown.heads].index("moment m_x")
    assert [each[place].under for each in shown.rows] == ["±4.0 %", "±50 %"]
    text = page(render_report(of)).one("section", id="tables").text
    assert "±4.0 %" in text
    assert "discretization error" in text
