"""Files in the Structural Analysis Format of one small slab: values in SI units and signs are worked out by hand."""

from __future__ import annotations

import math
import random
from pathlib import Path
from typing import Any

import pytest

import groundslab as gs
from helpers import saf_files

pytest.importorskip("openpyxl")

#: A foot, an inch [m] and a kilopound [N] (NIST SP 811).
FT, IN, KIP = 0.3048, 0.0254, 4448.2216152605
#: Heights of the load's plane below and above the slab [m].
BELOW, ABOVE = -2.0, 3.0


def slab(imperial: bool = False) -> saf_files.Sheets:
    """Return a slab of 6 by 4, in meters or feet, with one corner at the origin, on springs, with one load case."""
    m, mm, MPa, mass = ("ft", "in", "ksi", "lb/ft3") if imperial else ("m", "mm", "MPa", "kg/m3")
    k0, k1 = ("kip/ft3", "kip/ft") if imperial else ("MN/m3", "MN/m")
    return {
        "Model": saf_files.model_sheet("Imperial" if imperial else "Metric"),
        "StructuralMaterial": [
            ["Name", "Type", "Quality", f"Unit mass [{mass}]", f"E modulus [{MPa}]", "Poisson Coefficient",
             "Thermal expansion [1/°F]" if imperial else "Thermal expansion [1/K]"],
            ["C", "Concrete", "C30/37", 150 if imperial else 2500, 3600 if imperial else 33000, 0.2,
             5.5e-6 if imperial else 1.2e-5],
        ],
        "StructuralPointConnection": [
            ["Name", f"Coordinate X [{m}]", f"Coordinate Y [{m}]", f"Coordinate Z [{m}]"],
            ["N1", 0, 0, 0], ["N2", 6, 0, 0], ["N3", 6, 4, 0], ["N4", 0, 4, 0], ["I", 2, 1, 0],
        ],
        "StructuralSurfaceMember": [
            ["Name", "Material", "Thickness type", f"Thickness [{mm}]", "System plane at", "Nodes", "Edges", "LCS Type",
             f"Coordinate X [{m}]", f"Coordinate Y [{m}]", f"Coordinate Z [{m}]", "LCS Rotation [deg]",
             f"Analysis Z Eccentricity [{mm}]"],
            ["S", "C", "Constant", "12" if imperial else "300", "Centre", "N1; N2; N3; N4", "Line; Line; Line; Line",
             "x by vector", 1, 0, 0, 0, 0],
        ],
        "StructuralSurfaceConnection": [
            ["Name", "2D Member", "Subsoil", f"C1x [{k0}]", f"C1y [{k0}]", f"C1z [{k0}]", f"C2x [{k1}]", f"C2y [{k1}]"],
            ["SS", "S", "Gravel", 0, 0, 100, 50, 50],
        ],
        "StructuralLoadGroup": [
            ["Name", "Load group type", "Relation", "Load type"], ["LG", "Variable", "Standard", "Wind"],
        ],
        "StructuralLoadCase": [["Name", "Action type", "Load group", "Load type"], ["Q", "Variable", "LG", "Static"]],
    }  # fmt: skip


def free(q: str, **cells: Any) -> list[list[Any]]:
    """Return a free pressure on the square from (4, 0) to (8, 4), half of which lies off the slab."""
    height = cells.pop("height", 0.0)
    given = {
        "Name": "F", "Direction": "Z", "Distribution": "Uniform", "q [kN/m2]": q, "Load case": "Q",
        "Coordinate X [m]": "4; 8; 8; 4", "Coordinate Y [m]": "0; 0; 4; 4",
        "Coordinate Z [m]": "; ".join([str(height)] * 4), "Edges": "Line; Line; Line; Line",
        "Coordinate system": "Global", "Location": "Length", **cells,
    }  # fmt: skip
    return [list(given), list(given.values())]


def read(tmp_path: Path, sheets: saf_files.Sheets) -> gs.SafCase:
    """Return what is read from sheets."""
    return gs.read_saf(saf_files.write(tmp_path / "slab.xlsx", sheets))


def case_of(model: gs.Model) -> gs.LoadCase:
    """Return the only load case."""
    (case,) = model.cases
    return case


def notes(case: gs.SafCase) -> str:
    """Return all that the report says."""
    return "\n".join(line.why for line in case.report)


def test_imperial_values(tmp_path: Path) -> None:
    """Each kind of quantity, converted by the definitions of foot, inch and pound."""
    sheets = slab(imperial=True)
    sheets["StructuralPointSupport"] = [
        ["Name", "Boundary condition", "Node", "ux", "uy", "uz", "fix", "fiy", "fiz", "Stiffness Z [kip/ft]",
         "Stiffness Fix [kipft/deg]", "Stiffness Fiy [kipft/deg]"],
        ["P", "In node", "I", "Free", "Free", "Flexible", "Flexible", "Flexible", "Free", 200, 10, 10],
    ]  # fmt: skip
    sheets["StructuralEdgeConnection"] = [
        ["Name", "Boundary condition", "2D Member", "Edge", "ux", "uy", "uz", "fix", "fiy", "fiz",
         "Stiffness Z [kip/ft2]", "Coordinate system", "Coordinate definition", "Origin", "Start point [ft]",
         "End point [ft]"],
        ["L", "On edge", "S", 1, "Free", "Free", "Flexible", "Free", "Free", "Free", 5, "Global", "Absolute",
         "From start", 1, 3],
    ]  # fmt: skip
    sheets["StructuralCurveMoment"] = [
        ["Name", "Force action", "Distribution", "Direction", "Value 1 [kipft/ft]", "2D Member", "Edge", "Load case",
         "Coordinate system", "Coordinate definition", "Origin", "Start point [ft]", "End point [ft]"],
        ["M", "On edge", "Uniform", "Mx", 2, "S", 1, "Q", "Local", "Relative", "From start", 0, 1],
    ]  # fmt: skip
    sheets["StructuralSurfaceActionThermal"] = [
        ["Name", "Variation", "TempT [°F]", "TempB [°F]", "2D Member", "2D Member Region", "Load case"],
        ["T", "Linear", -9, 9, "S", None, "Q"],
    ]
    model = read(tmp_path, sheets).model
    assert model.plate.thickness == pytest.approx(12 * IN)
    assert model.plate.bounds == pytest.approx((0, 6 * FT, 0, 4 * FT))
    assert pytest.approx(3600 * KIP / IN**2) == model.plate.E
    assert model.plate.thermal_expansion == pytest.approx(9.9e-6)
    assert isinstance(model.ground, gs.Pasternak)
    assert (model.ground.k0, model.ground.k1) == pytest.approx((100 * KIP / FT**3, 50 * KIP / FT))
    point, line = model.supports
    assert isinstance(point, gs.PointSupport)
    assert (point.x, point.y) == pytest.approx((2 * FT, FT))
    assert point.stiffness == pytest.approx(200 * KIP / FT)
    assert point.rotational_stiffness == pytest.approx(10 * KIP * FT * 180 / math.pi)
    assert isinstance(line, gs.LineSupport)
    assert line.stiffness == pytest.approx(5 * KIP / FT**2)
    assert line.points == (pytest.approx((FT, 0)), pytest.approx((3 * FT, 0)))
    moment, temperature = model.loads
    # about the edge along x a positive moment lifts what lies to the left, up the page
    assert isinstance(moment, gs.LineMoment)
    assert moment.m == pytest.approx(-2 * KIP)
    assert isinstance(temperature, gs.TemperatureLoad)
    assert temperature.difference == pytest.approx(10)


def test_settlements_of_supports(tmp_path: Path) -> None:
    """Upwards is positive in the file, downwards here: -12 mm are a settlement of 12 mm; sideways is left out."""
    sheets = slab()
    sheets["StructuralPointSupport"] = [
        ["Name", "Node", "ux", "uy", "uz", "fix", "fiy", "fiz"],
        ["P", "I", "Free", "Free", "Rigid", "Free", "Free", "Free"],
    ]
    sheets["StructuralPointSupportDeformati"] = [
        ["Name", "Point support", "Direction", "Translation value [mm]", "Load case"],
        ["D", "P", "Z", -12, "Q"], ["E", "P", "X", 5, "Q"], ["F", "other", "Z", 5, "Q"],
    ]  # fmt: skip
    case = read(tmp_path, sheets)
    assert case.model.loads == (gs.SettlementLoad(name="D", case="Q", support="P", w=0.012),)
    assert [line.taken for line in case.report if line.name in "DEF"] == [True, False, False]


@pytest.mark.parametrize(
    ("kind", "vector", "turned", "angle"),
    [("x by vector", (1, 0), 30, 30), ("x by vector", (0, 2), 0, 90), ("y by vector", (0, 1), 0, 0),
     ("y by vector", (1, 0), 45, -45)],
)  # fmt: skip
def test_local_axes_of_the_slab(
    tmp_path: Path, kind: str, vector: tuple[float, float], turned: float, angle: float
) -> None:
    """A pressure of 2 kN/m2 along the local x axis, on 24 m2, is 48 kN in that direction; z goes up."""
    sheets = slab()
    sheets["StructuralSurfaceMember"][1][7:12] = [kind, *vector, 0, turned]
    sheets["StructuralSurfaceAction"] = [
        ["Name", "Direction", "Force action", "Value [kN/m2]", "2D Member", "Load case", "Coordinate system"],
        ["H", "X", "On 2D member", 2, "S", "Q", "Local"],
        ["V", "Z", "On 2D member", -3, "S", "Q", "Local"],
    ]
    model = read(tmp_path, sheets).model
    case = case_of(model)
    a = math.radians(angle)
    assert (case.H_x, case.H_y) == pytest.approx((48e3 * math.cos(a), 48e3 * math.sin(a)), abs=1e-6)
    (load,) = model.loads
    assert isinstance(load, gs.UniformLoad)
    assert load.q == 3e3


def test_free_loads_act_where_the_slab_is(tmp_path: Path) -> None:
    """Half of a square of 16 m2 lies off the slab: 2 kN/m2 along x are 16 kN; downwards the case clips it."""
    sheets = slab()
    sheets["StructuralSurfaceActionFree"] = [*free("2", Direction="X"), free("-5", Name="V")[1]]
    model = read(tmp_path, sheets).model
    assert (case_of(model).H_x, case_of(model).H_y) == (pytest.approx(16e3), 0)
    (load,) = model.loads
    assert isinstance(load, gs.AreaLoad)
    assert (load.q, load.shape.ring().area) == (5e3, 16)


def test_free_loads_that_vary_sideways(tmp_path: Path) -> None:
    """From 1 kN/m2 at x = 4 to 5 kN/m2 at x = 8: on the slab, to x = 6, the mean is 2 kN/m2 on 8 m2."""
    sheets = slab()
    sheets["StructuralSurfaceActionFree"] = free("C1:1; C2:5; C4:1", Direction="X", Distribution="DirectionXY")
    sheets["StructuralSurfaceAction"] = [
        ["Name", "Direction", "Force action", "Value [kN/m2]", "2D Member", "Load case", "Coordinate system"],
        ["V", "Z", "On 2D member", -3, "S", "Q", "Global"],
    ]
    assert case_of(read(tmp_path, sheets).model).H_x == pytest.approx(16e3)


def test_free_lines_that_reach_off_the_slab(tmp_path: Path) -> None:
    """From 0 at x = -2 to 4 kN/m at x = 2: on the slab 2 m with 2 to 4 kN/m, 6 kN; one beside the slab is left out."""
    sheets = slab()
    head = ["Name", "Distribution", "Direction", "Value 1 [kN/m]", "Value 2 [kN/m]", "Load case", "Coordinate X [m]",
            "Coordinate Y [m]", "Coordinate Z [m]", "Segments", "Coordinate system"]  # fmt: skip
    sheets["StructuralCurveActionFree"] = [
        head,
        ["H", "Trapez", "Y", 0, 4, "Q", "-2; 2", "1; 1", "0; 0", "Line", "Global"],
        ["V", "Trapez", "Z", 0, -4, "Q", "-2; 2", "1; 1", "0; 0", "Line", "Global"],
        ["off", "Uniform", "Z", -4, None, "Q", "-2; 9", "5; 5", "0; 0", "Line", "Global"],
    ]
    case = read(tmp_path, sheets)
    assert case_of(case.model).H_y == pytest.approx(6e3)
    assert [load.name for load in case.model.loads] == ["V"]
    assert [line.taken for line in case.report if line.name == "off"] == [False]


@pytest.mark.parametrize(
    ("height", "validity", "z", "acts"),
    [
        (0.0, "Z zero", "Positive", True), (0.0, "All", "Positive", True), (0.0, "Minus Z", "Positive", False),
        (0.0, "Plus Z zero", "Positive", True), (ABOVE, "Z zero", "Positive", False), (ABOVE, "All", "Positive", True),
        (ABOVE, "Minus Z", "Positive", True), (ABOVE, "Plus Z", "Positive", False), (ABOVE, "Plus Z", "Negative", True),
        (BELOW, "Plus Z", "Positive", True), (BELOW, "Minus Z zero", "Positive", False),
        (BELOW, "From to", "Positive", True),
        (BELOW, "From to", "Negative", False), (ABOVE, "From to", "Positive", False),
    ],
)  # fmt: skip
def test_free_loads_of_other_heights(tmp_path: Path, height: float, validity: str, z: str, acts: bool) -> None:
    """A load acts above or below its plane as it says; "from to" means 1.5 m to 2.5 m along its own z axis."""
    sheets = slab()
    words = {"Validity": validity, "Validity from [m]": 1.5, "Validity to [m]": 2.5, "Local Z direction": z}
    sheets["StructuralSurfaceActionFree"] = free("-5", height=height, **words)
    case = read(tmp_path, sheets)
    assert [load.name for load in case.parts["loads"]] == ["F"] * acts
    assert [line.taken for line in case.report if line.name == "F"] == [acts]


@pytest.mark.parametrize(("z", "q"), [("Positive", -5e3), ("Negative", 5e3)])
def test_free_loads_have_axes_of_their_own(tmp_path: Path, z: str, q: float) -> None:
    """With a local z axis that goes down, 5 kN/m2 along it press; the local x axis goes from the first place on."""
    sheets = slab()
    words = {"Coordinate system": "Local", "Local Z direction": z}
    turned = {"Coordinate X [m]": "6; 6; 4; 4", "Coordinate Y [m]": "0; 4; 4; 0"}
    sheets["StructuralSurfaceActionFree"] = [
        *free("5", **words),
        free("1", Name="H", Direction="X", **words, **turned)[1],
    ]
    model = read(tmp_path, sheets).model
    assert [load.q for load in model.loads if isinstance(load, gs.AreaLoad)] == [q]
    assert (case_of(model).H_x, case_of(model).H_y) == pytest.approx((0, 8e3), abs=1e-9)


def test_supports_with_local_axes_hold_along_the_slabs_z(tmp_path: Path) -> None:
    """Where the file's Y axis is vertical, the local z axis of an edge still is, and uy is sideways."""
    sheets = slab()
    sheets["Model"] = saf_files.model_sheet(vertical="Y vertical")
    for row in sheets["StructuralPointConnection"][1:]:
        row[1:4] = [row[2], row[3], row[1]]
    sheets["StructuralEdgeConnection"] = [
        ["Name", "Boundary condition", "2D Member", "Edge", "ux", "uy", "uz", "fix", "fiy", "fiz", "Coordinate system"],
        ["local", "On edge", "S", 1, "Free", "Free", "Rigid", "Rigid", "Free", "Free", "Local"],
        ["across", "On edge", "S", 2, "Free", "Rigid", "Free", "Free", "Free", "Free", "Local"],
        ["global", "On edge", "S", 3, "Free", "Rigid", "Free", "Free", "Free", "Free", "Global"],
    ]
    case = read(tmp_path, sheets)
    assert [(support.name, support.rotation) for support in case.parts["supports"]] == [
        ("local", "fixed"),
        ("global", "free"),
    ]


def test_what_supports_hold_besides_is_noted(tmp_path: Path) -> None:
    """A spring that also keeps the slab from turning is one that lets it turn here, and none holds it sideways."""
    sheets = slab()
    sheets["StructuralEdgeConnection"] = [
        ["Name", "Boundary condition", "2D Member", "Edge", "ux", "uy", "uz", "fix", "fiy", "fiz",
         "Stiffness Z [MN/m2]", "Coordinate system"],
        ["L", "On edge", "S", 1, "Rigid", "Free", "Flexible", "Rigid", "Free", "Free", 5, "Local"],
    ]  # fmt: skip
    said = notes(read(tmp_path, sheets))
    assert "turning about its line that is rigid, taken as free" in said
    assert "what holds it sideways, left out" in said


def test_a_slab_says_what_is_not_taken_of_it(tmp_path: Path) -> None:
    """An eccentric plane, a behavior other than isotropic; a region of another weight."""
    sheets = slab()
    sheets["StructuralSurfaceMember"][0].append("Behavior in analysis")
    sheets["StructuralSurfaceMember"][1][12:] = [-125, "Press only"]
    sheets["StructuralMaterial"].append(["L", "Concrete", "LC30/33", 1800, 20000, 0.2, 1.2e-5])
    sheets["StructuralSurfaceMemberRegion"] = [
        ["Name", "Material", "Thickness [mm]", "System plane at", "2D Member", "Nodes", "Edges"],
        ["R", "L", 300, "Centre", "S", "N1; N2; I", "Line; Line; Line"],
    ]
    said = notes(read(tmp_path, sheets))
    assert "its plane, taken to be the slab's middle plane" in said
    assert "a behavior that is press only, taken as isotropic" in said
    assert "a unit weight of its own" in said


@pytest.mark.parametrize(
    ("action", "group", "load", "kind", "said"),
    [
        ("Variable", "Permanent", "Static", "variable", 'load type "Static" and group of type "Permanent"'),
        ("Permanent", "Variable", "", "variable", 'action type "Permanent" and group of type "Variable"'),
        ("Permanent", "Permanent", "Snow", "variable", 'load type "Snow"'),
        ("Variable", "Variable", "Self weight", "variable", 'load type "Self weight"'),
        ("Variable", "Variable", "Seismic", "seismic", 'load type "Seismic"'),
        ("Permanent", "Permanent", "Standard", "permanent", ""),
        ("", "Permanent", "", "permanent", ""),
        ("", "", "", "permanent", ""),
        ("Variable", "Seismic", "Seismic", "seismic", ""),
        ("Variable", "Seismic", "Static", "seismic", ""),
        ("Accidental", "Accidental", "Static", "accidental", ""),
    ],
)  # fmt: skip
def test_kinds_of_a_case_that_contradict_are_said(
    tmp_path: Path, action: str, group: str, load: str, kind: str, said: str
) -> None:
    """A case that one of three columns calls variable is variable, and a note names all; else nothing is said."""
    sheets = slab()
    sheets["StructuralLoadGroup"][1][1] = group
    sheets["StructuralLoadGroup"][1][3] = None
    sheets["StructuralLoadCase"][1][1:4] = [action, "LG", load]
    sheets["StructuralSurfaceActionFree"] = free("-5")
    found = read(tmp_path, sheets)
    assert case_of(found.model).action == kind
    assert (f"taken as {kind}" in notes(found)) == bool(said)
    assert said in notes(found)


@pytest.mark.parametrize(
    ("action", "group", "load"),
    [("Accidental", "Variable", "Static"), ("Variable", "Accidental", "Static"), ("Permanent", "Seismic", "Others"),
     ("Permanent", "Accidental", "Others"), ("Permanent", "Permanent", "Seismic")],
)  # fmt: skip
def test_kinds_of_a_case_that_leave_open_what_is_safe_are_refused(
    tmp_path: Path, action: str, group: str, load: str
) -> None:
    """Accidental and seismic actions are in other combinations than the others: neither reading is on the safe side."""
    sheets = slab()
    sheets["StructuralLoadGroup"][1][1] = group
    sheets["StructuralLoadCase"][1][1:4] = [action, "LG", load]
    with pytest.raises(gs.InputError, match=f'action type "{action}".*"{group}", which contradict') as caught:
        read(tmp_path, sheets)
    assert "StructuralLoadCase, row 2" in str(caught.value)


def test_load_types_of_group_and_case_that_differ_are_refused(tmp_path: Path) -> None:
    """A case of snow in a group of wind has two sets of psi."""
    sheets = slab()
    sheets["StructuralLoadCase"][1][3] = "Snow"
    with pytest.raises(gs.InputError, match='load types of group and case that differ: "Wind" and "Snow"'):
        read(tmp_path, sheets)


def _add(sheet: str, *rows: list[Any]) -> dict[str, list[list[Any]]]:
    """Return a sheet of the slab with more rows."""
    return {sheet: [*slab()[sheet], *rows]}


_FORCES = ["Name", "Direction", "Force action", "Reference node", "Value [kN]", "Load case", "Coordinate system"]
_FORCE = ["F", "Z", "In node", "I", -10, "Q", "Global"]


@pytest.mark.parametrize(
    ("sheets", "said"),
    [
        (_add("StructuralSurfaceConnection", ["SS", "S", "Gravel", 0, 0, 60, 50, 50]),
         'StructuralSurfaceConnection, row 3: found the name "SS" again, as in row 2, with c1z "100" and "60"'),
        (_add("StructuralSurfaceMember", ["S", "C", "Constant", "900", *slab()["StructuralSurfaceMember"][1][4:]]),
         'thickness "300" and "900"'),
        (_add("StructuralPointConnection", ["N2", 7, 0, 0]), 'coordinatex "6" and "7"'),
        (_add("StructuralMaterial", ["C", "Concrete", "C30/37", 2500, 3300, 0.2, 1.2e-5]),
         'emodulus "33000" and "3300"'),
        (_add("StructuralLoadGroup", ["LG", "Permanent", "Standard", None]),
         'loadgrouptype "Variable" and "Permanent"'),
        (_add("StructuralLoadCase", ["Q", "Permanent", "LG", "Static"]), 'actiontype "Variable" and "Permanent"'),
        ({"StructuralPointAction": [_FORCES, _FORCE, _FORCE]},
         'the name "F" again, as in row 2, with the same values'),
        ({"StructuralPointAction": [[*_FORCES, "Value [kN]"], [*_FORCE, -20]]},
         'row 2, value: found two columns that say "-10 kN" and "-20 kN"'),
        ({"StructuralPointAction": [[*_FORCES, "Value [kip]"], [*_FORCE, -10]]}, '"-10 kN" and "-10 kip"'),
        ({"Model": [*saf_files.model_sheet(), ["System of units", "Imperial"]]}, '"Metric" and "Imperial"'),
        ({"Model ": saf_files.model_sheet("Imperial")}, "two sheets of that name"),
    ],
)  # fmt: skip
def test_what_sheets_say_twice_is_refused(tmp_path: Path, sheets: saf_files.Sheets, said: str) -> None:
    """Two rows of one name, two columns of one heading: neither added up nor overridden, but said with both values."""
    with pytest.raises(gs.InputError) as caught:
        read(tmp_path, slab() | sheets)
    assert said in str(caught.value)


def test_columns_that_say_the_same_twice_are_no_contradiction(tmp_path: Path) -> None:
    """Nor is a second one that is blank."""
    rows = [[*_FORCES, "Value [kN]"], [*_FORCE, -10], ["G", *_FORCE[1:], None]]
    model = read(tmp_path, slab() | {"StructuralPointAction": rows}).model
    assert [load.P for load in model.loads if isinstance(load, gs.PointLoad)] == [20e3]


def test_a_case_with_two_factors_in_a_combination_is_refused(tmp_path: Path) -> None:
    """It is not added up to 2.85."""
    row = ["C", None, "ULS", None, "Linear", 1.35, 1, "Q", 1.5, 1, "Q"]
    with pytest.raises(gs.InputError, match=r'the case "Q" with the factors 1\.35 and 1\.5'):
        read(tmp_path, combinations(row))


def test_two_results_of_one_section_are_refused(tmp_path: Path) -> None:
    """The foot of a column with two normal forces in one load case."""
    sheets = column(True, 0, -100, 0, 0, 0, 0, 0)
    sheets["ResultInternalForce1D"].append([*sheets["ResultInternalForce1D"][1][:6], -300, 0, 0, 0, 0, 0])
    with pytest.raises(gs.InputError, match='C in Q again, as in row 2, with n "-100" and "-300"'):
        read(tmp_path, sheets)


@pytest.mark.parametrize(
    ("value", "thickness", "P"),
    [
        (-1234, "300", 1234), ("-1234.5", "300", 1234.5), ("-12,5", "300", 12.5), ("-1.234,5", "300", 1234.5),
        ("-1,234.5", "300", 1234.5), ("-0,250", "300", 0.25), ("-1,234", "299.5", 1234), ("-1,234", "299,5", 1.234),
        ("-1 234", "300", 1234),
    ],
)  # fmt: skip
def test_texts_are_numbers_as_the_file_writes_them(tmp_path: Path, value: object, thickness: str, P: float) -> None:
    """What stands before decimals is what stands there in the other texts of the file."""
    sheets = slab() | {"StructuralPointAction": [_FORCES, [*_FORCE[:4], value, *_FORCE[5:]]]}
    sheets["StructuralSurfaceMember"][1][3] = thickness
    (load,) = read(tmp_path, sheets).model.loads
    assert isinstance(load, gs.PointLoad)
    assert pytest.approx(P * 1e3) == load.P


def test_coordinates_in_millimeters_are_noted(tmp_path: Path) -> None:
    """A slab of 6000 m by 4000 m would be one of 6 m by 4 m if its nodes were in millimeters."""
    sheets = slab()
    for row in sheets["StructuralPointConnection"][1:]:
        row[1:] = [1000 * value for value in row[1:]]
    assert "the unit is m, which makes it a slab of 6e+03 m x 4e+03 m; it would be 6 m x 4 m in mm" in notes(
        read(tmp_path, sheets)
    )
    assert "the unit is" not in notes(read(tmp_path, slab()))


def test_a_unit_in_a_cell_is_refused(tmp_path: Path) -> None:
    """It may be that of the heading or not: units stand in headings."""
    for cell in ("-10 kN", "-10 kip"):
        sheets = slab() | {"StructuralPointAction": [_FORCES, [*_FORCE[:4], cell, *_FORCE[5:]]]}
        with pytest.raises(gs.InputError, match=f'value: found "{cell}", expected a number'):
            read(tmp_path, sheets)


def test_a_text_that_two_countries_read_differently_is_refused(tmp_path: Path) -> None:
    """-1,234 kN are 1.234 or 1234 kN; nothing else in the file tells which."""
    sheets = slab() | {"StructuralPointAction": [_FORCES, [*_FORCE[:4], "-1,234", *_FORCE[5:]]]}
    with pytest.raises(gs.InputError, match=r"-1,234 may be -1234 or -1\.234: make the cell a number"):
        read(tmp_path, sheets)


def combinations(*rows: list[Any]) -> saf_files.Sheets:
    """Return the slab with a permanent case, two of wind that exclude each other, and combinations."""
    sheets = slab()
    sheets["StructuralLoadGroup"] += [["P", "Permanent", "Together", None], ["W", "Variable", "Exclusive", None]]
    sheets["StructuralLoadCase"] = [
        ["Name", "Action type", "Load group", "Load type"],
        ["G", "Permanent", "P", "Others"], ["W1", "Variable", "W", "Wind"], ["W2", "Variable", "W", "Wind"],
        ["Q", "Variable", "LG", "Static"],
    ]  # fmt: skip
    sheets["StructuralLoadCombination"] = [
        ["Name", "Description", "Category", "National standard", "Type", *(
            f"{what} {n}" for n in range(1, 5) for what in ("Load factor", "Multiplier", "Load case name"))],
        *rows,
    ]  # fmt: skip
    return sheets


_ALL = [1.35, 1, "G", 1.5, 0.6, "W1", 1.5, 0.6, "W2", 1.5, 1, "Q"]


def test_categories_of_cases(tmp_path: Path) -> None:
    """By the type of the group, else by that of the case: wind has psi 0.6, 0.2, 0 (EN 1990 Table A1.1)."""
    cases = {case.name: case for case in read(tmp_path, combinations()).parts["cases"]}
    assert (cases["W1"].category, cases["W1"].group) == ("wind", "W")
    assert (cases["W1"].psi_0, cases["W1"].psi_1, cases["W1"].psi_2) == (0.6, 0.2, 0)
    assert (cases["Q"].category, cases["Q"].group, cases["G"].action) == ("wind", "", "permanent")


def test_an_envelope_is_one_combination_for_each_exclusive_case(tmp_path: Path) -> None:
    """Wind from both sides never acts together; factor times multiplier is 0.9."""
    case = read(tmp_path, combinations(["E", None, "ULS (Ultimate Limit State)", None, "Envelope", *_ALL]))
    made = {each.name: dict(each.factors) for each in case.parts["combinations"]}
    assert made == {"E (1)": {"G": 1.35, "W1": 0.9, "Q": 1.5}, "E (2)": {"G": 1.35, "W2": 0.9, "Q": 1.5}}
    assert "taken as 2 combinations" in notes(case)


def test_combinations_by_a_standard(tmp_path: Path) -> None:
    """Those of IBC are made by ACI 318 and ASCE 7; cases that one leaves out are combined as well, which is noted."""
    row = ["C", None, "According national standard", "IBC-LRFD ultimate", None, None, 1, "G", None, 1, "Q"]
    other = ["D", None, "According national standard", "EN-SLS Frequent", None, None, 1, "G"]
    case = read(tmp_path, combinations(row, other))
    assert case.parts["combine"] == gs.Combine(sets=("ultimate",), expression="ACI 318")
    assert "also those that it does not list: W1, W2" in notes(case)
    assert "frequent of a second code, left out" in notes(case)


def test_a_limit_state_of_a_description_is_that_of_the_category(tmp_path: Path) -> None:
    """A combination that is called ultimate in words and serviceability by its category is refused."""
    with pytest.raises(gs.InputError, match=r'category "sls.*" and description "ultimate", which contradict'):
        read(tmp_path, combinations(["C", "ultimate", "SLS (Serviceability Limit State)", None, "Linear", *_ALL]))


def test_stiffnesses_that_contradict_are_noted(tmp_path: Path) -> None:
    """A rigid support with a spring; G of 13.75 GPa beside E = 33 GPa and nu = 0.2 is right, 10 GPa is not."""
    sheets = slab()
    sheets["StructuralPointSupport"] = [
        ["Name", "Boundary condition", "Node", "ux", "uy", "uz", "fix", "fiy", "fiz", "Stiffness Z [MN/m]"],
        ["P", "In node", "I", "Free", "Free", "Rigid", "Free", "Free", "Free", 200],
    ]
    for row, G in zip(sheets["StructuralMaterial"], ["G modulus [MPa]", 10000], strict=True):
        row.append(G)
    said = notes(read(tmp_path, sheets))
    assert 'uz "rigid" with a stiffness of 200 MN/m, taken as rigid' in said
    assert "E 33 GPa, G 10 GPa and Poisson's ratio 0.2, where E / (2 (1 + nu)) is 13.75 GPa" in said
    sheets["StructuralMaterial"][1][-1] = 13750
    assert "13.75" not in notes(read(tmp_path, sheets))


@pytest.mark.parametrize(
    ("units", "thickness"),
    [("Metric units", "Thickness [mm]"), ("METRIC", "thickness (mm)"), ("metric system", "Thickness  [ mm ]")],
)
def test_units_are_spelled_in_other_ways(tmp_path: Path, units: str, thickness: str) -> None:
    """300 mm are 0.3 m, however system of units and heading are written."""
    sheets = slab() | {"Model": saf_files.model_sheet(units)}
    sheets["StructuralSurfaceMember"][0][3] = thickness
    assert read(tmp_path, sheets).parts["plate"].thickness == 0.3


@pytest.mark.parametrize("seed", range(25))
def test_sheets_headings_and_words_spelled_in_other_ways(seed: int, tmp_path: Path) -> None:
    """Capitals, spaces, signs and brackets of sheets, headings, units and words: always the same slab and load."""
    chance = random.Random(seed)

    def letters(text: str) -> str:
        return chance.choice([str.upper, str.lower, str.title, str])(text)

    def heading(text: str) -> str:
        name, _, unit = str(text).partition(" [")
        name = letters(name).replace(" ", chance.choice([" ", "", "_", "  "]))
        left, right = chance.choice(["[]", "()"]) if unit else ("", "")
        unit = (
            unit.removesuffix("]").replace("2", chance.choice(["2", "²", "^2"])).replace("3", chance.choice(["3", "³"]))
        )
        return f"{name}{chance.choice([' ', '', '  '])}{left}{unit}{right}"

    words = {"Variable", "Wind", "Static", "Standard", "Constant", "Centre", "Global", "Z", "In node", "x by vector"}
    sheets = slab() | {"StructuralPointAction": [_FORCES, [*_FORCE[:4], "-10,5", *_FORCE[5:]]]}
    spelled = {
        letters(name) + chance.choice(["", " "]): [
            [heading(cell) for cell in rows[0]],
            *([letters(cell) if cell in words else cell for cell in row] for row in rows[1:]),
        ]
        for name, rows in sheets.items()
        if name != "Model"
    }
    model = chance.choice([["Metric", "Z vertical"], ["metric units", "z vertical"], ["METRIC", "Z-Vertical"]])
    spelled["Model"] = saf_files.model_sheet(model[0], model[1].replace("-", " "))
    case = read(tmp_path, spelled).model
    assert (case.plate.thickness, case.plate.E, case.ground) == (0.3, 33e9, gs.Pasternak(k0=100e6, k1=50e6))
    assert (case_of(case).action, case_of(case).category) == ("variable", "wind")
    (load,) = case.loads
    assert isinstance(load, gs.PointLoad)
    assert load.P == 10.5e3


def test_a_category_that_is_not_defined_is_noted(tmp_path: Path) -> None:
    """It counts as ultimate."""
    case = read(tmp_path, combinations(["C", None, "Not defined", None, "Linear", *_ALL]))
    assert [each.limit_state for each in case.parts["combinations"]] == ["ultimate"]
    assert 'the category "not defined", taken as ultimate' in notes(case)


def column(upwards: bool, rotation: float, *results: float) -> saf_files.Sheets:
    """Return the slab with a column of 3 m at (2, 1), whose local y is along y of the file unless it is turned."""
    sheets = slab()
    sheets["StructuralPointConnection"].append(["T", 2, 1, 3])
    sheets["StructuralCrossSection"] = [
        ["Name", "Material", "Cross-section type", "Shape", "Parameters [mm]"],
        ["CS", "C", "Parametric", "Rectangle", "400; 300"],
    ]
    sheets["StructuralCurveMember"] = [
        ["Name", "Type", "Cross section", "Nodes", "Segments", "LCS", "LCS Rotation [deg]", "Coordinate X [m]",
         "Coordinate Y [m]", "Coordinate Z [m]", "System line"],
        ["C", "Column", "CS", "I; T" if upwards else "T; I", "Line", "y by vector", rotation, 0, 1, 0, "Centre"],
    ]  # fmt: skip
    sheets["ResultInternalForce1D"] = [
        ["Result on", "Member", "Result for", "Load case", "Section at [m]", "Index", "N [kN]", "Vy [kN]", "Vz [kN]",
         "Mx [kNm]", "My [kNm]", "Mz [kNm]"],
        ["On beam", "C", "Load case", "Q", 0 if upwards else 3, 1, *results],
    ]  # fmt: skip
    return sheets


# Tension on the side of -z (M_y = 7 kNm) and of -y (M_z = 11 kNm) presses the slab on the side of z and of y. V_y = 3
# and V_z = 5 kN act on a foot where x begins along y and z, and so on the slab the other way; where x ends, along them.
@pytest.mark.parametrize(
    ("upwards", "rotation", "moments", "horizontal"),
    [
        (True, 0, (-7, 11), (5, -3)),  # x up, y along y: z = x cross y along -x
        (True, 90, (-11, -7), (3, 5)),  # y turned to where z was, along -x; z along -y
        (False, 0, (7, 11), (5, 3)),  # x down, y along y: z along x
    ],
)
def test_moments_at_the_foot_of_a_column(
    upwards: bool, rotation: float, moments: tuple[float, float], horizontal: tuple[float, float], tmp_path: Path
) -> None:
    """By statics of fibers, whichever end is the foot and however the column is turned."""
    case = read(tmp_path, column(upwards, rotation, -100, 3, 5, 0, 7, 11))
    (load,) = case.model.loads
    assert isinstance(load, gs.PointLoad)
    assert (load.P, load.M_x, load.M_y) == pytest.approx((100e3, *(1e3 * each for each in moments)))
    assert (case_of(case.model).H_x, case_of(case.model).H_y) == pytest.approx(tuple(1e3 * each for each in horizontal))


@pytest.mark.parametrize(
    ("N", "group", "told"), [(100, "Seismic", True), (-100, "Seismic", False), (100, "Variable", False)]
)
def test_forces_of_response_spectra_have_no_signs(N: float, group: str, told: bool, tmp_path: Path) -> None:
    """A seismic case that pulls all columns, as unsigned values do, is noted; one that presses them is not."""
    sheets = column(True, 0, N, 0, 0, 0, 0, 0)
    sheets["StructuralLoadGroup"][1][1] = group
    assert ("Q is seismic and presses no column" in notes(read(tmp_path, sheets))) == told


def test_a_column_that_is_pushed_at_its_top(tmp_path: Path) -> None:
    """A column that is pushed along x at its top presses the side of larger x down, and pushes the slab along x.

    10 kN, 3 m up, where z is along -x: the foot is held by 10 kN along z, V_z = 10 as at the start of the beam in the
    documentation. Tension is on the side of smaller x, that of z: M_y = -30, and dM_y / dx = V_z as there.
    """
    case = read(tmp_path, column(True, 0, -50, 0, 10, 0, -30, 0))
    (load,) = case.model.loads
    assert isinstance(load, gs.PointLoad)
    assert (load.P, load.M_x, load.M_y) == pytest.approx((50e3, 30e3, 0))
    assert (case_of(case.model).H_x, case_of(case.model).H_y) == pytest.approx((10e3, 0))


def parts_of_a_support(*parts: tuple[float, float, float]) -> saf_files.Sheets:
    """Return the slab with a support in parts of its first edge: start and end over the edge's 6 m, MN/m per meter."""
    sheets = slab()
    sheets["StructuralSurfaceAction"] = [
        ["Name", "2D Member", "Load case", "Value [kN/m2]", "Direction", "Coordinate system", "Location"],
        ["p", "S", "Q", -3, "Z", "Global", "Length"],
    ]
    sheets["StructuralEdgeConnection"] = [
        ["Name", "Boundary condition", "2D Member", "Edge", "ux", "uy", "uz", "fix", "fiy", "fiz",
         "Stiffness Z [MN/m2]", "Coordinate definition", "Origin", "Start point [m]", "End point [m]"],
        *(["L", "On edge", "S", 1, *["Free"] * 2, "Flexible", *["Free"] * 3, k, "Relative", "From start", *ends]
          for *ends, k in parts),
    ]  # fmt: skip
    return sheets


def test_rows_of_one_line_support_are_one(tmp_path: Path) -> None:
    """In whatever order they stand; what lies between two that adjoin is no point of it."""
    case = read(tmp_path, parts_of_a_support((0.5, 0.75, 5), (0, 0.5, 5), (0.75, 1, 5)))
    (support,) = case.model.supports
    assert isinstance(support, gs.LineSupport)
    assert sorted(support.points) == [(0, 0), (6, 0)]
    assert support.stiffness == pytest.approx(5e6)


@pytest.mark.parametrize(
    "second", [(0.5, 1, 7), (0.6, 1, 5), (0.4, 1, 5), (0, 0.5, 5)], ids=["stiffer", "apart", "overlapping", "the same"]
)
def test_rows_of_one_line_support_that_do_not_fit_are_refused(
    second: tuple[float, float, float], tmp_path: Path
) -> None:
    """With the row in which they stand."""
    with pytest.raises(gs.InputError, match=r'StructuralEdgeConnection, row 3 .*support "L" again'):
        read(tmp_path, parts_of_a_support((0, 0.5, 5), second))
