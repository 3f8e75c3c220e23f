"""Perimeters around columns and piles on a plate: how they run, and what openings leave of them.

No code's formulas are in here. The shape of a perimeter at a distance is that of EN 1992-1-1 6.4.2 (Figures 6.13 to
6.15), or with square corners that of ACI 318-19 22.6.4.1; both take off it what lies between the tangents from the
center of the loaded area to an opening (6.4.2(3), 22.6.4.3). What is left is a `Perimeter`: its length, center, moduli
and second moments (`line_properties`) are those of the legs that are left, not of the whole way around.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, pairwise
from operator import attrgetter
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from groundslab.arrays import Array, Integers, made_once_by
from groundslab.design.demands.line_properties import chains, cuts_strips, shape_of, total_length
from groundslab.design.demands.perimeter_pieces import Piece, WeightedLegs, pieces_of
from groundslab.errors import InputError, Issue
from groundslab.fem.mesh import sides_on_boundary
from groundslab.fem.shape_functions import lagrange
from groundslab.geometry.places import same_place
from groundslab.geometry.rectangles import direction_at, rectangle_at
from groundslab.messages import Message
from groundslab.results.plate_result import PlateResult

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon
    from shapely.geometry.base import BaseGeometry

#: Chords of a quarter of a circle; the perimeter is shorter than with arcs by less than 3e-5 of itself.
QUARTER_CHORDS = 64
#: Chords of a curved side of an element at the plate's edge.
SIDE_CHORDS = 16
#: Of the plate's edges near a column so many are tried as edges that the perimeter may run out to.
NEAREST_EDGES = 3
#: Tangents to an opening are followed so many times as far as the place reaches that is looked at.
FAR = 4.0
#: Over how far openings count it is looked whether they leave strips; by EN 1992-1-1 that is 2 d of 6 d.
STRIPS = 1 / 3
#: An opening is the side of a strip if it is seen over this angle [rad] at least; a smaller one is passed on each side.
SIDE = np.pi / 3
#: An opening's shadow is drawn in steps of this angle [rad] at most.
SHADOW_STEP = np.pi / 4


@dataclass(frozen=True, slots=True)
class RectangularColumn:
    """A column's footprint: a rectangle around its center [m], along x and y or turned by an angle [degrees]."""

    x: float
    y: float
    width_x: float
    width_y: float
    angle: float = 0.0

    def footprint(self) -> Polygon:
        """Return the rectangle."""
        from shapely import box

        ring = rectangle_at((self.x, self.y), (self.width_x, self.width_y), self.angle)
        x0, x1, y0, y1 = ring.bounds
        return box(x0, y0, x1, y1) if ring.is_rectangle else ring.polygon(np.inf)

    @property
    def axes(self) -> Array:
        """Return the unit vectors (2, 2) along its widths."""
        c, s = direction_at(self.angle)
        return np.array([[c, s], [-s, c]])


@dataclass(frozen=True, slots=True)
class RoundColumn:
    """The footprint of a column or a pile: a circle around its center [m]."""

    x: float
    y: float
    diameter: float

    def footprint(self) -> Polygon:
        """Return the circle, as chords."""
        from shapely import Point

        return Point(self.x, self.y).buffer(self.diameter / 2, quad_segs=QUARTER_CHORDS)

    @property
    def axes(self) -> Array:
        """Return x and y (2, 2): it has no axes of its own."""
        return np.eye(2)


@dataclass(frozen=True, slots=True)
class ZoneFootprint:
    """The footprint of a thicker zone of the plate, which it lies on."""

    region: Polygon
    axes: Array  # (2, 2): unit vectors along the sides of the smallest rectangle around it

    def footprint(self) -> Polygon:
        """Return the zone."""
        return self.region


Footprint = RectangularColumn | RoundColumn | ZoneFootprint


class Openings(NamedTuple):
    """Which openings shorten a perimeter, and how."""

    reach: float = 0.0  # those at most so far from the footprint [m]
    widened: bool = False  # whether one longer along the ray than across counts as wider (Figure 6.14)


class NearEdge(NamedTuple):
    """A straight edge of the plate near a footprint."""

    setback: float  # distance from the footprint [m]
    depth: float  # of the footprint's far side from the edge [m]
    outward: Array  # (2,): unit vector


@dataclass(frozen=True, slots=True)
class Surroundings:
    """The plate around a footprint, as far as its perimeters depend on it."""

    footprint: Polygon
    center: Array  # (2,) of the footprint [m]
    axes: Array  # (2, 2): unit vectors of the footprint's own axes
    plan: Polygon | MultiPolygon  # the plate, within reach
    boundary: BaseGeometry  # of the plate, its openings' too, within reach
    filled: Polygon | MultiPolygon  # the same without openings, but for those that leave strips
    rim: BaseGeometry  # of that, within reach
    edges: tuple[NearEdge, ...]  # the nearest ones first
    shadow: BaseGeometry  # the part of the plan behind openings, seen from the center
    rounding: float  # places closer than this are one [m]
    strips: bool = False  # whether openings and edges leave strips of the plate


@dataclass(frozen=True, slots=True)
class Perimeter:
    """A control perimeter on the plate, and the part of the plate that it cuts off with the column."""

    legs: Array  # (l, 2, 2): straight pieces that count, what it cuts off on their left [m]
    whole: Array  # (k, 2, 2): all of it on the plate, what openings take off too; free edges are none of it [m]
    ring: Array  # (r, 2, 2): the same as if the plate had no openings [m]
    inside: Polygon
    opened: bool  # whether an opening is near enough to take off a part of it
    setbacks: tuple[float, ...]  # of the edges that it runs straight out to [m]
    loaded: Polygon  # the footprint, stretched over these edges
    cut: bool = False  # whether it cuts the plate from edge to edge, which is one-way shear

    @property
    def u(self) -> float:
        """Return the length that counts [m]."""
        return total_length(self.legs)

    @property
    def length(self) -> float:
        """Return the length of all of it [m]."""
        return total_length(self.whole)


class SketchedPerimeter(NamedTuple):
    """What a sketch of a perimeter shows, and the table of its pieces."""

    line: Perimeter
    parts: tuple[WeightedLegs, ...]  # what counts of it, less in thinner slab
    center: Array  # (2,) of the column or pile, from which openings are seen [m]
    axes: Array  # (2, 2): unit vectors of axes 1 and 2
    origin: Array  # (2,): where places along them are measured from [m]
    further: tuple[tuple[str, SketchedPerimeter], ...] = ()  # others, by what their symbols end with

    @property
    def legs(self) -> Array:
        """Return the legs (l, 2, 2) that count, if only in part [m]."""
        return np.concatenate([part.legs for part in self.parts])

    @property
    def pieces(self) -> list[Piece]:
        """Return its pieces, one after the other."""
        return pieces_of(self.parts, self.axes, self.origin)


def perimeter(
    plate: PlateResult,
    column: Footprint,
    distance: float,
    openings: Openings | None = None,
    *,
    square: bool = False,
    near: float | None = None,
) -> Perimeter:
    """Return the control perimeter at a distance [m] from a footprint on a plate (see `perimeter_at`).

    Raises
    ------
    InputError
        If the footprint does not lie on the plate, or nothing of the perimeter does.
    """
    around = surroundings(plate, column, distance, openings or Openings())
    return perimeter_at(around, distance, square=square, near=near)


def surroundings(plate: PlateResult, column: Footprint, within: float, openings: Openings) -> Surroundings:
    """Return the plate around a footprint, for perimeters at most so far from it [m].

    Raises
    ------
    InputError
        If the footprint does not lie on the plate.
    """
    from shapely import Polygon, box, get_coordinates, get_parts, intersection, prepare, union_all

    plan, footprint = outline(plate), column.footprint()
    x0, y0, x1, y1 = plan.bounds
    rounding = same_place(x0, x1, y0, y1)
    if footprint.area == 0 or not plan.buffer(rounding).covers(footprint):
        where = Message("a column at {center:at m}", center=get_coordinates(footprint.centroid)[0])
        raise InputError([Issue("column", where, "a footprint that lies on the plate, on one level of it")])
    a0, b0, a1, b1 = footprint.bounds
    reach = 3 * (within + max(a1 - a0, b1 - b0))
    part = box(a0 - reach, b0 - reach, a1 + reach, b1 + reach)
    filled = union_all([Polygon(polygon.exterior) for polygon in get_parts(plan)])
    boundary, rim = intersection(plan.boundary, part), intersection(filled.boundary, part)
    prepare(boundary)
    prepare(rim)
    center = get_coordinates(footprint.centroid)[0]
    around = Surroundings(
        footprint=footprint,
        center=center,
        axes=column.axes,
        plan=intersection(plan, part),
        boundary=boundary,
        filled=intersection(filled, part),
        rim=rim,
        edges=tuple(_near_edges(plan, footprint, rounding)),
        shadow=shadow_of(plan, footprint, center, openings, FAR * reach),
        rounding=rounding,
    )
    region = footprint.buffer(max(within, STRIPS * openings.reach), quad_segs=QUARTER_CHORDS)
    if around.shadow.is_empty or not cuts_strips(_cut_off(around, region)[1]):
        return around
    return _with_strips(around, plan, region, openings)


def _with_strips(
    around: Surroundings, plan: Polygon | MultiPolygon, region: Polygon, openings: Openings
) -> Surroundings:
    """Return the plate around with the openings that leave strips as edges of it.

    They are those that go on beyond a region, and are seen from the center over SIDE or more; what lies between them
    and other edges is cut, and needs no tangents. All others have tangents.
    """
    from shapely import Polygon, difference, get_coordinates, get_parts, intersection, prepare, union_all

    holes = [Polygon(hole) for part in get_parts(plan) for hole in part.interiors]
    whole = union_all([Polygon(polygon.exterior) for polygon in get_parts(plan)])
    sides = [
        not region.covers(hole) and np.ptp(_directions(get_coordinates(hole) - around.center)) >= SIDE for hole in holes
    ]
    if not any(sides):
        return around
    within, beyond = (
        union_all([hole for hole, is_side in zip(holes, sides, strict=True) if is_side == kept])
        for kept in (False, True)
    )
    filled, part = difference(whole, beyond), around.plan.envelope
    rim = intersection(filled.boundary, part)
    prepare(rim)
    far = FAR * float(np.ptp(np.reshape(part.bounds, (2, 2)), axis=0).max())
    shadow = shadow_of(difference(whole, within), around.footprint, around.center, openings, far)
    return replace(around, filled=intersection(filled, part), rim=rim, shadow=shadow, strips=True)


def perimeter_at(
    around: Surroundings, distance: float, *, square: bool = False, near: float | None = None
) -> Perimeter:
    """Return the shortest perimeter on the plate at a distance [m] from a footprint (EN 1992-1-1 6.4.2).

    It runs around the footprint, with rounded corners, and ends where it meets the plate's edge (Figure 6.13), or runs
    straight out to one or several edges at a right angle, if that is shorter (Figure 6.15). Where the shortest one cuts
    the plate from edge to edge, which is one-way shear, it is the shortest of those that do not, all around or out to
    edges nearer than the opposite ones, as on a pad; on a strip all of them do. Lengths of the free edge
    itself do not count, nor what lies in the shadow of openings (Figure 6.14). With `square` its corners are square, as
    those of ACI 318-19 22.6.4.1. It may run out to edges up to a setback `near` [m], by default the distance.

    Raises
    ------
    InputError
        If nothing of the perimeter is left on the plate.
    """
    join: Literal["mitre", "round"] = "mitre" if square else "round"
    corner = distance * (2.0 if square else np.pi / 2)
    setback = distance if near is None else near
    stretched = [
        (edges, stretch(around, edges, distance))
        for edges in choose(around.edges)
        if _may_be_shorter(around, edges, corner, setback)
    ]
    regions = [polygon.buffer(distance, quad_segs=QUARTER_CHORDS, join_style=join) for _, polygon in stretched]
    ways = [_cut_off(around, region) for region in regions]
    lengths = [total_length(way) for _, way in ways]
    shortest = int(np.argmin(lengths))
    cut = _is_cut(around, regions[shortest], ways[shortest][1])
    if cut:
        near_ones = [i for i, (edges, _) in enumerate(stretched) if all(_is_nearer(around, edge) for edge in edges)]
        around_it = [i for i in near_ones if _goes_around(around, regions[i], ways[i][1], len(stretched[i][0]))]
        shortest = min(around_it, key=lengths.__getitem__, default=shortest)
        cut = not around_it
    inside, whole = ways[shortest]
    opened = not around.shadow.is_empty
    ring = _cut_off(around, regions[shortest], filled=True)[1] if opened else whole
    legs = outside(whole, around.shadow)
    if not total_length(legs) > around.rounding:
        where = Message("a column at {center:at m}", center=around.center)
        expected = Message("some plate at {distance:g m} from it", distance=distance)
        raise InputError([Issue("column", where, expected, "take a smaller distance")])
    setbacks = tuple(edge.setback for edge in stretched[shortest][0])
    return Perimeter(legs, whole, ring, inside, opened, setbacks, stretched[shortest][1], cut)


def _is_cut(around: Surroundings, region: Polygon, way: Array) -> bool:
    """Return whether legs (l, 2, 2) around a region cut the plate from edge to edge, or strips; none at all do not."""
    if len(way) == 0:
        return False
    return shape_of(way) == "cut" or (around.strips and not _is_in_one(around, region))


def _goes_around(around: Surroundings, region: Polygon, way: Array, edges: int) -> bool:
    """Return whether legs (l, 2, 2) around a region are in one piece and do not cut the plate.

    One that runs out to a number of edges turns so much at least; less do those that sides of a strip cut off.
    """
    if _is_cut(around, region, way) or not _is_in_one(around, region):
        return False
    return shape_of(way) in ("closed", "edge") or edges > 1


def _is_in_one(around: Surroundings, region: Polygon) -> bool:
    """Return whether the border of a region on the plate without openings is in one piece; sides of a strip part it."""
    return len(chains(_cut_off(around, region, filled=True)[1])) == 1


def _is_nearer(around: Surroundings, edge: NearEdge) -> bool:
    """Return whether an edge is nearer than all that face the other way, by more than rounding."""
    opposite = [other.setback for other in around.edges if float(other.outward @ edge.outward) < -np.sqrt(0.5)]
    return edge.setback < min(opposite, default=np.inf) - around.rounding


def _may_be_shorter(around: Surroundings, edges: tuple[NearEdge, ...], corner: float, near: float) -> bool:
    """Return whether a perimeter that runs out to near edges may be shorter than one all around, by their setbacks.

    All around are the sides of the footprint and four corners of a length [m]; two legs to one edge leave out a side
    and two corners, those to two edges two sides and three corners, those to three edges three sides and all corners.
    """
    x0, y0, x1, y1 = around.footprint.bounds
    width, setbacks = float(np.hypot(x1 - x0, y1 - y0)), [edge.setback for edge in edges]
    most = width / 2 + corner if len(edges) == 1 else len(edges) * width + (len(edges) + 1) * corner
    return not edges or (max(setbacks) <= near and sum(setbacks) < most)


def choose(edges: Sequence[NearEdge], at_most: int = NEAREST_EDGES) -> Iterator[tuple[NearEdge, ...]]:
    """Yield none of the nearest edges, then each of them, then several."""
    nearest = edges[:NEAREST_EDGES]
    for count in range(min(len(nearest), at_most) + 1):
        yield from combinations(nearest, count)


def stretch(around: Surroundings, edges: Sequence[NearEdge], distance: float = 0.0) -> Polygon:
    """Return the footprint stretched at a right angle over edges, and by a distance [m] beyond them."""
    from shapely import convex_hull, get_coordinates, multipoints

    points = get_coordinates(around.footprint)
    for edge in edges:
        points = np.vstack([points, points + (edge.depth + distance) * edge.outward])
    return convex_hull(multipoints(points))


def way_around(around: Surroundings, region: Polygon) -> Array:
    """Return the legs (l, 2, 2) [m] of a region's border on the plate, free edges left out."""
    return _cut_off(around, region)[1]


def outside(legs: Array, region: BaseGeometry) -> Array:
    """Return the parts (k, 2, 2) of legs (l, 2, 2) outside a region, each in the direction of its leg."""
    from shapely import LineString, difference, linestrings

    if region.is_empty:
        return legs
    parts = linestrings(legs)
    wholly, crossing = _wholly_or_in_part(parts, region)
    parts[wholly] = LineString()
    parts[crossing] = difference(parts[crossing], region)
    return _directed(legs, parts)


def within(legs: Array, region: BaseGeometry) -> Array:
    """Return the parts (k, 2, 2) of legs (l, 2, 2) in a region, each in the direction of its leg."""
    from shapely import LineString, intersection, linestrings

    parts = linestrings(legs)
    wholly, crossing = _wholly_or_in_part(parts, region)
    parts[crossing] = intersection(parts[crossing], region)
    parts[~(wholly | crossing)] = LineString()
    return _directed(legs, parts)


def _wholly_or_in_part(
    lines: np.typing.NDArray[Any], region: BaseGeometry
) -> tuple[np.typing.NDArray[np.bool_], np.typing.NDArray[np.bool_]]:
    """Return which of lines (l,) lie wholly in a region, and which in part: few, and only these take long to cut."""
    from shapely import covers, intersects, prepare

    prepare(region)
    wholly = covers(region, lines)
    return wholly, intersects(region, lines) & ~wholly


def _directed(legs: Array, parts_of_each: np.typing.NDArray[Any]) -> Array:
    """Return parts (k, 2, 2) of legs (l, 2, 2) by what is left of each (l,), in the direction of its leg."""
    from shapely import get_coordinates, get_parts, get_point, length

    parts, leg = get_parts(parts_of_each, return_index=True)
    solid = length(parts) > 0
    parts, leg = parts[solid], leg[solid]
    ends = np.stack([get_coordinates(get_point(parts, end)) for end in (0, -1)], axis=1)
    along = ((ends[:, 1] - ends[:, 0]) * (legs[leg, 1] - legs[leg, 0])).sum(axis=1)
    return np.where(along[:, None, None] >= 0, ends, ends[:, ::-1])


@made_once_by(attrgetter("nodes", "elements"))
def outline(plate: PlateResult) -> Polygon | MultiPolygon:
    """Return the plate in plan, its openings as holes, curved sides as chords."""
    return area_of(plate.nodes, plate.elements)


def area_of(nodes: Array, elements: Integers) -> Polygon | MultiPolygon:
    """Return the area in plan of elements (m, 9) with places of nodes (n, 2) [m], curved sides as chords."""
    from shapely import build_area, linestrings, multilinestrings

    # the border of two sections is no edge: its nodes stand once for each section, at exactly the same place
    _, first, same = np.unique(nodes + 0.0, axis=0, return_index=True, return_inverse=True)
    sides = first[sides_on_boundary(same.reshape(-1)[elements])]
    N, _ = lagrange(np.linspace(-1, 1, SIDE_CHORDS + 1))
    curves = np.einsum("ta,sax->stx", N, nodes[sides][:, [0, 2, 1]])
    return build_area(multilinestrings(linestrings(curves)))


def _near_edges(plan: Polygon | MultiPolygon, footprint: Polygon, rounding: float) -> Iterator[NearEdge]:
    """Yield the straight edges around the plate, the nearest to a footprint first."""
    from shapely import distance, get_coordinates, get_parts, linestrings
    from shapely.geometry.polygon import orient

    rings = [get_coordinates(orient(part).exterior.simplify(rounding)) for part in get_parts(plan)]
    ends = np.array([pair for ring in rings for pair in pairwise(ring)])
    setbacks = distance(linestrings(ends), footprint)
    points = get_coordinates(footprint)
    for i in np.argsort(setbacks, kind="stable"):
        a, b = ends[i]
        along = (b - a) / np.linalg.norm(b - a)
        outward = np.array([along[1], -along[0]])
        yield NearEdge(float(setbacks[i]), float(abs(((points - a) @ outward).min())), outward)


def _cut_off(around: Surroundings, region: Polygon, *, filled: bool = False) -> tuple[Polygon, Array]:
    """Return the part of the plate in a region that holds the column, and the legs (l, 2, 2) of its inner border."""
    from shapely import dwithin, get_coordinates, get_parts, intersection, points
    from shapely.geometry.polygon import orient

    plan, boundary = (around.filled, around.rim) if filled else (around.plan, around.boundary)
    parts = get_parts(intersection(plan, region))
    # mostly there is one part alone
    with_column = max(parts, key=lambda part: part.intersection(around.footprint).area) if len(parts) > 1 else parts[0]
    inside = orient(with_column)
    rings = [get_coordinates(ring) for ring in (inside.exterior, *inside.interiors)]
    legs = np.concatenate([np.stack([ring[:-1], ring[1:]], axis=1) for ring in rings])
    legs = legs[np.linalg.norm(legs[:, 1] - legs[:, 0], axis=1) > around.rounding]
    return inside, legs[~dwithin(boundary, points(legs.mean(axis=1)), around.rounding)]


def _directions(rays: Array) -> Array:
    """Return the angles (k,) [rad] of rays (k, 2) to places around an opening, from a center outside of it."""
    # they come back to where they began
    return np.unwrap(np.arctan2(rays[:, 1], rays[:, 0]))


def shadow_of(
    plan: Polygon | MultiPolygon, footprint: Polygon, center: Array, openings: Openings, far: float
) -> BaseGeometry:
    """Return the area between the tangents from a center to openings, out to a distance [m]."""
    from shapely import Polygon, get_coordinates, get_parts, union_all

    wedges = []
    for hole in (hole for part in get_parts(plan) for hole in part.interiors):
        if hole.distance(footprint) > openings.reach:
            continue
        rays = get_coordinates(hole) - center
        if openings.widened:
            rays = _widened(rays, get_coordinates(Polygon(hole).centroid)[0] - center)
        angles = _directions(rays)
        low, high = angles.min(), angles.max()
        steps = np.linspace(low, high, 2 + int((high - low) / SHADOW_STEP))
        wedges.append(Polygon(np.vstack([center, center + far * np.column_stack([np.cos(steps), np.sin(steps)])])))
    return union_all(wedges)


def _widened(rays: Array, middle: Array) -> Array:
    """Return the rays (k, 2) to an opening, widened to (l_1 l_2)^(1/2) if it is longer along its ray than across.

    l_1 is its extent along the ray to its middle (2,), l_2 that across (EN 1992-1-1 Figure 6.14).
    """
    along = middle / np.linalg.norm(middle)
    across = np.array([-along[1], along[0]])
    l_1, l_2 = np.ptp(rays @ along), np.ptp(rays @ across)
    if l_1 <= l_2:
        return rays
    return rays + np.outer((rays - middle) @ across * (np.sqrt(l_1 / l_2) - 1), across)
