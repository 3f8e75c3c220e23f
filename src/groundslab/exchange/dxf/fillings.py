"""Fillings (HATCH, MPOLYGON) as closed curves: each of their boundary paths is one."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from groundslab.exchange.dxf.drawing import GAP, ReadContext
from groundslab.exchange.dxf.flattening import Corners, divide_arc, flatten_ellipse, flatten_spline

if TYPE_CHECKING:
    from ezdxf.entities import Hatch, MPolygon
    from ezdxf.entities.boundary_paths import AbstractBoundaryPath, AbstractEdge
    from ezdxf.math import Vec3

#: Bits of a path's type: it is an outer one, it goes around a text.
_OUTER, _TEXT = 1 | 16, 8
#: The style that fills what lies inside inner paths, too.
_FILLS_ALL = 2


def read_filling(filling: Hatch | MPolygon, context: ReadContext) -> list[Corners] | str:
    """Return the closed curves around a filling and around what it leaves out, or why there are none."""
    from ezdxf.math import Vec3

    paths = [path for path in filling.paths if not path.path_type_flags & _TEXT]
    outer = [path for path in paths if path.path_type_flags & _OUTER]
    if filling.dxf.hatch_style == _FILLS_ALL and outer:
        paths = outer
    ocs, height = filling.ocs(), Vec3(filling.dxf.elevation).z
    # seen from below, anticlockwise is clockwise
    sign = 1.0 if filling.dxf.extrusion[2] > 0 else -1.0
    curves: list[Corners] = []
    for path in paths:
        drawn = _read_path(path, context)
        if isinstance(drawn, str):
            return drawn
        corners, bulges, remarks = drawn
        placed = [corner.replace(z=height) for corner in corners]
        curves.append((list(ocs.points_to_wcs(placed)), [sign * bulge for bulge in bulges], remarks))
    return curves or "it has no boundary"


def _read_path(path: AbstractBoundaryPath, context: ReadContext) -> Corners | str:
    """Return a boundary path as a closed curve in its own plane, or why it is none."""
    from ezdxf.entities.boundary_paths import EdgePath, PolylinePath
    from ezdxf.math import Vec3

    if isinstance(path, PolylinePath):
        corners = [Vec3(x, y) for x, y, _ in path.vertices]
        bulges = [bulge for _, _, bulge in path.vertices]
        is_open = bool(corners) and not corners[0].isclose(corners[-1])
        return (corners + corners[:1], bulges, []) if is_open else (corners, bulges[:-1], [])
    if not isinstance(path, EdgePath):
        return "its boundary is of an unknown kind"
    pieces = []
    for edge in path.edges:
        piece = _read_edge(edge, context)
        if isinstance(piece, str):
            return piece
        pieces.append(piece)
    return _join(pieces, GAP / float(context.scale))


def _read_edge(edge: AbstractEdge, context: ReadContext) -> Corners | str:
    """Return an edge of a path as corners and bulges, running in any direction."""
    from ezdxf.entities.boundary_paths import ArcEdge, EllipseEdge, LineEdge, SplineEdge
    from ezdxf.math import Vec3

    if isinstance(edge, LineEdge):
        return [Vec3(edge.start), Vec3(edge.end)], [0.0], []
    if isinstance(edge, ArcEdge):
        angle = (edge.end_angle - edge.start_angle) % 360.0 or 360.0
        return *divide_arc(Vec3(edge.center), edge.radius, edge.start_angle % 360.0, angle), []
    if isinstance(edge, EllipseEdge):
        return flatten_ellipse(edge.construction_tool(), edge.major_axis.magnitude, context)
    if isinstance(edge, SplineEdge):
        return flatten_spline(edge.construction_tool(), False, context)
    return "its boundary has an edge of an unknown kind"


def _join(pieces: list[Corners], near: float) -> Corners | str:
    """Return pieces that follow each other, each in any direction, as one closed curve; ends so near are one."""
    if not pieces:
        return "its boundary has no edges"
    corners, bulges, remarks = pieces[0]
    if len(pieces) > 1 and not _touches(corners[-1], pieces[1], near):
        corners, bulges = _turned(corners, bulges)
    corners, bulges, remarks = [*corners], [*bulges], [*remarks]
    for points, bends, words in pieces[1:]:
        along, bent = (points, bends) if corners[-1].distance(points[0]) <= near else _turned(points, bends)
        if corners[-1].distance(along[0]) > near:
            return "its boundary is not closed"
        corners += along[1:]
        bulges += bent
        remarks += words
    if corners[0].distance(corners[-1]) > near:
        return "its boundary is not closed"
    return [*corners[:-1], corners[0]], bulges, list(dict.fromkeys(remarks))


def _touches(corner: Vec3, piece: Corners, near: float) -> bool:
    points, _, _ = piece
    return bool(min(corner.distance(points[0]), corner.distance(points[-1])) <= near)


def _turned(corners: list[Vec3], bulges: Iterable[float]) -> tuple[list[Vec3], list[float]]:
    """Return a curve from its end to its start."""
    return corners[::-1], [-bulge for bulge in reversed(list(bulges))]
