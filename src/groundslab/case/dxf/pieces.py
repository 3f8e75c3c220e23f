"""One entity as a line of straight edges and arcs, or as a place."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from groundslab.case.dxf.sheet import CLOSE, FARTHEST, Sheet
from groundslab.errors import InputError
from groundslab.geometry.bulges import Point, from_line

if TYPE_CHECKING:
    from ezdxf.entities import Arc, DXFEntity, Spline
    from ezdxf.math import Vec3

#: Lines may miss an ellipse or a spline by this [m], or by this part of its size if that is more.
SAG, SAG_OF_SIZE = 1e-3, 1e-5
MOST_LINES = 10_000  # that splines are made into
HIGHEST = 25  # degree of a spline
LARGEST_BULGE = 100.0  # of an arc, as in a case file; all but a whole circle
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
class Piece:
    """One drawn line: points, bulges (one less than points if it is open), and remarks for the report."""

    points: list[Point]
    bulges: list[float]
    remarks: str = ""


def piece_of(entity: DXFEntity, sheet: Sheet) -> Piece | str:
    """Return an entity as a line of straight edges and arcs, or why it is ignored."""
    try:
        drawn = _drawn(entity, sheet)
    except InputError:
        raise
    except Exception as error:  # of any kind, as what is damaged may be anything
        return f"it is damaged ({error})"
    if isinstance(drawn, str):
        return drawn
    corners, bulges, remarks = drawn
    points = [sheet.point(corner) for corner in corners]
    bulges = [float(bulge) if not abs(bulge) <= FLAT else 0.0 for bulge in bulges]
    numbers = [*(value for point in points for value in point), *bulges]
    if not all(abs(value) < FARTHEST for value in numbers):
        return f"its coordinates are no numbers, or farther away than {FARTHEST:g} m"
    if max(map(abs, bulges), default=0.0) > LARGEST_BULGE:
        return f"an arc has a bulge of {max(map(abs, bulges)):.3g}, expected at most {LARGEST_BULGE:g}"
    heights = [sheet.metres(corner.z) for corner in corners]
    span = max((max(values) - min(values) for values in zip(*points, strict=True)), default=0.0)
    if not heights or (span == 0.0 and max(heights) == min(heights)):
        return "it has no length"
    if not max(heights) - min(heights) <= CLOSE * span:
        return "it does not lie in a horizontal plane"
    if abs(heights[0]) > CLOSE * span:
        remarks.append(f"at z = {sheet.shown(heights[0])}, taken as 0")
    return Piece(points, bulges, ", ".join(remarks))


def _drawn(entity: DXFEntity, sheet: Sheet) -> tuple[list[Vec3], list[float], list[str]] | str:
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
            if not _upright(entity.dxf.extrusion):
                return _TILTED
            sag = _sag(entity.dxf.major_axis.magnitude, sheet)
            corners = list(entity.flattening(sag))
        elif entity.dxf.degree > HIGHEST:
            return f"its degree is {entity.dxf.degree}, expected at most {HIGHEST}"
        else:
            corners, sag = _flattened(entity, sheet)
        within = f"{sheet.metres(sag) * 1e3:.3g} mm"
        return corners, [0.0] * (len(corners) - 1), [f"made into {len(corners) - 1} lines within {within}"]
    if not isinstance(entity, Circle | LWPolyline | Polyline):
        return _NOT_TAKEN.get(entity.dxftype(), "it is no line")
    if isinstance(entity, Polyline) and not entity.is_2d_polyline:
        return "it is a mesh"
    if not _upright(entity.dxf.extrusion):
        return _TILTED
    if isinstance(entity, Circle):
        local, bulges = _round(
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


def _sag(size: float, sheet: Sheet) -> float:
    """Return by how much lines may miss a curve of a size, both in the drawing's units."""
    return max(SAG / float(sheet.scale), SAG_OF_SIZE * size)


def _flattened(spline: Spline, sheet: Sheet) -> tuple[list[Vec3], float]:
    """Return corners of lines along a spline, and within which distance of it (in the drawing's units)."""
    tool = spline.construction_tool()
    knots = [float(knot) for knot in tool.knots()]
    # Knots before and after these only shape the curve's ends; closed splines have them.
    inner = sorted(set(knots[tool.order - 1 : tool.count + 1]))
    sheet.spend(4 * (len(inner) - 1), MOST_LINES, LINES_MADE)
    steering = [(point.x, point.y) for point in tool.control_points]
    sag = _sag(max(max(values) - min(values) for values in zip(*steering, strict=True)), sheet)
    corners = [tool.point(inner[0])]

    def follow(start: float, end: float, a: Vec3, b: Vec3, depth: int) -> None:
        between = [tool.point(start + (end - start) * part / 4) for part in (1, 2, 3)]
        # An S crosses its chord half way, so that quarters are looked at too.
        off = max(from_line((p.x, p.y), (a.x, a.y), (b.x, b.y)) for p in between)
        if depth < 2 or (off > sag / 2 and depth < MOST_HALVINGS):
            if depth >= 2:
                sheet.spend(1, MOST_LINES, LINES_MADE)
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


def _upright(extrusion: Vec3) -> bool:
    """Return whether a plane is horizontal, by the direction that stands on it."""
    x, y, z = map(float, extrusion)
    return math.hypot(x, y) <= 1e-9 * abs(z)


def _angles(arc: Arc | None) -> tuple[float, float]:
    """Return start and angle of an arc, or of the whole circle [degrees]."""
    if arc is None:
        return 180.0, 360.0
    return arc.dxf.start_angle % 360.0, (arc.dxf.end_angle - arc.dxf.start_angle) % 360.0 or 360.0


def _round(centre: Vec3, radius: float, start: float, angle: float) -> tuple[list[Vec3], list[float]]:
    """Return corners and bulges of an arc [degrees], in two parts if it is more than a half circle."""
    from ezdxf.math import Vec3

    parts = 1 if angle <= 180.0 + 1e-9 else 2
    turns = [(start + angle * part / parts) % 360.0 for part in range(parts + 1)]
    corners = [centre + Vec3(_QUARTERS.get(turn) or Vec3.from_deg_angle(turn)) * radius for turn in turns]
    return corners, [1.0 if angle in {180.0, 360.0} else math.tan(math.radians(angle / parts) / 4)] * parts


def spot_of(entity: DXFEntity, sheet: Sheet) -> Point | None:
    """Return the place of a POINT, a circle or a block's reference, None if it has none."""
    from ezdxf.entities import Circle, Insert
    from ezdxf.entities import Point as PointEntity

    if isinstance(entity, PointEntity):
        point = sheet.point(entity.dxf.location)
    elif isinstance(entity, Insert):
        point = sheet.point(entity.ocs().to_wcs(entity.dxf.insert))
    elif isinstance(entity, Circle) and entity.dxftype() == "CIRCLE":
        point = sheet.point(entity.ocs().to_wcs(entity.dxf.center))
    else:
        return None
    return point if all(abs(value) < FARTHEST for value in point) else None
