"""Loads on the slab: at nodes, along edges and over areas, free or not, and its own weight."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

from groundslab.case.saf.reading.context import ReadContext, RowFault, Vector, text, texts, word
from groundslab.case.saf.reading.geometry import CLOSE, Edge, join, make_edges, to_circle, to_ring, to_shape
from groundslab.case.saf.reading.ground import Path, find_edges, loaded_part
from groundslab.case.saf.reading.slab import Slab, slab_axes
from groundslab.case.saf.reading.workbook import Row
from groundslab.geometry.plan import Place, make_segments
from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.loads.load_cases import LoadCase
from groundslab.model.loads.load_types import AnyLoad, AreaLoad, PointLoad, SelfWeight, TemperatureLoad, UniformLoad
from groundslab.model.structure.columns import Column
from groundslab.schema.wording import describe

#: Components below this share of a vector are nothing but rounding.
ROUNDING = 1e-9


@dataclass(slots=True)
class Loads:
    """Loads as they are read, the forces and moments at a place by case and place, horizontal forces by case [N]."""

    loads: list[AnyLoad] = field(default_factory=list)
    points: dict[tuple[str, Place], dict[str, Any]] = field(default_factory=dict)
    horizontal: dict[str, list[float]] = field(default_factory=lambda: defaultdict(lambda: [0.0, 0.0]))

    def push(self, case: str, x: float, y: float) -> None:
        """Add a horizontal force to a case [N]."""
        self.horizontal[case][0] += x
        self.horizontal[case][1] += y

    def finish(self, columns: Sequence[Column]) -> list[AnyLoad]:
        """Return all loads, those at points last, on the columns that stand there."""
        known = {(column.x, column.y): column.name for column in columns}
        return [*self.loads, *(_make_point_load(*key, values, known) for key, values in self.points.items())]


def read_loads(context: ReadContext, slab: Slab, cases: Sequence[LoadCase], beams: bool) -> Loads:
    """Return the loads of the slab; what acts elsewhere in the building is left."""
    found = Loads()
    names = {case.name for case in cases}
    _read_self_weight(context, slab, found, beams)
    readers = {
        "StructuralPointAction": _read_point_action,
        "StructuralPointActionFree": _read_point_action,
        "StructuralPointMoment": _read_point_moment,
        "StructuralCurveAction": _read_curve_action,
        "StructuralCurveActionFree": _read_free_curve_action,
        "StructuralCurveMoment": _read_curve_moment,
        "StructuralSurfaceAction": _read_surface_action,
        "StructuralSurfaceActionFree": _read_free_surface_action,
        "StructuralSurfaceActionThermal": _read_temperature,
    }
    for sheet, reader in readers.items():
        for row in context.rows(sheet):
            with context.reading(row):
                case = text(row, "loadcase")
                if case not in names:
                    raise RowFault("loadcase", f"the case {describe(case)}", "one of sheet StructuralLoadCase")
                reader(context, row, slab, found)
    return found


def _make_point_load(case: str, place: Place, values: dict[str, Any], columns: dict[Place, str]) -> PointLoad:
    """Return the load at a place, on the column that stands there if one does."""
    column = columns.get(place)
    where = {"column": column} if column in values["columns"] else {"x": place[0], "y": place[1]}
    moments = {name: values[name] for name in ("M_x", "M_y")}
    return PointLoad(name=values["name"], case=case, P=values["P"], **moments, **where)


def add_at_point(
    found: Loads, case: str, place: Place, name: str, columns: Sequence[str] = (), **values: float
) -> None:
    """Add force or moments at a place to those of the same case there, which keep the name of the first."""
    nothing = {"P": 0.0, "M_x": 0.0, "M_y": 0.0, "name": name, "columns": set()}
    at_place = found.points.setdefault((case, place), nothing)
    at_place["columns"] |= set(columns)
    for key, value in values.items():
        at_place[key] += value


def _read_self_weight(context: ReadContext, slab: Slab, found: Loads, beams: bool) -> None:
    """Add the weight of the slab to the cases of self-weight."""
    for row in context.rows("StructuralLoadCase"):
        if word(row, "loadtype") == "self weight":
            found.loads.append(SelfWeight(case=row.name, unit_weight=slab.material.unit_weight, beams=beams))
            context.note(row, "the weight of the slab and its ribs; that of what stands on it is not known")


def _vector(
    context: ReadContext, row: Row, slab: Slab, quantity: str, number: str = "", value: str = "value"
) -> Vector:
    """Return the force of a row in plan x, plan y and up, by its direction or as a vector."""
    direction = word(row, "direction", ("x", "y", "z", "vector"))
    if direction == "vector":
        key = f"vector{number}xyz"
        parts = text(row, key).strip("()[] ").split(";")
        bare = [Row(row.sheet, row.number, {key: part}, row.units) for part in parts]
        if len(parts) != 3:
            raise RowFault(key, describe(text(row, key)), "three numbers such as (10;10;0)")
        x, y, z = (context.number(each, key, quantity) for each in bare)
    else:
        size = context.number(row, f"{value}{number}", quantity)
        x, y, z = (size if direction == axis else 0.0 for axis in "xyz")
    if word(row, "coordinatesystem", default="global") in ("local", "member lcs"):
        axes = slab_axes(context, slab)
        local = [x * axes[0][i] + y * axes[1][i] + z * axes[2][i] for i in range(3)]
        return local[0], local[1], local[2]
    return context.turned((x, y, z))


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


def _read_point_action(context: ReadContext, row: Row, slab: Slab, found: Loads) -> None:
    """Add a force at a node, or a free one."""
    place = _node_of(context, row, slab)
    if place is None:
        return
    # local axes of nodes are those of the file
    x, y, up = _vector(
        context, Row(row.sheet, row.number, {**row.cells, "coordinatesystem": "Global"}, row.units), slab, "force"
    )
    case = text(row, "loadcase")
    found.push(case, x, y)
    if up:
        on = [name for name, at in slab.columns.items() if at == place and row.sheet == "StructuralPointAction"]
        add_at_point(found, case, place, row.name, on, P=-up)
    context.take(row, _taken("point load", x, y, up))


def _taken(what: str, x: float, y: float, up: float) -> str:
    """Return as what a load was taken: what acts, and horizontal forces of the case."""
    flat = math.hypot(x, y) > ROUNDING * abs(up)
    return " and ".join([what] * (up != 0) + ["horizontal forces of its case"] * flat) or "a load of 0"


def _read_point_moment(context: ReadContext, row: Row, slab: Slab, found: Loads) -> None:
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
    add_at_point(found, text(row, "loadcase"), place, row.name, on, M_x=y + 0.0, M_y=-x + 0.0)
    context.take(row, "moment of a point load")


def _line_values(context: ReadContext, row: Row, slab: Slab) -> tuple[Vector, Vector]:
    """Return the force per length at the start and at the end of a line load."""
    start = _vector(context, row, slab, "line force", "1")
    trapez = word(row, "distribution", default="uniform").startswith("trapez")
    return start, _vector(context, row, slab, "line force", "2") if trapez else start


def _read_curve_action(context: ReadContext, row: Row, slab: Slab, found: Loads) -> None:
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
    start, end = _line_values(context, row, slab)
    path = loaded_part(context, row, edges)
    whole = wall and path == join(edges)
    _add_line(found, row, path, start, end, wall if whole else "")
    context.take(row, _taken("line load", *(a if a else b for a, b in zip(start, end, strict=True))))


def _add_line(found: Loads, row: Row, path: Path, start: Vector, end: Vector, wall: str = "") -> None:
    """Add a line load, and its horizontal part to its case."""
    points, bulges = path
    case = text(row, "loadcase")
    length = sum(edge.length for edge in make_segments(points, bulges))
    found.push(case, length * (start[0] + end[0]) / 2, length * (start[1] + end[1]) / 2)
    if not start[2] and not end[2]:
        return
    varies = {"q_end": -end[2]} if end[2] != start[2] else {}
    where: dict[str, Any] = {"wall": wall} if wall else {"points": points, "bulges": bulges}
    if not wall and not varies and (circle := to_circle(points, bulges)) is not None:
        where = {"shape": circle}
    found.loads.append(LineLoad(name=row.name, case=case, q=-start[2], **varies, **where))


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


def _read_free_curve_action(context: ReadContext, row: Row, slab: Slab, found: Loads) -> None:
    """Add a free force along a line in the slab's plane."""
    edges, _ = _free_edges(context, row, closed=False)
    if not all(edge.level(slab.height) for edge in edges):
        context.leave(row, "it is not in the slab's plane")
        return
    start, end = _line_values(context, row, slab)
    _add_line(found, row, join(edges), start, end)
    context.take(row, _taken("line load", *(a if a else b for a, b in zip(start, end, strict=True))))


def _read_curve_moment(context: ReadContext, row: Row, slab: Slab, found: Loads) -> None:
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
    found.loads.append(LineMoment(name=row.name, case=text(row, "loadcase"), m=m[0], **varies, **where))
    context.take(row, "line moment")


def _share_along(context: ReadContext, points: Sequence[Place], direction: str) -> float:
    """Return the share of a global moment that acts about a straight line, with its sign; 0 where they differ."""
    shares = set()
    x, y, _ = context.turned(tuple(1.0 if direction[1] == axis else 0.0 for axis in "xyz"))  # type: ignore[arg-type]
    for a, b in pairwise(points):
        length = math.dist(a, b)
        shares.add(round(((b[0] - a[0]) * x + (b[1] - a[1]) * y) / length, 12) if length else 0.0)
    return shares.pop() if len(shares) == 1 else 0.0


def _read_surface_action(context: ReadContext, row: Row, slab: Slab, found: Loads) -> None:
    """Add a pressure on the slab or on a region of it."""
    region, member = text(row, "2dmemberregion"), text(row, "2dmember")
    on = word(row, "forceaction")
    if "distribution" in on or (region not in slab.regions if region else member != slab.name):
        context.leave(row, "it does not act on the slab")
        return
    x, y, up = _vector(context, row, slab, "pressure")
    case = text(row, "loadcase")
    area = to_ring(slab.regions[region]).area if region else float(slab.area.area)
    found.push(case, x * area, y * area)
    if up and region:
        shape = to_shape(slab.regions[region])
        found.loads.append(AreaLoad(name=row.name, case=case, q=-up, shape=shape))
    elif up:
        found.loads.append(UniformLoad(name=row.name, case=case, q=-up))
    context.take(row, _taken("pressure", x, y, up))


def _read_free_surface_action(context: ReadContext, row: Row, slab: Slab, found: Loads) -> None:
    """Add a free pressure on a part of the slab's plane, constant or linear."""
    edges, corners = _free_edges(context, row, closed=True)
    if not all(edge.level(slab.height) for edge in edges):
        context.leave(row, "it is not in the slab's plane, and how it is projected is not read")
        return
    values = _corner_values(context, row)
    q, (gx, gy), about = _plane(row, corners, values, word(row, "distribution", default="uniform"))
    unit = _vector(context, Row(row.sheet, row.number, {**row.cells, "value": 1.0}, {}), slab, "number")
    shape, case = to_shape(edges), text(row, "loadcase")
    area = shape.ring().area
    found.push(case, q * unit[0] * area, q * unit[1] * area)
    down = -unit[2]
    if down:
        varies = {"slope": (gx * down + 0.0, gy * down + 0.0), "about": about} if gx or gy else {}
        found.loads.append(AreaLoad(name=row.name, case=case, q=q * down + 0.0, shape=shape, **varies))
    elif gx or gy:
        context.note(row, "a horizontal load that varies: its mean is not that of its corners")
    context.take(row, _taken("area load", q * unit[0], q * unit[1], unit[2]))


def _corner_values(context: ReadContext, row: Row) -> list[tuple[int, float]]:
    """Return the pressures of a free load by the number of the corner, 0 where it is the same everywhere."""
    found = []
    for part in texts(row, "q"):
        name, _, value = part.rpartition(":")
        number = name.strip().upper().removeprefix("C")
        if name and not number.isdigit():
            raise RowFault("q", describe(part), "a pressure, or some such as C1:-5; C2:-7")
        bare = Row(row.sheet, row.number, {"q": value}, row.units)
        found.append((int(number) if name else 0, context.number(bare, "q", "pressure")))
    if not found:
        raise RowFault("q", "nothing", "a pressure")
    return found


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


def _read_temperature(context: ReadContext, row: Row, slab: Slab, found: Loads) -> None:
    """Add a difference of temperature between the faces of the slab."""
    if text(row, "2dmember") != slab.name:
        context.leave(row, "it does not act on the slab")
    elif text(row, "2dmemberregion"):
        context.leave(row, "a temperature of a part of the slab")
    elif word(row, "variation") != "linear":
        context.leave(row, "a temperature that does not bend the slab")
    else:
        top, bottom = (context.number(row, key, "temperature") for key in ("tempt", "tempb"))
        # the top is where the local z axis points
        difference = (bottom - top) * context.upwards
        found.loads.append(TemperatureLoad(name=row.name, case=text(row, "loadcase"), difference=difference + 0.0))
        context.take(row, "temperature")
