"""A case file to start from: the drawing's geometry and loads, the rest to be filled in."""

from __future__ import annotations

import math
import re
import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundslab import units
from groundslab.case.numbers import why_unclear
from groundslab.exchange import blanks
from groundslab.exchange.dxf.classify import SAME, Footprint, circle_of, footprint_of
from groundslab.exchange.dxf.drawing import AreaMark, Drawing, LineMark, PointMark
from groundslab.geometry.plan import Place, Ring
from groundslab.geometry.regions import Region
from groundslab.schema.wording import printable, quote, with_article

if TYPE_CHECKING:
    from shapely import STRtree

_ZONE = (
    "# [[plate.zones]]",
    '# thickness = "400 mm"        # fill in; E and nu may differ too',
)

#: Width and height of a beam, as in "B1 40x80 cm" or "300/600 mm".
_SECTION = re.compile(r"(?<![\w.,])(\d+(?:[.,]\d+)?)\s*[x×/*]\s*(\d+(?:[.,]\d+)?)\s*(mm|cm|m)\b", re.IGNORECASE)
#: Units of loads, a thousand times those of SI.
_USUAL_UNITS = {"force": "kN", "force per length": "kN/m", "pressure": "kPa"}

#: A force so near the center of a column, as a part of its size, stands on all of it.
CENTRAL = 0.01
#: Letters of a line of comments.
LINE = 116


def to_case(drawing: Drawing, title: str = "", source: str = "drawing", notes: Sequence[str] = ()) -> str:
    """Return the text of a case file with the drawing's geometry and loads; the rest is there to be filled in.

    ``source`` is the word for what it was taken from, and ``notes`` are comments at its top.
    """
    thickness = '# thickness = "250 mm"        # fill in'
    if drawing.thickness is not None:
        thickness = f"thickness = {_length_text(drawing.thickness)}"
    made_from = with_article(source)
    size = drawing.remark_on_size
    notes = [*notes, *([f"Check the unit: {size}."] if size else [])]
    text = [
        f"# Input file of groundslab, made from {made_from}. What it does not contain is commented out with #.",
        '# Where it says "fill in", give your own value and take the # away, from the other lines of that section too.',
        f"# {_origin_text(drawing, source)} Loads and settlements are positive downwards.",
        *(f"# {line}" for note in notes for line in textwrap.wrap(printable(note), LINE)),
        "",
        f"title = {quote(title)}",
        "",
        "[plate]",
        thickness,
        '# E = "30 GPa"                # fill in',
        "# nu = 0.2                    # fill in",
        "",
        *_shape_lines("[plate.outline]", drawing.outline),
    ]
    for opening in drawing.openings:
        text += ["", *_shape_lines("[[plate.openings]]", opening)]
    for number, zone in enumerate(drawing.zones, 1):
        shape = _shape_lines("[plate.zones.shape]", zone)
        text += ["", f"# Zone {number} of the drawing.", *_ZONE, *(f"# {line}" for line in shape)]
    columns, lines = _column_lines(drawing, source)
    text += lines
    for number, wall in enumerate(drawing.walls, 1):
        text += _wall_lines(wall, _name_of(drawing.wall_names, "W", number))
    for number, beam in enumerate(drawing.beams, 1):
        text += _beam_lines(beam, number)
    text += ["", "# The ground under the plate; groundslab new shows other kinds.", *blanks.GROUND]
    under = _column_tree(columns)
    others = _other_shapes(drawing)
    for mark in drawing.point_loads:
        value = _value_line("P", mark.value, "force", "50 kN")
        text += _spread_over(mark, others) or _load_lines("point", mark, value, _place_point(mark, columns, under))
    for line in drawing.line_loads:
        value = _value_line("q", line.value, "force per length", "20 kN/m")
        text += _load_lines("line", line, value, _place_line(line, "[loads.shape]"))
    for area in drawing.area_loads:
        value = _value_line("q", area.value, "pressure", "10 kPa")
        holes = [row for hole in area.holes for row in _shape_lines("[[loads.holes]]", hole)]
        text += _load_lines("area", area, value, [*_shape_lines("[loads.shape]", area.curve), *holes])
    marks: list[PointMark | LineMark | AreaMark] = [*drawing.point_loads, *drawing.line_loads, *drawing.area_loads]
    if all(mark.value is None for mark in marks):
        text += ["", "# The loads, as many as there are.", *blanks.LOADS]
    return "\n".join(text) + "\n"


def _name_of(names: Sequence[str], letter: str, number: int) -> str:
    """Return the name that a column or a wall has in the file, or else its letter and number."""
    return names[number - 1] if names else f"{letter}{number}"


def _column_lines(drawing: Drawing, source: str) -> tuple[list[Footprint], list[str]]:
    """Return the columns that a case can hold, and the lines of all columns, those of the others as comments."""
    columns: list[Footprint] = []
    text: list[str] = []
    outline = Region(drawing.outline.segments())
    openings = Region(edge for opening in drawing.openings for edge in opening.segments())
    for number, column in enumerate(drawing.columns, 1):
        name = _name_of(drawing.column_names, "C", number)
        footprint = footprint_of(column, name) if isinstance(column, Ring) else None
        if footprint is not None and outline.holds(footprint.centre) and not openings.holds(footprint.centre):
            columns.append(footprint)
            text += ["", *_footprint_lines(footprint, f"Column {number} of the {source}")]
            continue
        if isinstance(column, Ring):
            lines, why = _point_lines(column.points, column.bulges), "it is not on the plate"
            if footprint is None:
                why = "a column is a rectangle, a circle, or as compact; punching is not checked"
        else:
            lines, why = [f"point = {_point_text(column)}"], "a point has no size"
        text += ["", f"# Column {number} of the {source}, for information only: {why}."]
        text += [f"#   {line}" for line in lines]
    return columns, text


def _wall_lines(wall: LineMark, name: str) -> list[str]:
    """Return the lines of a wall; one without a thickness is there to be filled in."""
    said = [f"# {wall.text}"] if wall.text else []
    place = ["[[walls]]", f"name = {quote(name)}", *_place_line(wall, "[walls.shape]")]
    thickness = 'thickness = "250 mm"  # fill in'
    if wall.value is not None:
        thickness = f'thickness = "{units.write(wall.value, "length")}"'
    lines = [*place[:2], thickness, *place[2:]]
    return ["", *said, *(lines if wall.value is not None else (f"# {line}" for line in lines))]


def _beam_lines(beam: LineMark, number: int) -> list[str]:
    """Return the lines of a beam; one without a section is there to be filled in."""
    said = [f"# {beam.text}"] if beam.text else []
    section = _SECTION.search(beam.text)
    if section is not None and any(map(why_unclear, section.groups()[:2])):
        section = None  # 1,200 mm are 1.2 mm or 1200 mm
    sizes = ("400", "800", "mm") if section is None else section.groups()
    width, height, unit = (size.replace(",", ".") for size in sizes)
    fill = "  # fill in" if section is None else ""
    lines = [
        "[[beams]]",
        f'name = "B{number}"',
        f'section = {{ kind = "rectangle", width = "{width} {unit}", height = "{height} {unit}" }}{fill}',
        *_place_line(beam, "[beams.shape]"),
    ]
    return ["", *said, *(lines if section is not None else (f"# {line}" for line in lines))]


def _footprint_lines(column: Footprint, what: str) -> list[str]:
    """Return the lines of a column."""
    # sums and differences of coordinates, freed of what rounding has left
    x, y, width_x, width_y = (_length_text(float(f"{value:.12g}")) for value in (*column.centre, *column.widths))
    size = [f"diameter = {width_x}"] if column.round else [f"width_x = {width_x}", f"width_y = {width_y}"]
    size += [f"angle = {column.angle!r}"] if column.angle else []
    remark = f"# {what}, as a circle of the same area: it is no rectangle."
    return [*([remark] if column.shape else []), "[[columns]]", f"name = {quote(column.name)}", f"x = {x}", f"y = {y}",
            *size]  # fmt: skip


def _other_shapes(drawing: Drawing) -> list[Ring]:
    """Return the columns that are closed curves but none that a case can hold."""
    return [column for column in drawing.columns if isinstance(column, Ring) and footprint_of(column, "") is None]


def _spread_over(mark: PointMark, shapes: Sequence[Ring]) -> list[str]:
    """Return the lines of a force that is spread over the column in whose center it stands, none of another one."""
    if mark.value is None:
        return []
    for shape in shapes:
        x0, x1, y0, y1 = shape.bounds
        middle = shape.polygon(SAME * max(x1 - x0, y1 - y0)).centroid
        if math.dist((middle.x, middle.y), (mark.x, mark.y)) <= CENTRAL * max(x1 - x0, y1 - y0):
            value = f'q = "{_computed(mark.value / shape.area, "pressure")}"  # {units.show(mark.value, "force")}'
            return _load_lines("area", mark, value, _shape_lines("[loads.shape]", shape))
    return []


def _load_lines(kind: str, mark: PointMark | LineMark | AreaMark, value: str, where: list[str]) -> list[str]:
    """Return the lines of a load; one without a value is there to be filled in."""
    name = [f"name = {quote(mark.text)}"] if mark.text else []
    lines = ["[[loads]]", f'kind = "{kind}"', *name, value, *where]
    return ["", *(lines if mark.value is not None else (f"# {line}" for line in lines))]


def _value_line(key: str, value: float | None, dimension: str, example: str) -> str:
    """Return the line of a value, or of one to be filled in."""
    return f'{key} = "{_quantity_text(value, dimension)}"' if value is not None else f'{key} = "{example}"  # fill in'


def _quantity_text(value: float, dimension: str) -> str:
    """Return a load in the unit that engineers write it in, if that gives the same number."""
    text = f"{value / 1e3:.15g} {_USUAL_UNITS[dimension]}"
    return text if units.parse(text, dimension) == value else units.write(value, dimension)


def _place_line(line: LineMark, head: str) -> list[str]:
    """Return the lines that say where a line runs: a circle below its head, or points and bulges."""
    circle = _circle_lines(Ring(line.points, line.bulges)) if line.closed else None
    return [head, *circle] if circle else _point_lines(line.corners(), line.bulges)


def _shape_lines(head: str, curve: Ring) -> list[str]:
    """Return the lines of a shape below its head."""
    return [head, *(_circle_lines(curve) or _polygon_lines(curve))]


def _circle_lines(curve: Ring) -> list[str] | None:
    """Return the lines of a circle, None if a curve is none."""
    circle = circle_of(curve)
    if circle is None:
        return None
    (x, y), radius = circle
    x, y, radius = (float(f"{value:.12g}") for value in (x, y, radius))
    return ['kind = "circle"', f"centre = {_point_text((x, y))}", f"radius = {_length_text(radius)}"]


def _column_tree(columns: list[Footprint]) -> STRtree:
    """Return a tree of the boxes around columns."""
    from shapely import STRtree, box

    centers = np.reshape([column.centre for column in columns], (-1, 2))
    # what is drawn of another shape reaches beyond its circle, by less than its diameter
    reach = np.reshape([(1 if column.shape is None else 3) * np.array(column.reach) for column in columns], (-1, 2))
    return STRtree(box(*(centers - (1 + SAME) * reach).T, *(centers + (1 + SAME) * reach).T))


def _place_point(mark: PointMark, columns: list[Footprint], tree: STRtree) -> list[str]:
    """Return the lines that say where a load acts: on the column that it lies on, or at its own place.

    A load beside the column's center keeps its moments about it. Where the force is not known yet, nor are these, and
    the load keeps its place.
    """
    from shapely import Point

    near = sorted(tree.query(Point(mark.x, mark.y)).tolist())
    holder = next((columns[k] for k in near if columns[k].covers(mark.x, mark.y)), None)
    if holder is not None:
        arms = {"M_x": mark.x - holder.centre[0], "M_y": mark.y - holder.centre[1]}
        beside = {name: arm for name, arm in arms.items() if abs(arm) > SAME * max(holder.widths)}
        if mark.value is not None or not beside:
            force = mark.value or 0.0
            moments = [
                f'{name} = "{_computed(force * arm, "moment")}"  # {arm:.6g} m off the center of the column'
                for name, arm in beside.items()
            ]
            return [*moments, f"column = {quote(holder.name)}"]
    return [f"x = {_length_text(mark.x)}", f"y = {_length_text(mark.y)}"]


def _origin_text(drawing: Drawing, source: str) -> str:
    """Return where the coordinates are measured from."""
    x, y = drawing.origin
    axes = f" The x axis is turned by {drawing.turned:.8g} degrees from the {source}'s." if drawing.turned else ""
    if not x and not y:
        return axes.strip() or f"Coordinates are the {source}'s own."
    return f"The origin is the {source}'s point ({x:.10g}, {y:.10g}) m.{axes}"


def _polygon_lines(curve: Ring) -> list[str]:
    """Return the lines of a closed curve as a polygon."""
    return ['kind = "polygon"', *_point_lines(curve.points, curve.bulges)]


def _point_lines(points: Sequence[Place], bulges: Sequence[float]) -> list[str]:
    """Return the lines of points and of bulges, these only if there are arcs."""
    lines = ["points = [", *(f"  {_point_text(point)}," for point in points), "]"]
    if any(bulges):
        lines.append(f"bulges = [{', '.join(repr(bulge or 0.0) for bulge in bulges)}]")
    return lines


def _point_text(point: Place) -> str:
    return f"[{_length_text(point[0])}, {_length_text(point[1])}]"


def _length_text(value: float) -> str:
    """Return a coordinate with its digits to the nanometer: those beyond are what rounding has left."""
    return f'"{repr(units.coordinate(value)).removesuffix(".0")} m"'


def _computed(value: float, dimension: str) -> str:
    """Return a quantity with fourteen digits: those beyond are what rounding has left."""
    return units.write(float(f"{value:.14g}"), dimension)
