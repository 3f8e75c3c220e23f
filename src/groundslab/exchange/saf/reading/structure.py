"""What is cast with the slab and stands on it: openings, zones, internal edges, ribs, columns and walls."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from groundslab.exchange.saf.reading.context import ReadContext, RowFault, Vector, cross, dot, text, texts, word
from groundslab.exchange.saf.reading.geometry import CLOSE, Edge, join, to_shape
from groundslab.exchange.saf.reading.slab import Material, Slab, read_edges, read_material, read_part, read_thickness
from groundslab.exchange.saf.reading.workbook import Row
from groundslab.model.plate import Plate, Zone
from groundslab.model.shapes import AnyShape, Rectangle
from groundslab.model.structure.beams import Beam, BeamSection, RectangularSection, RibSection
from groundslab.model.structure.columns import Column
from groundslab.model.structure.walls import Wall

#: Sides of a column are along x and y if they are within this of it.
ALONG = 1e-6
#: Differences of E, nu and thickness from the plate's, relative to them, that are none.
SAME = 1e-9


@dataclass(frozen=True, slots=True)
class CrossSection:
    """A cross-section: its shape in lower case, parameters [m], axes of H and B, and its row."""

    shape: str
    sizes: tuple[float, ...]
    upright: str
    row: Row


def read_plate(context: ReadContext, slab: Slab) -> Plate | None:
    """Return the plate with its openings and zones; issues are the context's."""
    openings, zones = list[AnyShape](), list[Zone]()
    for row in _of_slab(context, "StructuralSurfaceMemberOpening", slab):
        with context.reading(row):
            slab.openings[row.name] = read_part(context, row, slab, closed=True)
            openings.append(to_shape(slab.openings[row.name]))
            context.take(row, "opening")
    for row in _of_slab(context, "StructuralSurfaceMemberRegion", slab):
        with context.reading(row):
            slab.regions[row.name] = read_part(context, row, slab, closed=True)
            zones += _read_zone(context, row, slab)
    for row in _of_slab(context, "StructuralCurveEdge", slab):
        with context.reading(row):
            slab.internal[row.name] = read_part(context, row, slab, closed=False)
            context.take(row, "line for loads and supports")
    return _make_plate(context, slab, openings, zones)


def _make_plate(context: ReadContext, slab: Slab, openings: Sequence[AnyShape], zones: Sequence[Zone]) -> Plate | None:
    """Return the plate, a rectangle about the origin by its sides; None with an issue if it is none."""
    plates: list[Plate] = []
    with context.reading(slab.row):
        shape = to_shape(slab.edges)
        place: dict[str, Any] = {"outline": shape}
        if isinstance(shape, Rectangle) and shape.x[0] == -shape.x[1] and shape.y[0] == -shape.y[1]:
            place = {"length_x": shape.x[1] - shape.x[0], "length_y": shape.y[1] - shape.y[0]}
        plate = Plate(
            name=slab.name, **place, openings=tuple(openings), zones=tuple(zones), thickness=slab.thickness,
            E=slab.material.E, nu=slab.material.nu, thermal_expansion=slab.material.expansion,
        )  # fmt: skip
        plates.append(plate)
    return plates[0] if plates else None


def _of_slab(context: ReadContext, sheet: str, slab: Slab) -> list[Row]:
    """Return the rows of a sheet that belong to the slab; those of other members are left."""
    rows = context.rows(sheet)
    for row in rows:
        if text(row, "2dmember") != slab.name:
            context.leave(row, f"it belongs to {text(row, '2dmember') or 'nothing'}")
    return [row for row in rows if text(row, "2dmember") == slab.name]


def _read_zone(context: ReadContext, row: Row, slab: Slab) -> list[Zone]:
    """Return the zone of a region, none if it is like the rest of the plate."""
    material, thickness = read_material(context, row), read_thickness(context, row)
    eccentric = context.number(row, "eccentricityez", "size", 0.0)
    if eccentric or word(row, "systemplaneat", default="centre") not in ("centre", "center"):
        context.note(row, "its plane, taken to be the slab's middle plane")
    values = {"thickness": (thickness, slab.thickness), "E": (material.E, slab.material.E),
              "nu": (material.nu, slab.material.nu)}  # fmt: skip
    differ = {name: value for name, (value, plate) in values.items() if abs(value - plate) > SAME * plate}
    _note_material(context, row, material, slab)
    context.take(row, "zone" if differ else "part of the plan for loads and ground")
    return [Zone(shape=to_shape(slab.regions[row.name]), **differ)] if differ else []


def _note_material(context: ReadContext, row: Row, material: Material, slab: Slab) -> None:
    """Note what a material has of its own that only the whole slab can have."""
    for what, value, plate in (
        ("unit weight", material.unit_weight, slab.material.unit_weight),
        ("thermal expansion", material.expansion, slab.material.expansion),
    ):
        if abs(value - plate) > SAME * abs(plate):
            context.note(row, f"a {what} of its own, {value:g} in SI units, taken as the slab's, {plate:g}")


def read_cross_section(context: ReadContext, row: Row) -> CrossSection:
    """Return the cross-section that a row names; raises RowFault."""
    name = text(row, "crosssection")
    section = next((candidate for candidate in context.rows("StructuralCrossSection") if candidate.name == name), None)
    if section is None:
        raise RowFault("crosssection", f"the cross-section {name or 'nothing'!r}", "one of StructuralCrossSection")
    model = context.rows("Model")
    axes = text(model[0], "lcsofcrosssection") if model else ""
    letters = re.findall(r"[XYZ]", axes.upper().replace("MINUS", ""))
    upright = letters[0].lower() if letters and letters[0] in "YZ" and letters[-1] == "X" else "z"
    shape = word(section, "shape")
    sizes = context.numbers(section, "parameters", "size") if shape in ("rectangle", "circle") else []
    if any(size <= 0 for size in sizes):
        raise RowFault("crosssection", f"sizes of {name} that are not above 0", "sizes above 0")
    return CrossSection(shape, tuple(sizes), upright, section)


def read_beams(context: ReadContext, slab: Slab) -> list[Beam]:
    """Return the ribs of the slab."""
    beams = list[Beam]()
    for row in _of_slab(context, "StructuralCurveMemberRib", slab):
        with context.reading(row):
            slab.ribs[row.name] = read_part(context, row, slab, closed=False)
            section = _read_rib_section(context, row, slab)
            if section is None:
                continue
            points, bulges = join(slab.ribs[row.name])
            material = read_material(context, read_cross_section(context, row).row)
            other = {"E": (material.E, slab.material.E), "nu": (material.nu, slab.material.nu)}
            differ = {name: value for name, (value, plate) in other.items() if abs(value - plate) > SAME * plate}
            _note_material(context, row, material, slab)
            beams.append(Beam(name=row.name, points=points, bulges=bulges, section=section, **differ))
            context.take(row, "beam")
    return beams


def _read_rib_section(context: ReadContext, row: Row, slab: Slab) -> BeamSection | None:
    """Return the section of a rib, None if it is no rectangle."""
    cross_section = read_cross_section(context, row)
    if cross_section.shape != "rectangle" or len(cross_section.sizes) != 2:
        context.leave(row, f"its section {cross_section.row.name} is no rectangle; give it as properties by hand")
        return None
    if "axial" in word(row, "behaviourinanalysis"):
        context.note(row, "axial force only, taken as a beam that bends")
    height, width = cross_section.sizes
    # bottom and top by the local z axis of the slab, which is that of the file's vertical axis
    lower, upper = ("bottom", "top") if context.upwards > 0 else ("top", "bottom")
    side = {lower: "below", upper: "above"}.get(word(row, "alignment"))
    connection = word(row, "typeofconnection")
    if context.number(row, "eccentricityez", "size", 0.0):
        context.note(row, "its eccentricity ez, left out: it adjoins the plate, or lies about its middle plane")
    if side is None or connection.startswith(("without", "user")):
        if side is not None:
            context.note(row, f"a connection {connection!r}, taken as a rectangle about the plate's middle plane")
        return RectangularSection(width=width, height=height)
    if connection.startswith("full"):
        return RibSection(width=width, height=height, eccentric=True, side=side)
    return RibSection(width=width, height=height, side=side, effective_width=_flange(context, row, slab) or width)


def _flange(context: ReadContext, row: Row, slab: Slab) -> float:
    """Return the effective width of a rib for internal forces [m], 0 if it is not given."""
    sides = ("widthleftforinternalforces", "widthrightforinternalforces")
    if word(row, "effectivewidth").startswith("number"):
        return sum(context.number(Row(row.sheet, row.number, row.cells, {}), side, "number", 0.0) for side in sides) * (
            slab.thickness
        )
    return sum(context.number(row, side, "size", 0.0) for side in sides)


def read_columns(context: ReadContext, slab: Slab) -> list[Column]:
    """Return the columns that stand on the slab; where they stand is noted in it."""
    columns = list[Column]()
    for row in context.rows("StructuralCurveMember"):
        try:
            ends = [context.node(name) for name in texts(row, "nodes")]
        except RowFault:
            context.leave(row, "its nodes cannot be read")
            continue
        touching = [end for end in ends[:1] + ends[-1:] if abs(end[2] - slab.height) <= CLOSE and slab.holds(end[:2])]
        if not touching or len(ends) < 2:
            context.leave(row, "it does not stand on the slab")
            continue
        other = ends[-1] if touching[0] == ends[0] else ends[0]
        foot = touching[0]
        if len(ends) != 2 or math.dist(other[:2], foot[:2]) > CLOSE or other[2] <= slab.height + CLOSE:
            context.leave(row, "it is no column: one goes straight up from the slab")
            continue
        with context.reading(row):
            slab.columns[row.name] = foot[:2]
            columns += _read_column(context, row, foot[:2], (ends[0], ends[1]))
    return columns


def _read_column(
    context: ReadContext, row: Row, place: tuple[float, float], ends: tuple[Vector, Vector]
) -> list[Column]:
    """Return the column of a row, none if its section is neither a rectangle nor a circle."""
    section = read_cross_section(context, row)
    shifts = [context.number(row, key, "size", 0.0) for key in row.cells if key.startswith("analysis")]
    if any(shifts) or word(row, "systemline", default="centre") not in ("centre", "center"):
        context.note(row, "its system line and eccentricities, left out: it stands at its node")
    if text(row, "arbitrarydefinition"):
        context.note(row, f"a section that varies, taken as {section.row.name}")
    where = {"name": row.name, "x": place[0], "y": place[1]}
    if section.shape == "circle" and len(section.sizes) == 1:
        context.take(row, "column")
        return [Column(**where, diameter=section.sizes[0])]
    if section.shape != "rectangle" or len(section.sizes) != 2:
        context.leave(row, f"its section {section.row.name} is neither a rectangle nor a circle; loads keep its place")
        return []
    H, B = section.sizes
    upright = member_axes(context, row, ends)["zy".index(section.upright) + 1]
    if abs(upright[0]) <= ALONG or abs(upright[1]) <= ALONG:
        width_x, width_y = (H, B) if abs(upright[0]) > 0.5 else (B, H)
        context.take(row, "column")
        return [Column(**where, width_x=width_x, width_y=width_y)]
    # H is along the upright axis, which points either way
    angle = float(f"{math.remainder(math.degrees(math.atan2(upright[1], upright[0])), 180):.12g}")
    context.take(row, "column")
    return [Column(**where, width_x=H, width_y=B, angle=angle)]


def member_axes(context: ReadContext, row: Row, ends: tuple[Vector, Vector]) -> tuple[Vector, Vector, Vector]:
    """Return the local axes x, z and y of a straight member in plan x, plan y and up."""
    start, end = ends
    length = math.dist(start, end)
    x = ((end[0] - start[0]) / length, (end[1] - start[1]) / length, (end[2] - start[2]) / length)
    kind = word(row, "lcs", default="y by vector")
    by_vector = "vector" in kind
    quantity = "number" if by_vector else "length"
    bare = Row(row.sheet, row.number, row.cells, {}) if by_vector else row
    a, b, c = (context.number(bare, f"coordinate{axis}", quantity, 0.0) for axis in "xyz")
    vector = context.turned((a, b, c))
    if not by_vector:
        vector = (vector[0] - start[0], vector[1] - start[1], vector[2] - start[2])
    along = dot(vector, x)
    across = (vector[0] - along * x[0], vector[1] - along * x[1], vector[2] - along * x[2])
    size = math.hypot(*across)
    if size < ALONG:
        raise RowFault("coordinatex", "a vector along the member", "one across it, which gives its local axes")
    unit = (across[0] / size, across[1] / size, across[2] / size)
    y, z = (cross(unit, x), unit) if kind.startswith("z") else (unit, cross(x, unit))
    angle = context.number(row, "lcsrotation", "angle", 0.0)
    c, s = math.cos(angle), math.sin(angle)
    turned_y = (c * y[0] + s * z[0], c * y[1] + s * z[1], c * y[2] + s * z[2])
    return x, cross(x, turned_y), turned_y


def read_walls(context: ReadContext, slab: Slab) -> list[Wall]:
    """Return the walls whose lower edges stand on the slab."""
    walls = list[Wall]()
    for row in context.rows("StructuralSurfaceMember"):
        if row.name == slab.name:
            continue
        try:
            edges = read_edges(context, row, closed=True)
        except RowFault:
            context.leave(row, "its nodes and edges cannot be read")
            continue
        feet = [(number, edge) for number, edge in enumerate(edges, 1) if edge.level(slab.height) and _on(slab, edge)]
        heights = [place[2] for edge in edges for place in edge.places]
        if len(feet) != 1 or min(heights) < slab.height - CLOSE or max(heights) <= slab.height + CLOSE:
            context.leave(row, "it does not stand on the slab with one edge")
            continue
        with context.reading(row):
            number, edge = feet[0]
            walls.append(Wall(name=row.name, thickness=read_thickness(context, row), points=edge.points,
                              bulges=edge.bulges if any(edge.bulges) else ()))  # fmt: skip
            slab.walls[row.name] = (number, edge)
            context.take(row, "wall, without stiffness unless it is given a height")
    return walls


def _on(slab: Slab, edge: Edge) -> bool:
    """Return whether an edge starts and ends on the slab."""
    return slab.holds(edge.points[0]) and slab.holds(edge.points[-1])
