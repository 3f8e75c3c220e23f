"""Files in the Structural Analysis Format: which slab is read, as what, in which units, with which report."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

import groundslab as gs
from groundslab.case import casefile
from groundslab.model.loads.acting import PointForce
from helpers import saf_files

pytest.importorskip("openpyxl")


@pytest.fixture
def sheets() -> saf_files.Sheets:
    """Return the sheets of the house, to be changed."""
    return saf_files.house()


def read(tmp_path: Path, sheets: saf_files.Sheets, slab: str = "") -> gs.SafCase:
    """Return what is read from sheets."""
    return gs.read_saf(saf_files.write(tmp_path / "house.xlsx", sheets), slab)


def said(case: gs.SafCase, name: str) -> list[str]:
    """Return what the report says of an object."""
    return [line.why for line in case.report if line.name == name]


def cell(sheets: saf_files.Sheets, sheet: str, name: str, heading: str, value: Any) -> None:
    """Set the cell of an object below a heading."""
    head, *rows = sheets[sheet]
    next(row for row in rows if row[0] == name)[head.index(heading)] = value


def test_a_house_gives_its_slab(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """Of eleven members, seven openings, four regions and one rib, those of the slab on ground are there, as drawn."""
    case = read(tmp_path, sheets)
    model = case.model
    assert case.slab == "S6"
    plate = model.plate
    assert (plate.bounds, plate.thickness, plate.E, plate.nu) == ((0, 5, 0, 12), 0.25, 30e9, 0.2)
    assert [shape.ring().area for shape in plate.openings] == pytest.approx([1.0, math.pi / 4])
    assert [(zone.thickness, zone.E is None) for zone in plate.zones] == [(0.4, True), (0.4, True), (None, False)]
    # EN 1992-1-1 Table 3.1: E_cm of C30/37 is 33 GPa
    assert pytest.approx(33e9, rel=0.01) == plate.zones[2].E
    assert [(c.name, c.width_x, c.width_y, c.diameter) for c in model.columns] == [
        ("B1", 0.4, 0.25, None),
        ("B2", None, None, 0.35),
    ]
    assert [(wall.name, wall.thickness, wall.height) for wall in model.walls] == [
        ("S1", 0.2, None),
        ("S2", 0.24, None),
        ("S3", 0.2, None),
        ("S4", 0.2, None),
    ]
    (beam,) = model.beams
    assert beam.section == type(beam.section)(width=0.25, height=0.4, effective_width=0.9)
    gs.check(model)
    assert casefile.loads(case.text) == model


def test_ground_is_that_of_c1_and_c2(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """C1z is k0, the mean of C2x and C2y is k1 with a note; a region is a zone of soil of the same kind."""
    case = read(tmp_path, sheets)
    assert case.model.ground == gs.Pasternak(k0=160e6, k1=122.5e6)
    (zone,) = case.model.soil_zones
    assert (zone.ground, zone.shape.ring().bounds) == (gs.Pasternak(k0=80e6, k1=65e6), (0, 5, 11, 12))
    assert any("mean, 122.5 MN/m" in why for why in said(case, "SS1"))


def test_without_shear_ground_is_springs(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """Where no C2 is above 0 it is Winkler's."""
    head, *rows = sheets["StructuralSurfaceConnection"]
    sheets["StructuralSurfaceConnection"] = [head, *([*row[:-2], 0, 0] for row in rows)]
    assert read(tmp_path, sheets).model.ground == gs.Winkler(k=160e6)


def test_cases_and_combinations(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """Groups give kind and category; factor times multiplier; one by a standard is combined by its rules."""
    model = read(tmp_path, sheets).model
    assert [(case.name, case.action, case.category, case.group) for case in model.cases] == [
        ("LC1", "permanent", None, ""),
        ("LC2", "permanent", None, ""),
        ("LC3", "variable", "B", "LG2"),
    ]
    (combination,) = model.combinations
    assert (combination.name, combination.limit_state) == ("CO1", "ultimate")
    assert dict(combination.factors) == {"LC1": 1.35, "LC3": pytest.approx(1.05)}
    assert model.combine is not None
    assert model.combine.sets == ("quasi-permanent",)


def test_loads_press_downwards_where_they_act(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """Forces along -z press down; the weight is mass times g; lines keep their parts, origins and values."""
    loads = {load.name: load for load in read(tmp_path, sheets).model.loads}
    assert loads[""] == gs.SelfWeight(case="LC1", unit_weight=2500 * 9.80665, beams=True)
    assert loads["LF1"].replace(name="") == gs.LineLoad(case="LC2", q=10e3, q_end=20e3, points=((3.5, 8), (1.5, 8)))
    assert loads["LF2"].replace(name="") == gs.LineLoad(case="LC2", q=15e3, wall="S1")
    assert loads["LF3"].replace(name="") == gs.LineLoad(case="LC2", q=1e3, points=((2, 2), (1, 2)))
    # from (2, 3) by (3, 4) to (2, 5) is half a circle to the right of its chord: counterclockwise
    assert loads["LFF1"].replace(name="") == gs.LineLoad(case="LC2", q=2e3, points=((2, 3), (2, 5)), bulges=(1.0,))
    assert loads["LM1"].replace(name="") == gs.LineMoment(case="LC2", m=-3e3, points=((0.5, 8), (4.5, 8)))
    assert loads["SF1"].replace(name="") == gs.UniformLoad(case="LC2", q=2.5e3)
    slope = loads["SFF1"]
    assert (slope.q, slope.slope, slope.about) == (3e3, (pytest.approx(1e3), 0.0), (0.0, 9.0))
    assert loads["LT1"].replace(name="") == gs.TemperatureLoad(case="LC3", difference=-20)
    assert loads["FF1"].replace(name="") == gs.PointLoad(case="LC2", P=8e3, x=4.5, y=11.5)


def test_moments_turn_by_the_right_hand(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """A downward force F at (a, b) off a node has M_x = -b F and M_y = a F: here a F = 7, b F = -5 kN m."""
    model = read(tmp_path, sheets).model
    (load,) = (load for load in model.loads if load.name == "F1")
    (acting,) = model.shapes(load)
    assert isinstance(acting, PointForce)
    assert acting.M == (7e3, -5e3)
    assert load.column == "B1"


def test_horizontal_forces_are_those_of_their_case(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """A vector has three parts; those in the slab's plane are added up."""
    model = read(tmp_path, sheets).model
    assert [(case.H_x, case.H_y) for case in model.cases] == [(0, 0), (0, 0), (10e3, -20e3)]


def test_supports(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """One-sided springs at nodes, and a part of an edge, counted from its end, that keeps the slab from turning."""
    point, line = read(tmp_path, sheets).model.supports
    assert point == gs.PointSupport(name="Sn1", x=1, y=4, stiffness=100e6, acts="in compression")
    assert line == gs.LineSupport(name="Sle1", points=((5, 11), (5, 8)), rotation="fixed")


def test_everything_is_reported(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """Each row of a sheet that is read was taken or left with a reason."""
    case = read(tmp_path, sheets)
    seen = {(line.kind, line.name) for line in case.report if line.taken is not None}
    plain = {
        "Project",
        "Model",
        "StructuralMaterial",
        "StructuralCrossSection",
        "StructuralPointConnection",
        "StructuralStorey",
    }
    rows = {(sheet, str(row[0])) for sheet, lines in sheets.items() if sheet not in plain for row in lines[1:]}
    assert rows == seen
    assert "a sheet that is not read" in case.report_text()
    assert "without what its 7 columns and walls bear" in case.report_text()


def test_results_give_the_loads_of_columns_and_walls(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """N at the feet, of a member that ends there at its length; n across the foot of a wall; by load case only."""
    sheets["ResultInternalForce1D"] = [
        ["Result on", "Member", "Result for", "Load case", "Load combination", "Section at [m]", "Index", "N [kN]",
         "Vy [kN]", "Vz [kN]", "Mx [kNm]", "My [kNm]", "Mz [kNm]"],
        ["On beam", "B1", "Load case", "LC2", None, 0, 1, -400, 0, 0, 0, 12, 0],
        ["On beam", "B1", "Load case", "LC2", None, 3.6, 2, -380, 0, 0, 0, 0, 0],
        ["On beam", "B2", "Load case", "LC3", None, 0, 1, -90, 0, 0, 0, 0, 0],
        ["On beam", "B2", "Load case", "LC3", None, 3.6, 2, -100, 0, 0, 0, 0, 0],
        ["On beam", "B3", "Load case", "LC3", None, 0, 1, -70, 0, 0, 0, 0, 0],
        ["On beam", "B1", "Load combination", None, "CO1", 0, 1, -999, 0, 0, 0, 0, 0],
    ]  # fmt: skip
    sheets["ResultInternalForce2DEdge"] = [
        ["Result on", "2D member", "Edge", "Result for", "Load case", "Section at [m]", "Index", "nx [kN/m]",
         "ny [kN/m]", "nxy [kN/m]"],
        ["On edge", "S1", 1, "Load case", "LC2", 0, 1, 5, -30, 0],
        ["On edge", "S1", 1, "Load case", "LC2", 5, 2, 5, -50, 0],
        ["On edge", "S1", 3, "Load case", "LC2", 5, 2, 5, -77, 0],
    ]  # fmt: skip
    case = read(tmp_path, sheets)
    points = {
        (load.case, load.column or (load.x, load.y)): load
        for load in case.model.loads
        if isinstance(load, gs.PointLoad)
    }
    assert pytest.approx(100e3 + 400e3) == points["LC2", "B1"].P
    assert pytest.approx(50e3 + 100e3) == points["LC3", "B2"].P
    assert pytest.approx(70e3) == points["LC3", (4.0, 10.5)].P
    (line,) = (load for load in case.model.loads if load.name == "S1, n")
    assert line == gs.LineLoad(name="S1, n", case="LC2", q=30e3, q_end=50e3, points=((0, 0), (5, 0)))
    assert "B1 in LC2: N = -400 kN as a load with its moments and shear forces" in case.report_text()
    assert "1 rows of combinations, not read" in case.report_text()


def test_imperial_files_are_the_same_in_si(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """A spring of 1 kip/ft3 is 157.087 kN/m3, a force of 1 kip 4.4482 kN, 1 ksi 6.8948 MPa, 1 lb/ft3 16.018 kg/m3."""
    names = {"[m]": "[ft]", "[mm]": "[in]", "[MPa]": "[ksi]", "[kg/m3]": "[lb/ft3]",
             "[kN]": "[kip]", "[MN/m3]": "[kip/ft3]", "[MN/m]": "[kip/ft]",
             "[MN/m2]": "[kip/ft2]", "[kN/m]": "[kip/ft]", "[kNm]": "[kipft]",
             "[kNm/m]": "[kipft/ft]", "[kN/m2]": "[kip/ft2]", "[°C]": "[°F]"}  # fmt: skip
    for lines in sheets.values():
        for column, heading in enumerate(lines[0]):
            for metric, imperial in names.items():
                if isinstance(heading, str) and heading.endswith(metric):
                    lines[0][column] = heading.replace(metric, imperial)
    cell(sheets, "StructuralCrossSection", "CS1", "Parameters [in]", "16; 10")
    cell(sheets, "StructuralCrossSection", "CS2", "Parameters [in]", "14")
    sheets["Model"] = saf_files.model_sheet("Imperial")
    model = read(tmp_path, sheets).model
    assert model.plate.bounds == pytest.approx((0, 5 * 0.3048, 0, 12 * 0.3048))
    assert model.plate.thickness == pytest.approx(250 * 0.0254)
    assert pytest.approx(30000 * 6.894757e6, rel=1e-6) == model.plate.E
    assert isinstance(model.ground, gs.Pasternak)
    assert model.ground.k0 == pytest.approx(160 * 157.0875e3, rel=1e-6)
    assert model.ground.k1 == pytest.approx(122.5 * 14.5939e3, rel=1e-5)
    loads = {load.name: load for load in model.loads}
    assert pytest.approx(100 * 4448.2216, rel=1e-7) == loads["F1"].P
    # a pound per cubic foot weighs a pound-force: 157.0875 N/m3
    assert loads[""].unit_weight == pytest.approx(2500 * 157.0875, rel=1e-6)
    assert loads["LT1"].difference == pytest.approx(-20 / 1.8)


def test_units_of_the_other_system_are_refused(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """A heading in meters in an imperial file is an issue, not a guess."""
    sheets["Model"] = saf_files.model_sheet("Imperial")
    with pytest.raises(gs.InputError, match="as the system of units is Imperial"):
        read(tmp_path, sheets, "S6")


@pytest.mark.parametrize(
    "vertical", ["minus Z vertical", "X vertical", "minus X vertical", "Y vertical", "minus Y vertical"]
)
def test_other_vertical_axes_turn_the_same_house(tmp_path: Path, sheets: saf_files.Sheets, vertical: str) -> None:
    """Seen from above, the slab has its sides, and what pressed down in the file's own axis still presses down."""
    axis = "XYZ".index(vertical.replace("minus ", "")[0])
    sign = -1 if "minus" in vertical else 1
    sheets["Model"] = saf_files.model_sheet(vertical=vertical)
    for row in sheets["StructuralPointConnection"][1:]:
        plan, height = list(row[1:3]), row[3]
        plan.insert(axis, sign * height)
        row[1:4] = plan
    head = sheets["StructuralPointAction"][0]
    sheets["StructuralPointAction"] = [head, ["F1", "Standard", "XYZ"[axis], "In node", "N3", None,
                                       -100 * sign, None, "LC2", "Global"]]  # fmt: skip
    for sheet in ("StructuralPointActionFree", "StructuralCurveActionFree", "StructuralSurfaceActionFree",
                  "StructuralCurveAction", "StructuralPointMoment", "StructuralCurveMoment", "StructuralSurfaceAction",
                  "StructuralPointSupport", "StructuralEdgeConnection", "StructuralCurveMember"):  # fmt: skip
        del sheets[sheet]
    for row in sheets["StructuralSurfaceMember"][1:]:
        row[9:12] = [int(axis != 0), int(axis == 0), 0]
    model = read(tmp_path, sheets).model
    assert sorted(model.plate.sides) == [5, 12]
    # the local z axis of the slab is that of the file: bottom is above where it points down
    assert [getattr(beam.section, "side", "") for beam in model.beams] == ["below" if sign > 0 else "above"]
    assert len(model.walls) == 4
    (load,) = (load for load in model.loads if isinstance(load, gs.PointLoad))
    assert load.P == 100e3


def test_several_slabs_are_listed(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """Where none is on ground and two are lowest, or a name is unknown, the error lists those that there are."""
    del sheets["StructuralSurfaceConnection"]
    assert read(tmp_path, sheets).slab == "S6"
    assert read(tmp_path, sheets, "S5").slab == "S5"
    with pytest.raises(gs.InputError, match=r'no horizontal member "S1".*S5 at 3.6 m'):
        read(tmp_path, sheets, "S1")
    cell(sheets, "StructuralSurfaceMember", "S5", "Nodes", "O1; O2; O3; O4")
    with pytest.raises(gs.InputError, match=r"2 slabs to choose from.*S6 at 0 m"):
        read(tmp_path, sheets)


def test_what_a_file_lacks_is_to_be_filled_in(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """Without ground and loads the text has comments in their place, the model an error."""
    for sheet in [name for name in sheets if "Action" in name or "Moment" in name or "Combination" in name]:
        del sheets[sheet]
    del sheets["StructuralSurfaceConnection"], sheets["StructuralLoadCase"], sheets["StructuralLoadGroup"]
    case = read(tmp_path, sheets)
    assert "no ground under the slab" in case.text
    assert "no loads on the slab" in case.text
    with pytest.raises(gs.InputError, match="ground"):
        _ = case.model


@pytest.mark.parametrize(
    ("sheet", "name", "heading", "value", "message"),
    [
        ("StructuralSurfaceMember", "S6", "Material", "MAT9", "MAT9"),
        ("StructuralSurfaceMember", "S6", "Thickness [mm]", "-3", "more than 0"),
        ("StructuralSurfaceMemberOpening", "O1", "Nodes", "O1; O2; O3; O99", "O99"),
        ("StructuralSurfaceMemberOpening", "O1", "Edges", "Line; Line; Line", "4 nodes"),
        ("StructuralSurfaceMemberOpening", "O1", "Nodes", "O1; O2; O3; C2", "off the slab's plane"),
        ("StructuralSurfaceConnection", "SS1", "C1z [MN/m3]", 0, "C1z above 0"),
        ("StructuralSurfaceConnection", "SS2", "2D Member Region", "R9", "a region of S6"),
        ("StructuralPointAction", "F1", "Value [kN]", "much", '"much"'),
        ("StructuralPointAction", "F1", "Load case", "LC9", '"LC9"'),
        ("StructuralPointAction", "F2", "Vector (X;Y;Z) [kN]", "(1; 2)", "three numbers"),
        ("StructuralCurveAction", "LF3", "Edge", 9, "1 to 4"),
        ("StructuralCurveAction", "LF1", "End point [m]", 0.5, "a part of the edge"),
        ("StructuralLoadCombination", "CO1", "Load Case name 2", "LC9", '"LC9"'),
        ("StructuralPointSupport", "Sn1", "uz", "Non linear", "by hand"),
        ("StructuralSurfaceActionFree", "SFF1", "q [kN/m2]", "C1:-3; C9:-5; C4:-3", "corners C1 to C5"),
    ],
)
def test_wrong_rows_of_the_slab_are_issues(
    tmp_path: Path, sheets: saf_files.Sheets, sheet: str, name: str, heading: str, value: Any, message: str
) -> None:
    """The error names sheet, row and object, what is there and what is expected."""
    cell(sheets, sheet, name, heading, value)
    with pytest.raises(gs.InputError) as caught:
        read(tmp_path, sheets)
    (issue,) = caught.value.issues
    assert sheet in issue.location
    assert message in str(issue)


def test_turned_columns_keep_their_angle(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """By 90 degrees the sides change places; by 30 and by 120 its height is at that angle, or the opposite one."""
    cell(sheets, "StructuralCurveMember", "B1", "LCS Rotation [deg]", 90)
    first, _ = read(tmp_path, sheets).model.columns
    assert (first.width_x, first.width_y) == (0.25, 0.4)
    for turn, angle in ((30, 30), (120, -60)):
        cell(sheets, "StructuralCurveMember", "B1", "LCS Rotation [deg]", turn)
        case = read(tmp_path, sheets)
        column = case.model.columns[0]
        assert (column.width_x, column.width_y, column.angle) == pytest.approx((0.4, 0.25, angle))
        assert not any("circle" in why for why in said(case, "B1"))


def test_curves_of_all_kinds_make_outlines(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """A parabola of rise f over a chord c adds 2/3 f c, nearly so by 16 pieces; arcs and circles are exact."""
    sheets["StructuralPointConnection"] += [["Q1", 6.5, 6, 0], ["Q2", 1.5, 3, 0], ["Q3", 2, 2.5, 0], ["Q4", 2.5, 3, 0]]
    cell(sheets, "StructuralSurfaceMember", "S6", "Nodes", "N1; N2; Q1; N3; N4")
    cell(sheets, "StructuralSurfaceMember", "S6", "Edges", "Line; Parabolic Arc; Line; Line")
    case = read(tmp_path, sheets)
    assert case.model.plate.ring().area == pytest.approx(60 + 2 / 3 * 1.5 * 12, rel=1e-3)
    assert any("16 straight pieces" in why for why in said(case, "S6"))
    cell(sheets, "StructuralSurfaceMember", "S6", "Edges", "Line; Circular Arc; Line; Line")
    cell(sheets, "StructuralSurfaceMemberOpening", "O2", "Nodes", "Q2; Q3; Q4")
    cell(sheets, "StructuralSurfaceMemberOpening", "O2", "Edges", "Circle by 3 points")
    model = read(tmp_path, sheets).model
    R = (6**2 + 1.5**2) / (2 * 1.5)
    angle = 2 * math.asin(6 / R)
    assert model.plate.ring().area == pytest.approx(60 + R**2 / 2 * (angle - math.sin(angle)), rel=1e-9)
    assert model.plate.openings[1].ring().bounds == pytest.approx((1.5, 2.5, 2.5, 3.5))


def test_another_version_is_a_note(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """Version 1.0 is read as far as it has the same headings."""
    sheets["Model"][1] = ["SAF Version", "1.0.8"]
    assert "version 1.0.8, read as one of 2.0 to 2.2" in read(tmp_path, sheets).report_text()


def test_tables_side_by_side_are_read_one_after_the_other(tmp_path: Path, sheets: saf_files.Sheets) -> None:
    """A heading that comes again starts a further table in the sheet."""
    head, *rows = sheets["StructuralPointConnection"]
    half = len(rows) // 2
    beside = [
        [*row, None, *(rows[half + n] if half + n < len(rows) else [])]
        for n, row in enumerate(rows[: len(rows) - half])
    ]
    sheets["StructuralPointConnection"] = [[*head, None, *head], *beside]
    first = read(tmp_path, sheets).model
    assert first == read(tmp_path, saf_files.house()).model


def test_the_command_writes_a_case_and_reports(
    tmp_path: Path, sheets: saf_files.Sheets, capsys: pytest.CaptureFixture[str]
) -> None:
    """import-saf writes the case beside the report, and leaves an existing file alone."""
    from groundslab.cli import main

    file = saf_files.write(tmp_path / "house.xlsx", sheets)
    case = tmp_path / "slab.toml"
    assert main.main(["import-saf", str(file), "--out", str(case)]) == 0
    assert "left out:" in capsys.readouterr().err
    assert gs.load(case) == gs.read_saf(file).model
    assert main.main(["import-saf", str(file), "--slab", "S6", "--out", str(case)]) == 2
    assert "a name that is free" in capsys.readouterr().err
