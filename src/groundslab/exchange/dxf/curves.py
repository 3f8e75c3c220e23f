"""Entities as lines of straight edges and arcs, or as points."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from groundslab.errors import InputError
from groundslab.exchange.dxf.drawing import CLOSE, FARTHEST, ReadContext
from groundslab.exchange.dxf.fillings import read_filling
from groundslab.exchange.dxf.flattening import Corners, divide_arc, flatten_ellipse, flatten_spline
from groundslab.geometry.plan import LARGEST_BULGE, Place

if TYPE_CHECKING:
    from ezdxf.entities import Arc, DXFEntity
    from ezdxf.math import Vec3

FLAT = 1e-9  # bulge of a straight edge, at most
_TILTED = "it does not lie in a horizontal plane"
_NOT_TAKEN = {
    "SOLID": "a filled area is not taken; draw its edge as a line",
    "POINT": "a point is not a line",
    "TEXT": "text is read only next to point loads",
    "MTEXT": "text is read only next to point loads",
    "RAY": "it has no end",
    "XLINE": "it has no end",
}


@dataclass(frozen=True, slots=True)
class DrawnLine:
    """One drawn line: points, bulges (one less than points if it is open), remarks for the report, its width [m]."""

    points: list[Place]
    bulges: list[float]
    remarks: str = ""
    width: float = 0.0


def is_filling(entity: DXFEntity) -> bool:
    """Return whether an entity is a filled area, which has any number of edges."""
    return entity.dxftype() in {"HATCH", "MPOLYGON"}


def read_lines(entity: DXFEntity, context: ReadContext) -> list[DrawnLine] | str:
    """Return an entity as lines of straight edges and arcs, or why it is ignored: one line, of a filling its edges."""
    try:
        drawn = _read_curves(entity, context)
        width = _width(entity, context)
    except InputError:
        raise
    except MemoryError:
        raise
    except Exception as error:  # of any kind, as what is damaged may be anything
        return f"it is damaged ({error})"
    if isinstance(drawn, str):
        return drawn
    lines = [_to_line(corners, context) for corners in drawn]
    sound = [replace(line, width=width) for line in lines if isinstance(line, DrawnLine)]
    return sound or next((line for line in lines if isinstance(line, str)), "it has no edge")


def _width(entity: DXFEntity, context: ReadContext) -> float:
    """Return the width [m] that a polyline is drawn with, 0 if it has none or several."""
    from ezdxf.entities import LWPolyline, Polyline

    widths = {0.0}
    if isinstance(entity, LWPolyline):
        constant = entity.dxf.const_width
        widths = {float(constant)} if constant else {float(width) for pair in entity.get_points("se") for width in pair}
    elif isinstance(entity, Polyline) and entity.is_2d_polyline:
        widths = {float(entity.dxf.default_start_width), float(entity.dxf.default_end_width)}
    width = context.to_meters(widths.pop()) if len(widths) == 1 else 0.0
    return width if 0 < width < FARTHEST else 0.0


def _read_curves(entity: DXFEntity, context: ReadContext) -> list[Corners] | str:
    """Return the curves of an entity, or why there are none."""
    from ezdxf.entities import Hatch, MPolygon

    if isinstance(entity, Hatch | MPolygon):
        return read_filling(entity, context) if is_horizontal(entity.dxf.extrusion) else _TILTED
    drawn = _read_corners(entity, context)
    return drawn if isinstance(drawn, str) else [drawn]


def _to_line(drawn: Corners, context: ReadContext) -> DrawnLine | str:
    """Return corners as a line in meters, or why they are none."""
    corners, bulges, remarks = drawn
    points = [context.point(corner) for corner in corners]
    bulges = [float(bulge) if not abs(bulge) <= FLAT else 0.0 for bulge in bulges]
    numbers = [*(value for point in points for value in point), *bulges]
    if not all(abs(value) < FARTHEST for value in numbers):
        return f"its coordinates are not numbers, or farther away than {FARTHEST:g} m"
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


def _read_corners(entity: DXFEntity, context: ReadContext) -> Corners | str:
    """Return corners (in the drawing's units), bulges and remarks of a line, or why it is none."""
    from ezdxf.entities import Arc, Circle, Ellipse, Line, LWPolyline, Polyline, Spline
    from ezdxf.math import Vec3

    if isinstance(entity, Line):
        return [entity.dxf.start, entity.dxf.end], [0.0], []
    if isinstance(entity, Polyline) and entity.is_3d_polyline:
        corners = [Vec3(vertex.dxf.location) for vertex in entity.vertices if not vertex.dxf.flags & 16]
        corners += corners[:1] if entity.is_closed else []
        return corners, [0.0] * (len(corners) - 1), []
    if isinstance(entity, Spline):
        return flatten_spline(entity.construction_tool(), entity.closed, context)
    if isinstance(entity, Ellipse):
        if not is_horizontal(entity.dxf.extrusion):
            return _TILTED
        return flatten_ellipse(entity, entity.dxf.major_axis.magnitude, context)
    if not isinstance(entity, Circle | LWPolyline | Polyline):
        return _NOT_TAKEN.get(entity.dxftype(), "it is not a line")
    if isinstance(entity, Polyline) and not entity.is_2d_polyline:
        return "it is a mesh"
    if not is_horizontal(entity.dxf.extrusion):
        return _TILTED
    if isinstance(entity, Circle):
        local, bulges = divide_arc(
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


def is_horizontal(extrusion: Vec3) -> bool:
    """Return whether a plane is horizontal, by the direction that stands on it."""
    x, y, z = map(float, extrusion)
    return math.hypot(x, y) <= 1e-9 * abs(z)


def _angles(arc: Arc | None) -> tuple[float, float]:
    """Return start and angle of an arc, or of the whole circle [degrees]."""
    if arc is None:
        return 180.0, 360.0
    return arc.dxf.start_angle % 360.0, (arc.dxf.end_angle - arc.dxf.start_angle) % 360.0 or 360.0


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
