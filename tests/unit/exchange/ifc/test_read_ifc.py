"""Slabs from IFC files whose geometry is known by hand."""

from __future__ import annotations

import math
import random
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.case import casefile

pytest.importorskip("ifcopenshell")

from helpers.ifc_files import SLAB, UNITS, Building, turned


def read(building: Building, tmp_path: Path, slab: str = "", **options: Any) -> tuple[dict[str, Any], gs.IfcCase]:
    """Return the tables of the case that a building gives, and the case."""
    case = gs.read_ifc(building.write(tmp_path / "house.ifc"), slab, **options)
    return tomllib.loads(case.text), case


def meters(value: Any) -> Any:
    """Return lengths of a case [m], as numbers in the lists that they are in."""
    if isinstance(value, list):
        return [meters(each) for each in value]
    number, unit = value.split()
    assert unit == "m"
    return float(number)


def corners(shape: dict[str, Any]) -> set[tuple[float, float]]:
    """Return the corners of a polygon, to a nanometer."""
    return {(round(x, 9), round(y, 9)) for x, y in meters(shape["points"])}


def reasons(case: gs.IfcCase, taken: bool | None = False) -> dict[str, str]:
    """Return why elements were left out, or what they were taken as, by name."""
    return {line.name: line.why for line in case.report if line.taken is taken}


@pytest.mark.parametrize("version", ["IFC4", "IFC2X3"])
@pytest.mark.parametrize("unit", list(UNITS))
def test_a_slab_in_any_unit(unit: str, version: str, tmp_path: Path) -> None:
    """Outline and thickness are in meters, whatever the file's unit is; modulus, ground and loads are missing."""
    building = Building(unit, version)
    building.slab()
    tables, case = read(building, tmp_path)
    assert corners(tables["plate"]["outline"]) == set(SLAB)
    assert meters(tables["plate"]["thickness"]) == pytest.approx(0.3, rel=1e-12)
    assert set(tables) == {"title", "plate"}
    assert set(tables["plate"]) == {"thickness", "outline"}
    for blank in ("# E = ", "# nu = ", "# [ground]", "# [[loads]]"):
        assert blank in case.text
    assert f"({UNITS[unit][0]:.6g} m)" in case.report_text()


def test_placements_within_placements(tmp_path: Path) -> None:
    """The slab is turned by 30 degrees on a storey that is moved and turned by 60, on a site that is moved."""
    building = Building("mm", storey=turned(60, 10, 0, 2), site=turned(0, 100, 200, 50))
    building.slab(place=turned(30, 4, 0, -0.5))
    tables, case = read(building, tmp_path)
    # the slab is turned by 90 degrees about its corner, 4 m from (110, 200) at 60 degrees
    x, y = 110 + 4 * math.cos(math.pi / 3), 200 + 4 * math.sin(math.pi / 3)
    expected = {(round(x - b, 9), round(y + a, 9)) for a, b in SLAB}
    assert corners(tables["plate"]["outline"]) == expected
    assert "top of the slab at 51.5 m" in case.report_text()


def test_the_middle_as_origin_far_away(tmp_path: Path) -> None:
    """At coordinates of a national grid the slab keeps its sides to a nanometer once its middle is the origin."""
    building = Building("mm", site=turned(0, 691_000.25, 5_334_000.5))
    building.slab()
    tables, case = read(building, tmp_path, origin="center")
    assert corners(tables["plate"]["outline"]) == {(-3, -2), (3, -2), (3, 2), (-3, 2)}
    assert case.origin == (691_003.25, 5_334_002.5)
    assert "the IFC file's point (691003.25, 5334002.5) m" in case.text


def test_a_place_on_the_map_is_noted(tmp_path: Path) -> None:
    """What IfcMapConversion says is in the report and the case; coordinates stay the building's."""
    building = Building()
    building.slab()
    system = building.file.create_entity("IfcProjectedCRS", "EPSG:25832")
    context = building.file.by_type("IfcGeometricRepresentationContext", include_subtypes=False)[0]
    building.file.create_entity("IfcMapConversion", context, system, 691e3, 5334e3, 515.0, 0.0, 1.0)
    tables, case = read(building, tmp_path)
    assert corners(tables["plate"]["outline"]) == set(SLAB)
    assert "easting 691000, northing 5334000, height 515 of EPSG:25832, its x axis 90 degrees from east" in " ".join(
        case.text.replace("\n# ", " ").split()
    )


def test_openings(tmp_path: Path) -> None:
    """One through the slab is an opening, one over its edge is cut out, a recess and one beside are left out."""
    building = Building("ft")
    slab = building.slab()
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    for name, x, y, height, below in (
        ("Shaft", 1, 1, 0.3, 0), ("Notch", 5.5, -0.5, 0.5, 0.1), ("Sump", 3, 2, 0.2, -0.1), ("Off", 8, 8, 0.3, 0),
    ):  # fmt: skip
        place = turned(0, x, y, -below)
        building.add("IfcOpeningElement", name, building.polygon(square), height, place, voids=slab)
    round_one = building.profile("IfcCircleProfileDef", Radius=0.25)
    building.add("IfcOpeningElement", "Pipe", round_one, 0.3, turned(0, 4, 3), voids=slab)
    tables, case = read(building, tmp_path)
    assert corners(tables["plate"]["outline"]) == {(0, 0), (5.5, 0), (5.5, 0.5), (6, 0.5), (6, 4), (0, 4)}
    polygon, pipe = sorted(tables["plate"]["openings"], key=lambda opening: opening["kind"], reverse=True)
    assert corners(polygon) == {(1, 1), (2, 1), (2, 2), (1, 2)}
    assert (meters(pipe["centre"]), meters(pipe["radius"])) == (pytest.approx([4, 3]), pytest.approx(0.25))
    assert "recess" in reasons(case)["Sump"]
    assert "beside" in reasons(case)["Off"]
    assert "cut out of the edge" in reasons(case, taken=True)["Notch"]


def test_a_hole_in_the_profile_is_an_opening(tmp_path: Path) -> None:
    """A slab whose own profile has a hole has an opening there."""
    building = Building()
    profile = building.polygon(SLAB, [[(2, 1), (2, 2), (3, 2), (3, 1)]])
    building.add("IfcSlab", "Raft", profile, 0.25)
    tables, _ = read(building, tmp_path)
    (opening,) = tables["plate"]["openings"]
    assert corners(opening) == {(2, 1), (2, 2), (3, 2), (3, 1)}


def test_columns(tmp_path: Path) -> None:
    """Rectangles and circles keep their sizes, an I profile has the rectangle around it, a turned one equal area."""
    building = Building("mm")
    building.slab()
    rectangle = building.profile("IfcRectangleProfileDef", XDim=0.4, YDim=0.3)
    i_profile = building.profile(
        "IfcIShapeProfileDef", OverallWidth=0.2, OverallDepth=0.3, WebThickness=0.01, FlangeThickness=0.02
    )
    tube = building.profile("IfcCircleHollowProfileDef", Radius=0.15, WallThickness=0.01)
    for name, profile, place in (
        ("K1", rectangle, turned(0, 1, 1)),
        ("K2", building.profile("IfcCircleProfileDef", Radius=0.2), turned(0, 2, 1)),
        ("K3", i_profile, turned(90, 3, 1)),
        ("K4", rectangle, turned(30, 4, 1)),
        ("K5", tube, turned(0, 5, 1)),
        ("K1", rectangle, turned(90, 5, 3, 0.04)),  # of the same name, on a layer of mortar
    ):
        building.add("IfcColumn", name, profile, 3, place)
    tables, case = read(building, tmp_path)
    found = {column["name"]: {key: value if key == "angle" else meters(value)
                              for key, value in column.items() if key != "name"}
             for column in tables["columns"]}  # fmt: skip
    assert found == {
        "K1": {"x": 1, "y": 1, "width_x": 0.4, "width_y": 0.3},
        "K2": pytest.approx({"x": 2, "y": 1, "diameter": 0.4}),
        "K3": {"x": 3, "y": 1, "width_x": 0.3, "width_y": 0.2},
        "K4": pytest.approx({"x": 4, "y": 1, "width_x": 0.4, "width_y": 0.3, "angle": 30}),
        "K5": pytest.approx({"x": 5, "y": 1, "diameter": 0.3}),
        "K1 (2)": {"x": 5, "y": 3, "width_x": 0.3, "width_y": 0.4},
    }
    assert "the shape around it" in reasons(case, taken=True)["K3"]
    assert "K4" not in reasons(case, taken=None)


def test_a_building_that_is_turned_is_turned_back(tmp_path: Path) -> None:
    """With `align` the columns of a building at 30 degrees are rectangles again."""
    building = Building("mm", site=turned(30, 100, 200))
    building.slab()
    rectangle = building.profile("IfcRectangleProfileDef", XDim=0.4, YDim=0.3)
    building.add("IfcColumn", "K1", rectangle, 3, turned(0, 4, 1))
    tables, case = read(building, tmp_path, origin="center", align=True)
    assert corners(tables["plate"]["outline"]) == {(-3, -2), (3, -2), (3, 2), (-3, 2)}
    (column,) = tables["columns"]
    assert [meters(column[key]) for key in ("x", "y", "width_x", "width_y")] == [1, -1, 0.4, 0.3]
    assert "turned by 30 degrees" in case.text
    assert not reasons(case, taken=None)


def test_columns_that_do_not_stand_on_the_slab(tmp_path: Path) -> None:
    """Columns below it, on the next storey, beside it, over an opening and through it are left out, with the reason."""
    building = Building()
    slab = building.slab()
    building.add("IfcOpeningElement", "Shaft", building.polygon([(1, 1), (2, 1), (2, 2), (1, 2)]), 0.3, voids=slab)
    square = building.profile("IfcRectangleProfileDef", XDim=0.3, YDim=0.3)
    for name, height, place in (
        ("below", 3, turned(0, 3, 3, -3.3)), ("above", 3, turned(0, 3, 3, 3)), ("beside", 3, turned(0, 7, 3)),
        ("over", 3, turned(0, 1.5, 1.5)), ("through", 6, turned(0, 3, 3, -3)),
    ):  # fmt: skip
        building.add("IfcColumn", name, square, height, place)
    tables, case = read(building, tmp_path)
    assert "columns" not in tables
    why = reasons(case)
    words = {"below": "below", "above": "above", "beside": "beside", "over": "opening", "through": "through"}
    assert all(word in why[name] for name, word in words.items())


def test_walls(tmp_path: Path) -> None:
    """A wall has the middle of its foot for its axis, and its width; one that leaves the slab is cut at its edge."""
    building = Building("mm")
    building.slab()
    foot = building.polygon([(0, 0), (3, 0), (3, 0.25), (0, 0.25)])
    building.add("IfcWall", "Edge", foot, 2.8, turned(90, 0.25, 0.5))
    building.add("IfcWall", "Out", foot, 2.8, turned(0, 4, 2))
    building.add("IfcWall", "Slanting", foot, 2.8, turned(30, 1, 1))
    building.add("IfcWall", "Corner", building.polygon([(0, 0), (2, 0), (2, 0.2), (0.2, 0.2), (0.2, 2), (0, 2)]), 2.8)
    building.add("IfcWall", "Off", foot, 2.8, turned(0, 0, 5))
    tables, case = read(building, tmp_path)
    axes = {wall["name"]: np.array(meters(wall["points"])) for wall in tables["walls"]}
    assert {wall["name"]: meters(wall["thickness"]) for wall in tables["walls"]} == pytest.approx(
        {"Edge": 0.25, "Out": 0.25, "Slanting": 0.25}
    )
    np.testing.assert_allclose(axes["Edge"], [[0.125, 0.5], [0.125, 3.5]], atol=1e-9)
    np.testing.assert_allclose(axes["Out"], [[4, 2.125], [6, 2.125]], atol=2e-6)
    start = np.array([1 - 0.125 * 0.5, 1 + 0.125 * math.sqrt(0.75)])
    np.testing.assert_allclose(axes["Slanting"], [start, start + 3 * np.array([math.sqrt(0.75), 0.5])], atol=1e-8)
    assert "straight strip" in reasons(case)["Corner"]
    assert "beside" in reasons(case)["Off"]
    assert "as far as" in reasons(case, taken=True)["Out"]


#: Boxes of a wall of 4 m with a door of 1 m by 2.1 m, 1 m from its start, and one of a slab of 6 m by 4 m.
DOOR = [(0, 1, 0, 0.2, 0, 2.1), (2, 4, 0, 0.2, 0, 2.1), (0, 1, 0, 0.2, 2.1, 2.8), (1, 2, 0, 0.2, 2.1, 2.8),
        (2, 4, 0, 0.2, 2.1, 2.8)]  # fmt: skip
RAFT = [(0, 6, 0, 4, -0.3, 0)]


@pytest.mark.parametrize(
    ("version", "kind"),
    [("IFC4", ""), ("IFC2X3", ""), ("IFC4", "IfcTriangulatedFaceSet"), ("IFC4", "IfcPolygonalFaceSet"),
     ("IFC4", "IfcFacetedBrep"), ("IFC2X3", "IfcFacetedBrep")],
)  # fmt: skip
def test_a_wall_with_a_door_in_its_body(version: str, kind: str, tmp_path: Path) -> None:
    """Its foot is in two pieces: from 0 to 1 m and from 2 to 4 m, 1 m up the page; extruded across, and of faces."""
    building = Building("mm", version)
    slab = building.slab()
    front = building.polygon([(0, 0), (1, 0), (1, 2.1), (2, 2.1), (2, 0), (4, 0), (4, 2.8), (0, 2.8)])
    # the profile stands upright, its x along x and its y up, and is extruded against y
    upright = np.array([[1, 0, 0, 1], [0, 0, -1, 1.2], [0, 1, 0, 0], [0, 0, 0, 1.0]])
    wall = building.add("IfcWall", "W", front, 0.2, upright)
    if kind:
        building.tessellate(slab, RAFT, kind)
        building.place(slab, np.eye(4), building.storey)
        building.tessellate(wall, DOOR, kind)
        building.place(wall, turned(0, 1, 1), building.storey)
    tables, case = read(building, tmp_path)
    assert corners(tables["plate"]["outline"]) == set(SLAB)
    assert meters(tables["plate"]["thickness"]) == pytest.approx(0.3)
    axes = sorted((meters(wall["points"]), meters(wall["thickness"]), wall["name"]) for wall in tables["walls"])
    assert axes == [
        ([[1, 1.1], [2, 1.1]], pytest.approx(0.2), axes[0][2]), ([[3, 1.1], [5, 1.1]], pytest.approx(0.2), axes[1][2])
    ]  # fmt: skip
    assert {name for *_, name in axes} == {"W", "W (2)"}
    assert "in 2 pieces as between doors" in reasons(case, taken=True)["W"]


def test_thicknesses_that_contradict_the_body_are_noted(tmp_path: Path) -> None:
    """Layers of 250 mm and a depth of 280 mm of a slab whose body has 300 mm; a wall that agrees has no note."""
    from ifcopenshell.api import material, pset

    building = Building("mm")
    slab = building.slab()
    wall = building.add("IfcWall", "W", building.polygon([(1, 1), (4, 1), (4, 1.2), (1, 1.2)]), 2.8)
    for element, thickness in ((slab, 250.0), (wall, 200.0)):
        layers = material.add_material_set(building.file, name="L", set_type="IfcMaterialLayerSet")
        layer = material.add_layer(building.file, layer_set=layers, material=material.add_material(building.file))
        layer.LayerThickness = thickness
        material.assign_material(building.file, products=[element], type="IfcMaterialLayerSet", material=layers)
    quantities = pset.add_qto(building.file, product=slab, name="Qto_SlabBaseQuantities")
    pset.edit_qto(building.file, qto=quantities, properties={"Depth": 280.0})
    _, case = read(building, tmp_path)
    said = [(line.name, line.why) for line in case.report if line.taken is None]
    assert said == [
        ("Raft", "its body is 0.3 m thick, its material layers are 0.25 m: the body counts"),
        ("Raft", "its body is 0.3 m thick, its quantity Depth is 0.28 m: the body counts"),
    ]


@pytest.mark.parametrize("seed", range(12))
def test_units_and_names_spelled_in_other_ways(seed: int, tmp_path: Path) -> None:
    """Any unit and version, capitals and spaces in the slab's name: always 6 m by 4 m."""
    chance = random.Random(seed)
    building = Building(chance.choice(list(UNITS)), chance.choice(["IFC4", "IFC2X3"]))
    building.slab("Raft of house 7")
    building.slab("Roof", place=turned(0, 0, 0, 3))
    wanted = chance.choice(["raft of house 7", "RAFT OF HOUSE 7", "Raft  of house 7 ", "raftofhouse7"])
    path = building.write(tmp_path / "house.ifc")
    text = path.read_text()
    schema = f"FILE_SCHEMA(('{building.file.schema}'))"
    assert schema in text
    path.write_text(text.replace(schema, chance.choice([schema, schema.replace("((", "( ( ").replace("))", " ) )")])))
    case = gs.read_ifc(path, wanted)
    assert corners(tomllib.loads(case.text)["plate"]["outline"]) == set(SLAB)


def test_arcs_become_chords_within_a_millimeter(tmp_path: Path) -> None:
    """A round slab of 5 m is a circle; half of it has its corners on the arc, and chords at most 1 mm off it."""
    building = Building()
    file = building.file
    building.add("IfcSlab", "Round", building.profile("IfcCircleProfileDef", Radius=5), 0.3)
    places = file.create_entity("IfcCartesianPointList2D", ((5.0, 0.0), (0.0, 5.0), (-5.0, 0.0)))
    parts = [file.create_entity("IfcArcIndex", (1, 2, 3)), file.create_entity("IfcLineIndex", (3, 1))]
    half = file.create_entity("IfcIndexedPolyCurve", places, parts)
    building.add("IfcSlab", "Half", file.create_entity("IfcArbitraryClosedProfileDef", "AREA", None, half), 0.3)
    outline = read(building, tmp_path, "Round")[0]["plate"]["outline"]
    assert (outline["kind"], meters(outline["radius"])) == ("circle", pytest.approx(5, abs=1e-7))
    outline = read(building, tmp_path, "Half")[0]["plate"]["outline"]
    points = np.array(meters(outline["points"]))
    np.testing.assert_allclose(np.hypot(*points.T), 5, atol=1e-6)
    chords = np.hypot(*(np.roll(points, -1, axis=0) - points).T)
    chords = np.sort(chords)[:-1]  # the longest is the diameter
    assert len(chords) > 10
    assert (5 - np.sqrt(25 - chords**2 / 4)).max() < 1.001e-3


def test_several_slabs_are_listed(tmp_path: Path) -> None:
    """Without a choice each slab is listed with storey, area and height; its GlobalId tells one of two alike."""
    building = Building()
    building.slab()
    upper = building.slab(points=[(0, 0), (2, 0), (2, 2), (0, 2)], place=turned(0, 0, 0, 3))
    with pytest.raises(gs.InputError) as error:
        read(building, tmp_path)
    text = str(error.value)
    for words in ("2 slabs", upper.GlobalId, 'storey "Ground floor"', "24 m2, top at 0 m", "4 m2, top at 3 m"):
        assert words in text
    with pytest.raises(gs.InputError, match="2 slabs"):
        read(building, tmp_path, "Raft")
    tables, _ = read(building, tmp_path, upper.GlobalId)
    assert corners(tables["plate"]["outline"]) == {(0, 0), (2, 0), (2, 2), (0, 2)}
    with pytest.raises(gs.InputError, match='no slab "Rafts"'):
        read(building, tmp_path, "Rafts")


def test_slabs_that_are_not_level_are_refused(tmp_path: Path) -> None:
    """A slab tilted by 5 degrees is refused with its tilt."""
    building = Building()
    c, s = math.cos(math.radians(5)), math.sin(math.radians(5))
    tilted = np.array([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0], [0, 0, 0, 1.0]])
    building.slab(place=tilted)
    with pytest.raises(gs.InputError, match=r"tilted by 5 degrees"):
        read(building, tmp_path)


def test_a_body_of_two_thicknesses_has_none(tmp_path: Path) -> None:
    """A slab with a thickening below has its outline, and its thickness is to be filled in."""
    building = Building()
    slab = building.slab()
    (shape,) = slab.Representation.Representations
    up = building.file.create_entity("IfcDirection", (0.0, 0.0, 1.0))
    block = building.file.create_entity(
        "IfcExtrudedAreaSolid", building.polygon([(2, 1), (4, 1), (4, 3), (2, 3)]),
        building.file.create_entity(
            "IfcAxis2Placement3D", building.file.create_entity("IfcCartesianPoint", (0.0, 0.0, -0.2))), up, 0.2,
    )  # fmt: skip
    shape.Items = (*shape.Items, block)
    tables, case = read(building, tmp_path)
    assert corners(tables["plate"]["outline"]) == set(SLAB)
    assert "thickness" not in tables["plate"]
    assert '# thickness = "250 mm"' in case.text
    assert "no plate of one thickness" in reasons(case, taken=None)["Raft"]


def test_a_case_that_is_filled_in_is_a_model(tmp_path: Path) -> None:
    """With modulus, ground and a load the text is a model."""
    building = Building("mm")
    building.slab()
    building.add("IfcColumn", "K1", building.profile("IfcCircleProfileDef", Radius=0.2), 3, turned(0, 3, 2))
    _, case = read(building, tmp_path)
    text = case.text.replace("# E = ", "E = ", 1).replace("# nu = 0.2 ", "nu = 0.2 ", 1)
    text += '[ground]\nkind = "winkler"\nk = "20 MPa/m"\n[[loads]]\nkind = "point"\nP = "500 kN"\ncolumn = "K1"\n'
    model = casefile.loads(text)
    assert model.plate.thickness == 0.3
    assert [column.diameter for column in model.columns] == pytest.approx([0.4])


#: A file without anything, of some schema.
BARE = (
    b"ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
    b"FILE_SCHEMA(('%b'));\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n"
)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "not IFC, or damaged"),
        (b"PK\x03\x04", "compressed"),
        (BARE % b"IFC2X2_FINAL", "IFC 2x3 or IFC 4"),
        (BARE % b"IFC2X3", "unit"),
        (BARE % b"IFC4", "unit"),
    ],
)
def test_other_files_are_refused(content: bytes, words: str, tmp_path: Path) -> None:
    """An empty one, an archive, an older version, and one without anything."""
    path = tmp_path / "house.ifc"
    path.write_bytes(content)
    with pytest.raises(gs.InputError, match=words):
        gs.read_ifc(path)


def test_a_building_without_units_or_slabs_is_refused(tmp_path: Path) -> None:
    """What has no unit of length is not guessed at."""
    building = Building("none")
    building.slab()
    with pytest.raises(gs.InputError, match="LENGTHUNIT"):
        read(building, tmp_path)
    with pytest.raises(gs.InputError, match="no slab"):
        read(Building(), tmp_path)
    with pytest.raises(gs.InputError, match="no file of that name"):
        gs.read_ifc(tmp_path / "none.ifc")
