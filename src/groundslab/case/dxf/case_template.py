"""A case file to start from: the drawing's geometry and loads, the rest to be filled in."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab import units
from groundslab.case.dxf.drawing import AreaMark, Drawing, LineMark, PointMark
from groundslab.geometry.plan import Place, Ring
from groundslab.geometry.regions import Region
from groundslab.schema.wording import quote

if TYPE_CHECKING:
    from shapely import STRtree

_ZONE = (
    "# [[plate.zones]]",
    '# thickness = "400 mm"        # fill in; E and nu may differ too',
)
_GROUND = (
    "# The ground under the plate; groundslab new shows other kinds.",
    "# [ground]",
    '# kind = "vlasov"',
    "# [[ground.layers]]            # from the top downwards, as many as there are",
    '# E = "20 MPa"                # fill in',
    "# nu = 0.3                    # fill in",
    '# thickness = "2 m"           # fill in',
)
_LOADS = (
    "# The loads, as many as there are.",
    "# [[loads]]",
    '# kind = "uniform"',
    '# q = "6.25 kPa"              # fill in',
)

#: Units of loads, a thousand times those of SI.
_USUAL_UNITS = {"force": "kN", "force per length": "kN/m", "pressure": "kPa"}

#: What differs by less than this part of a column's size is the same.
SAME = 1e-6
#: A coordinate so small is what rounding left of zero [m].
NOTHING = 1e-12


@dataclass(frozen=True, slots=True)
class Footprint:
    """A column that a case can hold: a rectangle along x and y, or a circle if both widths are its diameter."""

    name: str
    centre: Place
    widths: Place
    round: bool

    def covers(self, x: float, y: float) -> bool:
        """Return whether a place lies on it."""
        dx, dy = abs(x - self.centre[0]), abs(y - self.centre[1])
        reach = 0.5 + SAME
        if self.round:
            return math.hypot(dx, dy) <= reach * self.widths[0]
        return dx <= reach * self.widths[0] and dy <= reach * self.widths[1]

    def lines(self) -> list[str]:
        """Return the lines of the case."""
        # sums and differences of coordinates, freed of what rounding has left
        x, y, width_x, width_y = (_length_text(float(f"{value:.12g}")) for value in (*self.centre, *self.widths))
        size = [f"diameter = {width_x}"] if self.round else [f"width_x = {width_x}", f"width_y = {width_y}"]
        return ["[[columns]]", f"name = {quote(self.name)}", f"x = {x}", f"y = {y}", *size]


def footprint_of(curve: Ring, name: str) -> Footprint | None:
    """Return a closed curve as a column, None if it is neither a circle nor a rectangle along x and y."""
    xs, ys = zip(*curve.points, strict=True)
    if all(curve.bulges):
        arcs = curve.segments()
        centre, radius = arcs[0].centre, arcs[0].radius
        alike = all(math.dist(arc.centre, centre) + abs(arc.radius - radius) <= SAME * radius for arc in arcs)
        whole = abs(abs(sum(arc.sweep for arc in arcs)) - 2 * math.pi) <= SAME
        return Footprint(name, centre, (2 * radius, 2 * radius), round=True) if alike and whole else None
    low, high = (min(xs), min(ys)), (max(xs), max(ys))
    near = SAME * max(high[0] - low[0], high[1] - low[1])
    corners = {(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])}
    rectangle = len(curve.points) == 4 and not any(curve.bulges)
    if not rectangle or any(min(math.dist(corner, each) for each in curve.points) > near for corner in corners):
        return None
    centre = (low[0] + high[0]) / 2, (low[1] + high[1]) / 2
    return Footprint(name, centre, (high[0] - low[0], high[1] - low[1]), round=False)


def to_case(drawing: Drawing, title: str = "") -> str:
    """Return the text of a case file with the drawing's geometry and loads; the rest is there to be filled in."""
    text = [
        "# Input file of groundslab, made from a drawing. What no drawing says stands behind #. Where it says",
        '# "fill in", give your own value and take the # away, from the other lines of that section too.',
        f"# {_origin_text(drawing)} Loads and settlements are positive downwards.",
        "",
        f"title = {quote(title)}",
        "",
        "[plate]",
        '# thickness = "250 mm"        # fill in',
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
    columns, lines = _column_lines(drawing)
    text += lines
    text += ["", *_GROUND]
    under = _column_tree(columns)
    for mark in drawing.point_loads:
        value = _value_line("P", mark.value, "force", "50 kN")
        text += _load_lines("point", mark, value, _place_point(mark, columns, under))
    for line in drawing.line_loads:
        value = _value_line("q", line.value, "force per length", "20 kN/m")
        text += _load_lines("line", line, value, _place_line(line))
    for area in drawing.area_loads:
        value = _value_line("q", area.value, "pressure", "10 kPa")
        holes = [row for hole in area.holes for row in _shape_lines("[[loads.holes]]", hole)]
        text += _load_lines("area", area, value, [*_shape_lines("[loads.shape]", area.curve), *holes])
    marks: list[PointMark | LineMark | AreaMark] = [*drawing.point_loads, *drawing.line_loads, *drawing.area_loads]
    if all(each.value is None for each in marks):
        text += ["", *_LOADS]
    return "\n".join(text) + "\n"


def _column_lines(drawing: Drawing) -> tuple[list[Footprint], list[str]]:
    """Return the columns that a case can hold, and the lines of all columns, those of the others as comments."""
    columns: list[Footprint] = []
    text: list[str] = []
    outline = Region(drawing.outline.segments())
    openings = Region(edge for opening in drawing.openings for edge in opening.segments())
    for number, column in enumerate(drawing.columns, 1):
        footprint = footprint_of(column, f"C{number}") if isinstance(column, Ring) else None
        if footprint is not None and outline.holds(footprint.centre) and not openings.holds(footprint.centre):
            columns.append(footprint)
            text += ["", *footprint.lines()]
            continue
        if isinstance(column, Ring):
            lines, why = _point_lines(column.points, column.bulges), "it does not stand on the plate"
            if footprint is None:
                why = "a column is a rectangle along x and y, or a circle"
        else:
            lines, why = [f"point = {_point_text(column)}"], "a point says nothing of its size"
        text += ["", f"# Column {number} of the drawing, for information only: {why}."]
        text += [f"#   {line}" for line in lines]
    return columns, text


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


def _place_line(load: LineMark) -> list[str]:
    """Return the lines that say where a line load stands: a circle, or points and bulges."""
    circle = _circle_lines(Ring(load.points, load.bulges)) if load.closed else None
    return ["[loads.shape]", *circle] if circle else _point_lines(load.corners(), load.bulges)


def _shape_lines(head: str, curve: Ring) -> list[str]:
    """Return the lines of a shape below its head."""
    return [head, *(_circle_lines(curve) or _polygon_lines(curve))]


def _circle_lines(curve: Ring) -> list[str] | None:
    """Return the lines of a circle, None if a curve is none."""
    found = footprint_of(curve, "")
    if found is None or not found.round:
        return None
    x, y, radius = (float(f"{value:.12g}") for value in (*found.centre, found.widths[0] / 2))
    return ['kind = "circle"', f"centre = {_point_text((x, y))}", f"radius = {_length_text(radius)}"]


def _column_tree(columns: list[Footprint]) -> STRtree:
    """Return a tree of the boxes around columns."""
    from shapely import STRtree, box

    centers = np.reshape([column.centre for column in columns], (-1, 2))
    reach = (0.5 + SAME) * np.reshape([column.widths for column in columns], (-1, 2))
    return STRtree(box(*(centers - reach).T, *(centers + reach).T))


def _place_point(mark: PointMark, columns: list[Footprint], tree: STRtree) -> list[str]:
    """Return the lines that say where a load acts: on the column that it lies on, or at its own place.

    A load beside the column's center keeps its moments about it. Where the force is not known yet, nor are these, and
    the load keeps its place.
    """
    from shapely import Point

    near = sorted(tree.query(Point(mark.x, mark.y)).tolist())
    own = next((columns[k] for k in near if columns[k].covers(mark.x, mark.y)), None)
    if own is not None:
        arms = {"M_x": mark.x - own.centre[0], "M_y": mark.y - own.centre[1]}
        beside = {name: arm for name, arm in arms.items() if abs(arm) > SAME * max(own.widths)}
        if mark.value is not None or not beside:
            force = mark.value or 0.0
            moments = [
                f'{name} = "{units.write(force * arm, "moment")}"  # {arm:.6g} m beside the center of the column'
                for name, arm in beside.items()
            ]
            return [*moments, f"column = {quote(own.name)}"]
    return [f"x = {_length_text(mark.x)}", f"y = {_length_text(mark.y)}"]


def _origin_text(drawing: Drawing) -> str:
    """Return where the coordinates are measured from."""
    x, y = drawing.origin
    if not x and not y:
        return "Coordinates are the drawing's own."
    return f"The origin is the drawing's point ({x:.10g}, {y:.10g}) m."


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
    """Return a coordinate with all its digits; what rounding left of zero is zero."""
    return f'"{repr(value if abs(value) > NOTHING else 0.0).removesuffix(".0")} m"'
