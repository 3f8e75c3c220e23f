"""Free loads: along lines and over areas at places of their own, which act on what lies there."""

from __future__ import annotations

import math
from collections.abc import Sequence

from groundslab.exchange.saf.reading.context import ReadContext, RowFault, Vector, cross, text, texts, word
from groundslab.exchange.saf.reading.geometry import CLOSE, Edge, join, make_edges, to_ring, to_shape
from groundslab.exchange.saf.reading.loads.forces import (
    Axes,
    Loads,
    add_line,
    line_values,
    on_slab,
    read_vector,
    words_of,
)
from groundslab.exchange.saf.reading.slab import Slab, slab_axes
from groundslab.exchange.saf.reading.workbook import Row
from groundslab.geometry.areas import equal_area_polygon
from groundslab.geometry.plan import Place
from groundslab.model.loads.load_types import AreaLoad
from groundslab.schema.wording import describe

#: Which loads in a plane of their own act on what lies in it, above it and below it, by the word that says so; files
#: of versions that have no such word mean what lies in it.
_VALID = {
    "": (True, False, False), "all": (True, True, True), "z zero": (True, False, False),
    "minus z": (False, False, True), "minus z zero": (True, False, True),
    "plus z": (False, True, False), "plus z zero": (True, True, False),
}  # fmt: skip


def _free_edges(context: ReadContext, row: Row, closed: bool) -> tuple[tuple[Edge, ...], list[Place]]:
    """Return the edges of a free load through its own places, and these places in plan."""
    columns = [context.numbers(row, f"coordinate{axis}", "length") for axis in "xyz"]
    if len({len(column) for column in columns}) != 1:
        raise RowFault(
            "coordinatex", f"{' , '.join(str(len(column)) for column in columns)} coordinates", "as many of each"
        )
    places = [context.turned(place) for place in zip(*columns, strict=True)]
    edges = make_edges(places, texts(row, "edges") or texts(row, "segments"), closed)
    for edge in edges:
        if edge.remark:
            context.note(row, edge.remark)
    return edges, [place[:2] for place in places]


def read_free_curve_action(context: ReadContext, row: Row, slab: Slab, loads: Loads) -> None:
    """Add a free force along a line in the slab's plane."""
    edges, _ = _free_edges(context, row, closed=False)
    if not all(edge.level(slab.height) for edge in edges):
        context.leave(row, "it is not in the slab's plane")
        return
    if not on_slab(slab, join(edges)):
        context.leave(row, "it acts elsewhere in the building")
        return
    start, end = line_values(context, row, slab_axes(context, slab))
    add_line(loads, row, join(edges), start, end, slab)
    context.take(row, words_of("line load", *(a if a else b for a, b in zip(start, end, strict=True))))


def read_free_surface_action(context: ReadContext, row: Row, slab: Slab, loads: Loads) -> None:
    """Add a free pressure on a part of the plan, constant or linear, if it acts on the slab."""
    edges, corners = _free_edges(context, row, closed=True)
    height = edges[0].places[0][2]
    if not all(edge.level(height) for edge in edges):
        context.leave(row, "it is not horizontal, and how it is projected is not read")
        return
    up = context.upwards * (-1 if word(row, "localzdirection") == "negative" else 1)
    if not _is_valid(context, row, (slab.height - height) * up):
        context.leave(row, "it does not act at the slab's height")
        return
    part = equal_area_polygon(to_ring(edges)).intersection(slab.area)
    if part.area <= CLOSE**2:
        context.leave(row, "it acts elsewhere in the building")
        return
    values = _corner_values(context, row)
    q, (gx, gy), about = _plane(row, corners, values, word(row, "distribution", default="uniform"))
    axes = _own_axes(corners, up) if word(row, "coordinatesystem") == "local" else slab_axes(context, slab)
    unit = read_vector(context, Row(row.sheet, row.number, {**row.cells, "value": 1.0}, {}), "number", axes)
    case, down = text(row, "loadcase"), -unit[2]
    # the mean of a linear pressure is that at the centroid
    mean = q + gx * (part.centroid.x - about[0]) + gy * (part.centroid.y - about[1])
    loads.push(case, mean * unit[0] * part.area, mean * unit[1] * part.area)
    if down:
        varies = {"slope": (gx * down + 0.0, gy * down + 0.0), "about": about} if gx or gy else {}
        loads.loads.append(AreaLoad(name=row.name, case=case, q=q * down + 0.0, shape=to_shape(edges), **varies))
    context.take(row, words_of("area load", q * unit[0], q * unit[1], unit[2]))


def _is_valid(context: ReadContext, row: Row, above: float) -> bool:
    """Return whether a free load acts on what lies so far above its plane, along its own z axis [m]."""
    validity = word(row, "validity")
    if validity == "from to":
        least, most = (context.number(row, key, "length") for key in ("validityfrom", "validityto"))
        return least - CLOSE <= above <= most + CLOSE
    if validity not in _VALID:
        raise RowFault("validity", describe(validity), "one of All, Z zero, Plus Z, Minus Z, From to")
    side = 0 if abs(above) <= CLOSE else 1 if above > 0 else 2
    return _VALID[validity][side]


def _own_axes(corners: Sequence[Place], up: float) -> Axes:
    """Return the local axes of a free load: x from its first place to the second, z up or down."""
    (ax, ay), (bx, by) = corners[:2]
    length = math.dist((ax, ay), (bx, by))
    if length < CLOSE:
        raise RowFault("coordinatex", "a first and a second place that are one", "places apart, for local axes")
    x: Vector = ((bx - ax) / length, (by - ay) / length, 0.0)
    z: Vector = (0.0, 0.0, up)
    return x, cross(z, x), z


def _corner_values(context: ReadContext, row: Row) -> list[tuple[int, float]]:
    """Return the pressures of a free load by the number of the corner, 0 where it is the same everywhere."""
    pressures = []
    for part in texts(row, "q"):
        name, _, value = part.rpartition(":")
        number = name.strip().upper().removeprefix("C")
        if name and not number.isdigit():
            raise RowFault("q", describe(part), "a pressure, or some such as C1:-5; C2:-7")
        bare = Row(row.sheet, row.number, {"q": value}, row.units)
        pressures.append((int(number) if name else 0, context.number(bare, "q", "pressure")))
    if not pressures:
        raise RowFault("q", "nothing", "a pressure")
    return pressures


def _plane(
    row: Row, corners: Sequence[Place], values: Sequence[tuple[int, float]], distribution: str
) -> tuple[float, tuple[float, float], Place]:
    """Return a pressure at a place, its growth along x and y, and the place: the plane through the corners' values."""
    if distribution == "uniform" or len(values) == 1:
        return values[0][1], (0.0, 0.0), (0.0, 0.0)
    if any(not 1 <= number <= len(corners) for number, _ in values):
        raise RowFault("q", text(row, "q"), f"corners C1 to C{len(corners)}")
    (first, q), *others = values
    x0, y0 = corners[first - 1]
    rows = [(corners[number - 1][0] - x0, corners[number - 1][1] - y0, value - q) for number, value in others]
    if distribution.replace(" ", "") == "directionxy" and len(rows) == 2:
        (ax, ay, da), (bx, by, db) = rows
        twice = ax * by - ay * bx
        if abs(twice) < CLOSE**2:
            raise RowFault("q", text(row, "q"), "three corners that are not on a line")
        return q, ((da * by - db * ay) / twice, (ax * db - bx * da) / twice), (x0, y0)
    # along the load's own x axis, from its first corner to its second one, or across it
    (ux, uy), (vx, vy) = corners[0], corners[1 % len(corners)]
    length = math.dist((ux, uy), (vx, vy))
    if len(rows) != 1 or length < CLOSE or "direction" not in distribution:
        raise RowFault("q", text(row, "q"), "two corners, or three for DirectionXY")
    ex, ey = (vx - ux) / length, (vy - uy) / length
    if distribution.replace(" ", "") == "directiony":
        ex, ey = -ey, ex
    along = rows[0][0] * ex + rows[0][1] * ey
    if abs(along) < CLOSE:
        raise RowFault("q", text(row, "q"), "corners apart in the direction in which the load varies")
    return q, (rows[0][2] / along * ex, rows[0][2] / along * ey), (x0, y0)
