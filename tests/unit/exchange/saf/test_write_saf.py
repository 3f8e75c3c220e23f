"""Cases as files in the Structural Analysis Format: what comes back from them, and what is said not to be there."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from shapely.geometry.base import BaseGeometry

import groundslab as gs
from groundslab.cli import main
from groundslab.exchange.saf.writing.writer import write_model
from groundslab.geometry.areas import inertia
from groundslab.model.combinations import as_solved, place_patterns
from groundslab.model.loads.acting import AreaPressure, LineForce, PointForce, Pressure
from groundslab.model.plates.region import get_plate_region
from groundslab.model.remarks.resultants import case_forces
from groundslab.model.structure.beams import Beam, GivenSection, RectangularSection, RibSection
from helpers.paths import EXAMPLES

openpyxl = pytest.importorskip("openpyxl")

#: What each example cannot say in the format, but for parts that it has no place for (`NO_PLACE`).
LEFT = {
    "basement": ["case dead: own"],
    "bearing_walls": [
        "wall outer: one for each piece", "wall outer: height", "wall inner: one for each piece", "wall inner: height",
        "case G: own", "combine", "load 3: one for each piece", "load earth pressure: one for each piece",
        "load 5: without the walls", "load 8: one for each piece", "load 9: without the walls",
    ],
    "boreholes": ["case loads: own", "loads: cases"],
    "combined_footing": ["case G: own", "combine"],
    "cracked_footing": ["case G: own", "combine"],
    "grade_beams": ["case G: own", "combine"],
    "house_raft": ["case G: own", "combine"],
    "industrial_floor": ["moves", "load pallets: footprint", "load front axle: footprint"],
    "joined_bays": ["case loads: own", "loads: cases", "load wheel: footprint", "plates"],
    "l_raft": [],
    "neighbours": ["self-weight: pressures", "load fill along both: second order", "plates"],
    "oblique_facade": ["case G: own", "combine"],
    "pad": ["case G: own", "combine"],
    "pavement": [],
    "piled_raft": [
        "support pile 1: gap", "support pile 2: gap", "support pile 3: gap", "support pile 4: gap", "case loads: own",
        "loads: cases", "load core: footprint",
    ],
    "raft_on_continuum": ["case G: own", "combine"],
    "raft_under_a_frame": ["case G: own", "combine"],
    "raft_with_pit": ["region R1: a pit", "case G: own", "combine"],
    "ribbed_raft": ["case G: own", "combine"],
    "second_generation": ["wall W: height", "case G: own", "combine"],
    "strip": ["soil_zones[1]: apart", "case loads: own", "loads: cases"],
    "table1": ["loads: cases"],
    "tank": ["case tank: own", "case water: psi", "case groundwater: psi", "combine"],
    "tower_crane": ["case crane: own", "load 2: footprint", "load 3: footprint", "load 4: footprint"],
    "us_mat": ["case D: own", "combine"],
    "void": ["case loads: own", "loads: cases"],
    "warehouse": ["moves", "load double rack: footprint", "load forklift: footprint"],
    "wind_turbine": ["case dead: own", "load tower: footprint", "load 3: footprint", "load 4: footprint"],
}  # fmt: skip
#: Parts without a place in the format, by example.
NO_PLACE = {
    "basement": "beyond limits mesh", "bearing_walls": "reinforcement limits ground",
    "boreholes": "beyond boreholes limits mesh ground", "combined_footing": "beyond reinforcement limits mesh",
    "cracked_footing": "reinforcement cracking long_term limits mesh",
    "grade_beams": "output reinforcement",
    "house_raft": "beyond boreholes output reinforcement limits soil_strength mesh ground",
    "industrial_floor": "floor mesh", "joined_bays": "joints mesh",
    "l_raft": "beyond boreholes output reinforcement mesh ground", "neighbours": "beyond limits mesh ground",
    "oblique_facade": "reinforcement limits",
    "pad": "beyond reinforcement limits mesh ground", "pavement": "mesh", "piled_raft": "beyond limits mesh ground",
    "raft_on_continuum": "output mesh ground", "raft_under_a_frame": "axes building reinforcement limits ground",
    "raft_with_pit": "beyond boreholes reinforcement limits mesh ground",
    "ribbed_raft": "reinforcement limits ground", "second_generation": "reinforcement mesh",
    "strip": "beyond output limits mesh", "table1": "mesh ground",
    "tank": "beyond reinforcement limits soil_strength mesh ground", "tower_crane": "limits mesh",
    "us_mat": "reinforcement limits mesh", "void": "beyond contact limits mesh",
    "warehouse": "reinforcement limits floor mesh", "wind_turbine": "beyond limits mesh ground",
}  # fmt: skip
#: k0 [Pa/m] and k1 [Pa m] where the ground has none of its own, as results would give them.
FOUND = (12e6, 3e6)


def test_all_examples_are_here() -> None:
    """The lists name every example."""
    names = {path.stem for path in EXAMPLES.glob("*.toml")}
    assert names == LEFT.keys() == NO_PLACE.keys()


@pytest.mark.parametrize("name", sorted(LEFT))
def test_an_example_comes_back(name: str, tmp_path: Path) -> None:
    """Geometry, ground, supports, factors and the resultants of cases are the same; the rest is listed, one by one.

    What was read, written once more, comes back as it is.
    """
    model = gs.load(EXAMPLES / f"{name}.toml")
    left = write_model(model, tmp_path / "first.xlsx", FOUND)
    read = gs.read_saf(tmp_path / "first.xlsx", model.plate.name or "S1").model
    write_model(read, tmp_path / "second.xlsx")
    assert gs.read_saf(tmp_path / "second.xlsx", read.plate.name).model == read

    no_place = [line.partition(":")[0] for line in left if "no place" in line]
    assert no_place == NO_PLACE[name].split()
    others = [line for line in left if "no place" not in line]
    assert len(others) == len(LEFT[name])
    for line, expected in zip(others, LEFT[name], strict=True):
        start, _, word = expected.partition(": ")
        assert line.startswith(start)
        assert word in line
    same_slab(place_patterns(model), read)
    if len(model.every_plate) == 1:
        same_loads(model, read)


def test_a_wall_with_a_door_is_written_by_its_pieces(tmp_path: Path) -> None:
    """Three walls, and what acts through them as loads along lines, with its force and moments, which come back."""
    model = gs.Model(
        plate={"name": "S1", "length_x": 8.0, "length_y": 6.0, "thickness": 0.4, "E": 33e9, "nu": 0.2},
        ground={"kind": "pasternak", "k0": 20e6, "k1": 0.0},
        walls=[{"name": "W", "thickness": 0.25, "points": [(-3, 0), (3, 0), (3, 2)],
                "openings": [{"start": 1.0, "end": 2.0, "height": 2.1}]}],
        cases=[{"name": "G"}],
        loads=[{"kind": "line", "q": 90e3, "q_end": 20e3, "wall": "W", "case": "G"},
               {"kind": "line moment", "m": 3e3, "wall": "W", "case": "G"},
               {"kind": "core", "core": "K", "P": 2e6, "M_x": 1e5, "M_y": -3e5, "case": "G"}],
        cores=[{"name": "K", "walls": ["W"]}],
    )  # fmt: skip
    left = write_model(model, tmp_path / "first.xlsx")
    assert "load 1: written as 4 loads along lines, without the walls through which they act" in left
    assert "load 3: written as 3 loads along lines, without the walls through which they act" in left
    read = gs.read_saf(tmp_path / "first.xlsx", "S1").model
    assert [wall.edges for wall in read.walls] == [(edge,) for wall in model.walls for piece in wall.pieces
                                                   for edge in piece.edges]  # fmt: skip
    same_loads(model, read)


def same_slab(model: gs.Model, read: gs.Model) -> None:
    """Compare plate, structure, ground and supports."""
    one, other = model.plate, read.plate
    assert other.ring().area == pytest.approx(one.ring().area, rel=1e-9)
    assert other.bounds == pytest.approx(one.bounds, rel=1e-12, abs=1e-9)
    assert (other.thickness, other.E, other.nu) == pytest.approx((one.thickness, one.E, one.nu), rel=1e-12)
    assert [shape.ring().area for shape in other.openings] == [shape.ring().area for shape in one.openings]
    assert other.zones == tuple(zone.replace(level=None, wall=None) for zone in one.zones)
    # axes have no place in the format: columns are where they are, but attached to none
    assert read.columns == tuple(column.replace(at="") for column in model.columns)
    assert [wall.thickness for wall in read.walls] == [
        wall.thickness for wall in model.placed_walls for piece in wall.pieces for _ in piece.edges
    ]
    assert [beam.section for beam in read.beams] == [beam.section for beam in model.beams]
    assert [beam.edges for beam in read.beams] == [beam.edges for beam in model.beams]
    if isinstance(model.ground, gs.Winkler | gs.Pasternak):
        expected = model.ground
        if isinstance(expected, gs.Winkler):
            expected = gs.Winkler(k=expected.modulus(max(model.plate.sides)))
        assert read.ground.kind == expected.kind
        found, wanted = (
            (ground.k or 0.0,) if isinstance(ground, gs.Winkler) else (ground.k0, ground.k1)
            for ground in (read.ground, expected)
        )
        assert found == pytest.approx(wanted, rel=1e-12)
    else:
        assert read.ground == gs.Pasternak(k0=FOUND[0], k1=FOUND[1])
    points = [support for support in model.supports if support.kind != "line"]
    assert [support.points for support in read.supports if support.kind == "point"] == [each.points for each in points]


def same_loads(model: gs.Model, read: gs.Model) -> None:
    """Compare the forces and the moments about the origin of all cases, and the combinations with their factors."""
    solved, back = as_solved(model), as_solved(read)
    own = {case.name: f"{case.name} self weight" for case in solved.cases}
    for moments in (forces_of, first_moments):
        one, other = moments(solved), moments(back)
        size = max([1.0, *map(abs, one.values())])
        for case, value in one.items():
            apart = other.get(own.get(case, ""), 0.0) if model.cases else other.get("loads self weight", 0.0)
            assert other.get(case or "loads", 0.0) + apart == pytest.approx(value, rel=1e-9, abs=1e-9 * size)
    if model.combinations or model.combine is not None:
        assert [each.limit_state for each in back.combinations] == [each.limit_state for each in solved.combinations]
        for one, other in zip(solved.combinations, back.combinations, strict=True):
            factors = dict(other.factors)
            for case, factor in one.factors:
                assert [factors[case], factors.get(own[case], factors[case])] == pytest.approx([factor, factor])


def forces_of(model: gs.Model) -> dict[str, float]:
    """Return the vertical forces of cases [N]."""
    return case_forces(model)


def first_moments(model: gs.Model) -> dict[str, float]:
    """Return the moment of each case about the x axis plus twice that about the y axis [N m], but for plate actions."""
    total: dict[str, float] = {}
    for load, shape in model.acting:
        moment = 0.0
        if isinstance(shape, PointForce):
            (x, y), (M_x, M_y) = shape.place, shape.M
            moment = shape.P * (y + 2 * x) + M_y + 2 * M_x
        elif isinstance(shape, AreaPressure) and shape.on == "plate":
            area = shape.to_shapely().intersection(get_plate_region(model.plate, model.plates).area)
            moment = moment_of(shape.pressure, area)
        elif isinstance(shape, LineForce):
            lengths = [edge.length for edge in shape.edges]
            ways = [sum(lengths[:n]) + length / 2 for n, length in enumerate(lengths)]
            for edge, length, way in zip(shape.edges, lengths, ways, strict=True):
                q, m = (ends[0] + (ends[1] - ends[0]) * way / sum(lengths) for ends in (shape.q, shape.m))
                x, y = edge.middle
                moment += length * (q * (y + 2 * x) + m)
        total[load.case] = total.get(load.case, 0.0) + moment
    return total


def moment_of(pressure: Pressure, area: BaseGeometry) -> float:
    """Return int q (y + 2 x) dA of a linear pressure: that of its mean at the centroid, and of its growth about it."""
    moment = 0.0
    for part in getattr(area, "geoms", [area]):
        if part.area:
            center, second = inertia(part)
            moment += float(pressure(center)) * part.area * float(center @ (2, 1))
            moment += float(np.array(pressure.slope) @ second @ (2, 1))
    return moment


def test_everything_that_the_format_knows_comes_back(tmp_path: Path) -> None:
    """Beams, supports, seismic and exclusive cases, horizontal forces, moments, temperatures: the model is the same."""
    point = {"name": "P", "x": 2.0, "y": 1.0}
    model = gs.Model(
        title="All of it",
        project=gs.Project(name="p", number="1", author="a", revision="B"),
        plate=gs.Plate(
            name="slab",
            outline={"kind": "polygon", "points": [(0, 0), (6, 0), (6, 4), (0, 4)], "bulges": [0, 0.2, 0, 0]},
            openings=[{"kind": "circle", "centre": (4, 2), "radius": 0.5}], thickness=0.3, E=31e9, nu=0.2,
            zones=[{"shape": {"kind": "rectangle", "x": (0, 1), "y": (0, 1)}, "thickness": 0.5, "nu": 0.1}],
        ),
        ground=gs.Pasternak(k0=20e6, k1=3e6),
        soil_zones=[{"shape": {"kind": "rectangle", "x": (0, 1), "y": (0, 1)}, "ground": gs.Pasternak(k0=5e6, k1=0.0)}],
        supports=[
            gs.PointSupport(name="a", x=1, y=3, stiffness=50e6, acts="in tension", rotational_stiffness=2e6),
            gs.PointSupport(name="b", x=5, y=3, rotation="fixed"),
            gs.LineSupport(name="c", points=((1, 1), (1, 2), (2, 2)), stiffness=10e6, acts="in compression"),
            gs.LineSupport(name="d", points=((0, 0), (0, 4)), rotation="fixed"),
        ],
        columns=[gs.Column(name="C", x=2, y=3, width_x=0.3, width_y=0.4), gs.Column(name="D", x=5, y=1, diameter=0.5)],
        walls=[gs.Wall(name="W", thickness=0.2, points=((1, 0.5), (3, 0.5)))],
        beams=[
            Beam(name="r", points=((1, 2), (3, 2)), section=RibSection(width=0.3, height=0.4, effective_width=1.2)),
            Beam(name="e", points=((1, 3), (3, 3)),
                 section=RibSection(width=0.3, height=0.4, eccentric=True, side="above")),
            Beam(name="m", points=((1, 1), (2, 1), (3, 2)), bulges=(0.0, 0.5), E=33e9,
                 section=RectangularSection(width=0.3, height=0.9)),
        ],
        cases=[
            gs.LoadCase(name="G"),
            gs.LoadCase(name="g"),
            gs.LoadCase(name="Q", action="variable", category="E"),
            gs.LoadCase(name="W1", action="variable", category="wind", group="wind", H_x=12e3, H_y=-3e3),
            gs.LoadCase(name="W2", action="variable", category="wind", group="wind"),
            gs.LoadCase(name="A", action="accidental"),
            gs.LoadCase(name="E", action="seismic"),
        ],
        loads=[
            gs.SelfWeight(case="G", unit_weight=25e3, beams=True),
            gs.LineLoad(name="l", case="g", q=10e3, q_end=-5e3, points=((1, 1), (3, 1))),
            gs.LineLoad(name="ring", case="g", q=10e3, shape={"kind": "circle", "centre": (4, 2), "radius": 1.0}),
            gs.LineLoad(name="w", case="g", q=30e3, wall="W"),
            gs.LineMoment(name="m", case="E", m=3e3, m_end=4e3, points=((1, 1), (3, 1))),
            gs.LineMoment(name="mw", case="E", m=-3e3, wall="W"),
            gs.UniformLoad(name="u", case="Q", q=5e3),
            gs.AreaLoad(name="a", case="Q", q=2e3, slope=(100.0, 50.0), about=(1, 1),
                        shape={"kind": "polygon", "points": [(1, 1), (3, 1), (2, 3)]}),
            gs.AreaLoad(name="c", case="A", q=2e3, shape={"kind": "circle", "centre": (2, 2), "radius": 0.5}),
            gs.TemperatureLoad(name="t", case="W2", difference=12.0),
            gs.PointLoad(name="column", case="Q", P=100e3, M_x=5e3, M_y=-7e3, column="C"),
            gs.PointLoad(**point, case="A", P=0, M_x=5e3),
            gs.PointLoad(**point, case="E", P=-8e3),
            gs.SettlementLoad(name="s", case="g", support="b", w=0.012),
        ],
        combinations=[
            gs.Combination(name="1", factors={"G": 1.35, "Q": 1.5}),
            gs.Combination(name="2", limit_state="frequent", factors={"G": 1.0, "Q": 0.5}, rule="EN 1990 6.15b"),
            gs.Combination(name="3", limit_state="uplift", factors={"G": 0.9, "W1": 1.5}),
        ],
    )  # fmt: skip
    assert write_model(model, tmp_path / "all.xlsx") == ("wall W: has no height; written 3 m high",)
    read = gs.read_saf(tmp_path / "all.xlsx").model
    for name, part in model:
        if name != "loads":
            assert getattr(read, name) == part, name
    # the pressure that varies is given at a corner, not at its own place
    (varying,) = (load for load in model.loads if load.name == "a")
    (back,) = (load for load in read.loads if load.name == "a")
    assert isinstance(back, gs.AreaLoad)
    assert (back.q, back.slope, back.about) == (2e3, pytest.approx((100, 50)), (1, 1))
    assert sorted(map(repr, set(read.loads) - {back})) == sorted(map(repr, set(model.loads) - {varying}))


def test_results_give_the_ground_of_vlasov(tmp_path: Path) -> None:
    """C1z and C2 are k0 and k1 of the solution; a case alone has none, and its file no ground."""
    model = gs.Model(
        plate=gs.Plate(length_x=4, length_y=3, thickness=0.3, E=30e9, nu=0.2),
        ground=gs.Vlasov(layers=[gs.SoilLayer(E=20e6, nu=0.3, thickness=4)]),
        loads=[gs.UniformLoad(q=10e3)],
        mesh=gs.Mesh(size=1),
    )
    results = gs.solve(model)
    gs.write_saf(results, tmp_path / "results.xlsx")
    ground = gs.read_saf(tmp_path / "results.xlsx").model.ground
    constants = results["all loads"].constants
    assert isinstance(ground, gs.Pasternak)
    assert (ground.k0, ground.k1) == pytest.approx((constants.k0[0], constants.k1[0]), rel=1e-12)
    assert any("solve it first" in line for line in gs.write_saf(model, tmp_path / "case.xlsx"))
    assert "ground" not in gs.read_saf(tmp_path / "case.xlsx").parts


def test_forces_along_edges_are_written(tmp_path: Path) -> None:
    """A cantilever of length L under q, nu = 0: at its edge m_x = -q L^2 / 2 and v_x = q L, on others m_n = 0."""
    q, L = 10e3, 3.0
    model = gs.Model(
        plate=gs.Plate(outline={"kind": "rectangle", "x": (0, L), "y": (0, 2)}, thickness=0.3, E=30e9, nu=0.0,
                       edges={"left": "clamped"}),
        ground=gs.Winkler(k=1.0),
        contact=gs.Contact(tensionless=False),
        loads=[gs.UniformLoad(q=q)],
        mesh=gs.Mesh(size=0.25),
    )  # fmt: skip
    left = gs.write_saf(gs.solve(model), tmp_path / "cantilever.xlsx")
    assert any(line.startswith("section forces along edges: in the slab's local axes") for line in left)
    head, *rows = openpyxl.load_workbook(tmp_path / "cantilever.xlsx")["ResultInternalForce2DEdge"].values
    found = [dict(zip(head, row, strict=True)) for row in rows]
    assert {(row["Result for"], row["Load case"], row["2D member"]) for row in found} == {("Load case", "loads", "S1")}
    lower, clamped = ([row for row in found if row["Edge"] == number] for number in (1, 4))
    # edge 1 runs along x, edge 4 down the page at x = 0
    assert [row["Section at [m]"] for row in lower] == pytest.approx(np.linspace(0, L, 13))
    assert [row["Index"] for row in lower] == list(range(1, 14))
    # not at the ends of the clamped edge, where what is recovered by patches is a few percent off
    for row in lower[2:]:
        x = row["Section at [m]"]
        assert row["mx [kNm/m]"] == pytest.approx(-q * (L - x) ** 2 / 2e3, abs=0.02)
        assert row["vx [kN/m]"] == pytest.approx(q * (L - x) / 1e3, abs=0.1)
        assert row["my [kNm/m]"] == pytest.approx(0, abs=0.02)
    middle = [(row["mx [kNm/m]"], row["vx [kN/m]"]) for row in clamped[2:-2]]
    assert middle == [pytest.approx((-45, 30), abs=0.01)] * 5
    assert gs.read_saf(tmp_path / "cantilever.xlsx").slab == "S1"


def test_cases_in_us_units_are_written_in_imperial_units(tmp_path: Path) -> None:
    """The same slab comes back from a file whose headings and numbers are imperial: 300 mm are 11.811 in."""
    model = gs.Model(
        project=gs.Project(units="US"),
        plate=gs.Plate(name="slab", length_x=4.5, length_y=3, thickness=0.3, E=30e9, nu=0.2),
        ground=gs.Pasternak(k0=20e6, k1=3e6),
        supports=[gs.PointSupport(name="a", x=1, y=1, stiffness=50e6, rotational_stiffness=2e6)],
        columns=[gs.Column(name="C", x=-1, y=1, width_x=0.3, width_y=0.4)],
        cases=[gs.LoadCase(name="G")],
        loads=[
            gs.AreaLoad(name="a", case="G", q=2e3, slope=(100.0, 50.0), about=(1, 1),
                        shape={"kind": "polygon", "points": [(1, 1), (2, 1), (2, 1.25)]}),
            gs.LineMoment(name="m", case="G", m=3e3, points=((-1, -1), (1, -1))),
            gs.PointLoad(name="column", case="G", P=100e3, M_x=5e3, column="C"),
            gs.TemperatureLoad(name="t", case="G", difference=12.0),
        ],
    )  # fmt: skip
    write_model(model, tmp_path / "us.xlsx")
    book = openpyxl.load_workbook(tmp_path / "us.xlsx")
    head, row = book["StructuralSurfaceMember"].values
    assert float(dict(zip(head, row, strict=True))["Thickness [in]"]) == pytest.approx(300 / 25.4)
    head, row = book["StructuralSurfaceActionFree"].values
    first, second, _ = str(dict(zip(head, row, strict=True))["q [kip/ft2]"]).split("; ")
    assert (first[:3], second[:3]) == ("C1:", "C2:")
    assert float(second[3:]) == pytest.approx(-2.1e3 / 47880.25898)
    read = gs.read_saf(tmp_path / "us.xlsx").model
    assert read.project == gs.Project(units="US")
    for part in ("plate", "ground", "supports", "columns"):
        for (key, value), (_, other) in zip(*(numbers_of(getattr(each, part)) for each in (model, read)), strict=True):
            assert other == pytest.approx(value, rel=1e-12), key
    back = {load.name: load for load in read.loads}
    varies = back["a"]
    assert isinstance(varies, gs.AreaLoad)
    assert float(varies.pressure(np.array([2.0, 1.25]))) == pytest.approx(2112.5)
    assert [back[name].magnitudes[0][1] for name in ("m", "column", "t")] == pytest.approx([3e3, 100e3, 12])


def numbers_of(part: object) -> list[tuple[str, float]]:
    """Return the numbers of a part of a model, or of each of several."""
    items = part if isinstance(part, tuple) else (part,)
    return [(key, value) for item in items for key, value in item if isinstance(value, float)]


def test_what_cannot_be_written_is_said(tmp_path: Path) -> None:
    """Beams by their properties and their keys, piles, shrinkage, loads on the ground, plates' own edges are listed."""
    model = gs.Model(
        plate=gs.Plate(length_x=8, length_y=6, thickness=0.3, E=30e9, nu=0.2, edges={"left": "clamped"}),
        ground=gs.Winkler(k=20e6),
        beams=[
            Beam(name="steel", points=((0, 0), (2, 0)), section=GivenSection(second_moment=1e-4, shear_area=1e-3)),
            Beam(
                name="soft",
                points=((0, 1), (2, 1)),
                section={"kind": "rectangle", "width": 0.3, "height": 0.5},
                stiffness=0.5,
                torsion="released",
            ),
            Beam(name="plain", points=((0, 2), (2, 2)), section={"kind": "rectangle", "width": 0.3, "height": 0.5}),
        ],
        cases=[gs.LoadCase(name="G")],
        loads=[gs.UniformLoad(q=10e3, case="G"), gs.ShrinkageLoad(top=1e-4, case="G")],
    )
    left = write_model(model, tmp_path / "some.xlsx")
    assert [line.partition(":")[0] for line in left] == ["beam steel", "beam soft", "plate edges", "load 2"]
    assert "beam soft: stiffness, torsion not written" in left
    (edge,) = gs.read_saf(tmp_path / "some.xlsx").model.supports
    assert edge == gs.LineSupport(name="Sle1", points=((-4, 3), (-4, -3)), rotation="fixed")


def test_each_of_several_plates_has_what_stands_on_it(tmp_path: Path) -> None:
    """A column, a rib and a load on the second plate are read with it, those of the first one are not."""
    model = gs.Model(
        plate=gs.Plate(name="a", length_x=4, length_y=4, thickness=0.3, E=30e9, nu=0.2),
        plates=[gs.FurtherPlate(name="b", outline={"kind": "rectangle", "x": (2.5, 6), "y": (-2, 2)}, thickness=0.4,
                                E=30e9, nu=0.2)],
        ground=gs.Winkler(k=20e6),
        columns=[gs.Column(name="A", x=0, y=0, diameter=0.3), gs.Column(name="B", x=4, y=0, diameter=0.3)],
        beams=[Beam(name="r", points=((3, -1), (5, -1)), section=RectangularSection(width=0.3, height=0.8))],
        cases=[gs.LoadCase(name="G")],
        loads=[
            gs.PointLoad(case="G", name="on A", P=10e3, column="A"),
            gs.PointLoad(case="G", name="on B", P=20e3, column="B"),
            gs.UniformLoad(case="G", name="of b", q=1e3, plate="b"),
            gs.LineMoment(case="G", name="m", m=2e3, points=((3, 1), (5, 1))),
        ],
    )  # fmt: skip
    write_model(model, tmp_path / "two.xlsx")
    first, second = (gs.read_saf(tmp_path / "two.xlsx", name).model for name in "ab")
    assert ([column.name for column in first.columns], first.beams) == (["A"], ())
    assert [load.name for load in first.loads] == ["on A"]
    assert ([column.name for column in second.columns], second.beams) == (["B"], model.beams)
    assert sorted(load.name for load in second.loads) == ["m", "of b", "on B"]


def test_texts_are_never_formulas(tmp_path: Path) -> None:
    """A name such as =1+1 stands in the file as a text."""
    model = gs.Model(
        title="=1+1",
        plate=gs.Plate(name="=A1", length_x=4, length_y=3, thickness=0.3, E=30e9, nu=0.2),
        ground=gs.Winkler(k=20e6),
        loads=[gs.UniformLoad(name='=HYPERLINK("x")', q=10e3)],
    )
    write_model(model, tmp_path / "names.xlsx")
    book = openpyxl.load_workbook(tmp_path / "names.xlsx")
    assert all(cell.data_type != "f" for sheet in book for row in sheet.iter_rows() for cell in row)
    assert gs.read_saf(tmp_path / "names.xlsx").slab == "=A1"


def test_the_command_writes_a_file_and_says_what_is_not_in_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """export-saf leaves an existing file alone."""
    target = tmp_path / "strip.xlsx"
    arguments = ["export-saf", str(EXAMPLES / "strip.toml"), "--out", str(target)]
    assert main.main(arguments) == 0
    assert "no place" in capsys.readouterr().err
    assert main.main(arguments) == 2
    assert "a name that is free" in capsys.readouterr().err
