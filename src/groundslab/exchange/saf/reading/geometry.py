"""Curves of a file: edges of members through nodes, in plan, and closed curves as shapes."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from groundslab.exchange.saf.reading.context import RowFault, Vector
from groundslab.geometry.plan import LARGEST_BULGE, Place, Ring, make_segments
from groundslab.model.shapes import AnyShape, Circle, Polygon, Rectangle
from groundslab.schema.wording import describe

#: Places closer than this are one, heights too [m].
CLOSE = 1e-4
#: Pieces by which parabolas and Bezier curves are replaced.
PIECES = 16
#: Arcs that rise less than this over their chords are straight.
FLATTEST = 1e-6
#: Arcs whose centers and radii differ by less than this, relative to the radius, are of one circle.
ROUNDING = 1e-9
MOST_NODES = 10_000  # of one curve

_NODES = {"line": 2, "circular arc": 3, "circle arc": 3, "parabolic arc": 3, "bezier": 4}
_CIRCLES = ("circle and point", "circle by 3 points")


@dataclass(frozen=True, slots=True)
class Edge:
    """One edge of a curve: its places (x, y, height) [m], the bulge after each but the last in plan, and a remark."""

    places: tuple[Vector, ...]
    bulges: tuple[float, ...]
    remark: str = ""

    @property
    def points(self) -> tuple[Place, ...]:
        """Return its places in plan."""
        return tuple((x, y) for x, y, _ in self.places)

    def level(self, height: float) -> bool:
        """Return whether all of it lies at a height [m]."""
        return all(abs(place[2] - height) <= CLOSE for place in self.places)


def make_edges(places: Sequence[Vector], kinds: Sequence[str], closed: bool) -> tuple[Edge, ...]:
    """Return the edges of a curve through places; raises RowFault where kinds and places do not fit."""
    if len(places) > MOST_NODES:
        raise RowFault("nodes", f"{len(places):,} nodes", f"at most {MOST_NODES:,}")
    words = [" ".join(kind.lower().split()) for kind in kinds] or ["line"] * (len(places) - (not closed))
    if len(words) == 1 and words[0] in _CIRCLES:
        return (_circle_edge(places, words[0]),)
    corners = list(places)
    if closed and len(corners) > 1 and _same(corners[0], corners[-1]):
        corners.pop()
    counts = [_count_nodes(kind, len(words), len(corners), closed) for kind in words]
    needed = sum(count - 1 for count in counts) + (not closed)
    if needed != len(corners) or len(corners) < 2:
        raise RowFault(
            "nodes", f"{len(corners)} nodes", f"{max(needed, 2)}, as the edges {describe('; '.join(kinds))} have"
        )
    around = [*corners, *corners[: 1 if closed else 0]]
    edges, first = [], 0
    for kind, count in zip(words, counts, strict=True):
        edges.append(_make_edge(kind, around[first : first + count]))
        first += count - 1
    if closed and sum(len(edge.bulges) for edge in edges) < 3 and not any(any(edge.bulges) for edge in edges):
        raise RowFault("nodes", f"{len(corners)} nodes on a line", "a closed curve")
    return tuple(edges)


def _count_nodes(kind: str, kinds: int, nodes: int, closed: bool) -> int:
    """Return through how many nodes an edge runs."""
    if kind in _NODES:
        return _NODES[kind]
    match = re.fullmatch(r"spline(?:[- ](\d{1,4}))?", kind)
    if match and match[1] and int(match[1]) >= 2:
        return int(match[1])
    if match and kinds == 1:
        return nodes + closed
    raise RowFault(
        "edges", describe(kind), "Line, Circular Arc, Parabolic Arc, Bezier or Spline and its number of nodes"
    )


def _make_edge(kind: str, places: Sequence[Vector]) -> Edge:
    """Return one edge through its places."""
    if kind == "line":
        return Edge(tuple(places), (0.0,))
    if kind in ("circular arc", "circle arc"):
        a, middle, b = places
        return Edge((a, b), (arc_bulge(a[:2], middle[:2], b[:2]),))
    if kind.startswith("spline"):
        return Edge(tuple(places), (0.0,) * (len(places) - 1), "a spline, taken as straight between its nodes")
    if kind == "bezier":
        control = list(places)
    else:  # the parabola that is at the middle node half way
        a, middle, b = places
        top = tuple(2 * m - (p + q) / 2 for p, m, q in zip(a, middle, b, strict=True))
        control = [a, (top[0], top[1], top[2]), b]
    curve = [_bezier(control, step / PIECES) for step in range(PIECES + 1)]
    return Edge(tuple(curve), (0.0,) * PIECES, f"a curve, taken as {PIECES} straight pieces")


def _bezier(control: Sequence[Vector], t: float) -> Vector:
    """Return the place of a Bezier curve at t, by de Casteljau."""
    points = list(control)
    while len(points) > 1:
        points = [
            (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])) for a, b in pairwise(points)
        ]
    return points[0]


def arc_bulge(a: Sequence[float], middle: Sequence[float], b: Sequence[float]) -> float:
    """Return the bulge of the arc from a through a middle place to b, tan of a quarter of its angle."""
    ux, uy, vx, vy = a[0] - middle[0], a[1] - middle[1], b[0] - middle[0], b[1] - middle[1]
    if max(abs(ux), abs(uy)) < CLOSE or max(abs(vx), abs(vy)) < CLOSE:
        raise RowFault("nodes", "an arc whose nodes coincide", "three places")
    # the angle at the middle node is pi less half of the arc's angle
    angle = math.pi - math.atan2(abs(ux * vy - uy * vx), ux * vx + uy * vy)
    bulge = float(f"{math.tan(angle / 2):.12g}")
    if bulge > LARGEST_BULGE:
        raise RowFault("nodes", "an arc that is nearly a whole circle", "two arcs")
    # seen along an arc that runs counterclockwise, its middle lies to the right of the chord
    return 0.0 if bulge < FLATTEST else math.copysign(bulge, uy * vx - ux * vy)


def _circle_edge(places: Sequence[Vector], kind: str) -> Edge:
    """Return the edge of a whole circle, which starts at its first node on it."""
    if len(places) == 3:
        (ax, ay, height), (bx, by, _), (cx, cy, _) = places
        twice = 2 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by))
        if abs(twice) < CLOSE**2:
            raise RowFault("nodes", "a circle through places on a line", "three places apart")
        a2, b2, c2 = ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy
        x = (a2 * (by - cy) + b2 * (cy - ay) + c2 * (ay - by)) / twice
        y = (a2 * (cx - bx) + b2 * (ax - cx) + c2 * (bx - ax)) / twice
        start = (ax, ay)
    elif len(places) == 2:
        (x, y, height), start = places[0], places[1][:2]
    else:
        raise RowFault(
            "nodes", f"{len(places)} nodes", "the center and a point, or three points", f"of {describe(kind)}"
        )
    opposite = (2 * x - start[0], 2 * y - start[1])
    around = (start, opposite, start)
    return Edge(tuple((px, py, height) for px, py in around), (1.0, 1.0))


def _same(a: Vector, b: Vector) -> bool:
    return math.dist(a, b) <= CLOSE / 100


def join(edges: Sequence[Edge]) -> tuple[tuple[Place, ...], tuple[float, ...]]:
    """Return the points of edges one after the other, and the bulges between them, none if all are straight."""
    points = [edges[0].points[0], *(point for edge in edges for point in edge.points[1:])]
    bulges = tuple(bulge for edge in edges for bulge in edge.bulges)
    return tuple(points), bulges if any(bulges) else ()


def to_shape(edges: Sequence[Edge]) -> AnyShape:
    """Return the shape that a closed curve is: a rectangle along x and y, a circle, or a polygon."""
    points, bulges = join(edges)
    corners = points[:-1]
    if (circle := to_circle(points, bulges)) is not None:
        return circle
    if len(corners) == 4 and not bulges:
        xs, ys = sorted({x for x, _ in corners}), sorted({y for _, y in corners})
        if (
            len(xs) == len(ys) == 2
            and len(set(corners)) == 4
            and all(a[0] == b[0] or a[1] == b[1] for a, b in pairwise(points))
        ):
            return Rectangle(x=(xs[0], xs[1]), y=(ys[0], ys[1]))
    return Polygon(points=corners, bulges=bulges)


def to_circle(points: Sequence[Place], bulges: Sequence[float]) -> Circle | None:
    """Return the circle that closed arcs make up, None if they don't."""
    edges = make_segments(points, bulges)
    if points[0] != points[-1] or len(edges) < 2 or len(edges) > len(bulges) or any(edge.straight for edge in edges):
        return None
    radius, sweep = edges[0].radius, sum(edge.sweep for edge in edges)
    apart = max(math.dist(edges[0].centre, edge.centre) + abs(edge.radius - radius) for edge in edges)
    if apart > ROUNDING * radius or abs(abs(sweep) - 2 * math.pi) > ROUNDING:
        return None
    x, y = (sum(edge.centre[axis] for edge in edges) / len(edges) for axis in (0, 1))
    return Circle(centre=(_tidy(x), _tidy(y)), radius=_tidy(radius))


def to_ring(edges: Sequence[Edge]) -> Ring:
    """Return a closed curve."""
    points, bulges = join(edges)
    return Ring(points[:-1], bulges)


def _tidy(value: float) -> float:
    """Return a coordinate freed of what rounding has left."""
    return round(float(f"{value:.11g}"), 12) + 0.0
