"""Entities on the layers that are read, out of nested blocks, as lines with arcs or as points."""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from graphlib import CycleError, TopologicalSorter
from typing import TYPE_CHECKING

import numpy as np

from groundslab.case.dxf.document import Roles
from groundslab.case.dxf.drawing import CLOSE, FARTHEST, MOST_ENTITIES, ReadContext, Source, abort
from groundslab.errors import InputError
from groundslab.geometry.plan import LARGEST_BULGE, Place, Segment
from groundslab.schema.wording import describe

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.entities import Arc, DXFEntity, DXFGraphic, Insert, Spline
    from ezdxf.math import Vec3

DEEPEST = 16  # blocks in blocks
MOST_PLACED = 200_000  # entities of blocks, copied to where they are referred to
FEWER = "leave only what is needed in the drawing, or resolve the blocks in the CAD program"


@dataclass(slots=True)
class _Content:
    """What a block holds: its entities by the role of their layers, and references to other blocks.

    Entities on layer 0 take the role of the layer that the block is referred to from; here they have the role "0".
    """

    entities: Counter[str | None] = field(default_factory=Counter)
    references: Counter[tuple[str, str | None]] = field(default_factory=Counter)  # by block and role


class BlockCounts:
    """How many entities of each block lie on the layers that are read, and how many must be placed to get them."""

    def __init__(self, document: Document, roles: Roles, context: ReadContext) -> None:
        self._document, self._roles = document, roles
        contents: dict[str, _Content] = {}
        space = self._content(document.modelspace(), contents)
        graph = {name: {child for child, _ in content.references} for name, content in contents.items()}
        #: By block and role of what lies on layer 0: entities taken and entities placed.
        self._counts: dict[tuple[str, str | None], tuple[int, int]] = {}
        try:
            order = list(TopologicalSorter(graph).static_order())
        except CycleError as error:
            names = " in ".join(describe(name) for name in error.args[1][:8])
            abort(context, f"a block that holds itself: {names}", "blocks that can be resolved")
        for name in order:
            for role in (None, *roles.named.values()):
                self._counts[name, role] = self._count_below(contents.get(name, _Content()), role)
        taken, placed = self._count_below(space, None)
        for count, limit, words in (
            (taken, MOST_ENTITIES, "entities on the layers that are read, those of blocks included"),
            (placed - sum(space.entities.values()), MOST_PLACED, "entities of blocks to be placed"),
        ):
            if count > limit:
                shown = f"{count:,}" if count < 10**15 else f"more than {10**15:,}"
                abort(context, f"{shown} {words}", f"at most {limit:,}", FEWER)

    def holds(self, name: str, role: str | None) -> bool:
        """Return whether a block has anything on the layers that are read, if its layer 0 has this role."""
        return self._counts.get((name.lower(), role), (1, 1))[0] > 0

    def _content(self, entities: Iterable[DXFEntity], contents: dict[str, _Content]) -> _Content:
        """Return what there is, and enter the blocks that it refers to, and those that these do."""
        first, todo = _Content(), [(entities, "")]
        while todo:
            some, name = todo.pop()
            content = contents.setdefault(name, _Content()) if name else first
            for entity in some:
                layer = layer_of(entity)
                role = "0" if layer == "0" and name else self._roles.of(layer)
                if entity.dxftype() != "INSERT":
                    content.entities[role] += 1
                    continue
                child = str(entity.dxf.get("name")).lower()
                content.references[child, role] += max(entity.mcount, 1)
                content.entities[role] += _count_attributes(entity, self._roles)
                block = self._document.blocks.get(child)
                if child not in contents and block is not None and not block.block.is_xref:
                    contents[child] = _Content()
                    todo.append((block, child))
        return first

    def _count_below(self, content: _Content, role: str | None) -> tuple[int, int]:
        """Return how many entities are taken and placed, if layer 0 has this role."""
        own = {"0": role}
        taken = sum(count for each, count in content.entities.items() if own.get(str(each), each) is not None)
        placed = sum(content.entities.values())
        for (child, each), count in content.references.items():
            its = own.get(str(each), each)
            below = (1, 1) if its == "point_loads" else self._counts.get((child, its), (0, 0))
            if below[0]:
                taken, placed = taken + count * below[0], placed + count * (1 + below[1])
            else:
                placed += 1
        return taken, placed


def layer_of(entity: DXFEntity) -> str:
    """Return the layer that an entity names."""
    return str(entity.dxf.get("layer", "0")) if entity.is_supported_dxf_attrib("layer") else "0"


def _count_attributes(insert: DXFEntity, roles: Roles) -> int:
    """Return how many attributes of a block's reference lie on the layer of point loads."""
    attributes: list[DXFEntity] = insert.attribs
    return sum(roles.of(layer_of(each)) == "point_loads" for each in attributes)


def iterate_entities(
    entities: Iterable[DXFEntity],
    roles: Roles,
    blocks: BlockCounts,
    context: ReadContext,
    outer: tuple[Source, ...] = (),
) -> Iterator[tuple[str, Source, DXFEntity]]:
    """Yield what lies on the layers that are read, with blocks resolved: role, source, entity."""
    from ezdxf.entities import Insert

    for entity in entities:
        source = _locate_entity(entity, outer)
        role = roles.of(source.layer)
        if not isinstance(entity, Insert):
            if role:
                yield role, source, entity
            continue
        if role != "point_loads" and not _has_content(entity, source, role, blocks, context):
            continue
        for single in entity.multi_insert() if entity.mcount > 1 else (entity,):
            if role == "point_loads":
                yield role, source, single
            else:
                yield from _iterate_block(single, source, roles, blocks, context, outer)


def _locate_entity(entity: DXFEntity, outer: tuple[Source, ...]) -> Source:
    """Return where an entity comes from; on layer 0 of a block it lies on the layer of the block's reference."""
    layer, kind = layer_of(entity), entity.dxftype()
    if not outer:
        return Source(layer, kind, entity.dxf.get("handle") or "")
    block = outer[-1].entity.removeprefix("INSERT ")
    return Source(outer[-1].layer if layer == "0" else layer, f"{kind} in {block}", outer[0].handle)


def _has_content(insert: Insert, source: Source, role: str | None, blocks: BlockCounts, context: ReadContext) -> bool:
    """Return whether there is anything to take from a block's reference; if not, and it lies on a layer, say why."""
    name = insert.dxf.get("name")
    own = Source(source.layer, f"INSERT block {describe(str(name))}", source.handle)
    if not isinstance(name, str) or insert.block() is None or insert.is_xref():
        why = "its block is an external file or is missing"
    elif not blocks.holds(name, role):
        why = "its block has nothing on the layers that are read"
    else:
        return True
    if role:
        context.report_entity(own, False, why)
    return bool(insert.attribs)


def _iterate_block(
    insert: Insert, source: Source, roles: Roles, blocks: BlockCounts, context: ReadContext, outer: tuple[Source, ...]
) -> Iterator[tuple[str, Source, DXFEntity]]:
    """Yield what the content of a block's reference has on the layers that are read."""
    from ezdxf.lldxf.const import DXFError

    for attribute in insert.attribs:
        its = _locate_entity(attribute, (*outer, source))
        if roles.of(its.layer) == "point_loads":
            yield "point_loads", its, attribute
    name = str(insert.dxf.get("name"))
    own = Source(source.layer, f"INSERT block {describe(name)}", source.handle)
    if insert.block() is None or insert.is_xref() or not blocks.holds(name, roles.of(source.layer)):
        return
    if len(outer) >= DEEPEST:
        context.issue([own], None, "too many blocks in blocks", f"at most {DEEPEST} blocks in each other", FEWER)
        return
    inner = (*outer, own)
    skipped: list[tuple[DXFGraphic, str]] = []
    callback: Callable[[DXFGraphic, str], None] = lambda part, why: skipped.append((part, why))  # noqa: E731
    try:
        parts = list(insert.virtual_entities(skipped_entity_callback=callback))
    except (DXFError, ArithmeticError, ValueError) as error:
        context.issue([own], None, f"a block that cannot be placed ({error})", "a block with sound scales")
        return
    for part, why in skipped:
        its = _locate_entity(part, inner)
        if roles.of(its.layer):
            context.report_entity(its, False, f"it cannot be placed ({why})")
    yield from iterate_entities(parts, roles, blocks, context, inner)


#: Lines may miss an ellipse or a spline by this [m], or by this part of its size if that is more.
SAG, SAG_OF_SIZE = 1e-3, 1e-5
MOST_LINES = 10_000  # that splines are made into
HIGHEST = 25  # degree of a spline
MOST_HALVINGS = 16  # of a spline's span
LINES_MADE = "lines that splines are made into"
FLAT = 1e-9  # bulge of a straight edge, at most
# Directions without the rounding of sines.
_QUARTERS = {0.0: (1, 0), 90.0: (0, 1), 180.0: (-1, 0), 270.0: (0, -1)}
_TILTED = "it does not lie in a horizontal plane"
_NOT_TAKEN = {
    "HATCH": "a filling is not taken; draw its edge as a line",
    "MPOLYGON": "a filling is not taken; draw its edge as a line",
    "SOLID": "a filled area is not taken; draw its edge as a line",
    "POINT": "a point is no line",
    "TEXT": "text is taken beside point loads only",
    "MTEXT": "text is taken beside point loads only",
    "RAY": "it has no end",
    "XLINE": "it has no end",
}


@dataclass(frozen=True, slots=True)
class DrawnLine:
    """One drawn line: points, bulges (one less than points if it is open), and remarks for the report."""

    points: list[Place]
    bulges: list[float]
    remarks: str = ""


def read_line(entity: DXFEntity, context: ReadContext) -> DrawnLine | str:
    """Return an entity as a line of straight edges and arcs, or why it is ignored."""
    try:
        drawn = _read_corners(entity, context)
    except InputError:
        raise
    except Exception as error:  # of any kind, as what is damaged may be anything
        return f"it is damaged ({error})"
    if isinstance(drawn, str):
        return drawn
    corners, bulges, remarks = drawn
    points = [context.point(corner) for corner in corners]
    bulges = [float(bulge) if not abs(bulge) <= FLAT else 0.0 for bulge in bulges]
    numbers = [*(value for point in points for value in point), *bulges]
    if not all(abs(value) < FARTHEST for value in numbers):
        return f"its coordinates are no numbers, or farther away than {FARTHEST:g} m"
    if max(map(abs, bulges), default=0.0) > LARGEST_BULGE:
        return f"an arc has a bulge of {max(map(abs, bulges)):.3g}, expected at most {LARGEST_BULGE:g}"
    heights = [context.to_meters(corner.z) for corner in corners]
    span = max((max(values) - min(values) for values in zip(*points, strict=True)), default=0.0)
    if not heights or (span == 0.0 and max(heights) == min(heights)):
        return "it has no length"
    if not max(heights) - min(heights) <= CLOSE * span:
        return "it does not lie in a horizontal plane"
    if abs(heights[0]) > CLOSE * span:
        remarks.append(f"at z = {context.format_length(heights[0])}, taken as 0")
    return DrawnLine(points, bulges, ", ".join(remarks))


def _read_corners(entity: DXFEntity, context: ReadContext) -> tuple[list[Vec3], list[float], list[str]] | str:
    """Return corners (in the drawing's units), bulges and remarks of a line, or why it is none."""
    from ezdxf.entities import Arc, Circle, Ellipse, Line, LWPolyline, Polyline, Spline
    from ezdxf.math import Vec3

    if isinstance(entity, Line):
        return [entity.dxf.start, entity.dxf.end], [0.0], []
    if isinstance(entity, Polyline) and entity.is_3d_polyline:
        corners = [Vec3(vertex.dxf.location) for vertex in entity.vertices if not vertex.dxf.flags & 16]
        corners += corners[:1] if entity.is_closed else []
        return corners, [0.0] * (len(corners) - 1), []
    if isinstance(entity, Ellipse | Spline):
        if isinstance(entity, Ellipse):
            if not _is_horizontal(entity.dxf.extrusion):
                return _TILTED
            sag = _sag(entity.dxf.major_axis.magnitude, context)
            corners = list(entity.flattening(sag))
        elif entity.dxf.degree > HIGHEST:
            return f"its degree is {entity.dxf.degree}, expected at most {HIGHEST}"
        else:
            corners, sag = _flatten_spline(entity, context)
        within = f"{context.to_meters(sag) * 1e3:.3g} mm"
        return corners, [0.0] * (len(corners) - 1), [f"made into {len(corners) - 1} lines within {within}"]
    if not isinstance(entity, Circle | LWPolyline | Polyline):
        return _NOT_TAKEN.get(entity.dxftype(), "it is no line")
    if isinstance(entity, Polyline) and not entity.is_2d_polyline:
        return "it is a mesh"
    if not _is_horizontal(entity.dxf.extrusion):
        return _TILTED
    if isinstance(entity, Circle):
        local, bulges = _divide_arc(
            entity.dxf.center, abs(entity.dxf.radius), *_angles(entity if isinstance(entity, Arc) else None)
        )
    elif isinstance(entity, LWPolyline):
        local = [Vec3(x, y, entity.dxf.elevation) for x, y in entity.get_points("xy")]
        bulges = [bulge for (bulge,) in entity.get_points("b")]
    else:
        # A frame's corners only steer a curve that is drawn beside them.
        vertices = [vertex for vertex in entity.vertices if not vertex.dxf.flags & 16]
        height = Vec3(entity.dxf.elevation).z
        local = [Vec3(vertex.dxf.location).replace(z=height) for vertex in vertices]
        bulges = [vertex.dxf.get("bulge", 0.0) for vertex in vertices]
    if not isinstance(entity, Circle):
        if entity.is_closed:
            local += local[:1]
        bulges = bulges[: max(len(local) - 1, 0)]
    # Seen from below, anticlockwise is clockwise.
    sign = 1.0 if entity.dxf.extrusion[2] > 0 else -1.0
    return list(entity.ocs().points_to_wcs(local)), [sign * bulge for bulge in bulges], []


def _sag(size: float, context: ReadContext) -> float:
    """Return by how much lines may miss a curve of a size, both in the drawing's units."""
    return max(SAG / float(context.scale), SAG_OF_SIZE * size)


def _flatten_spline(spline: Spline, context: ReadContext) -> tuple[list[Vec3], float]:
    """Return corners of lines along a spline, and within which distance of it (in the drawing's units)."""
    tool = spline.construction_tool()
    knots = [float(knot) for knot in tool.knots()]
    # Knots before and after these only shape the curve's ends; closed splines have them.
    inner = sorted(set(knots[tool.order - 1 : tool.count + 1]))
    context.count_work(4 * (len(inner) - 1), MOST_LINES, LINES_MADE)
    steering = [(point.x, point.y) for point in tool.control_points]
    sag = _sag(max(max(values) - min(values) for values in zip(*steering, strict=True)), context)
    corners = [tool.point(inner[0])]

    def follow(start: float, end: float, a: Vec3, b: Vec3, depth: int) -> None:
        between = [tool.point(start + (end - start) * part / 4) for part in (1, 2, 3)]
        # An S crosses its chord half way, so that quarters are looked at too.
        off = Segment((a.x, a.y), (b.x, b.y)).distance(np.array([(p.x, p.y) for p in between])).max()
        if depth < 2 or (off > sag / 2 and depth < MOST_HALVINGS):
            if depth >= 2:
                context.count_work(1, MOST_LINES, LINES_MADE)
            middle = (start + end) / 2
            follow(start, middle, a, between[1], depth + 1)
            follow(middle, end, between[1], b, depth + 1)
        else:
            corners.append(b)

    for start, end in itertools.pairwise(inner):
        follow(start, end, corners[-1], tool.point(end), 0)
    if spline.closed and not corners[0].isclose(corners[-1]):
        corners.append(corners[0])
    return corners, sag


def _is_horizontal(extrusion: Vec3) -> bool:
    """Return whether a plane is horizontal, by the direction that stands on it."""
    x, y, z = map(float, extrusion)
    return math.hypot(x, y) <= 1e-9 * abs(z)


def _angles(arc: Arc | None) -> tuple[float, float]:
    """Return start and angle of an arc, or of the whole circle [degrees]."""
    if arc is None:
        return 180.0, 360.0
    return arc.dxf.start_angle % 360.0, (arc.dxf.end_angle - arc.dxf.start_angle) % 360.0 or 360.0


def _divide_arc(centre: Vec3, radius: float, start: float, angle: float) -> tuple[list[Vec3], list[float]]:
    """Return corners and bulges of an arc [degrees], in two parts if it is more than a half circle."""
    from ezdxf.math import Vec3

    parts = 1 if angle <= 180.0 + 1e-9 else 2
    turns = [(start + angle * part / parts) % 360.0 for part in range(parts + 1)]
    corners = [centre + Vec3(_QUARTERS.get(turn) or Vec3.from_deg_angle(turn)) * radius for turn in turns]
    return corners, [1.0 if angle in {180.0, 360.0} else math.tan(math.radians(angle / parts) / 4)] * parts


def read_position(entity: DXFEntity, context: ReadContext) -> Place | None:
    """Return the place of a POINT, a circle or a block's reference, None if it has none."""
    from ezdxf.entities import Circle, Insert, Point

    if isinstance(entity, Point):
        point = context.point(entity.dxf.location)
    elif isinstance(entity, Insert):
        point = context.point(entity.ocs().to_wcs(entity.dxf.insert))
    elif isinstance(entity, Circle) and entity.dxftype() == "CIRCLE":
        point = context.point(entity.ocs().to_wcs(entity.dxf.center))
    else:
        return None
    return point if all(abs(value) < FARTHEST for value in point) else None
