"""Loads on the slab: at nodes, along edges and over areas, free or not, and its own weight."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from groundslab.exchange.saf.reading.context import ReadContext, RowFault, cross, text, word
from groundslab.exchange.saf.reading.geometry import CLOSE, Edge, join, to_ring, to_shape
from groundslab.exchange.saf.reading.ground import find_edges, loaded_part
from groundslab.exchange.saf.reading.loads.forces import (
    ROUNDING,
    Axes,
    Loads,
    add_at_point,
    add_line,
    line_values,
    read_vector,
    words_of,
)
from groundslab.exchange.saf.reading.loads.free import read_free_curve_action, read_free_surface_action
from groundslab.exchange.saf.reading.slab import Slab, slab_axes
from groundslab.exchange.saf.reading.workbook import Row
from groundslab.geometry.areas import equal_area_polygon
from groundslab.geometry.plan import Place
from groundslab.model.loads.lines import LineMoment
from groundslab.model.loads.load_cases import LoadCase
from groundslab.model.loads.load_types import (
    AnyLoad,
    AreaLoad,
    SelfWeight,
    SettlementLoad,
    TemperatureLoad,
    UniformLoad,
)
from groundslab.model.supports import AnySupport
from groundslab.schema.wording import describe


def read_loads(context: ReadContext, slab: Slab, cases: Sequence[LoadCase], beams: bool) -> Loads:
    """Return the loads of the slab; what acts elsewhere in the building is left."""
    loads = Loads()
    names = {case.name for case in cases}
    _read_self_weight(context, slab, loads, beams)
    readers = {
        "StructuralPointAction": _read_point_action,
        "StructuralPointActionFree": _read_point_action,
        "StructuralPointMoment": _read_point_moment,
        "StructuralCurveAction": _read_curve_action,
        "StructuralCurveActionFree": read_free_curve_action,
        "StructuralCurveMoment": _read_curve_moment,
        "StructuralSurfaceAction": _read_surface_action,
        "StructuralSurfaceActionFree": read_free_surface_action,
        "StructuralSurfaceActionThermal": _read_temperature,
    }
    for sheet, reader in readers.items():
        for row in context.rows(sheet):
            with context.reading(row):
                case = text(row, "loadcase")
                if case not in names:
                    raise RowFault("loadcase", f"the case {describe(case)}", "one of sheet StructuralLoadCase")
                reader(context, row, slab, loads)
    return loads


def _read_self_weight(context: ReadContext, slab: Slab, loads: Loads, beams: bool) -> None:
    """Add the weight of the slab to the cases of self-weight."""
    for row in context.rows("StructuralLoadCase"):
        if word(row, "loadtype") == "self weight":
            loads.loads.append(SelfWeight(case=row.name, unit_weight=slab.material.unit_weight, beams=beams))
            context.note(row, "the weight of the slab and its ribs; that of what stands on it is not known")


def _node_of(context: ReadContext, row: Row, slab: Slab) -> Place | None:
    """Return the place of a load at a node of the slab, None if it acts elsewhere, which is reported."""
    if "coordinatex" in row.cells and row.sheet == "StructuralPointActionFree":
        x, y, height = context.turned(
            (context.number(row, "coordinatex", "length"), context.number(row, "coordinatey", "length"),
             context.number(row, "coordinatez", "length"))
        )  # fmt: skip
    elif word(row, "forceaction", default="in node") != "in node":
        context.leave(row, f"it acts on {text(row, 'referencemember') or 'a member'}, not on the slab")
        return None
    else:
        x, y, height = context.node(text(row, "referencenode"))
    if abs(height - slab.height) > CLOSE or not slab.holds((x, y)):
        context.leave(row, "it acts elsewhere in the building")
        return None
    return x, y


def _read_point_action(context: ReadContext, row: Row, slab: Slab, loads: Loads) -> None:
    """Add a force at a node, or a free one."""
    place = _node_of(context, row, slab)
    if place is None:
        return
    # local axes of nodes are those of the file
    bare = Row(row.sheet, row.number, {**row.cells, "coordinatesystem": "Global"}, row.units)
    x, y, up = read_vector(context, bare, "force", slab_axes(context, slab))
    case = text(row, "loadcase")
    loads.push(case, x, y)
    if up:
        on = [name for name, at in slab.columns.items() if at == place and row.sheet == "StructuralPointAction"]
        add_at_point(loads, case, place, row.name, on, P=-up)
    context.take(row, words_of("point load", x, y, up))


def _read_point_moment(context: ReadContext, row: Row, slab: Slab, loads: Loads) -> None:
    """Add a moment at a node: about y it presses larger x down, about x smaller y."""
    place = _node_of(context, row, slab)
    if place is None:
        return
    direction = word(row, "direction", ("mx", "my", "mz"))
    size = context.number(row, "value", "moment")
    x, y, up = context.turned(tuple(size if direction[1] == axis else 0.0 for axis in "xyz"))  # type: ignore[arg-type]
    if up:
        context.leave(row, "it turns about the vertical axis")
        return
    on = [name for name, at in slab.columns.items() if at == place]
    add_at_point(loads, text(row, "loadcase"), place, row.name, on, M_x=y + 0.0, M_y=-x + 0.0)
    context.take(row, "moment of a point load")


def _read_curve_action(context: ReadContext, row: Row, slab: Slab, loads: Loads) -> None:
    """Add a force along edges of the slab, along a wall on it, or along a rib."""
    edges = find_edges(row, slab, text(row, "forceaction"))
    if not edges:
        context.leave(row, "it does not act on the slab")
        return
    wall = text(row, "2dmember") if text(row, "2dmember") in slab.walls else ""
    if wall and word(row, "coordinatesystem", default="global") != "global":
        context.leave(row, "it has the local axes of a wall")
        return
    if any(context.number(row, key, "size", 0.0) for key in ("eccentricityey", "eccentricityez")):
        context.note(row, "its eccentricities, left out: it acts along its line")
    start, end = line_values(context, row, _axes_of(context, row, slab, edges))
    path = loaded_part(context, row, edges)
    whole = wall and path == join(edges)
    add_line(loads, row, path, start, end, slab, wall if whole else "")
    context.take(row, words_of("line load", *(a if a else b for a, b in zip(start, end, strict=True))))


def _axes_of(context: ReadContext, row: Row, slab: Slab, edges: Sequence[Edge]) -> Axes:
    """Return the local axes of a load along edges: those of the slab, on a rib those of the rib."""
    x, y, z = slab_axes(context, slab)
    if word(row, "forceaction") != "on rib" or word(row, "coordinatesystem") != "local":
        return x, y, z
    points, bulges = join(edges)
    (ax, ay), (bx, by) = points[0], points[-1]
    length = math.dist((ax, ay), (bx, by))
    off = (abs((by - ay) * (x - ax) - (bx - ax) * (y - ay)) for x, y in points)
    if length < CLOSE or any(bulges) or max(off) > CLOSE * length:
        raise RowFault("coordinatesystem", "local axes of a rib that is not straight", "Global")
    x = ((bx - ax) / length, (by - ay) / length, 0.0)
    return x, cross(z, x), z


def _read_curve_moment(context: ReadContext, row: Row, slab: Slab, loads: Loads) -> None:
    """Add a moment about a line: about its own direction, with its sign reversed (docs/howto/exchange_saf.md)."""
    edges = find_edges(row, slab, text(row, "forceaction"))
    if not edges:
        context.leave(row, "it does not act on the slab")
        return
    points, bulges = loaded_part(context, row, edges)
    direction = word(row, "direction", ("mx", "my", "mz"))
    sizes = [context.number(row, "value1", "line moment")]
    if word(row, "distribution", default="uniform").startswith("trapez"):
        sizes.append(context.number(row, "value2", "line moment"))
    if word(row, "coordinatesystem", default="global") == "local":
        share = 1.0 if direction == "mx" else 0.0
        if word(row, "origin", default="from start") == "from end":
            share = -share  # the edge's own axis runs from its start
    else:
        share = _share_along(context, points, direction) if not any(bulges) else 0.0
    if abs(share) < 1 - ROUNDING:
        context.leave(row, "a moment that is not about its line alone")
        return
    m = [-size * math.copysign(1.0, share) for size in sizes]
    wall = text(row, "2dmember") if text(row, "2dmember") in slab.walls else ""
    whole = wall and (points, bulges) == join(edges)
    where: dict[str, Any] = {"wall": wall} if whole else {"points": points, "bulges": bulges}
    varies = {"m_end": m[1]} if len(m) > 1 else {}
    loads.loads.append(LineMoment(name=row.name, case=text(row, "loadcase"), m=m[0], **varies, **where))
    context.take(row, "line moment")


def _share_along(context: ReadContext, points: Sequence[Place], direction: str) -> float:
    """Return the share of a global moment that acts about a straight line, with its sign; 0 where they differ."""
    shares = set()
    x, y, _ = context.turned(tuple(1.0 if direction[1] == axis else 0.0 for axis in "xyz"))  # type: ignore[arg-type]
    for a, b in pairwise(points):
        length = math.dist(a, b)
        shares.add(round(((b[0] - a[0]) * x + (b[1] - a[1]) * y) / length, 12) if length else 0.0)
    return shares.pop() if len(shares) == 1 else 0.0


def _read_surface_action(context: ReadContext, row: Row, slab: Slab, loads: Loads) -> None:
    """Add a pressure on the slab or on a region of it."""
    region, member = text(row, "2dmemberregion"), text(row, "2dmember")
    on = word(row, "forceaction")
    if "distribution" in on or (region not in slab.regions if region else member != slab.name):
        context.leave(row, "it does not act on the slab")
        return
    x, y, up = read_vector(context, row, "pressure", slab_axes(context, slab))
    case = text(row, "loadcase")
    if x or y:
        part = equal_area_polygon(to_ring(slab.regions[region])).intersection(slab.area) if region else slab.area
        loads.push(case, x * part.area, y * part.area)
    if up and region:
        shape = to_shape(slab.regions[region])
        loads.loads.append(AreaLoad(name=row.name, case=case, q=-up, shape=shape))
    elif up:
        loads.loads.append(UniformLoad(name=row.name, case=case, q=-up))
    context.take(row, words_of("pressure", x, y, up))


def _read_temperature(context: ReadContext, row: Row, slab: Slab, loads: Loads) -> None:
    """Add a difference of temperature between the faces of the slab."""
    if text(row, "2dmember") != slab.name:
        context.leave(row, "it does not act on the slab")
    elif text(row, "2dmemberregion"):
        context.leave(row, "a temperature of a part of the slab")
    elif word(row, "variation") != "linear":
        context.leave(row, "a temperature that does not bend the slab")
    else:
        top, bottom = (context.number(row, key, "temperature") for key in ("tempt", "tempb"))
        if top + bottom:
            context.note(row, f"its mean of {(top + bottom) / 2:g} K, left out: it does not bend the slab")
        # the top is where the local z axis points
        difference = (bottom - top) * context.upwards
        loads.loads.append(TemperatureLoad(name=row.name, case=text(row, "loadcase"), difference=difference + 0.0))
        context.take(row, "temperature")


def read_settlements(context: ReadContext, supports: Sequence[AnySupport], cases: Sequence[LoadCase]) -> list[AnyLoad]:
    """Return the settlements that are forced on the slab's supports at points."""
    at_points, names = {support.name for support in supports if support.kind == "point"}, {case.name for case in cases}
    upright = "xyz"[max(range(3), key=lambda axis: abs(context.axes[2][axis]))]
    loads = list[AnyLoad]()
    for row in context.rows("StructuralPointSupportDeformation"):
        with context.reading(row):
            support, case = text(row, "pointsupport"), text(row, "loadcase")
            if support not in at_points:
                context.leave(row, f"it moves {support or 'nothing'}, which does not support the slab")
            elif word(row, "direction", ("x", "y", "z", "rx", "ry", "rz")) != upright:
                context.leave(row, "it moves its support sideways, or turns it")
            elif case not in names:
                raise RowFault("loadcase", f"the case {describe(case)}", "one of sheet StructuralLoadCase")
            else:
                w = -context.number(row, "translationvalue", "size") * context.upwards + 0.0
                loads.append(SettlementLoad(name=row.name, case=case, support=support, w=w))
                context.take(row, "settlement of a support")
    return loads
