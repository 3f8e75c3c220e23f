"""What carries the slab: ground given by C1 and C2, supports at points and along lines."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from groundslab.exchange.saf.reading.context import ReadContext, RowFault, text, word
from groundslab.exchange.saf.reading.geometry import CLOSE, Edge, join, to_shape
from groundslab.exchange.saf.reading.slab import Slab
from groundslab.exchange.saf.reading.workbook import Row
from groundslab.geometry.plan import Place, make_segments
from groundslab.model.ground import AnyGround, Pasternak, Winkler
from groundslab.model.structure.lines import part_of_line
from groundslab.model.supports import LineSupport, PointSupport
from groundslab.model.varying_ground import SoilZone
from groundslab.schema.wording import describe, listed

_WAYS = ("rigid", "free", "flexible", "compression only", "tension only", "flexible compression only",
         "flexible tension only")  # fmt: skip
Path = tuple[tuple[Place, ...], tuple[float, ...]]


def read_ground(context: ReadContext, slab: Slab) -> tuple[AnyGround | None, tuple[SoilZone, ...]]:
    """Return the ground under the whole slab, None if there is none, and that of its regions."""
    whole, parts = list[tuple[float, float]](), list[tuple[str, tuple[float, float]]]()
    for row in context.rows("StructuralSurfaceConnection"):
        if text(row, "2dmember") != slab.name:
            context.leave(row, f"it supports {text(row, '2dmember') or 'nothing'}")
            continue
        with context.reading(row):
            region = text(row, "2dmemberregion")
            if region and region not in slab.regions:
                raise RowFault("2dmemberregion", describe(region), f"a region of {slab.name}")
            stiffness = _read_stiffness(context, row)
            parts += [(region, stiffness)] if region else []
            whole += [] if region else [stiffness]
            context.take(row, f"ground {'of a part' if region else 'under the slab'}: k0 = C1z, k1 = C2")
    if len(whole) > 1:
        context.note(None, f"{len(whole)} under all of the slab, added up", "StructuralSurfaceConnection")
    total = (sum(k0 for k0, _ in whole), sum(k1 for _, k1 in whole))
    shear = any(k1 > 0 for _, k1 in [total, *(stiffness for _, stiffness in parts)])
    zones = tuple(
        SoilZone(shape=to_shape(slab.regions[region]), ground=_make_ground(stiffness, shear))
        for region, stiffness in parts
    )
    return _make_ground(total, shear) if whole else None, zones


def _read_stiffness(context: ReadContext, row: Row) -> tuple[float, float]:
    """Return C1z [Pa/m] and the mean of C2x and C2y [Pa m]; raises RowFault where there is no spring."""
    C1z = context.number(row, "c1z", "surface stiffness")
    C2x, C2y = (context.number(row, key, "shear stiffness", 0.0) for key in ("c2x", "c2y"))
    if C1z <= 0 or min(C2x, C2y) < 0:
        raise RowFault("c1z", f"C1z {C1z:g}, C2x {C2x:g}, C2y {C2y:g}", "C1z above 0, C2x and C2y not below")
    if C2x != C2y:
        context.note(row, f"C2x and C2y that differ, taken as their mean, {(C2x + C2y) / 2e6:g} MN/m")
    if any(context.number(row, key, "surface stiffness", 0.0) for key in ("c1x", "c1y")):
        context.note(row, "C1x and C1y, left out: the slab only bends")
    return C1z, float(f"{(C2x + C2y) / 2:.14g}")


def _make_ground(stiffness: tuple[float, float], shear: bool) -> AnyGround:
    k0, k1 = stiffness
    return Pasternak(k0=k0, k1=k1) if shear else Winkler(k=k0)


def read_supports(context: ReadContext, slab: Slab) -> list[PointSupport | LineSupport]:
    """Return the supports of the slab at nodes, along edges and along ribs."""
    supports = list[PointSupport | LineSupport]()
    for row in context.rows("StructuralPointSupport"):
        with context.reading(row):
            supports += _read_point_support(context, row, slab)
    lines = list[tuple[Row, LineSupport]]()
    for row in context.rows("StructuralEdgeConnection"):
        with context.reading(row):
            edges = find_edges(row, slab, text(row, "boundarycondition"))
            lines += [(row, support) for support in _read_line_support(context, row, edges)]
    for row in context.rows("StructuralCurveConnection"):
        with context.reading(row):
            edges = slab.ribs.get(text(row, "memberrib"), ())
            lines += [(row, support) for support in _read_line_support(context, row, edges)]
    return [*supports, *_join_rows(context, lines)]


def _join_rows(context: ReadContext, lines: Sequence[tuple[Row, LineSupport]]) -> list[LineSupport]:
    """Return line supports, rows of one name as one where they adjoin and are alike; issues are the context's."""
    parts: dict[str, list[tuple[Row, LineSupport]]] = {}
    for row, support in lines:
        parts.setdefault(support.name or f"row {row.number} of {row.sheet}", []).append((row, support))
    joined = []
    for (_, support), *left in parts.values():
        while adjoining := next((pair for pair in left if _chain(support, pair[1])), None):
            left.remove(adjoining)
            support = support.replace(points=_chain(support, adjoining[1]))
        joined.append(support)
        for row, _ in left:
            with context.reading(row):
                repetition = f"support {describe(support.name)} again, apart from its other rows or unlike them"
                raise RowFault("", repetition, "parts that adjoin, as stiff and fixed as each other, or another name")
    return joined


def _chain(support: LineSupport, other: LineSupport) -> tuple[Place, ...]:
    """Return the points of two parts of a support in order; none if they are unlike or do not adjoin."""
    if support.replace(points=other.points) != other:
        return ()
    for first in (support.points, support.points[::-1]):
        for second in (other.points, other.points[::-1]):
            if math.dist(first[-1], second[0]) <= CLOSE and not _overlap(first, second):
                (ax, ay), (bx, by), (cx, cy) = first[-2], first[-1], second[1]
                turn = (bx - ax) * (cy - by) - (by - ay) * (cx - bx)
                straight = abs(turn) <= CLOSE * math.dist(first[-2], second[1])
                return (*(first[:-1] if straight else first), *second[1:])
    return ()


def _overlap(first: Sequence[Place], second: Sequence[Place]) -> bool:
    """Return whether the second line goes back along the first one from where that ends."""
    (ax, ay), (bx, by), (cx, cy) = first[-2], first[-1], second[1]
    along = (bx - ax) * (cx - bx) + (by - ay) * (cy - by)
    across = (bx - ax) * (cy - by) - (by - ay) * (cx - bx)
    return along < 0 and abs(across) <= CLOSE * math.dist(first[-1], second[1])


def _read_vertical(context: ReadContext, row: Row, quantity: str) -> dict[str, Any] | None:
    """Return how a support acts vertically and how stiff it is, None if it is free."""
    # local axes of edges and ribs have the slab's z, which goes up or down as the file's vertical axis
    is_local = word(row, "coordinatesystem") == "local" and row.sheet != "StructuralPointSupport"
    letter = "z" if is_local else "xyz"[max(range(3), key=lambda axis: abs(context.axes[2][axis]))]
    sideways = [f"u{axis}" for axis in "xyz" if axis != letter and word(row, f"u{axis}", default="free") != "free"]
    if sideways:
        context.note(row, "what holds it sideways, left out: the slab only bends")
    way = word(row, f"u{letter}", (*_WAYS, "non linear"))
    if way == "non linear":
        raise RowFault(f"u{letter}", '"Non linear"', listed(list(_WAYS)), "such a support is given by hand")
    values: dict[str, Any] = {}
    if "flexible" in way:
        values["stiffness"] = context.number(row, f"stiffness{letter}", quantity)
        if values["stiffness"] <= 0:
            raise RowFault(f"stiffness{letter}", text(row, f"stiffness{letter}"), "more than 0")
    elif stiff := context.number(row, f"stiffness{letter}", quantity, 0.0):
        unit = "N/m" if quantity == "point stiffness" else "N/m2"
        context.note(row, f"u{letter} {describe(way)} with a stiffness of {stiff / 1e6:g} M{unit}, taken as {way}")
    if way == "free":
        return None
    if "only" in way:
        # compression only keeps the member from moving against the axis, which goes up or down
        pushes = ("compression" in way) == (context.upwards > 0)
        values["acts"] = "in compression" if pushes else "in tension"
    return values


def _read_point_support(context: ReadContext, row: Row, slab: Slab) -> list[PointSupport]:
    """Return the support at a node of the slab, none if it is elsewhere."""
    if word(row, "boundarycondition", default="in node") != "in node" or not text(row, "node"):
        context.leave(row, "it supports a member")
        return []
    x, y, height = context.node(text(row, "node"))
    if abs(height - slab.height) > CLOSE or not slab.holds((x, y)):
        context.leave(row, "it is not at the slab")
        return []
    acts = _read_vertical(context, row, "point stiffness")
    if acts is None:
        context.leave(row, "it is free vertically")
        return []
    flat = [axis for axis in range(3) if context.axes[2][axis] == 0]
    turning = [word(row, f"fi{'xyz'[axis]}", ("rigid", "free", "flexible", "non linear"), "free") for axis in flat]
    if turning == ["rigid", "rigid"]:
        acts["rotation"] = "fixed"
    elif turning == ["flexible", "flexible"]:
        stiff = [context.number(row, f"stiffnessfi{'xyz'[axis]}", "rotational stiffness") for axis in flat]
        if min(stiff) > 0:
            acts["rotational_stiffness"] = sum(stiff) / 2
        if stiff[0] != stiff[1]:
            context.note(row, "rotational stiffnesses that differ, taken as their mean")
    elif turning != ["free", "free"]:
        context.note(row, f"rotations that are {turning[0]} and {turning[1]}, taken as free")
    context.take(row, "support")
    return [PointSupport(name=row.name, x=x, y=y, **acts)]


def find_edges(row: Row, slab: Slab, on: str) -> tuple[Edge, ...]:
    """Return the edges that a load or support of the slab runs along, none if it is not the slab's."""
    member = text(row, "2dmember")
    on = " ".join(on.lower().split()) or ("on internal edge" if text(row, "internaledge") else "on edge")
    if on == "on internal edge":
        return slab.internal.get(text(row, "internaledge"), ())
    if on == "on rib":
        return slab.ribs.get(text(row, "memberrib"), ())
    if on == "on edge" and member in slab.walls:
        number, edge = slab.walls[member]
        return (edge,) if text(row, "edge") == str(number) else ()
    curves = {
        "on edge": slab.edges if member == slab.name else (),
        "on subregion edge": slab.regions.get(text(row, "2dmemberregion"), ()),
        "on opening edge": slab.openings.get(text(row, "2dmemberopening"), ()),
    }
    edges = curves.get(on, ())
    if not edges:
        return ()
    number_text = text(row, "edge")
    if not number_text.isdigit() or not 1 <= int(number_text) <= len(edges):
        raise RowFault("edge", describe(number_text), f"the number of an edge, 1 to {len(edges)}")
    return (edges[int(number_text) - 1],)


def loaded_part(context: ReadContext, row: Row, edges: Sequence[Edge]) -> Path:
    """Return the part of edges on which a load or support acts, from its origin on; raises RowFault."""
    points, bulges = join(edges)
    if word(row, "origin", default="from start") == "from end":
        points, bulges = points[::-1], tuple(-bulge for bulge in bulges[::-1])
    line = make_segments(points, bulges)
    length = sum(edge.length for edge in line)
    relative = word(row, "coordinatedefinition", default="relative") == "relative"
    bare = Row(row.sheet, row.number, row.cells, {}) if relative else row
    quantity = "number" if relative else "length"
    start = context.number(bare, "startpoint", quantity, 0.0) * (length if relative else 1.0)
    end = context.number(bare, "endpoint", quantity, 1.0 if relative else length) * (length if relative else 1.0)
    if start <= CLOSE and end >= length - CLOSE:
        return points, bulges
    if end - start < CLOSE or start > length - CLOSE:
        raise RowFault("startpoint", f"from {start:g} m to {end:g} m", f"a part of the edge's {length:.6g} m")
    return part_of_line(line, start, end)


def _read_line_support(context: ReadContext, row: Row, edges: tuple[Edge, ...]) -> list[LineSupport]:
    """Return the support along edges, none if there are none, or if they are arcs."""
    if not edges:
        context.leave(row, "it is not at the slab")
        return []
    acts = _read_vertical(context, row, "line stiffness")
    if acts is None:
        context.leave(row, "it is free vertically")
        return []
    points, bulges = loaded_part(context, row, edges)
    if any(bulges):
        context.leave(row, "it follows an arc; supports run along straight lines")
        return []
    turning = _turning(context, row, points)
    if turning == "rigid" and "stiffness" not in acts and "acts" not in acts:
        acts["rotation"] = "fixed"
    elif turning != "free":
        context.note(row, f"turning about its line that is {turning}, taken as free")
    context.take(row, "support along a line")
    return [LineSupport(name=row.name, points=points, **acts)]


def _turning(context: ReadContext, row: Row, points: tuple[Place, ...]) -> str:
    """Return how a support lets the slab turn about its line."""
    if word(row, "coordinatesystem", default="global") == "local":
        return word(row, "fix", default="free")
    (ax, ay), (bx, by) = points[0], points[-1]
    length = math.hypot(bx - ax, by - ay)
    line = ((bx - ax) / length, (by - ay) / length) if length > 0 else (0.0, 0.0)
    # rotations about those axes of the file that have a part along the line
    parts = [abs(context.axes[0][axis] * line[0] + context.axes[1][axis] * line[1]) for axis in range(3)]
    ways = {word(row, f"fi{'xyz'[axis]}", default="free") for axis in range(3) if parts[axis] > CLOSE}
    if len(ways) > 1:
        context.note(row, f"turning about its line that is {listed(sorted(ways), 'and')}, taken as free")
    return ways.pop() if len(ways) == 1 else "free"
