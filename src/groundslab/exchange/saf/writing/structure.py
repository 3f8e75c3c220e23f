"""The slab and what stands on it as rows: members, openings, regions, ribs, columns, walls, supports, ground."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundslab.exchange.saf.units import GRAVITY, from_si
from groundslab.exchange.saf.writing.sheets import Sheets
from groundslab.geometry.plan import FLAT, Place, Ring, Segment
from groundslab.model.ground import AnyGround, Pasternak, Winkler
from groundslab.model.loads.load_types import SelfWeight
from groundslab.model.plate import Plate
from groundslab.model.plates.other_plates import AnyPlate
from groundslab.model.shapes import AnyShape, Circle
from groundslab.model.structure.beams import Beam, GivenSection, RectangularSection
from groundslab.model.structure.walls import Wall
from groundslab.model.supports import LineSupport, PointSupport

if TYPE_CHECKING:
    from groundslab.model.model import Model

#: Columns are this high, as is a wall without a height [m]: models of a slab do not say.
HEIGHT = 3.0
#: Shares of a soil zone outside of the plate that are rounding.
NO_PART = 1e-9

#: Keys of beams that ribs have, too.
_OF_RIBS = ("name", "points", "at", "bulges", "shape", "section", "E", "nu")
_WAYS = {"both ways": ("Rigid", "Flexible"), "in compression": ("Compression only", "Flexible compression only"),
         "in tension": ("Tension only", "Flexible tension only")}  # fmt: skip


def plate_names(plates: Sequence[AnyPlate]) -> list[str]:
    """Return the names under which plates are written."""
    return [plate.name or f"S{number}" for number, plate in enumerate(plates, start=1)]


def plate_at(plates: Mapping[str, Ring], place: Place) -> str:
    """Return the name of the plate on which a place lies, the first one where it lies on none."""
    from shapely import Point

    from groundslab.geometry.areas import equal_area_polygon

    first, *others = plates
    on = (name for name in others if equal_area_polygon(plates[name]).intersects(Point(place)))
    return next(on, first)


def middle(edge: Segment) -> tuple[float, float]:
    """Return the middle of an edge, freed of what rounding has left."""
    x, y = edge.middle
    return float(f"{x:.14g}"), float(f"{y:.14g}")


def _curve(sheets: Sheets, edges: Sequence[Segment], closed: bool) -> dict[str, str]:
    """Return nodes and edges of a curve; a node for its end where it is open."""
    nodes, kinds = list[str](), list[str]()
    for edge in edges:
        nodes.append(sheets.node(edge.start))
        if not edge.straight:
            nodes.append(sheets.node(middle(edge)))
        kinds.append("Line" if edge.straight else "Circular Arc")
    if not closed:
        nodes.append(sheets.node(edges[-1].end))
    return {"nodes": "; ".join(nodes), "edges" if closed else "segments": "; ".join(kinds)}


def _closed(sheets: Sheets, shape: AnyShape | None, ring: Ring) -> dict[str, str]:
    """Return nodes and edges of a closed curve."""
    if isinstance(shape, Circle):
        x, y = shape.centre
        nodes = f"{sheets.node((x, y))}; {sheets.node((x + shape.radius, y))}"
        return {"nodes": nodes, "edges": "Circle and Point"}
    return _curve(sheets, ring.segments(), closed=True)


def write_materials(sheets: Sheets, model: Model) -> dict[tuple[float, float], str]:
    """Write the materials of plates, zones and beams; return their names by E and nu."""
    first = model.plate
    pairs = [(plate.E, plate.nu) for plate in model.every_plate]
    pairs += [
        (zone.E or plate.E, plate.nu if zone.nu is None else zone.nu)
        for plate in model.every_plate
        for zone in plate.zones
    ]
    pairs += [(beam.E or first.E, first.nu if beam.nu is None else beam.nu) for beam in model.beams]
    weights = [load.unit_weight for load in model.loads if isinstance(load, SelfWeight) and not load.plate]
    quality = getattr(model.reinforcement, "concrete", None) or ""
    names: dict[tuple[float, float], str] = {}
    for E, nu in dict.fromkeys(pairs):
        grade = quality if (E, nu) == (first.E, first.nu) else ""
        names[E, nu] = sheets.add(
            "StructuralMaterial", "", "MAT", type="Concrete", quality=grade or f"E = {E / 1e9:.6g} GPa",
            unitmass=float(f"{weights[0] / GRAVITY:.14g}") if weights else None,
            emodulus=from_si(E, "modulus"), gmodulus=from_si(E / (2 * (1 + nu)), "modulus"), poissoncoefficient=nu,
            thermalexpansion=first.thermal_expansion,
        )  # fmt: skip
    return names


def write_plate(sheets: Sheets, plate: AnyPlate, name: str, materials: Mapping[tuple[float, float], str]) -> None:
    """Write a plate with its openings and zones."""
    sheets.add(
        "StructuralSurfaceMember", name, "S", type="Plate", material=materials[plate.E, plate.nu],
        thicknesstype="Constant", thickness=_size_text(plate.thickness), systemplaneat="Centre",
        **_closed(sheets, plate.outline, plate.ring()), **_axes("x by vector", (1, 0, 0)), shape="Flat",
        behaviorinanalysis="Isotropic", internalnodes="",
    )  # fmt: skip
    for opening in plate.openings:
        curve = _closed(sheets, opening, opening.ring())
        sheets.add("StructuralSurfaceMemberOpening", "", "O", **{"2dmember": name}, **curve)
    for zone in plate.zones:
        material = materials[zone.E or plate.E, plate.nu if zone.nu is None else zone.nu]
        region = _write_region(sheets, name, zone.shape, material, zone.thickness or plate.thickness)
        if zone.level is not None:
            sheets.leave(
                f"region {region}",
                "a pit without its level and walls, of which the weight is a load along lines",
            )


def _size_text(length: float) -> str:
    """Return a length as the text of a thickness [mm]."""
    return f"{from_si(length, 'size'):.14g}"


def _axes(kind: str, vector: tuple[float, float, float]) -> dict[str, object]:
    x, y, z = vector
    return {"lcstype": kind, "coordinatex": x, "coordinatey": y, "coordinatez": z, "lcsrotation": 0,
            "structuralzeccentricity": 0, "analysiszeccentricity": 0}  # fmt: skip


def _write_region(sheets: Sheets, plate: str, shape: AnyShape, material: str, thickness: float) -> str:
    """Write a region and return its name."""
    return sheets.add(
        "StructuralSurfaceMemberRegion", "", "R", material=material, thickness=from_si(thickness, "size"),
        systemplaneat="Centre", eccentricityez=0, **{"2dmember": plate}, **_closed(sheets, shape, shape.ring()),
    )  # fmt: skip


def write_columns(sheets: Sheets, model: Model, material: str) -> dict[str, str]:
    """Write the columns; return the nodes at their feet by their names."""
    feet: dict[str, str] = {}
    for column in model.columns:
        if column.diameter is not None:
            section = cross_section(sheets, material, "Circle", (column.diameter,))
        else:
            assert column.width_x is not None
            assert column.width_y is not None
            # with the local y axis along y, the upright z axis of the section lies along x
            section = cross_section(sheets, material, "Rectangle", (column.width_x, column.width_y))
        feet[column.name] = sheets.node((column.x, column.y))
        sheets.add(
            "StructuralCurveMember", column.name, "B", type="Column", crosssection=section,
            nodes=f"{feet[column.name]}; {sheets.node((column.x, column.y), HEIGHT)}", segments="Line", length=HEIGHT,
            geometricalshape="Line", lcs="y by vector", lcsrotation=column.angle, coordinatex=0, coordinatey=1,
            coordinatez=0, systemline="Centre", behaviourinanalysis="Standard", analysisyeccentricityofbegnode=0,
            analysiszeccentricityofbegnode=0, analysisyeccentricityofendnode=0, analysiszeccentricityofendnode=0,
        )  # fmt: skip
    return feet


def cross_section(sheets: Sheets, material: str, shape: str, sizes: Sequence[float]) -> str:
    """Return the name of a cross-section, which is written once."""
    parameters = "; ".join(_size_text(size) for size in sizes)
    wanted = {"material": material, "crosssectiontype": "Parametric", "shape": shape, "parameters": parameters}
    for row in sheets.rows["StructuralCrossSection"]:
        if {key: row[key] for key in wanted} == wanted:
            return str(row["name"])
    return sheets.add("StructuralCrossSection", "", "CS", **wanted)


def write_walls(sheets: Sheets, walls: Sequence[Wall], material: str) -> dict[str, list[tuple[str, Segment]]]:
    """Write each piece of the walls as a member; return the members with their axes by the walls' names."""
    written: dict[str, list[tuple[str, Segment]]] = {}
    for wall in walls:
        height = wall.height or HEIGHT
        edges = [edge for piece in wall.pieces for edge in piece.edges]
        for edge in edges:
            upper = [sheets.node(place, height) for place in _places(edge)][::-1]
            nodes = "; ".join([*(sheets.node(place) for place in _places(edge)), *upper])
            kind = "Line" if edge.straight else "Circular Arc"
            dx, dy = edge.end[0] - edge.start[0], edge.end[1] - edge.start[1]
            size = float(np.hypot(dx, dy))
            member = sheets.add(
                "StructuralSurfaceMember", wall.name, "W", type="Wall" if edge.straight else "Shell", material=material,
                thicknesstype="Constant", thickness=_size_text(wall.thickness), systemplaneat="Centre", nodes=nodes,
                edges=f"{kind}; Line; {kind}; Line", **_axes("x by vector", (dx / size, dy / size, 0)),
                shape="Flat" if edge.straight else "Curved", behaviorinanalysis="Isotropic",
            )  # fmt: skip
            written.setdefault(wall.name, []).append((member, edge))
        if len(edges) > 1:
            sheets.leave(f"wall {wall.name}", f"written as {len(edges)} walls, one for each piece")
        if wall.height is None:
            sheets.leave(f"wall {wall.name}", f"has no height; written {HEIGHT:g} m high")
        elif wall.openings or wall.stiffness != 1 or wall.E is not None:
            sheets.leave(f"wall {wall.name}", "its openings, share of stiffness and own E are not written")
    return written


def _places(edge: Segment) -> list[tuple[float, float]]:
    return [edge.start, *([] if edge.straight else [middle(edge)]), edge.end]


def write_beams(
    sheets: Sheets, model: Model, plates: Mapping[str, Ring], materials: Mapping[tuple[float, float], str]
) -> None:
    """Write the beams as ribs of the plates on which they start."""
    for beam in model.beams:
        if isinstance(beam.section, GivenSection):
            sheets.leave(f"beam {beam.name}", "a section by its properties is not written")
            continue
        first = model.plate
        material = materials[beam.E or first.E, first.nu if beam.nu is None else beam.nu]
        section = cross_section(sheets, material, "Rectangle", (beam.section.height, beam.section.width))
        many = len(beam.edges) > 1
        geometry = "Polyline" if many else "Line" if beam.edges[0].straight else "Circular Arc"
        sheets.add(
            "StructuralCurveMemberRib", beam.name, "RIB",
            **{"2dmember": plate_at(plates, beam.edges[0].start)},
            crosssection=section,
            **_curve(sheets, beam.edges, closed=False), geometricalshape=geometry, eccentricityez=0,
            shapeoftherib="T Symmetric", behaviourinanalysis="Standard", effectivewidth="Width", **_rib(sheets, beam),
        )  # fmt: skip
        left = [key for key, value in beam if key not in _OF_RIBS and value != Beam.field_defaults[key]]
        if left:
            sheets.leave(f"beam {beam.name}", f"{', '.join(left)} not written")


def _rib(sheets: Sheets, beam: Beam) -> dict[str, object]:
    """Return how a rib is joined to the plate."""
    section = beam.section
    assert not isinstance(section, GivenSection)
    widths = ("widthleftforcheck", "widthrightforcheck", "widthleftforinternalforces", "widthrightforinternalforces")
    if isinstance(section, RectangularSection):
        half = from_si(section.width / 2, "size")
        return {"alignment": "Centre", "typeofconnection": "Without Composite Action", **dict.fromkeys(widths, half)}
    half = from_si(section.flange_width / 2, "size")
    connection = "Full shear connection" if section.eccentric else "Partial shear connection"
    if section.eccentric and section.effective_width is not None:
        sheets.leave(f"beam {beam.name}", "the effective width for its bars is not read back")
    side = "Bottom" if section.side == "below" else "Top"
    return {"alignment": side, "typeofconnection": connection, **dict.fromkeys(widths, half)}


def write_ground(
    sheets: Sheets, model: Model, names: Sequence[str], material: str, stiffness: tuple[float, float] | None
) -> None:
    """Write the ground under all plates, and that of zones under the first one.

    ``stiffness`` is k0 [Pa/m] and k1 [Pa m] of ground that is not given by them, such as a Vlasov solution has found.
    """
    under = _stiffness_of(model.ground, max(model.plate.sides)) or stiffness
    if under is None:
        solved = "; results have, solve it first" if model.ground.kind == "vlasov" else ""
        sheets.leave("ground", f"{model.ground.kind} has no k0 and k1 of its own{solved}")
        return
    for name in names:
        _write_connection(sheets, name, None, under, model.ground.kind)
    from groundslab.geometry.areas import equal_area_polygon

    for number, zone in enumerate(model.soil_zones, start=1):
        subgrade = _stiffness_of(zone.ground, max(model.plate.sides))
        shape = equal_area_polygon(zone.shape.ring())
        plate = equal_area_polygon(model.plate.ring())
        rows = sheets.rows["StructuralSurfaceMemberRegion"]
        same = [row["name"] for row, part in zip(rows, model.plate.zones, strict=False) if part.shape == zone.shape]
        others = any(equal_area_polygon(part.shape.ring()).intersects(shape) for part in model.plate.zones)
        if subgrade is None or shape.difference(plate).area > NO_PART * shape.area or (others and not same):
            sheets.leave(
                f"soil_zones[{number}]", "written only with k0 and k1, on the plate and apart from other zones"
            )
            continue
        region = same[0] if same else _write_region(sheets, names[0], zone.shape, material, model.plate.thickness)
        _write_connection(sheets, names[0], region, subgrade, zone.ground.kind)


def _stiffness_of(ground: AnyGround, side: float) -> tuple[float, float] | None:
    """Return k0 [Pa/m] and k1 [Pa m] of a ground, None if it has none of its own."""
    if isinstance(ground, Winkler):
        return ground.modulus(side), 0.0
    return (ground.k0, ground.k1) if isinstance(ground, Pasternak) else None


def _write_connection(
    sheets: Sheets, plate: str, region: str | None, stiffness: tuple[float, float], kind: str
) -> None:
    k0, k1 = stiffness
    C2 = from_si(k1, "shear stiffness")
    sheets.add(
        "StructuralSurfaceConnection", "", "SS", **{"2dmember": plate, "2dmemberregion": region}, subsoil=kind,
        c1x=0, c1y=0, c1zspring="Linear", c1z=from_si(k0, "surface stiffness"), c2x=C2, c2y=C2,
    )  # fmt: skip


def write_supports(sheets: Sheets, model: Model, plates: Mapping[str, Ring]) -> None:
    """Write supports at points and along lines, and those of the plate's edges."""
    for number, support in enumerate(model.supports, start=1):
        what = f"support {support.name or number}"
        if isinstance(support, PointSupport):
            turning = "Rigid" if support.rotation == "fixed" else "Flexible" if support.rotational_stiffness else "Free"
            stiff = (
                from_si(support.rotational_stiffness, "rotational stiffness") if support.rotational_stiffness else None
            )
            sheets.add(
                "StructuralPointSupport", support.name, "Sn", type="Custom", boundarycondition="In node",
                node=sheets.node((support.x, support.y)), ux="Free", uy="Free", uz=_way(support), fix=turning,
                fiy=turning, fiz="Free", stiffnessfix=stiff, stiffnessfiy=stiff,
                stiffnessz=from_si(support.stiffness, "point stiffness") if support.stiffness else None,
            )  # fmt: skip
        elif isinstance(support, LineSupport):
            plate = plate_at(plates, support.points[0])
            edge = sheets.add(
                "StructuralCurveEdge", "", "ES", **{"2dmember": plate}, **_curve(sheets, support.edges, closed=False)
            )
            turning = "Rigid" if support.rotation == "fixed" else "Free"
            _write_line(sheets, support.name, plate, {"boundarycondition": "On internal edge", "internaledge": edge},
                        _way(support), (turning, "Free"), support.stiffness)  # fmt: skip
        else:
            sheets.leave(what, "a pile, whose stiffness follows from the ground, is not written")
            continue
        if support.gap or support.limit is not None or getattr(support, "diameter", None) is not None:
            sheets.leave(what, "its gap, limit and diameter are not written")
    _write_edges(sheets, model.plate, next(iter(plates)))


def _way(support: PointSupport | LineSupport) -> str:
    return _WAYS[support.acts][support.elastic]


def _write_line(
    sheets: Sheets, name: str, plate: str, where: Mapping[str, object], uz: str, turning: tuple[str, str],
    stiffness: float | None,
) -> None:  # fmt: skip
    """Write a support along a line; it turns about the line, and about what lies across it."""
    sheets.add(
        "StructuralEdgeConnection", name, "Sle", type="Custom", **{"2dmember": plate}, **where, ux="Free", uy="Free",
        uz=uz, fix=turning[0], fiy=turning[1], fiz="Free", coordinatesystem="Local", coordinatedefinition="Relative",
        origin="From start", startpoint=0, endpoint=1,
        stiffnessz=from_si(stiffness, "line stiffness") if stiffness else None,
    )  # fmt: skip


def _write_edges(sheets: Sheets, plate: Plate, name: str) -> None:
    """Write the supports of the plate's own edges."""
    turning = {"hinged": ("Free", "Rigid"), "soft": ("Free", "Free"), "clamped": ("Rigid", "Rigid")}
    x0, x1, y0, y1 = plate.bounds
    size = FLAT * max(x1 - x0, y1 - y0)
    sides = (
        (0, x0, plate.edges.left),
        (0, x1, plate.edges.right),
        (1, y0, plate.edges.bottom),
        (1, y1, plate.edges.top),
    )
    supported = 0
    for number, edge in enumerate(plate.ring().segments(), start=1):
        kinds = [plate.support] + [
            kind for axis, at, kind in sides
            if edge.straight and abs(edge.start[axis] - at) <= size and abs(edge.end[axis] - at) <= size
        ]  # fmt: skip
        for kind in (kind for kind in kinds if kind != "free"):
            number_in_file = 1 if isinstance(plate.outline, Circle) else number
            if number_in_file < number:
                continue
            where = {"boundarycondition": "On edge", "edge": number_in_file}
            _write_line(sheets, "", name, where, "Rigid", turning[kind], None)
            supported += 1
    if supported:
        sheets.leave("plate edges", f"{supported} supported edges are read back as line supports")
