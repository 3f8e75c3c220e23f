"""A case file to start from: the drawing's geometry and loads, the rest to be filled in."""

from __future__ import annotations

import math
from dataclasses import dataclass

from groundslab import units
from groundslab.dxf.curves import Curve, Point, edges_of, inside
from groundslab.dxf.drawing import Drawing, PointMark
from groundslab.dxf.words import quote

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

#: What differs by less than this part of a column's size is the same.
SAME = 1e-6
#: A coordinate so small is what rounding left of zero [m].
NOTHING = 1e-12


@dataclass(frozen=True, slots=True)
class Footprint:
    """A column that a case can hold: a rectangle along x and y, or a circle if both widths are its diameter."""

    name: str
    centre: Point
    widths: Point
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
        x, y, width_x, width_y = (_metres(float(f"{value:.12g}")) for value in (*self.centre, *self.widths))
        size = [f"diameter = {width_x}"] if self.round else [f"width_x = {width_x}", f"width_y = {width_y}"]
        return ["[[columns]]", f"name = {quote(self.name)}", f"x = {x}", f"y = {y}", *size]


def footprint_of(curve: Curve, name: str) -> Footprint | None:
    """Return a closed curve as a column, None if it is neither a circle nor a rectangle along x and y."""
    xs, ys = zip(*curve.points, strict=True)
    if all(curve.bulges):
        circles = [edge.circle() for edge in edges_of(curve)]
        (centre, radius), *others = circles
        turn = sum(4 * math.atan(bulge) for bulge in curve.bulges)
        alike = all(math.dist(c, centre) + abs(r - radius) <= SAME * radius for c, r in others)
        whole = abs(abs(turn) - 2 * math.pi) <= SAME
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
        "# Coordinates are the drawing's own. Loads and settlements are positive downwards.",
        "",
        f"title = {quote(title)}",
        "",
        "[plate]",
        '# thickness = "250 mm"        # fill in',
        '# E = "30 GPa"                # fill in',
        "# nu = 0.2                    # fill in",
        "",
        "[plate.outline]",
        'kind = "polygon"',
        *_curve_lines(drawing.outline),
    ]
    for opening in drawing.openings:
        text += ["", "[[plate.openings]]", 'kind = "polygon"', *_curve_lines(opening)]
    for number, zone in enumerate(drawing.zones, 1):
        shape = ["[plate.zones.shape]", 'kind = "polygon"', *_curve_lines(zone)]
        text += ["", f"# Zone {number} of the drawing.", *_ZONE, *(f"# {line}" for line in shape)]
    columns: list[Footprint] = []
    for number, column in enumerate(drawing.columns, 1):
        footprint = footprint_of(column, f"C{number}") if isinstance(column, Curve) else None
        if footprint is not None and _on_plate(drawing, footprint.centre):
            columns.append(footprint)
            text += ["", *footprint.lines()]
            continue
        if footprint is not None:
            why = "it does not stand on the plate"
        elif isinstance(column, Curve):
            why = "a column is a rectangle along x and y, or a circle"
        else:
            why = "a point says nothing of its size"
        text += ["", f"# Column {number} of the drawing, for information only: {why}."]
        lines = _curve_lines(column) if isinstance(column, Curve) else [f"point = {_pair(column)}"]
        text += [f"#   {line}" for line in lines]
    text += ["", *_GROUND]
    for mark in drawing.point_loads:
        name = [f"name = {quote(mark.text)}"] if mark.text else []
        force = f'P = "{units.write(mark.value, "force")}"' if mark.value is not None else 'P = "50 kN"  # fill in'
        lines = ["[[loads]]", 'kind = "point"', *name, force, *_where(mark, columns)]
        text += ["", *(lines if mark.value is not None else (f"# {line}" for line in lines))]
    if all(mark.value is None for mark in drawing.point_loads):
        text += ["", *_LOADS]
    return "\n".join(text) + "\n"


def _on_plate(drawing: Drawing, place: Point) -> bool:
    """Return whether a place lies inside the outline and in no opening."""
    return inside(place, edges_of(drawing.outline)) and not any(
        inside(place, edges_of(opening)) for opening in drawing.openings
    )


def _where(mark: PointMark, columns: list[Footprint]) -> list[str]:
    """Return the lines that say where a load acts: on the column that it lies on, or at its own place.

    A load beside the column's centre keeps its moments about it. Where the force is not known yet, nor are these, and
    the load keeps its place.
    """
    own = next((column for column in columns if column.covers(mark.x, mark.y)), None)
    if own is not None:
        arms = {"M_x": mark.x - own.centre[0], "M_y": mark.y - own.centre[1]}
        beside = {name: arm for name, arm in arms.items() if abs(arm) > SAME * max(own.widths)}
        if mark.value is not None or not beside:
            force = mark.value or 0.0
            moments = [
                f'{name} = "{units.write(force * arm, "moment")}"  # {arm:.6g} m beside the centre of the column'
                for name, arm in beside.items()
            ]
            return [*moments, f"column = {quote(own.name)}"]
    return [f"x = {_metres(mark.x)}", f"y = {_metres(mark.y)}"]


def _curve_lines(curve: Curve) -> list[str]:
    """Return the lines of a closed curve; bulges only if it has arcs."""
    lines = ["points = [", *(f"  {_pair(point)}," for point in curve.points), "]"]
    if any(curve.bulges):
        lines.append(f"bulges = [{', '.join(repr(bulge or 0.0) for bulge in curve.bulges)}]")
    return lines


def _pair(point: Point) -> str:
    return f"[{_metres(point[0])}, {_metres(point[1])}]"


def _metres(value: float) -> str:
    """Return a coordinate with all its digits; what rounding left of zero is zero."""
    return f'"{repr(value if abs(value) > NOTHING else 0.0).removesuffix(".0")} m"'
