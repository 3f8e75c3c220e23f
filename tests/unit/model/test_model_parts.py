"""The rules of supports, columns, cases, combinations, varying ground and requested outputs, reported by location."""

from __future__ import annotations

from typing import Any

import pytest

from groundslab.case.casefile import loads, to_toml
from groundslab.errors import InputError
from groundslab.model.combinations import list_combinations
from groundslab.model.loads.load_cases import Combination
from groundslab.model.model import Model, json_schema
from groundslab.model.shapes import Polygon

PLATE: dict[str, Any] = {"length_x": "6 m", "length_y": "4 m", "thickness": "0.25 m", "E": "30 GPa", "nu": 0.2}
LAYER: dict[str, Any] = {"E": "20 MPa", "nu": 0.3, "thickness": "2 m"}
WINKLER: dict[str, Any] = {"kind": "winkler", "k": "20 MPa/m"}
VLASOV: dict[str, Any] = {"kind": "vlasov", "layers": [LAYER]}
STACK: dict[str, Any] = {"kind": "layered", "coupling": "consistent", "layers": [LAYER, LAYER]}
UNIFORM: dict[str, Any] = {"kind": "uniform", "q": "10 kPa"}
LOAD: dict[str, Any] = {"kind": "point", "P": "10 kN", "x": "0 m", "y": "0 m"}
LINE: dict[str, Any] = {"kind": "line", "q": "1 kN/m", "points": [["0 m", "0 m"], ["1 m", "0 m"]]}
POINT: dict[str, Any] = {"kind": "point", "x": "1 m", "y": "1 m"}
WALL: dict[str, Any] = {"kind": "line", "points": [["-3 m", "0 m"], ["3 m", "0 m"]]}
COLUMN: dict[str, Any] = {"name": "A1", "x": "1 m", "y": "0 m", "diameter": "0.3 m"}
BOX: dict[str, Any] = {"kind": "rectangle", "x": ["-1 m", "1 m"], "y": ["-1 m", "1 m"]}
ZONE: dict[str, Any] = {"shape": BOX, "thickness": "0.5 m"}
HOLE: dict[str, Any] = {"x": "0 m", "y": "0 m", "layers": [LAYER]}
GAP: dict[str, Any] = {"x": "0 m", "y": "0 m", "gap": "1 mm"}
OUT: dict[str, Any] = {"name": "a", "x": "0 m", "y": "0 m"}
CUT: dict[str, Any] = {"name": "a", "start": ["-3 m", "0 m"], "end": ["3 m", "0 m"]}
BARS: dict[str, Any] = {"f_ck": "30 MPa", "f_yk": "500 MPa", "bottom": ["40 mm", "50 mm"], "top": ["40 mm", "50 mm"]}
SPACED: dict[str, Any] = {"diameter": "12 mm", "spacing": "150 mm"}
LAID: dict[str, Any] = BARS | dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), SPACED)
BAR_ZONE: dict[str, Any] = {
    **SPACED,
    "name": "Z",
    "shape": BOX,
    "layers": ["bottom_x", "bottom_y"],
    "diameter": "16 mm",
}
CASES: list[dict[str, Any]] = [{"name": "dead"}, {"name": "live", "action": "variable"}]
DEAD: dict[str, Any] = {**UNIFORM, "case": "dead"}
MIX: dict[str, Any] = {"name": "K1", "factors": {"dead": 1.35, "live": 1.5}}


def case(plate: dict[str, Any] | None = None, **parts: Any) -> dict[str, Any]:
    """Return a description as a file holds it, sound but for what is given."""
    return {"plate": {**PLATE, **(plate or {})}, "ground": WINKLER, "loads": [UNIFORM], **parts}


def cases(**parts: Any) -> dict[str, Any]:
    """Return a description with two load cases."""
    return case(**{"cases": CASES, "loads": [DEAD], **parts})


def mixed(factors: Any) -> dict[str, Any]:
    """Return a description with a combination of such factors."""
    return cases(combinations=[{**MIX, "factors": factors}])


def combined(**keys: Any) -> dict[str, Any]:
    """Return a description with automatic combinations."""
    return cases(combine={"sets": ["ultimate"], **keys})


def designed(bars: dict[str, Any], **parts: Any) -> dict[str, Any]:
    """Return a description with reinforcement and ultimate combinations to find it for."""
    return combined() | {"reinforcement": bars} | parts


UNDESIGNED = "no ultimate combination of loads", "at least one to design for"


def issues(data: object) -> list[tuple[str, str, str, str]]:
    """Return all issues of what a file holds."""
    with pytest.raises(InputError) as error:
        Model.model_validate(data, from_file=True)
    return [(issue.location, issue.found, issue.expected, issue.hint) for issue in error.value.issues]


TABLE = "a table of numbers such as {dead = 1.35, live = 1.5}"
OFF = "a place on the plate, not in an opening or outside the outline"
STRIP = "nothing, or at least 0.006 m"
ONE_FAULT = [
    # supports: keys that do not go together
    (case(supports=[{**POINT, "gap": "1 mm"}]),
     "supports[1].gap", "0.001 m", "no gap for a support that acts both ways"),
    (case(supports=[{**WALL, "limit": "1 kN/m"}]),
     "supports[1].limit", "a limit", "no limit for a support that acts both ways"),
    (case(supports=[{**POINT, "rotation": "fixed", "rotational_stiffness": "1 kNm/rad"}]),
     "supports[1].rotational_stiffness", "a stiffness", 'none, as rotation is "fixed"'),
    (case(supports=[{**WALL, "rotation": "fixed", "acts": "in tension"}]),
     "supports[1].rotation", '"fixed"',
     '"free", or a rigid support that acts both ways: along the line w = 0 then says how it turns'),
    (case(supports=[{**WALL, "rotation": "fixed", "stiffness": "1 MN/m^2"}]),
     "supports[1].rotation", '"fixed"',
     '"free", or a rigid support that acts both ways: along the line w = 0 then says how it turns'),
    (case(supports=[{**POINT, "acts": "up"}]),
     "supports[1].acts", '"up"', '"both ways", "in compression" or "in tension"'),
    (case(supports=[{**POINT, "kind": "area"}]), "supports[1].kind", '"area"', '"point", "line" or "pile"'),
    (case(supports=[{**POINT, "stiffness": "1 MN/m^2"}]),
     "supports[1].stiffness", '"1 MN/m^2"', 'a force per settlement such as "200 MN/m"'),
    (case(supports=[{**WALL, "stiffness": "1 MN/m"}]),
     "supports[1].stiffness", '"1 MN/m"', 'a force per length and settlement such as "50 MN/m^2"'),
    (case(supports=[{**POINT, "name": "a"}, {**WALL, "name": "a"}]),
     "supports[2].name", '"a" again', "a unique name"),
    # supports: where they are
    (case(supports=[{**POINT, "x": "3.1 m"}]), "supports[1]", "a point off the plate at (3.1, 1)", "one on the plate"),
    (case(supports=[{**POINT, "x": "1e6 m"}]),
     "supports[1]", "a place far off the plate, (1000000, 1) m", "one on it"),
    (case(supports=[{**WALL, "points": [["0 m", "-1e6 m"], ["0 m", "2 m"]]}]),
     "supports[1]", "a place far off the plate, (0, -1000000) m", "one on it"),
    (case({"openings": [BOX]}, supports=[{**POINT, "x": "0 m", "y": "0 m"}]),
     "supports[1]", "a point off the plate at (0, 0)", "one on the plate"),
    (case(supports=[{**WALL, "points": [["0 m", "0 m"]]}]), "supports[1].points", "1 point", "at least two"),
    (case(supports=[{**WALL, "points": [["0 m", "0 m"], ["0 m", "0 m"]]}]),
     "supports[1]", "a piece without length at (0, 0)", "points apart from each other"),
    (case(supports=[WALL, {**WALL, "points": [["-3 m", "0 m"], ["3 m", "0.1 m"]]}]),
     "supports[1]", "an edge that parts from supports[2] at (-3, 0) at less than 5 degrees",
     "a larger angle, or the same edge"),
    (case(supports=[{**WALL, "points": [["-3 m", "2 m"], ["3 m", "1.8 m"]]}]),
     "supports[1]", "an edge that parts from plate.outline at (-3, 2) at less than 5 degrees",
     "a larger angle, or the same edge"),
    (case({"zones": [ZONE]}, supports=[{**WALL, "points": [["1 m", "1 m"], ["3 m", "1.05 m"]]}],
          loads=[UNIFORM], mesh={"counts": [4, 4]}), "mesh.counts", "counts", "a size"),
    (case(supports=[POINT, {**POINT, "x": "1.005 m"}]),
     "supports[2]", "0.005 m between it and supports[1] at (1.005, 1)", STRIP),
    # settlements and columns that loads name
    (case(loads=[{"kind": "settlement", "support": "a1", "w": "1 mm"}], supports=[{**POINT, "name": "A1"}]),
     "loads[1].support", '"a1"', '"A1"'),
    (case(loads=[{"kind": "settlement", "support": "", "w": "1 mm"}], supports=[POINT]),
     "loads[1].support", '""', "a support, and [[supports]] that says where it is"),
    (case(loads=[{"kind": "point", "P": "1 N", "column": "a1"}], columns=[COLUMN]),
     "loads[1].column", '"a1"', '"A1"'),
    (case(loads=[{"kind": "point", "P": "1 N", "column": "a1"}]),
     "loads[1].column", '"a1"', "a column, and [[columns]] that says where it is"),
    (case(loads=[{**LOAD, "y": "0 m", "x": None} | {"column": "A1"}], columns=[COLUMN]),
     "loads[1].y", "y together with a column", "one of them"),
    (case(loads=[{"kind": "point", "P": "1 N", "x": "0 m"}]),
     "loads[1].y", "nothing", 'a position such as "1.5 m", or the name of a column'),
    (case(loads=[{**LOAD, "diameter": "0.1 m", "width_x": "0.1 m", "width_y": "0.1 m"}]),
     "loads[1].diameter", "a diameter together with a width", "width_x and width_y, or diameter"),
    (case(loads=[{**LOAD, "width_y": "0.1 m"}]), "loads[1].width_x", "nothing", "width_x and width_y, both of them"),
    (case(loads=[{**LOAD, "M_x": "1 kN"}]), "loads[1].M_x", '"1 kN"', 'a moment such as "80 kNm"'),
    # columns
    (case(columns=[COLUMN, COLUMN]), "columns[2].name", '"A1" again', "a unique name"),
    (case(columns=[{**COLUMN, "name": ""}]), "columns[1].name", "no name", "a name"),
    (case(columns=[{"name": "A1", "x": "0 m", "y": "0 m"}]),
     "columns[1].width_x", "nothing", "width_x and width_y, or diameter"),
    (case(columns=[{**COLUMN, "x": "3.2 m"}]),
     "columns[1].x", "3.2 m", "a position on the plate, from -3.0 m to 3.0 m"),
    (case(columns=[{**COLUMN, "diameter": "1e6 m"}]), "columns[1]", "a part that reaches far off the plate", OFF),
    # other loads
    (case(loads=[{**LINE, "points": [["0 m", "0 m"]]}]), "loads[1].points", "1 point", "at least two"),
    (case(loads=[{**LINE, "points": [["0 m", "0 m"], ["1 m", "0 m"], ["1 m", "0 m"]]}]),
     "loads[1].points[3]", "(1.0, 0.0) m twice", "another place than the one before"),
    (case(loads=[{**LINE, "points": [["0 m", "0 m"], ["1e-20 m", "0 m"]]}]),
     "loads[1].points[2]", "(1e-20, 0.0) m twice", "another place than the one before"),
    (case(loads=[{**UNIFORM, "slope": ["1 kPa/m"]}]), "loads[1].slope", "a list of 1",
     'a list of 2, each a pressure per length such as "20 MPa/m"'),
    (case(loads=[{"kind": "temperature", "difference": "15 degC"}]),
     "loads[1].difference", '"15 degC"', 'a temperature difference such as "15 K"'),
    (case({"thermal_expansion": "1e-5 K"}), "plate.thermal_expansion", '"1e-5 K"',
     'a strain per temperature such as "1e-5 1/K"'),
    (case(loads=[{"kind": "self weight", "unit_weight": "0 kN/m^3"}]),
     "loads[1].unit_weight", '"0 kN/m^3"', "a weight per volume above 0"),
    # cases and combinations
    (case(loads=[DEAD]), "loads[1].case", '"dead"', "no case, as there are no [[cases]]"),
    (cases(loads=[UNIFORM]), "loads[1].case", "no case", '"dead" or "live"'),
    (cases(loads=[{**UNIFORM, "case": "Live"}]), "loads[1].case", '"Live"', '"dead" or "live"'),
    (cases(cases=[*CASES, {"name": "dead"}]), "cases[3].name", '"dead" again', "a unique name"),
    (cases(cases=[*CASES, {"name": ""}]), "cases[3].name", "no name", "a name"),
    (cases(cases=[*CASES, {"name": "snow", "action": "variable", "psi_1": 0.1}]),
     "cases[3].psi_2", "0.3", "at most psi_1, 0.1"),
    (cases(cases=[*CASES, {"name": "snow", "psi_0": 1.1}]),
     "cases[3].psi_0", "1.1", "a number at least 0 and at most 1"),
    (case(combinations=[MIX]), "combinations", "a list of 1", "none, as there are no [[cases]] to combine"),
    (cases(combinations=[MIX, MIX]), "combinations[2].name", '"K1" again', "a unique name"),
    (mixed({"daed": 1}), "combinations[1].factors.daed", "a case that is not there", '"dead" or "live"'),
    (mixed({}), "combinations[1].factors", "a table", TABLE),
    (mixed([["dead", 1]]), "combinations[1].factors", "a list of 1", TABLE),
    (mixed("dead"), "combinations[1].factors", '"dead"', TABLE),
    (mixed((([], 1),)), "combinations[1].factors", "a list of 1", TABLE),
    (mixed({1: 2}), "combinations[1].factors", "a table", TABLE),
    (mixed((("dead", 1), ("dead", 2))), "combinations[1].factors.dead", "a second factor", "one factor for each name"),
    (mixed({"dead": 0, "live": 0.0}), "combinations[1].factors", "no factor that is not 0",
     "a factor for at least one case"),
    (mixed({"dead": True}), "combinations[1].factors.dead", "true", "a number"),
    (mixed({"dead": "1"}), "combinations[1].factors.dead", '"1"', "a number"),
    (mixed({"dead": {"a": 1}}), "combinations[1].factors.dead", "a table", "a number"),
    (mixed({"dead": float("nan")}), "combinations[1].factors.dead", "nan", "a number"),
    (mixed({"dead": 10**400}), "combinations[1].factors.dead", "a huge number", "a number"),
    (mixed({"\x1b": 1}), r'combinations[1].factors."\\u001b"', "a case that is not there", '"dead" or "live"'),
    # automatic combinations
    (case(combine={"sets": ["ultimate"]}), "combine", "automatic combinations", "[[cases]] to combine"),
    (combined(sets=["ultimate", "ultimate"]), "combine.sets", '["ultimate", "ultimate"]', "each value at most once"),
    (combined(permanent=[1.0, 1.35]), "combine.permanent", "[1.0, 1.35]",
     "the unfavourable factor first, the larger one"),
    (combined(variable=[1.5, 0.5]), "combine.variable[2]", "0.5", "0"),
    (combined(permanent=[0, 0], variable=[0, 0]),
     "combine", "no combination that is not nothing", "factors and shares that are not all 0"),
    (cases(cases=[{"name": "dead"}, {"name": "a + b"}], combine={"sets": ["ultimate"]}),
     "cases[2].name", '"a + b"', "a name that can be used in a sum"),
    (cases(cases=[{"name": "dead"}, *({"name": f"Q{n}", "action": "variable"} for n in range(12))],
           combine={"sets": ["ultimate"]}), "combine", "12 variable actions", "at most 500 combinations"),
    (cases(combinations=[{**MIX, "name": "ULS 1"}], combine={"sets": ["ultimate"]}),
     "combinations[1].name", '"ULS 1", which combine makes as well', "a unique name"),
    # contact
    (case(contact={"voids": [{"depth": "1 mm", "x": ["0 m", "1 m"], "y": ["0 m", "1 m"], "shape": BOX}]}),
     "contact.voids[1].shape", "a shape together with x or y", "one of them"),
    (case(contact={"voids": [{"x": ["0 m", "1 m"]}]}), "contact.voids[1].y", "nothing", "x and y, or a shape"),
    (case(contact={"voids": [{"shape": {"kind": "circle", "radius": "1e6 m"}}]}),
     "contact.voids[1]", "a part that reaches far off the plate", OFF),
    (case(contact={"gaps": [GAP, {**GAP, "gap": "2 mm"}]}),
     "contact.gaps[2]", "the place of gaps[1]", "a different place"),
    (case(contact={"gaps": [GAP], "tensionless": False}),
     "contact.gaps", "a list of 1", "no gaps, as tensionless is false"),
    (case(contact={"limit_pressure": "1 MPa", "tensionless": False}),
     "contact.limit_pressure", "1000000.0 Pa", "no limit, as tensionless is false"),
    # ground that varies
    (case(boreholes=[HOLE]), "boreholes", 'boreholes in "winkler" ground without soil layers',
     "ground of layers given by E, nu and thickness"),
    (case(ground=STACK, boreholes=[HOLE]), "boreholes[1].layers", "1 layers", "2, as many as the ground has"),
    (case(ground=VLASOV, boreholes=[HOLE, HOLE]), "boreholes[2]", "the place of boreholes[1]", "a different place"),
    (case(ground=VLASOV, boreholes=[{**HOLE, "layers": [{**LAYER, "sublayers": 2}]}]),
     "boreholes[1].layers[1].sublayers", "2", "none, as those of the ground's layer count"),
    (case(ground=VLASOV, boreholes=[{**HOLE, "layers": []}]),
     "boreholes[1].layers", "an empty list", "at least one table"),
    (case(ground={**VLASOV, "formulas": "as printed"}, boreholes=[HOLE]),
     "ground.formulas", '"as printed" with boreholes', '"exact"'),
    (case(ground=VLASOV, soil_zones=[{"shape": BOX, "ground": WINKLER}]), "soil_zones[1].ground",
     "ground of another kind", 'ground like the rest: "vlasov" with the same rules and as many layers'),
    (case(ground=VLASOV, boreholes=[HOLE], soil_zones=[{"shape": BOX, "ground": VLASOV}]),
     "soil_zones", "zones together with boreholes", "one of them"),
    # what is wanted
    (case(output={"points": [{**OUT, "x": "9 m"}]}),
     "output.points[1].x", "9.0 m", "a position on the plate, from -3.0 m to 3.0 m"),
    (case({"openings": [BOX]}, output={"points": [OUT]}),
     "output.points[1]", "a part off the plate, at (0, 0) m", OFF),
    (case(output={"points": [OUT, OUT]}), "output.points[2].name", '"a" again', "a unique name"),
    (case(output={"lines": [{**CUT, "name": ""}]}), "output.lines[1].name", "no name", "a name"),
    (case(output={"lines": [{**CUT, "end": ["-3 m", "0 m"]}]}),
     "output.lines[1].end", "the place where it starts", "another place"),
    (case(output={"lines": [{**CUT, "start": ["-3 m", "3 m"], "end": ["3 m", "3 m"]}]}),
     "output.lines[1]", "a line off the plate", "one that crosses it"),
    (case(output={"strips": [{**CUT, "width": "1 m", "stations": 1}]}),
     "output.strips[1].stations", "1", "a whole number from 2 to 1000"),
    (case(output={"strips": [{**CUT, "width": "0 m"}]}), "output.strips[1].width", '"0 m"', "a length above 0"),
    (designed({**BARS, "top": ["40 mm", "125 mm"]}),
     "reinforcement.top[2]", "0.125 m", "less than half of the least thickness, 0.125 m"),
    (designed({**BARS, "bottom": ["10 mm", "60 mm"], "top": ["10 mm", "10 mm"]},
              plate={**PLATE, "zones": [{**ZONE, "thickness": "0.1 m"}]}),
     "reinforcement.bottom[2]", "0.06 m", "less than half of the least thickness, 0.05 m"),
    (designed({**LAID, "zones": [BAR_ZONE, BAR_ZONE]}),
     "reinforcement.zones[2].name", '"Z" again', "a unique name"),
    (designed({**BARS, "zones": [BAR_ZONE]}), "reinforcement.bottom_x", "no bars", "bars in all four layers"),
    (designed({**LAID, "zones": [{key: value for key, value in BAR_ZONE.items() if key != "spacing"}]}),
     "reinforcement.zones[1].spacing", "nothing", "diameter and spacing, or mesh"),
    (designed({**LAID, "zones": [{**BAR_ZONE, "mesh": "Q335A"}]}), "reinforcement.zones[1].mesh",
     "a mesh together with diameter or spacing", "one of them"),
    (designed({**LAID, "zones": [{"name": "Z", "shape": BOX, "layers": ["top_x"], "mesh": "Q335A"}]}),
     "reinforcement.zones[1].layers", '"top_x"', "both layers of a face, as a mesh has wires both ways"),
    (designed({**LAID, "zones": [{**BAR_ZONE, "shape": {**BOX, "x": ["20 m", "21 m"]}}]}),
     "reinforcement.zones[1].shape", "a zone off the plate", "one that lies at least partly on it"),
    (designed({**LAID, "bottom": ["8 mm", "20 mm"], "zones": [BAR_ZONE]}), "reinforcement.zones[1]",
     "bars of 0.016 m", "bars thinner than 0.016 m, whose axes lie 0.008 m from the face"),
    (designed({**LAID, "top_x": {**SPACED, "spacing": "19 mm"}}), "reinforcement.top_x.spacing",
     '"19 mm"', "a length at least 20 mm"),
    (designed({**LAID, "bottom_mesh": "A393"}), "reinforcement.bottom_mesh",
     "a mesh together with bars", "one of them"),
    (case(reinforcement={**BARS, "alpha_cc": 1.1}),
     "reinforcement.alpha_cc", "1.1", "a number above 0 and at most 1"),
    # what is designed for
    (case(reinforcement=BARS), "reinforcement", *UNDESIGNED),
    (cases(reinforcement=BARS), "reinforcement", *UNDESIGNED),
    (cases(reinforcement=BARS, combinations=[{**MIX, "limit_state": "characteristic"}]), "reinforcement", *UNDESIGNED),
    (cases(reinforcement=BARS, combine={"sets": ["characteristic", "frequent"]}), "reinforcement", *UNDESIGNED),
]  # fmt: skip


def test_one_fault() -> None:
    """Each rule, broken alone, gives exactly one issue with the exact place, what is there, and what should be."""
    for data, where, found, expected in ONE_FAULT:
        (issue,) = issues(data)
        assert issue[:3] == (where, found, expected)


@pytest.mark.parametrize(
    ("part", "where"),
    [
        ({"supports": [{**WALL, "points": [["0 m", "0 m"], ["0 m", "2.1 m"]]}]}, "supports[1]"),
        ({"plate": {**PLATE, "openings": [BOX]}, "supports": [WALL]}, "supports[1]"),
        ({"columns": [{**COLUMN, "x": "2.9 m"}]}, "columns[1]"),
        ({"plate": {**PLATE, "openings": [BOX]}, "columns": [{**COLUMN, "x": "0 m"}]}, "columns[1]"),
        ({"loads": [{**LOAD, "x": "3 m", "width_x": "0.2 m", "width_y": "0.2 m"}]}, "loads[1]"),
        ({"contact": {"voids": [{"shape": {"kind": "circle", "radius": "2.1 m"}}]}}, "contact.voids[1]"),
    ],
)
def test_parts_partly_off_the_plate(part: dict[str, Any], where: str) -> None:
    """What leaves the plate, or reaches into an opening, is reported once, with a place that is off it."""
    ((place, found, _, _),) = issues(case() | part)
    assert place == where
    assert "off the plate" in found or "leaves the plate" in found


@pytest.mark.parametrize("distance", [1e-12, 1e-10, 1e-9])
@pytest.mark.parametrize("place", ["edge", "beyond", "zone"])
def test_supports_at_a_hair(distance: float, place: str) -> None:
    """A support that misses an edge or a zone's corner by a rounding error lies on it."""
    x = {"edge": 3 - distance, "beyond": 3 + distance, "zone": 1 + distance}[place]
    data = case({"zones": [ZONE]}, supports=[{**POINT, "x": f"{x!r} m"}])
    assert Model.model_validate(data, from_file=True).supports[0].x == x


@pytest.mark.parametrize("distance", [1e-8, 1e-6, 1e-4, 1e-3])
@pytest.mark.parametrize(
    ("support", "other"),
    [
        (lambda d: {**POINT, "x": f"{3 - d!r} m"}, "plate.outline"),
        (lambda d: {**POINT, "x": f"{1 + d!r} m"}, "plate.zones[1]"),
        (lambda d: {**WALL, "points": [["-3 m", f"{1 + d!r} m"], ["3 m", f"{1 + d!r} m"]]}, "plate.zones[1]"),
        (lambda d: {**WALL, "points": [["-3 m", f"{2 - d!r} m"], ["3 m", f"{2 - d!r} m"]]}, "plate.outline"),
    ],
)
def test_supports_too_close(distance: float, support: Any, other: str) -> None:
    """A support beside an edge or a corner, too close to be meshed, is reported with its distance and its neighbour."""
    ((where, found, expected, _),) = issues(case({"zones": [ZONE]}, supports=[support(distance)]))
    assert where == "supports[1]"
    assert found.startswith(f"{distance:.3g} m between it and {other} at ")
    assert expected == STRIP


def test_supports_may_cross_and_lie_on_edges() -> None:
    """Lines of supports may cross each other and themselves, run along an edge, and points may stand on them."""
    supports = [
        WALL,
        {**WALL, "points": [["0 m", "-2 m"], ["0 m", "2 m"]]},
        {**WALL, "points": [["-3 m", "-2 m"], ["3 m", "-2 m"], ["3 m", "2 m"]]},
        {**WALL, "points": [["-1 m", "-1 m"], ["1 m", "1 m"], ["1 m", "-1 m"], ["-1 m", "1 m"]]},
        {**POINT, "x": "3 m", "y": "-2 m"},
        {**POINT, "x": "0 m", "y": "0 m"},
    ]
    assert len(Model.model_validate(case(supports=supports), from_file=True).supports) == 6


@pytest.mark.parametrize(
    ("data", "fix"),
    [
        (cases(loads=[{**UNIFORM, "case": "Live"}]), 'did you mean "live"?'),
        (mixed({"daed": 1}), 'did you mean "dead"?'),
        (case(loads=[{"kind": "point", "P": "1 N", "column": "a1"}], columns=[COLUMN]), 'did you mean "A1"?'),
        (case(loads=[{"kind": "settlement", "support": "a1", "w": "1 mm"}], supports=[{**POINT, "name": "A1"}]),
         'did you mean "A1"?'),
        (case(supports=[{**POINT, "stifness": "1 MN/m"}]), 'did you mean "stiffness"?'),
        (case(loads=[{"kind": "self-weight", "unit_weight": "25 kN/m^3"}]), 'did you mean "self weight"?'),
    ],
)  # fmt: skip
def test_suggestions(data: object, fix: str) -> None:
    """A mistyped name of a case, column, support, key or kind is answered with the one that was meant."""
    ((_, _, _, hint),) = issues(data)
    assert hint == fix


def test_many_faults_at_once() -> None:
    """Faults of all the parts come together, each with its place, in one go."""
    data = case(
        contact={"voids": [{"depth": "0 m", "shape": BOX}, {"x": ["0 m", "1 m"]}], "limit_pressure": "1 kN"},
        supports=[{**POINT, "gap": "1 mm"}, {**WALL, "acts": "up"}],
        columns=[{**COLUMN, "diameter": "0 m"}],
        cases=[{"name": "dead", "psi_0": 2}],
        loads=[{**LINE, "points": [["0 m", "0 m"]]}, {**LOAD, "column": "A"}, {"kind": "temperature"}],
        combinations=[{"name": "K", "factors": {"dead": True, "live": "1"}}],
        combine={"sets": [], "permanent": [1, 2]},
        output={"points": [OUT, OUT], "lines": [{**CUT, "end": ["-3 m", "0 m"]}]},
        reinforcement={**BARS, "top": ["1 m"]},
    )
    assert [where for where, *_ in issues(data)] == [
        "contact.voids[1].depth", "contact.voids[2].y", "contact.limit_pressure", "supports[1].gap", "supports[2].acts",
        "columns[1].diameter", "cases[1].psi_0", "loads[1].points", "loads[2].x", "loads[2].y", "loads[3].difference",
        "combinations[1].factors.dead", "combinations[1].factors.live", "combine.sets", "combine.permanent",
        "output.lines[1].end", "output.points[2].name", "reinforcement.top",
    ]  # fmt: skip


def test_design_without_ultimate_combinations_says_which_keys_to_add() -> None:
    """The hint names [[cases]] only where there are none, and always what makes an ultimate combination."""
    both = 'add [[combinations]] with limit_state = "ultimate" and factors, or "ultimate" in the sets of [combine]'
    ((*_, hint),) = issues(cases(reinforcement=BARS))
    assert hint.startswith(both)
    ((*_, hint),) = issues(case(reinforcement=BARS))
    assert hint.startswith("add [[cases]], the case of each load, and then [[combinations]] with limit_state =")
    for sound in (designed(BARS), cases(reinforcement=BARS, combinations=[MIX])):
        Model.model_validate(sound, from_file=True)


def test_unfactored_loads_are_never_called_ultimate() -> None:
    """All loads of a file without cases, and each case by itself, are characteristic: nothing is factored there."""
    for data in (case(), cases()):
        made = list_combinations(Model.model_validate(data, from_file=True))
        assert {each.limit_state for each in made} == {"characteristic"}


def test_names_of_the_file_are_made_harmless_and_short() -> None:
    """Names that a file has chosen come into messages escaped and cut, and of many only some are reported."""
    long = [{"name": f"{'x' * 3000}{n}"} for n in range(30)]
    for data in (
        cases(cases=long, loads=[{**UNIFORM, "case": "y" * 3000}]),
        cases(cases=[{"name": "\x1b[31m"}] * 2, loads=[{**UNIFORM, "case": "\x1b"}]),
        case(columns=[{**COLUMN, **each} for each in long], loads=[{**LOAD, "x": None, "y": None, "column": "y"}]),
    ):
        for issue in issues(data):
            line = ": ".join(issue)
            assert len(line) < 800
            assert "\x1b" not in line


def test_nearly_straight_arcs() -> None:
    """An arc that hardly bends is a curve like any other, not a division by zero."""
    shape = Polygon(points=[(0, 0), (1, 0), (1, 1)], bulges=[1e-20, 1e-12])
    assert shape.ring().polygon(1e-4).area == pytest.approx(0.5, rel=1e-9)


def test_polygon_is_rebuilt_from_its_dump() -> None:
    """A polygon without arcs, dumped and rebuilt, is the same, as is one whose list of bulges is empty in a file."""
    shape = Polygon(points=[(0, 0), (1, 0), (1, 1)])
    assert Polygon(**shape.model_dump()) == shape
    assert Polygon(points=[(0, 0), (1, 0), (1, 1)], bulges=[]) == shape


FULL = {
    **case(
        {"thermal_expansion": "0.000012 1/K", "zones": [ZONE]},
        ground=VLASOV,
        contact={
            "voids": [{"shape": {"kind": "circle", "radius": "0.5 m"}}, {"depth": "1 mm", "shape": BOX}],
            "gaps": [GAP],
            "limit_pressure": "300 kPa",
        },
        boreholes=[{**HOLE, "name": "B1"}],
        supports=[
            {**POINT, "name": "S1", "acts": "in tension", "gap": "1 mm", "limit": "5 kN", "stiffness": "3 MN/m",
             "rotational_stiffness": "5 kNm/rad"},
            {**WALL, "name": "S2", "acts": "in compression", "limit": "5 kN/m", "stiffness": "3 MN/m^2"},
        ],
        columns=[COLUMN, {"name": "A 2", "x": "-1 m", "y": "0 m", "width_x": "0.3 m", "width_y": "0.4 m"}],
        cases=[CASES[0], {**CASES[1], "psi_0": 0.8, "psi_1": 0.6, "psi_2": 0.4, "group": "wind"}],
        loads=[
            {**DEAD, "slope": ["1 kPa/m", "0 Pa/m"], "bend": ["1 kPa/m^2", "0 Pa/m^2", "2 kPa/m^2"],
             "about": ["1 m", "0 m"]},
            {"kind": "area", "case": "live", "q": "1 kPa", "shape": BOX},
            {**LINE, "case": "live", "q_end": "3 kN/m"},
            {"kind": "point", "case": "live", "P": "5 kN", "M_x": "1 kNm", "M_y": "2 Nm", "column": "A 2"},
            {**LOAD, "case": "dead", "diameter": "0.2 m"},
            {"kind": "self weight", "case": "dead", "unit_weight": "25 kN/m^3"},
            {"kind": "temperature", "case": "live", "difference": "-15 K"},
            {"kind": "settlement", "case": "live", "support": "S2", "w": "3 mm"},
        ],
        combinations=[{"name": "a \"b\"", "limit_state": "frequent", "factors": {"dead": 1, "live": -0.25}}],
        combine={"sets": ["ultimate", "quasi-permanent"], "permanent": [1.2, 0.9], "variable": [1.4, 0]},
        output={"points": [OUT], "lines": [CUT], "strips": [{**CUT, "width": "1 m", "stations": 5}]},
        reinforcement={**BARS, "gamma_c": 1.4, "gamma_s": 1.1, "alpha_cc": 0.85},
    ),
}  # fmt: skip


def test_all_keys_are_written_and_read() -> None:
    """A description with every new key, written as a file and read again, is the same; so is what it makes."""
    model = Model.model_validate(FULL, from_file=True)
    text = to_toml(model)
    assert loads(text) == model
    assert Model(**model.model_dump()) == model
    for word in ("rotational_stiffness", "thermal_expansion", "limit_pressure", "q_end", "psi_1", "alpha_cc", "bend"):
        assert word in text
    assert [each.name for each in list_combinations(model)][:2] == ['a "b"', "ULS 1"]


def test_factors_from_python() -> None:
    """Factors are a table or the pairs of one, and come back as pairs in their order."""
    table = Combination(name="K", factors={"b": 1, "a": 2})
    assert table.factors == (("b", 1.0), ("a", 2.0))
    assert Combination(name="K", factors=(("b", 1), ("a", 2))) == table


def test_psi_matter_for_variable_cases_only() -> None:
    """A permanent case may have any psi; they do not count."""
    data = cases(cases=[{"name": "dead", "psi_1": 0.0, "psi_2": 1.0}], combine={"sets": ["ultimate"]})
    model = Model.model_validate(data, from_file=True)
    assert [dict(each.factors) for each in list_combinations(model)] == [{"dead": 1.35}, {"dead": 1.0}]


def _check(value: Any, schema: dict[str, Any], root: dict[str, Any]) -> bool:
    """Return whether a value fits the part of JSON schema that the program writes."""
    import re

    if "$ref" in schema:
        return _check(value, root["definitions"][schema["$ref"].rsplit("/", 1)[1]], root)
    if "required" in schema and set(schema) == {"required"}:
        return set(schema["required"]) <= set(value)
    for words, how in (("anyOf", any), ("oneOf", any), ("allOf", all)):
        if words in schema:
            rest = {key: each for key, each in schema.items() if key != words}
            others = set(rest) <= {"description", "title"} or _check(value, rest, root)
            return others and how(_check(value, each, root) for each in schema[words])
    if "const" in schema or "enum" in schema:
        return value in schema.get("enum", [schema.get("const")])
    kind = schema.get("type")
    if kind == "object":
        known, rest = schema.get("properties", {}), schema.get("additionalProperties", True)
        inner = all(_check(each, known[key], root) if key in known else
                    (isinstance(rest, dict) and _check(each, rest, root)) for key, each in value.items()) \
            if isinstance(value, dict) else False  # fmt: skip
        return inner and set(schema.get("required", ())) <= set(value)
    if kind == "array":
        low, high = schema.get("minItems", 0), schema.get("maxItems", 10**9)
        return isinstance(value, list) and low <= len(value) <= high and all(
            _check(each, schema["items"], root) for each in value)  # fmt: skip
    if kind == "string":
        return isinstance(value, str) and re.search(schema.get("pattern", ""), value) is not None
    if kind == "boolean":
        return isinstance(value, bool)
    return kind in ("number", "integer") and isinstance(value, int | float)


def test_schema_takes_all_keys_and_refuses_others() -> None:
    """The JSON schema accepts a file with every key, and none with a misspelt one or a number without unit."""
    schema = json_schema()
    assert _check(FULL, schema, schema)
    assert not _check({**FULL, "supports": [{**POINT, "stifness": "1 N/m"}]}, schema, schema)
    assert not _check({**FULL, "columns": [{**COLUMN, "x": 1}]}, schema, schema)
    assert not _check({**FULL, "combinations": [{"name": "K", "factors": {}}, {"name": "K"}]}, schema, schema)
