"""Loads as rows: at nodes, along lines and over areas."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.exchange.saf.units import from_si
from groundslab.exchange.saf.writing.cases import ALL_LOADS, by_material
from groundslab.exchange.saf.writing.sheets import Sheets
from groundslab.exchange.saf.writing.structure import middle, plate_at
from groundslab.geometry.areas import equal_area_polygon
from groundslab.geometry.plan import Ring, Segment
from groundslab.model.loads.acting import LineForce
from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.loads.load_types import (
    AreaLoad,
    PatchLoad,
    PointLoad,
    SelfWeight,
    SettlementLoad,
    TemperatureLoad,
    UniformLoad,
)
from groundslab.model.loads.placement import weights_of_pits
from groundslab.model.shapes import Rectangle
from groundslab.model.structure.lines import line_segments

if TYPE_CHECKING:
    from groundslab.model.model import Model


@dataclass(frozen=True, slots=True)
class Placed:
    """Where loads act: plates by name in the file, feet of columns, and walls with their members."""

    plates: Mapping[str, str]
    rings: Mapping[str, Ring]
    feet: Mapping[str, str]
    walls: Mapping[str, Sequence[tuple[str, Segment]]]


def write_loads(sheets: Sheets, model: Model, placed: Placed) -> None:
    """Write all loads but the self-weight of materials, and the horizontal forces of cases."""
    if any(isinstance(load, SelfWeight) and not load.beams for load in model.loads) and model.beams:
        sheets.leave("self-weight", "programs that read the file weigh the ribs, too")
    for number, load in enumerate(model.loads, start=1):
        what = f"load {load.name or number}"
        common = {"loadcase": load.case or ALL_LOADS}
        if isinstance(load, PointLoad):
            _write_point(sheets, load, common, placed, what)
        elif isinstance(load, LineLoad | LineMoment) and not (load.wall and len(model.shapes(load)) > 1):
            _write_line(sheets, load, common, placed, what)
        elif isinstance(load, UniformLoad):
            _write_uniform(sheets, load, common, placed, what)
        elif isinstance(load, PatchLoad | AreaLoad):
            _write_area(sheets, load, common, what)
        elif isinstance(load, TemperatureLoad):
            for plate in _plates_of(load.plate, placed):
                half = load.difference / 2
                sheets.add(
                    "StructuralSurfaceActionThermal",
                    load.name,
                    "LT",
                    variation="Linear",
                    tempt=-half + 0.0,
                    tempb=half,
                    **{"2dmember": plate},
                    **common,
                )
        elif isinstance(load, SettlementLoad):
            _write_settlement(sheets, load, common, what)
        elif isinstance(load, SelfWeight):
            if not by_material(model, load):
                _write_weight(sheets, model, load, common, placed)
            for line in weights_of_pits(model.plate, model.plates, load):
                _write_force(sheets, load.name, line.q, _places(line.edges, closed=False), common)
        elif lines := [shape for shape in model.shapes(load) if isinstance(shape, LineForce)]:
            _write_lines(sheets, load.name, lines, common, placed, what)
        else:
            sheets.leave(what, f"{load.kind} is not written")
    for case in model.cases:
        for direction, H in (("X", case.H_x), ("Y", case.H_y)):
            if H:
                node = sheets.node(model.plate.ring().points[0])
                _add_force(sheets, f"{case.name} H", node, direction, H, {"loadcase": case.name})


def _write_settlement(sheets: Sheets, load: SettlementLoad, common: Mapping[str, Any], what: str) -> None:
    """Write a settlement that is forced on a support at a point."""
    if load.support not in sheets.names["StructuralPointSupport"]:
        sheets.leave(what, "settlements of other supports than those at points are not written")
        return
    value = from_si(-load.w, "size") + 0.0
    where = {"pointsupport": load.support, "direction": "Z", "translationvalue": value}
    sheets.add("StructuralPointSupportDeformation", load.name, "RS", **where, **common)


def _write_weight(sheets: Sheets, model: Model, load: SelfWeight, common: Mapping[str, Any], placed: Placed) -> None:
    """Write a self-weight that materials cannot give as pressures on a plate and, in addition, on its zones."""
    for plate, name in zip(model.every_plate, placed.plates.values(), strict=True):
        if load.plate not in ("", plate.name):
            continue
        _add_weight(
            sheets, load, load.unit_weight * plate.thickness, {"forceaction": "On 2D member", "2dmember": name}, common
        )
        rows = [row for row in sheets.rows["StructuralSurfaceMemberRegion"] if row["2dmember"] == name]
        for zone, row in zip(plate.zones, rows, strict=False):
            if (more := load.unit_weight * ((zone.thickness or plate.thickness) - plate.thickness)) != 0:
                where = {"forceaction": "On 2D member region", "2dmember": name, "2dmemberregion": row["name"]}
                _add_weight(sheets, load, more, where, common)
    sheets.leave("self-weight", "of one plate, or of another unit weight: written as pressures")


def _add_weight(
    sheets: Sheets, load: SelfWeight, q: float, where: Mapping[str, Any], common: Mapping[str, Any]
) -> None:
    sheets.add(
        "StructuralSurfaceAction",
        load.name,
        "SF",
        direction="Z",
        type="Self weight",
        value=from_si(-q, "pressure"),
        coordinatesystem="Global",
        location="Length",
        **where,
        **common,
    )


def _plates_of(name: str, placed: Placed) -> list[str]:
    """Return the names in the file of the plates on which a load acts: the one it names, or all."""
    return [written for plate, written in placed.plates.items() if name in ("", plate)]


def _add_force(sheets: Sheets, name: str, node: str, direction: str, value: float, common: Mapping[str, Any]) -> None:
    """Add a force at a node, in the direction of an axis."""
    sheets.add(
        "StructuralPointAction",
        name,
        "F",
        type="Standard",
        direction=direction,
        forceaction="In node",
        referencenode=node,
        value=from_si(value, "force") + 0.0,
        coordinatesystem="Global",
        **common,
    )


def _write_point(sheets: Sheets, load: PointLoad, common: Mapping[str, Any], placed: Placed, what: str) -> None:
    """Write a force and moments at a node, a free force, or the pressure on its footprint."""
    moments = {"My": load.M_x, "Mx": -load.M_y}
    if load.column:
        node = placed.feet[load.column]
    else:
        assert load.x is not None
        assert load.y is not None
        (force,) = load.acts
        if force.ring is not None:
            sheets.leave(what, "written as a pressure on its footprint")
            pressure = force.pressure(equal_area_polygon(force.ring))
            places = np.array(_first_places(force.ring))
            _add_area(sheets, load.name, force.ring, pressure(places).tolist(), common)
            return
        if not any(moments.values()):
            sheets.add(
                "StructuralPointActionFree",
                load.name,
                "FF",
                type="Standard",
                direction="Z",
                value=from_si(-load.P, "force") + 0.0,
                coordinatex=load.x,
                coordinatey=load.y,
                coordinatez=0,
                coordinatesystem="Global",
                **common,
            )
            return
        node = sheets.node((load.x, load.y))
    if load.P or not any(moments.values()):
        _add_force(sheets, load.name, node, "Z", -load.P, common)
    for direction, M in moments.items():
        if M:
            sheets.add(
                "StructuralPointMoment",
                load.name,
                "M",
                type="Standard",
                direction=direction,
                forceaction="In node",
                referencenode=node,
                value=from_si(M, "moment"),
                coordinatesystem="Global",
                **common,
            )


def _write_line(
    sheets: Sheets, load: LineLoad | LineMoment, common: Mapping[str, Any], placed: Placed, what: str
) -> None:
    """Write a force or moment along a line, in pieces where it varies over several."""
    start, end = (load.q, load.q_end) if isinstance(load, LineLoad) else (load.m, load.m_end)
    ends = (start, start if end is None else end)
    if load.width is not None:
        sheets.leave(what, "its width is not written")
    pieces = placed.walls.get(load.wall, ()) if load.wall else ()
    edges = [edge for _, edge in pieces] or list(line_segments(load.points, load.bulges, load.shape))
    apart = bool(pieces) or (ends[0] != ends[1] and len(edges) > 1)
    groups = [[edge] for edge in edges] if apart else [edges]
    if len(groups) > 1:
        sheets.leave(what, f"written as {len(groups)} loads, one for each piece of its line")
    total, done = sum(edge.length for edge in edges), 0.0
    for position, group in enumerate(groups):
        length = sum(edge.length for edge in group)
        values = tuple(ends[0] + (ends[1] - ends[0]) * way / total for way in (done, done + length))
        done += length
        on = {"forceaction": "On edge", "2dmember": pieces[position][0], "edge": 1} if pieces else None
        if isinstance(load, LineMoment):
            _write_moment(sheets, load.name, values, on or _inner(sheets, group, placed), common)
        else:
            _write_force(sheets, load.name, values, on or _places(group, closed=False), common)


def _write_lines(
    sheets: Sheets, name: str, lines: Sequence[LineForce], common: Mapping[str, Any], placed: Placed, what: str
) -> None:
    """Write what acts on parts of walls as loads along lines, one for each straight piece or arc."""
    count = sum(len(line.edges) for line in lines)
    sheets.leave(what, f"written as {count} loads along lines, without the walls through which they act")
    for line in lines:
        low = 0.0
        for edge in line.edges:
            ways = np.array([low, low + edge.length]) / line.length
            low += edge.length
            force, couple = (tuple((ends[0] + (ends[1] - ends[0]) * ways).tolist()) for ends in (line.q, line.m))
            if any(line.q):
                _write_force(sheets, name, force, _places([edge], closed=False), common)
            if any(line.m):
                _write_moment(sheets, name, couple, _inner(sheets, [edge], placed), common)


def _write_moment(
    sheets: Sheets, name: str, values: Sequence[float], edge: Mapping[str, Any], common: Mapping[str, Any]
) -> None:
    """Write a moment about an edge of a wall or of the slab [N m/m]."""
    moment = [from_si(-value, "line moment") + 0.0 for value in values]
    where = {"direction": "Mx", "coordinatesystem": "Local", **edge, **_extent()}
    sheets.add("StructuralCurveMoment", name, "LM", **where, **_values(moment), **common)


def _write_force(
    sheets: Sheets, name: str, values: Sequence[float], where: Mapping[str, Any], common: Mapping[str, Any]
) -> None:
    """Write a force per length along an edge of a wall, or a free one through places of its own [N/m]."""
    force = [from_si(-value, "line force") + 0.0 for value in values]
    axis = {"direction": "Z", "coordinatesystem": "Global"}
    if "forceaction" in where:
        at_edge = {**_extent(), "eccentricityey": 0, "eccentricityez": 0}
        sheets.add("StructuralCurveAction", name, "LF", **axis, **where, **at_edge, **_values(force), **common)
    else:
        free = {"type": "Standard", **axis, "location": "Length"}
        sheets.add("StructuralCurveActionFree", name, "LF", **free, **where, **_values(force), **common)


def _inner(sheets: Sheets, edges: Sequence[Segment], placed: Placed) -> dict[str, Any]:
    """Return where a load acts on an internal edge, which is written in the plate on which it starts."""
    plate = plate_at(placed.rings, edges[0].start)
    nodes = [sheets.node(edges[0].start)]
    for edge in edges:
        nodes += [] if edge.straight else [sheets.node(middle(edge))]
        nodes.append(sheets.node(edge.end))
    kinds = "; ".join("Line" if edge.straight else "Circular Arc" for edge in edges)
    name = sheets.add("StructuralCurveEdge", "", "ES", **{"2dmember": plate}, nodes="; ".join(nodes), segments=kinds)
    return {"forceaction": "On internal edge", "2dmember": plate, "internaledge": name}


def _extent() -> dict[str, Any]:
    return {
        "type": "Standard",
        "location": "Length",
        "coordinatedefinition": "Relative",
        "origin": "From start",
        "extent": "Full",
        "startpoint": 0,
        "endpoint": 1,
    }


def _values(values: Sequence[float]) -> dict[str, Any]:
    """Return the values of a line load at its start and end, one of a uniform one."""
    if values[0] == values[1]:
        return {"distribution": "Uniform", "value1": values[0]}
    return {"distribution": "Trapez", "value1": values[0], "value2": values[1]}


def _places(edges: Sequence[Segment], closed: bool) -> dict[str, Any]:
    """Return the places of a free load, arcs by places half way."""
    places = list[tuple[float, float]]()
    for edge in edges:
        places += [edge.start] if edge.straight else [edge.start, middle(edge)]
    places += [] if closed else [edges[-1].end]
    kinds = "; ".join("Line" if edge.straight else "Circular Arc" for edge in edges)
    x, y = ("; ".join(repr(float(place[axis]) + 0.0) for place in places) for axis in (0, 1))
    zeros = "; ".join("0" for _ in places)
    return {"coordinatex": x, "coordinatey": y, "coordinatez": zeros, "edges" if closed else "segments": kinds}


def _write_uniform(sheets: Sheets, load: UniformLoad, common: Mapping[str, Any], placed: Placed, what: str) -> None:
    """Write a pressure on whole plates, constant or linear."""
    if any(load.bend):
        sheets.leave(what, "a pressure of second order is not written")
        return
    for plate in _plates_of(load.plate, placed):
        if any(load.slope):
            _add_area(sheets, load.name, placed.rings[plate], _corner_values(load, placed.rings[plate]), common)
        else:
            sheets.add(
                "StructuralSurfaceAction",
                load.name,
                "SF",
                direction="Z",
                type="Standard",
                forceaction="On 2D member",
                value=from_si(-load.q, "pressure") + 0.0,
                coordinatesystem="Global",
                location="Length",
                **{"2dmember": plate},
                **common,
            )


def _write_area(sheets: Sheets, load: PatchLoad | AreaLoad, common: Mapping[str, Any], what: str) -> None:
    """Write a free pressure on a part of the plan."""
    holes = isinstance(load, AreaLoad) and load.holes
    if any(load.bend) or load.on == "ground" or holes:
        sheets.leave(what, "a pressure of second order, on the ground beside the plate, or with holes is not written")
        return
    shape = load.shape if isinstance(load, AreaLoad) else Rectangle(x=load.x, y=load.y)
    _add_area(sheets, load.name, shape.ring(), _corner_values(load, shape.ring()), common)


def _corner_values(load: UniformLoad | PatchLoad | AreaLoad, ring: Ring) -> list[float]:
    """Return the pressure at the first three places of a ring as it is written, arcs with their middles."""
    values: list[float] = load.pressure(np.array(_first_places(ring))).tolist()
    return values


def _first_places(ring: Ring) -> list[tuple[float, float]]:
    places = [
        place for edge in ring.segments() for place in ((edge.start,) if edge.straight else (edge.start, middle(edge)))
    ]
    return places[:3]


def _add_area(sheets: Sheets, name: str, ring: Ring, values: Sequence[float], common: Mapping[str, Any]) -> None:
    """Add a free pressure by its values at the first three places."""
    forces = [from_si(-value, "pressure") + 0.0 for value in values]
    varies = len(set(forces)) > 1
    q = "; ".join(f"C{n}:{force!r}" for n, force in enumerate(forces, start=1)) if varies else repr(forces[0])
    sheets.add(
        "StructuralSurfaceActionFree",
        name,
        "SFF",
        direction="Z",
        type="Standard",
        q=q,
        distribution="DirectionXY" if varies else "Uniform",
        validity="Z zero",
        localzdirection="Positive",
        **_places(ring.segments(), closed=True),
        coordinatesystem="Global",
        location="Length",
        **common,
    )
