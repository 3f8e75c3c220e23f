"""Loads along lines and on areas, walls, and their values."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from groundslab import units
from groundslab.errors import Issue
from groundslab.exchange.dxf.chaining import ClosedCurve, PointIndex
from groundslab.exchange.dxf.classify import EnclosingCurves, faces_of_wall, report_taken
from groundslab.exchange.dxf.curves import DrawnLine
from groundslab.exchange.dxf.document import Roles
from groundslab.exchange.dxf.drawing import DOUBLE, GAP, AreaMark, LineMark, ReadContext, Source
from groundslab.exchange.dxf.loads import labelling
from groundslab.geometry.plan import Place, Ring, Segment, segment
from groundslab.schema.wording import describe

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

CHORDS = 16  # of an arc, to see what is near it


def read_lines_with_values(
    role: str,
    lines: Sequence[tuple[Source, DrawnLine]],
    texts: Sequence[labelling.Label],
    roles: Roles,
    tolerance: float,
    context: ReadContext,
) -> list[LineMark]:
    """Return line loads, or walls, with the values that stand beside them or in the names of their layers."""
    from shapely import LineString

    nodes, middles = PointIndex(tolerance), PointIndex(tolerance)
    seen: set[frozenset[tuple[int, int, int]]] = set()
    marks: list[labelling.PendingLoad] = []
    drawn: list[list[tuple[Place, Place, float]]] = []
    widths: list[float] = []
    for source, piece in lines:
        parts = [
            (a, b, bulge)
            for (a, b), bulge in zip(pairwise(piece.points), piece.bulges, strict=True)
            if math.dist(a, b) > tolerance
        ]
        edges = [segment(*edge) for edge in parts]
        ends = [sorted((nodes.number(a), nodes.number(b))) for a, b, _ in parts]
        key = frozenset((a, b, middles.number(edge.middle)) for (a, b), edge in zip(ends, edges, strict=True))
        if not parts or key in seen:
            context.report_entity(source, False, DOUBLE if parts else "it has no length")
            continue
        seen.add(key)
        drawn.append(parts)
        widths.append(piece.width)
        start = edges[0].start
        marks.append(
            labelling.PendingLoad(source, start, LineString([start, *(p for edge in edges for p in divide_edge(edge))]))
        )
    labelling.assign_texts(marks, texts, role, context)
    defaults = _read_layer_values([mark.source.layer for mark in marks], role, roles, context)
    loads = []
    for mark, parts, width in zip(marks, drawn, widths, strict=True):
        value, how = labelling.choose_value(mark, role, context, defaults)
        starts, ends_of, bulges = zip(*parts, strict=True)
        closed = len(parts) > 1 and math.dist(starts[0], ends_of[-1]) <= tolerance
        points = starts if closed else (*starts, ends_of[-1])
        if role == "walls":
            faces = faces_of_wall(points, bulges) if closed else None
            # walls along all four edges of a strip are thinner than half of it
            if faces is not None and (value is None or value > faces[1] / 2):
                (points, width), bulges = faces, (0.0,)
            by = "its two faces" if faces is not None else "the width of the line"
            if value is None and width:
                value, how = width, f" of {units.show(width, 'length')}, by {by}"
            elif value is not None and width and abs(value - width) > GAP:
                said, is_drawn = (units.show(size, "length") for size in (value, width))
                why = f"a wall of {said} by its text or layer and of {is_drawn} by {by}: {said} counts"
                context.report_entity(Source(mark.source.layer, "LAYER", ""), True, why)
        context.report_entity(mark.source, True, f"{role.replace('_', ' ').removesuffix('s')}{how}")
        loads.append(LineMark(points, bulges, value, labelling.join_texts(mark)))
    return loads


def read_area_loads(
    curves: list[ClosedCurve], texts: Sequence[labelling.Label], roles: Roles, context: ReadContext
) -> list[AreaMark]:
    """Return the area loads with the values that stand in or beside them or in the names of their layers.

    A curve without a value of its own is a hole of the area in which it lies.
    """
    from shapely import Polygon

    shapes = [_valid(Polygon([p for edge in closed.curve.segments() for p in divide_edge(edge)])) for closed in curves]
    marks = [
        labelling.PendingLoad(closed.sources[0], closed.curve.points[0], shape, closed.curve.area)
        for closed, shape in zip(curves, shapes, strict=True)
    ]
    labelling.assign_texts(marks, texts, "area_loads", context)
    defaults = _read_layer_values([mark.source.layer for mark in marks], "area_loads", roles, context)
    holders = EnclosingCurves(curves, context)
    hole_of: dict[int, int] = {}
    for number in sorted(range(len(curves)), key=lambda index: -curves[index].curve.area):
        outer = holders.find(curves[number].curve.points, last=True)
        if outer is not None and outer not in hole_of and not marks[number].values:
            hole_of[number] = outer
        holders.add(number)
    order = [number for number in range(len(curves)) if number not in hole_of]
    loads = {number: position for position, number in enumerate(order, 1)}
    holes: dict[int, list[Ring]] = defaultdict(list)
    for hole, outer in hole_of.items():
        holes[outer].append(curves[hole].curve)
    areas = []
    for number in order:
        value, how = labelling.choose_value(marks[number], "area_loads", context, defaults)
        report_taken(curves[number], f"area load {loads[number]}{how}", context)
        areas.append(AreaMark(curves[number].curve, tuple(holes[number]), value, labelling.join_texts(marks[number])))
    for hole, outer in hole_of.items():
        report_taken(curves[hole], f"hole in area load {loads[outer]}, as it has no value", context)
    return areas


def divide_edge(edge: Segment) -> list[Place]:
    """Return points along an edge, its end the last of them."""
    if edge.straight:
        return [edge.end]
    places: list[Place] = edge.at(np.arange(1, CHORDS + 1) / CHORDS).tolist()
    return places


def _valid(polygon: BaseGeometry) -> BaseGeometry:
    """Return a polygon, or the rectangle around it if it crosses itself, which is an issue of its own."""
    return polygon if polygon.is_valid else polygon.envelope


def _read_layer_values(names: Sequence[str], role: str, roles: Roles, context: ReadContext) -> dict[str, float]:
    """Return the values that stand in names of layers; what is meant as one and is none is an issue."""
    values = {}
    for name in dict.fromkeys(names):
        value = labelling.find_layer_quantity(roles.suffix(name), labelling.DIMENSION[role])
        if isinstance(value, float):
            values[name] = value
        elif value is not None:
            where, expected = f"{context.path}, layer {describe(name)}", units.expectation(labelling.DIMENSION[role])
            context.add(Issue(where, describe(roles.suffix(name)), expected, value))
    return values
