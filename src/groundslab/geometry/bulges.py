"""Edges as DXF has them: two points and a bulge, and what lies inside closed ones.

A bulge is the tangent of a quarter of the arc's angle, positive if it turns left (counter-clockwise), 0 if straight.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from groundslab.geometry.plan import Ring

Point = tuple[float, float]
#: Counts work that is about to be done, and raises where it is too much.
Spend = Callable[[int], None]


class Edge(NamedTuple):
    """A straight line or an arc from a to b."""

    a: Point
    b: Point
    bulge: float

    def middle(self) -> Point:
        """Return the point half way along the edge."""
        (ax, ay), (bx, by) = self.a, self.b
        return (ax + bx + self.bulge * (by - ay)) / 2, (ay + by - self.bulge * (bx - ax)) / 2

    def circle(self) -> tuple[Point, float]:
        """Return center and radius of an arc."""
        (ax, ay), (bx, by) = self.a, self.b
        lean = (1 - self.bulge**2) / (4 * self.bulge)
        centre = (ax + bx) / 2 - lean * (by - ay), (ay + by) / 2 + lean * (bx - ax)
        return centre, math.dist(self.a, self.b) * (1 + self.bulge**2) / (4 * abs(self.bulge))

    def side(self, point: Point) -> float:
        """Return twice the area of the triangle a, b, point: positive if the point lies to the left."""
        (ax, ay), (bx, by) = self.a, self.b
        return (bx - ax) * (point[1] - ay) - (by - ay) * (point[0] - ax)

    def holds(self, point: Point, tolerance: float) -> bool:
        """Return whether the point lies on the edge."""
        if math.dist(point, self.a) <= tolerance or math.dist(point, self.b) <= tolerance:
            return True
        if self.bulge:
            centre, radius = self.circle()
            return abs(math.dist(point, centre) - radius) <= tolerance and self.side(point) * self.bulge < 0
        return distance_to_line(point, self.a, self.b) <= tolerance

    def box(self) -> tuple[float, float, float, float]:
        """Return least x and y, greatest x and y of a rectangle that holds the edge."""
        if abs(self.bulge) > 1:
            (x, y), grown = self.circle()
            return x - grown, y - grown, x + grown, y + grown
        grown = abs(self.bulge) * math.dist(self.a, self.b) / 2
        (ax, ay), (bx, by) = self.a, self.b
        return min(ax, bx) - grown, min(ay, by) - grown, max(ax, bx) + grown, max(ay, by) + grown


def distance_to_line(point: Point, a: Point, b: Point) -> float:
    """Return how far a point is from the straight line between a and b."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    square = dx * dx + dy * dy
    along = ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / square if square else 0.0
    along = min(max(along, 0.0), 1.0)
    return math.dist(point, (a[0] + along * dx, a[1] + along * dy))


def get_edges(ring: Ring) -> list[Edge]:
    """Return the edges of a closed curve with a bulge for each point, in order."""
    ends = (*ring.points[1:], ring.points[0])
    return [Edge(a, b, bulge) for a, b, bulge in zip(ring.points, ends, ring.bulges, strict=True)]


def signed_area(edges: Sequence[Edge]) -> float:
    """Return the area that closed edges enclose, negative if they run clockwise."""
    ox, oy = edges[0].a
    total = 0.0
    for edge in edges:
        (ax, ay), (bx, by) = edge.a, edge.b
        total += ((ax - ox) * (by - oy) - (bx - ox) * (ay - oy)) / 2
        if edge.bulge:
            angle = 4 * math.atan(edge.bulge)
            total += edge.circle()[1] ** 2 / 2 * (angle - math.sin(angle))
    return total


def inside(point: Point, edges: Sequence[Edge]) -> bool:
    """Return whether closed edges wind around a point: around by the chords, once more within an arc's segment."""
    winding = 0
    for edge in edges:
        side = _side(edge, point)
        if edge.a[1] <= point[1] < edge.b[1] and side > 0:
            winding += 1
        elif edge.b[1] <= point[1] < edge.a[1] and side < 0:
            winding -= 1
        if edge.bulge and side * edge.bulge < 0:
            centre, radius = edge.circle()
            if math.dist(point, centre) < radius:
                winding += 1 if edge.bulge > 0 else -1
    return winding != 0


def _side(edge: Edge, point: Point) -> float:
    """Return what is positive for a point to the left; one on a chord counts as a little higher, then farther right."""
    return edge.side(point) or (edge.b[0] - edge.a[0]) or (edge.a[1] - edge.b[1])


class Region:
    """Closed edges with a search tree, for repeated tests of what lies inside."""

    def __init__(self, edges: Sequence[Edge]) -> None:
        from shapely import STRtree, box

        self.edges = tuple(edges)
        self.boxes = [edge.box() for edge in self.edges]
        self.tree = STRtree([box(*each) for each in self.boxes])
        self.far = max(each[2] for each in self.boxes)

    def holds(self, point: Point, spend: Spend | None = None) -> bool:
        """Return whether the edges wind around a point; none counts but those that meet the ray to its right."""
        from shapely import LineString

        met = self.tree.query(LineString([point, (max(self.far, point[0]), point[1])]))
        if spend is not None:
            spend(len(met))
        return inside(point, [self.edges[k] for k in met])
