"""Tables of results that are formulas: each figure is one that can be worked out by hand."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from shapely import box

import groundslab
from groundslab.design.demands.loads import column_loads
from groundslab.errors import InputError, NoEquilibrium
from groundslab.model.combinations import list_combinations
from groundslab.model.model import Model
from groundslab.results.fields import POINT_FIELDS, RANGED_FIELDS
from groundslab.results.records import SupportResult
from groundslab.results.results import Results, results_of
from groundslab.views.files.vtk import plate_mesh
from groundslab.views.tables.envelopes import fields_of_envelope
from groundslab.views.tables.result_tables import tables_of
from groundslab.views.tables.table import Table, table_of
from helpers.plates import parted, plate_of, straight
from helpers.synthetic import LENGTH_X, LENGTH_Y, results

CASES = [{"name": "G"}, {"name": "Q", "action": "variable"}]
COMBINATIONS = [
    {"name": "lifted", "factors": {"Q": -2.0}},
    {"name": "most", "factors": {"G": 1.35, "Q": 1.5}},
    {"name": "least", "factors": {"G": 1.0, "Q": -0.5}},
    {"name": "in use", "limit_state": "characteristic", "factors": {"G": 1.0, "Q": 1.0}},
]
STEEL = {"f_ck": "30 MPa", "f_yk": "500 MPa", "bottom": ("40 mm", "50 mm"), "top": ("30 mm", "45 mm")}


def described(**changes: Any) -> Model:
    """Return a model with two cases and four combinations, one of which is to be refused."""
    parts: dict[str, Any] = {
        "plate": {"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": 0.4, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "loads": [{"kind": "uniform", "q": 1e3, "case": "G"}, {"kind": "uniform", "q": 1e3, "case": "Q"}],
        "cases": CASES,
        "combinations": COMBINATIONS,
    }
    return Model(**parts | changes)


def combined(model: Model | None = None, plate: dict[str, Any] | None = None, **changes: Any) -> Results:
    """Return made-up results of all combinations but "lifted"; "least" has moments times -2."""
    model, made = model or described(), {}
    for each in model.combinations:
        one = results(model=model, combination=each.name, limit_state=each.limit_state, factors=each.factors, **changes)
        fields: dict[str, Any] = dict(plate or {})
        if each.name == "least":
            fields = {"moment_x": -2 * one.plate.moment_x} | fields
        made[each.name] = replace(one, plate=replace(one.plate, **fields))
    del made["lifted"]
    refused = {"lifted": NoEquilibrium("nothing holds\nthe plate down")}
    return Results(model, model.combinations, made, refused)


def table(name: str, of: Results) -> Table:
    """Return one of the tables."""
    return {each.name: each for each in tables_of(of)}[name]


def row(found: Table, **where: Any) -> dict[str, Any]:
    """Return the one row of a table whose cells are these."""
    names = [column.name for column in found.columns]
    rows = [dict(zip(names, cells, strict=True)) for cells in found.rows()]
    (one,) = [each for each in rows if all(each[key] == value for key, value in where.items())]
    return one


def test_what_is_not_asked_for_has_no_table() -> None:
    """Without points, lines, strips, supports, columns and reinforcement six tables are left."""
    names = ["extremes", "envelope", "tilt"]
    assert [each.name for each in tables_of(combined())] == ["combinations", "acting", *names, "checks"]
    all_well = replace(combined(), combinations=combined().combinations[1:], refused={})
    assert [each.name for each in tables_of(all_well)] == ["combinations", "acting", *names]
    assert [each.name for each in tables_of(results_of(results()))] == ["combinations", *names]
    assert groundslab.tables_of is tables_of


def test_combinations() -> None:
    """Factors as text, the certificate's figures, settlement, uplift, share in contact; why one is refused."""
    found = table("combinations", combined())
    assert found["combination"] == ("lifted", "most", "least", "in use")
    assert found["loads"] == ("-2 Q", "1.35 G + 1.5 Q", "1 G - 0.5 Q", "1 G + 1 Q")
    most, lifted = row(found, combination="most"), row(found, combination="lifted")
    assert most["outcome"] == "solved"
    assert (most["sum of loads"], most["reaction"]) == (5760, 5760)
    # the bowl w = 28 mm (1 - 2 r2) touches at 104 of 144 parts of Simpson's weights
    assert most["largest settlement"] == pytest.approx(28)
    assert most["largest uplift"] == pytest.approx(28)
    assert most["area in contact"] == pytest.approx(100 * 104 / 144)
    assert most["largest pressure"] == pytest.approx(560)
    assert most["largest edge line force"] is None
    assert (most["worst figure of the certificate"], most["which figure"]) == (1e-11, "ground_balance")
    assert lifted["outcome"] == "FOUNDATION FAILS: nothing holds the plate down"
    assert all(value is None for key, value in lifted.items() if key not in list(lifted)[:5])


def test_without_cases_all_loads_act() -> None:
    """A model without cases has one combination, whose factors are no cases' factors."""
    model = described(cases=[], combinations=[], loads=[{"kind": "uniform", "q": 1e3}])
    one = results(model=model)
    found = table("combinations", Results(model, list_combinations(model), {"all loads": one}, {}))
    assert found["loads"] == ("all loads",)
    assert found["outcome"] == ("solved",)


def test_no_uplift() -> None:
    """A plate that settles everywhere has no uplift, not a negative one."""
    assert row(table("combinations", combined(lifts=False)), combination="most")["largest uplift"] == 0


def test_edge_line_force_stands_apart() -> None:
    """On ground with shear, the line force of 500 kN/m at edges in contact stands beside 560 kPa of pressure."""
    of = combined(described(ground={"kind": "pasternak", "k0": 20e6, "k1": 30e6}), shear=True)
    most = row(table("combinations", of), combination="most")
    assert most["largest pressure"] == pytest.approx(560)
    assert most["largest edge line force"] == pytest.approx(500)
    for name, key in (("extremes", "combination"), ("envelope", "limit state")):
        here = {key: {"combination": "most", "limit state": "ultimate"}[key]}
        assert row(table(name, of), quantity="pressure p", **here)["greatest"] == pytest.approx(560)
        along = row(table(name, of), quantity="line force f", **here)
        assert (along["unit"], along["greatest"]) == ("kN/m", pytest.approx(500))
        # the least along the edge: none at the corners, which have lifted
        assert along["least"] == 0


def test_extremes_and_their_places() -> None:
    """m_x is 100 kNm/m in the centre and none along x = +-4.8 m, of which the middle on the right is named."""
    found = table("extremes", combined())
    one = row(found, combination="most", quantity="moment m_x")
    assert (one["unit"], one["greatest"], one["least"]) == ("kNm/m", pytest.approx(100), 0)
    assert (one["x of the greatest"], one["y of the greatest"]) == (0, 0)
    assert (one["x of the least"], one["y of the least"]) == (4.8, 0)
    assert set(found["combination"]) == {"most", "least", "in use"}
    assert len(found) == 3 * (len(RANGED_FIELDS) - 1)  # no line force on springs


def test_envelope_keeps_limit_states_apart() -> None:
    """100 kNm/m come from one ultimate combination, -200 from the other, neither counts for the characteristic one."""
    found = table("envelope", combined())
    ultimate = row(found, **{"limit state": "ultimate"}, quantity="moment m_x")
    assert (ultimate["greatest"], ultimate["combination of the greatest"]) == (pytest.approx(100), "most")
    assert (ultimate["least"], ultimate["combination of the least"]) == (pytest.approx(-200), "least")
    assert (ultimate["x of the least"], ultimate["y of the least"]) == (0, 0)
    in_use = row(found, **{"limit state": "characteristic"}, quantity="moment m_x")
    assert (in_use["least"], in_use["combination of the least"]) == (0, "in use")


def test_tilt_of_a_plane() -> None:
    """A plate that goes down by 0.3 mm/m along x and -0.4 along y tilts by 0.5 towards -53.13 degrees, undeflected."""
    x, y = results().plate.nodes.T
    found = table("tilt", combined(plate={"settlement": 5e-3 + 3e-4 * x - 4e-4 * y}))
    one = row(found, combination="in use")
    assert one["mean settlement"] == pytest.approx(5)
    assert (one["tilt along x"], one["tilt along y"], one["tilt"]) == pytest.approx((0.3, -0.4, 0.5))
    assert one["direction of the tilt from x"] == pytest.approx(-53.13010235)
    assert one["largest deflection"] == pytest.approx(0, abs=1e-9)


def test_points() -> None:
    """Quadratic fields at a point by hand, with principal moments and those of Wood and Armer."""
    model = described(output={"points": [{"name": "P", "x": 1.2, "y": 0.9}]})
    one = row(table("points", combined(model)), combination="most", point="P")
    m_x, m_y, m_xy = 93.75, 65.0, 2.16
    assert (one["moment m_x"], one["moment m_y"], one["moment m_xy"]) == pytest.approx((m_x, m_y, m_xy))
    assert one["design moment bottom x"] == pytest.approx(m_x + m_xy)
    assert one["design moment bottom y"] == pytest.approx(m_y + m_xy)
    assert (one["design moment top x"], one["design moment top y"]) == (0, 0)
    values, vectors = np.linalg.eigh([[m_x, m_xy], [m_xy, m_y]])
    assert (one["principal moment m_2"], one["principal moment m_1"]) == pytest.approx(tuple(values))
    direction = np.degrees(np.arctan(vectors[1, 1] / vectors[0, 1]))
    assert one["direction of m_1 from x"] == pytest.approx(direction)


def test_lines_and_strips() -> None:
    """Along the middle q_x = -30 x; a strip of width 2 has int m_x dy = 2 m_x, and 1/2 of it where it half lies off."""
    across = {"start": (-4.8, 0), "end": (4.8, 0)}
    edge = {"start": (-4.8, 3.6), "end": (4.8, 3.6)}
    strips = [{"name": "mid", "width": 2.0, "stations": 5, **across}]
    strips += [{"name": "edge", "width": 2.0, "stations": 5, **edge}]
    of = combined(described(output={"lines": [{"name": "L", **across}], "strips": strips}))
    lines = table("lines", of)
    rows = [i for i, name in enumerate(lines["combination"]) if name == "most"]
    s, x, q_x, part = (np.array(lines[name])[rows].astype(float) for name in ("s", "x", "shear q_x", "part"))
    assert (s[0], s[-1]) == (0, pytest.approx(9.6))
    assert s - 4.8 == pytest.approx(x)
    assert q_x == pytest.approx(-30 * x)
    assert not part.any()
    for name, width in (("mid", 2.0), ("edge", 1.0)):
        one = row(table("strips", of), combination="most", strip=name, s=4.8)
        assert one["width on the plate"] == pytest.approx(width)
        assert one["moment"] == pytest.approx(100 * width)
        assert one["mean moment"] == pytest.approx(100)
        assert one["design moment top along"] == 0
    turned = row(table("strips", of), combination="least", strip="mid", s=4.8)
    assert turned["moment"] == pytest.approx(-400)


def test_places_are_rounded_to_nanometres() -> None:
    """What rounding leaves of zero in a coordinate is zero; other quantities keep all their digits."""
    heads = [("x", "m"), ("pressure", "kPa")]
    table = table_of("t", "T", heads, [[2.77555756156e-16, 2.5e-16], [-1e-10, 1.0], [1 / 3, 2.0]])
    assert table.csv() == "x [m],pressure [kPa]\n0,2.5e-16\n0,1\n0.3333333,2\n"


def test_lines_that_miss_the_plate_are_named() -> None:
    """A line or strip that meets the outline but no element has no rows, a note says so once; a point has no values."""
    wide = {"length_x": 20, "length_y": LENGTH_Y, "thickness": 0.4, "E": 30e9, "nu": 0.2}
    off = {"start": (6, 0), "end": (9, 0)}
    output = {"lines": [{"name": "off", **off}], "strips": [{"name": "off", "width": 1.0, **off}]}
    points = [{"name": "on", "x": 4, "y": 0}, {"name": "off", "x": 9, "y": 0}]
    of = combined(described(plate=wide, output=output | {"points": points}))
    settlements = [row(table("points", of), combination="most", point=name)["settlement w"] for name in ("on", "off")]
    assert settlements[0] is not None
    assert settlements[1] is None
    for name, kind in (("lines", "line"), ("strips", "strip")):
        found = table(name, of)
        assert len(found) == 0
        assert [note for note in found.notes if "does not cross" in note] == [
            f"{kind} off: it does not cross the plate"
        ]
        assert found.csv().count("\n") == 1


def test_supports() -> None:
    """A line's force is the nodes' sum, its forces per length are those by each node's share."""
    supports = [
        {"kind": "line", "name": "wall", "points": [(-1, 0), (1, 0)]},
        {"kind": "point", "name": "pile", "x": 2, "y": 1},
    ]
    wall = SupportResult(
        "wall",
        nodes=np.array([[-1.0, 0], [0, 0], [1, 0]]),
        length=np.array([0.5, 1.0, 0.5]),
        settlement=np.array([1e-3, 3e-3, 2e-3]),
        force=np.array([10e3, 40e3, 30e3]),
        moment_x=np.array([1e3, 2e3, 3e3]),
        moment_y=np.zeros(3),
    )
    one = np.array([0.0])
    pile = SupportResult("pile", np.array([[2.0, 1]]), one, one + 4e-3, one - 5e3, one, one + 7e3)
    of = combined(described(supports=supports), supports=(wall, pile))
    at_wall = row(table("supports", of), combination="most", support="wall")
    assert (at_wall["kind"], at_wall["force"], at_wall["length"]) == ("line", 80, 2)
    assert (at_wall["least force per length"], at_wall["greatest force per length"]) == (20, 60)
    assert (at_wall["least settlement"], at_wall["greatest settlement"]) == (1, 3)
    assert (at_wall["moment M_x"], at_wall["moment M_y"]) == (6, 0)
    at_pile = row(table("supports", of), combination="most", support="pile")
    assert (at_pile["kind"], at_pile["force"], at_pile["moment M_y"]) == ("point", -5, 7)
    assert at_pile["length"] is at_pile["least force per length"] is None


COLUMNS = [
    {"name": "A", "x": 0.0, "y": 0.0, "width_x": 0.4, "width_y": 0.6},
    {"name": "B", "x": 3.0, "y": 0.0, "diameter": 0.5},
    {"name": "C", "x": -3.0, "y": 2.0, "diameter": 0.5},
]
ON_COLUMNS = [
    {"kind": "point", "column": "A", "P": "400 kN", "case": "G"},
    {"kind": "point", "column": "A", "P": "100 kN", "case": "Q"},
    {"kind": "point", "column": "B", "P": "200 kN", "case": "Q"},
]


def test_columns_and_their_neighbours() -> None:
    """Loads with factors; on w = 1 mm/m x + 2 mm/m y the worst neighbour of A is B, and tilt explains all of it."""
    x, y = results().plate.nodes.T
    model = described(columns=COLUMNS, loads=ON_COLUMNS)
    found = table("columns", combined(model, plate={"settlement": 1e-2 + 1e-3 * x - 1e-5 * y}))
    loads = [row(found, combination="most", column=name)["load"] for name in "ABC"]
    assert loads == pytest.approx([1.35 * 400 + 1.5 * 100, 1.5 * 200, 0])
    a, b = (row(found, combination="most", column=name) for name in "AB")
    assert (a["settlement"], b["settlement"]) == pytest.approx((10, 13))
    assert (a["worst neighbour"], b["worst neighbour"]) == ("B", "A")
    assert (a["settlement difference"], b["settlement difference"]) == pytest.approx((3, -3))
    assert (a["distance"], a["angular distortion"]) == pytest.approx((3, 1))
    assert a["angular distortion without tilt"] == pytest.approx(0, abs=1e-9)
    assert "V_Ed" not in [column.name for column in found.columns]


def test_one_column_has_no_neighbour() -> None:
    """A single column, or two at one place, have nothing to be compared with."""
    twins = [COLUMNS[0], {**COLUMNS[0], "name": "twin"}]
    for columns in (COLUMNS[:1], twins):
        found = table("columns", combined(described(columns=columns)))
        assert found["worst neighbour"] == (None,) * len(found)
        assert found["settlement"] == pytest.approx([28.0] * len(found))


def test_punching_under_even_pressure() -> None:
    """With pressure p and load q everywhere, V_Ed = P - (p - q) A for the rectangle with rounded corners around A."""
    model = described(columns=COLUMNS, loads=[*ON_COLUMNS, {"kind": "uniform", "q": 10e3, "case": "Q"}])
    model = model.replace(reinforcement=STEEL)
    pressure = {"pressure": np.full(len(results(n=6).plate.nodes), 50e3)}
    found = table("columns", combined(model, plate=pressure, n=6))
    one = row(found, combination="most", column="A")
    d = 0.4 - 0.045
    u = 2 * (0.4 + 0.6) + 2 * np.pi * 2 * d
    area = 0.4 * 0.6 + 2 * (0.4 + 0.6) * 2 * d + np.pi * (2 * d) ** 2
    assert one["d"] == pytest.approx(1e3 * d)
    assert one["u"] == pytest.approx(u, rel=1e-4)
    assert one["pressure inside"] == pytest.approx(50 * area, rel=1e-4)
    assert one["other loads inside"] == pytest.approx(1.5 * 10 * area, rel=1e-4)
    V_Ed = 1.35 * 400 + 1.5 * 100 - (50 - 15) * area
    assert one["V_Ed"] == pytest.approx(V_Ed, rel=1e-4)
    assert one["v_Ed"] == pytest.approx(V_Ed / 1e3 / (u * d), rel=1e-4)
    # B pulls in "least": 0.5 x 200 kN, pressure and -0.5 q inside push up as well, and the top bars are in tension
    area = np.pi * (0.25 + 2 * (0.4 - 0.0375)) ** 2
    assert row(found, combination="least", column="B")["V_Ed"] == pytest.approx(100 + (50 + 5) * area, rel=1e-4)
    # C carries nothing
    assert row(found, combination="most", column="C")["V_Ed"] is None


def test_punching_that_cannot_be_looked_at() -> None:
    """A plate with nothing left around the column has no perimeter, and a note says why."""
    column = {"name": "K", "x": 0.0, "y": 0.0, "width_x": 9.6, "width_y": 7.2}
    of = combined(described(columns=[column], loads=[{**ON_COLUMNS[0], "column": "K"}], reinforcement=STEEL))
    found = table("columns", of)
    assert set(found["V_Ed"]) == {None}
    assert [note for note in found.notes if note.startswith("no punching of column K: ")]


def test_loads_on_a_part() -> None:
    """Every kind of load counts with what lies on the part, by its case; loads on the column itself do not."""
    loads = [
        {"kind": "uniform", "q": 1e3, "slope": (100, 0), "bend": (600, 0, 0), "about": (0, 0), "case": "G"},
        {"kind": "patch", "q": 2e3, "x": (0.5, 3), "y": (-1, 1), "case": "Q"},
        {"kind": "self weight", "unit_weight": 25e3, "case": "G"},
        {"kind": "line", "q": 10e3, "q_end": 30e3, "points": [(-2, 0), (0, 0), (2, 0)], "case": "Q"},
        {"kind": "line", "q": 10e3, "points": [(-4, 3), (4, 3)], "case": "Q"},
        {"kind": "point", "P": 5e3, "x": 0.5, "y": 0.5, "case": "Q"},
        {"kind": "point", "P": 7e3, "x": 2.5, "y": 0.5, "case": "Q"},
        {"kind": "point", "P": 8e3, "M_x": 1e3, "x": 1, "y": 0, "width_x": 1, "width_y": 1, "case": "Q"},
        {"kind": "point", "P": 1e6, "column": "A", "case": "Q"},
    ]
    model = described(loads=loads, columns=COLUMNS[:1])
    found = column_loads.sum_of_others(results(n=6, model=model), box(-1, -1, 1, 1), ("A",))
    # q bends: int 300 x^2 dA = 400 N
    assert found["G"] == pytest.approx(1e3 * 4 + 400 + 25e3 * 0.4 * 4)
    # half of the footprint: its half of P, and of the moment int_0^0.5 12 M x dx = 1.5 M, taken off on the left
    footprint = 8e3 / 2 - 1.5e3
    # the line's force per length is 15 kN/m at x = -1 and 25 kN/m at x = 1
    assert found["Q"] == pytest.approx(2e3 * 0.5 * 2 + 20e3 * 2 + 5e3 + footprint)


def test_thickness_by_zone() -> None:
    """Nodes on a zone's border stand once for each side, each with its own thickness."""
    mesh, right = parted(straight(), 2.0)
    zone = {"shape": {"kind": "rectangle", "x": (2, 6), "y": (0, 4)}, "thickness": 0.7}
    outline = {"kind": "rectangle", "x": (0, 6), "y": (0, 4)}
    plate = {"outline": outline, "thickness": 0.4, "E": 30e9, "nu": 0.2, "zones": [zone]}
    of = results(model=described(plate=plate), plate=plate_of(mesh))
    found, section = of.elements.at_nodes(of.plate)
    assert section.tolist() == right.astype(int).tolist()
    assert found.tolist() == np.where(right, 0.7, 0.4).tolist()


def test_columns_on_two_thicknesses() -> None:
    """A column across the border of two sections is checked with the thinner one."""
    mesh, _ = parted(straight(), 2.0)
    zone = {"shape": {"kind": "rectangle", "x": (2, 6), "y": (0, 4)}, "thickness": 0.7}
    outline = {"kind": "rectangle", "x": (0, 6), "y": (0, 4)}
    plate = {"outline": outline, "thickness": 0.4, "E": 30e9, "nu": 0.2, "zones": [zone]}
    column = {"name": "K", "x": 2.0, "y": 2.0, "diameter": 0.4}
    loads = [{"kind": "point", "column": "K", "P": "1 MN", "case": "G"}]
    model = described(plate=plate, columns=[column], loads=loads, reinforcement=STEEL)
    about: dict[str, Any] = {"limit_state": "ultimate", "factors": model.combinations[1].factors}
    one = results(model=model, plate=plate_of(mesh), combination="most", **about)
    found = table("columns", Results(model, model.combinations[1:2], {"most": one}, {}))
    assert found["d"] == pytest.approx((400 - 45,))
    assert found["V_Ed"] == pytest.approx((1350,))


def bent(m_x: float) -> dict[str, Any]:
    """Return fields with a moment along x alone, m_x [N m/m] in the centre."""
    x, _ = results().plate.nodes.T
    none = np.zeros(len(x))
    return {"moment_x": m_x * (1 - (x / 4.8) ** 2), "moment_y": none, "moment_xy": none}


def test_reinforcement_carries_the_moment() -> None:
    """The area found balances 200 kNm/m: m = A f_yd (d - A f_yd / (2 f_cd)); the least one is 0.26 f_ctm / f_yk d."""
    of = combined(described(reinforcement=STEEL), plate=bent(200e3))
    one = row(table("reinforcement", of), layer="bottom x", section="plate")
    force, d = one["required area"] * 1e-4 * 500e6 / 1.15, 0.4 - 0.04
    assert force * (d - force / (2 * 20e6)) == pytest.approx(200e3)
    assert (one["x"], one["y"], one["combination"], one["thickness"]) == (0, 0, "most", 0.4)
    assert one["design moment"] == pytest.approx(200)
    assert one["minimum area"] == pytest.approx(0.26 * 0.30 * 30 ** (2 / 3) / 500 * d * 1e4)
    assert one["part of the plate that fails"] == one["part of the plate that needs links"] == 0
    top = row(table("reinforcement", of), layer="top y")
    assert (top["required area"], top["combination"], top["x"]) == (0, None, None)


def test_reinforcement_that_fails() -> None:
    """A moment too large for the concrete makes the layer inf, and the share of the area where it does is reported."""
    of = combined(described(reinforcement=STEEL), plate=bent(20e6))
    one = row(table("reinforcement", of), layer="bottom x")
    assert one["required area"] == np.inf
    assert 50 < one["part of the plate that fails"] < 100
    fields = fields_of_envelope(of)
    failing = fields["reinforcement fails"] == 1
    assert np.array_equal(np.isinf(fields["reinforcement bottom x [cm2/m]"]), failing)
    assert failing.any()
    assert not failing.all()


def test_reinforcement_without_ultimate_combinations() -> None:
    """Characteristic combinations are not designed for: where the ultimate ones have no result there is no row."""
    use = [{**each, "limit_state": "characteristic"} for each in COMBINATIONS[1:]]
    found = table("reinforcement", combined(described(reinforcement=STEEL, combinations=[COMBINATIONS[0], *use])))
    assert len(found) == 0
    assert found.notes[0] == "No ultimate combination has a result."
    with pytest.raises(InputError, match="no ultimate combination"):
        described(reinforcement=STEEL, combinations=use)


def test_ultimate_combinations_without_partial_factors_are_remarked_upon() -> None:
    """Where no factor of any ultimate combination is above 1, a note says what the loads must hold then."""
    notes = table("reinforcement", combined(described(reinforcement=STEEL))).notes
    assert not [each for each in notes if "above 1" in each]
    given = [{**each, "factors": {"G": 1.0}} for each in COMBINATIONS]
    assert "above 1" in table("reinforcement", combined(described(reinforcement=STEEL, combinations=given))).notes[-1]


#: A plate of 400 mm with a zone of 700 mm on x > 2 m, y from 0 to 4 m.
ZONED = {
    "outline": {"kind": "rectangle", "x": (0, 6), "y": (0, 4)}, "thickness": 0.4, "E": 30e9, "nu": 0.2,
    "zones": [{"shape": {"kind": "rectangle", "x": (2, 6), "y": (0, 4)}, "thickness": 0.7}],
}  # fmt: skip


def designed(moments: Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]) -> Table:
    """Return the table of a plate with a zone, whose m_x [N m/m] follows from x, y and from being in the zone."""
    mesh, right = parted(straight(), 2.0)
    model = described(plate=ZONED, reinforcement=STEEL)
    plate = plate_of(mesh)
    none = np.zeros(len(plate.nodes))
    plate = replace(plate, moment_x=moments(*plate.nodes.T, right), moment_y=none, moment_xy=none)
    about: dict[str, Any] = {"limit_state": "ultimate", "factors": model.combinations[1].factors}
    one = results(model=model, plate=plate, combination="most", **about)
    return table("reinforcement", Results(model, model.combinations[1:2], {"most": one}, {}))


def test_each_section_of_the_plate_has_a_row_of_its_own() -> None:
    """Thin and thick part each name their own moment, place, depth and least area (9.2.1.1(1)), by hand.

    400 kNm/m in the middle of the thick part need, with d = 0.66 m and f_cd = 20 MPa, less there than 250 kNm/m need
    with d = 0.36 m: A = (1 - sqrt(1 - 2 m / (d^2 f_cd))) d f_cd / f_yd = 14.27 and 16.83 cm2/m.
    """

    def m_x(x: np.ndarray, y: np.ndarray, thick: np.ndarray) -> np.ndarray:
        return np.where(
            thick, 400e3 * (1 - ((x - 4) ** 2 + (y - 2) ** 2) / 20), 250e3 * (1 - (y - 2) ** 2 / 20 - x / 20)
        )

    found = designed(m_x)
    thin, thick = row(found, layer="bottom x", section="plate"), row(found, layer="bottom x", section="zone 1")
    assert (thin["governed by"], thick["governed by"]) == ("moment", "moment")
    assert (thin["x"], thin["y"], thin["design moment"], thin["thickness"]) == (0, 2, pytest.approx(250), 0.4)
    assert (thick["x"], thick["y"], thick["design moment"], thick["thickness"]) == (4, 2, pytest.approx(400), 0.7)
    assert thin["required area"] == pytest.approx(16.83, abs=0.005)
    assert thick["required area"] == pytest.approx(14.27, abs=0.005)
    # 0.26 f_ctm / f_yk d with f_ctm = 2.896 MPa
    assert thin["minimum area"] == pytest.approx(0.26 * 2.8965 / 500 * 0.36 * 1e4, rel=1e-4)
    assert thick["minimum area"] == pytest.approx(0.26 * 2.8965 / 500 * 0.66 * 1e4, rel=1e-4)
    assert row(found, layer="top x", section="plate")["governed by"] is None
    assert len(found) == 8


def test_minimum_reinforcement_names_the_largest_moment() -> None:
    """Where the minimum governs all over the plate, the row says so, with the place of the largest moment."""
    found = designed(lambda x, y, thick: 1e3 + 2e3 * (x == 1) * (y == 3) - 5e3 * thick)
    one = row(found, layer="bottom x", section="plate")
    assert one["governed by"] == "minimum"
    assert one["required area"] == one["minimum area"]
    assert (one["x"], one["y"], one["design moment"]) == (1, 3, pytest.approx(3))
    top = row(found, layer="top x", section="zone 1")
    assert (top["governed by"], top["design moment"]) == ("minimum", pytest.approx(-4))


def test_bars_in_compression_name_the_moment_of_the_other_face() -> None:
    """1000 kNm/m of sagging in 400 mm are beyond the concrete alone, so bars at the top serve in compression.

    By hand, x / d = 0.45: m_lim = 0.36 (1 - 0.18) f_cd d^2 = 765 kNm/m, the rest over d - d_2 = 0.33 m is 712 kN/m, and
    the strain 3.5 (1 - 0.03 / 0.162) = 2.85 per mille is above that of yielding, 2.17: A_s2 = 16.37 cm2/m.
    """
    found = designed(lambda x, y, thick: np.where(thick, 0.0, 1000e3 * (1 - (x / 20) ** 2 - (y - 2) ** 2 / 20)))
    one = row(found, layer="top x", section="plate")
    assert (one["governed by"], one["x"], one["y"]) == ("bars in compression", 0, 2)
    assert one["design moment"] == pytest.approx(1000)
    m_lim = 0.36 * 0.82 * 20e6 * 0.36**2
    assert one["required area"] == pytest.approx((1000e3 - m_lim) / 0.33 / (500e6 / 1.15) * 1e4, rel=1e-9)
    assert one["part of the plate that needs links"] > 0
    assert one["part of the plate that fails"] == 0


def test_what_is_too_weak_names_its_largest_moment() -> None:
    """Of many places where no reinforcement helps the worst one is named, not the one nearest to the origin."""
    found = designed(lambda x, y, thick: np.where(thick, 0.0, -9e6 - 1e6 * (x**2 + y)))
    for layer in ("bottom x", "top x"):
        one = row(found, layer=layer, section="plate")
        assert one["governed by"] == "concrete too weak"
        assert one["required area"] == np.inf
        assert one["design moment"] == pytest.approx(-17e3)
        assert (one["x"], one["y"]) == (2, 4)
    assert row(found, layer="top x", section="zone 1")["part of the plate that fails"] == 0


def test_materials_beyond_the_code_are_refused() -> None:
    """Concrete that EN 1992-1-1 is not made for is an error, not a number."""
    with pytest.raises(InputError, match=r"f_ck"):
        tables_of(combined(described(reinforcement={**STEEL, "f_ck": "5 MPa"})))


def test_fields_of_the_envelope() -> None:
    """Each node has its extremes, and the number of the combination that they come from."""
    of = combined(described(reinforcement=STEEL))
    fields, plate = fields_of_envelope(of), of["most"].plate
    assert fields["ultimate greatest moment m_x [kNm/m]"] == pytest.approx(plate.moment_x / 1e3)
    assert fields["ultimate least moment m_x [kNm/m]"] == pytest.approx(-plate.moment_x / 500)
    loaded = plate.moment_x > 0
    assert set(fields["ultimate combination of least moment m_x"][loaded]) == {2}
    assert set(fields["ultimate combination of greatest moment m_x"]) == {1}
    assert set(fields["characteristic combination of greatest moment m_x"]) == {3}
    assert not [name for name in fields if name.startswith(("frequent", "quasi"))]
    assert all(values.shape == (len(plate.nodes),) for values in fields.values())
    area = fields["reinforcement top x [cm2/m]"].max()
    assert area == pytest.approx(row(table("reinforcement", of), layer="top x")["required area"])


def test_different_meshes_have_no_envelope() -> None:
    """Results on another mesh cannot be compared node by node."""
    of = combined()
    of.results["in use"] = results(n=3, model=of.model, combination="in use", limit_state="characteristic")
    with pytest.raises(groundslab.GroundslabError, match="different meshes"):
        fields_of_envelope(of)


def test_all_refused() -> None:
    """Where nothing has results, combinations say why, each is a check that fails, and factors are known."""
    output = {"points": [{"name": "P", "x": 0, "y": 0}]}
    model = described(columns=COLUMNS, reinforcement=STEEL, output=output)
    refused = {each.name: NoEquilibrium("no") for each in model.combinations}
    of = Results(model, model.combinations, {}, refused)
    counts = {table.name: len(table) for table in tables_of(of) if len(table)}
    assert counts == {"combinations": 4, "acting": 7, "checks": 4}
    assert set(table("checks", of)["verdict"]) == {"fails"}
    assert fields_of_envelope(of) == {}


def test_names_are_those_of_the_files_for_paraview() -> None:
    """Columns are called as the arrays of plate.vtu are."""
    there = set(plate_mesh(results()).point_data)
    assert {about.name for about in POINT_FIELDS.values()} <= there
    assert POINT_FIELDS["settlement"].name == "settlement w [mm]"


def test_table_as_text() -> None:
    """Units in the header, seven digits, nothing where there is nothing, quotes where they are needed."""
    made = table_of("t", "T", [("name", ""), ("load", "kN"), ("n", "")], [("a, b", np.pi, 3), ("c", None, np.int64(4))])
    assert made.csv() == 'name,load [kN],n\n"a, b",3.141593,3\nc,,4\n'
    assert made.rows() == [("a, b", np.pi, 3), ("c", None, 4)]
    assert table_of("t", "T", [("v", "")], [(-0.0,)]).csv() == "v\n0\n"
    with pytest.raises(KeyError):
        made["load [kN]"]


def test_tables_that_are_none() -> None:
    """Columns of different lengths and two of one name are refused."""
    with pytest.raises(ValueError, match="twice"):
        table_of("t", "T", [("a", "m"), ("a", "mm")], [(1, 2)])
    made = table_of("t", "T", [("a", "")], [(1,)]).columns + table_of("t", "T", [("b", "")], []).columns
    with pytest.raises(ValueError, match="length"):
        Table("t", "T", made)
