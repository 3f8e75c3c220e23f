"""What punching of a foundation slab is checked with: the control perimeter and the shear force on it.

EN 1992-1-1 6.4.2 (perimeters), 6.4.3 (v_Ed, beta) and 6.4.4 (foundations: the pressure inside the perimeter carries its
part of the column's force). Resistances are in `en1992/punching`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations, pairwise
from typing import TYPE_CHECKING, Literal

import numpy as np

from groundslab.arrays import Array
from groundslab.design.section_cuts import rotate_to_cut
from groundslab.errors import InputError, Issue
from groundslab.fem import load_vectors
from groundslab.fem.line_traversal import interpolation, pieces
from groundslab.fem.mesh import Mesh, sides_on_boundary
from groundslab.fem.shape_functions import lagrange
from groundslab.geometry.places import same_place
from groundslab.geometry.plan import format_place
from groundslab.results.mesh_results import PlateResult

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon


#: Chords of a quarter of a circle; the perimeter is shorter than with arcs by less than 3e-5 of itself.
QUARTER_CHORDS = 64
#: Chords of a curved side of an element at the plate's edge.
SIDE_CHORDS = 16
#: A side of a column shorter than itself by this share lies on an edge in part.
SAME_SIDE = 1e-6
#: An opening counts up to this distance from the column, in effective depths (6.4.2 (3)).
OPENING_REACH = 6.0
#: Of the plate's edges near a column so many are tried as edges that the perimeter may run out to.
NEAREST_EDGES = 3


#: How a perimeter runs, by the angle in degrees that it turns at least.
Shape = Literal["closed", "edge", "corner", "cut"]
TURNED: Mapping[Shape, float] = {"closed": 225.0, "edge": 135.0, "corner": 45.0, "cut": -1.0}


@dataclass(frozen=True, slots=True)
class RectangularColumn:
    """A column's footprint: a rectangle along x and y around its center [m]."""

    x: float
    y: float
    width_x: float
    width_y: float

    def footprint(self) -> Polygon:
        """Return the rectangle."""
        from shapely import box

        a, b = self.width_x / 2, self.width_y / 2
        return box(self.x - a, self.y - b, self.x + a, self.y + b)


@dataclass(frozen=True, slots=True)
class RoundColumn:
    """A column's footprint: a circle around its center [m]."""

    x: float
    y: float
    diameter: float

    def footprint(self) -> Polygon:
        """Return the circle, as chords."""
        from shapely import Point

        return Point(self.x, self.y).buffer(self.diameter / 2, quad_segs=QUARTER_CHORDS)


@dataclass(frozen=True, slots=True)
class Perimeter:
    """A control perimeter on the plate, and the part of the plate that it cuts off with the column."""

    legs: Array  # (l, 2, 2): straight pieces on the plate, what it cuts off on their left; free edges are none [m]
    inside: Polygon
    u: float  # its length, less what lies in the shadow of openings [m]

    @property
    def length(self) -> float:
        """Return the length of all legs [m]."""
        return float(np.linalg.norm(self.legs[:, 1] - self.legs[:, 0], axis=1).sum())


@dataclass(frozen=True, slots=True)
class Punching:
    """The demand of punching on a control perimeter, all of it positive where the column pushes down."""

    V_Ed: float  # column's force + other loads inside - contact pressure inside [N]
    u: float  # length of the perimeter that counts [m]
    v_Ed: float  # V_Ed / (u d) [Pa]
    pressure_inside: float  # contact pressure integrated over the part inside the perimeter [N]
    area: float  # of that part [m2]
    shear: float  # the field of shear forces integrated along the perimeter: V_Ed but for the error of the mesh [N]
    largest: float  # the largest shear force per length on the perimeter [N/m]; grows at free edges, see demand
    perimeter: Perimeter


def demand(
    plate: PlateResult,
    column: RectangularColumn | RoundColumn,
    d: float,
    force: float,
    distributed: float = 0.0,
    distance: float | None = None,
) -> Punching:
    """Return the demand of punching by a column's force [N] at a distance [m] from it, 2 d unless given.

    d is the effective depth [m], `distributed` the other loads on the slab inside [Pa], its self-weight for example.
    V_Ed is the reduced force of (6.4.4 (2)): the loads inside less all of the ground's force inside. A line force
    along the edge counts with it, spread over half an element.

    Where a perimeter ends at a free edge, the twisting moment that must vanish there gives large shear forces over
    about the plate's thickness. The largest one is that of the mesh, then, and grows as the mesh is refined.
    """
    reach = 2 * d if distance is None else distance
    issues = []
    if not d > 0:
        issues.append(Issue("d", f"{d:g} m", "an effective depth greater than zero"))
    if not reach >= 0:
        issues.append(Issue("distance", f"{reach:g} m", "a distance that is not negative"))
    if issues:
        raise InputError(issues)
    line = perimeter(plate, column, reach, OPENING_REACH * d)
    mesh = Mesh(plate.nodes, plate.elements)
    shares = load_vectors.integrate_over_polygon(mesh, np.arange(len(mesh.elements)), line.inside)
    pressure = float((shares * (plate.contact_force / plate.area)[mesh.elements]).sum())
    V_Ed = force + distributed * line.inside.area - pressure
    shear, largest = _shear(plate, line)
    return Punching(
        V_Ed=V_Ed,
        u=line.u,
        v_Ed=V_Ed / (line.u * d),
        pressure_inside=pressure,
        area=float(line.inside.area),
        shear=shear,
        largest=largest,
        perimeter=line,
    )


def perimeter(
    plate: PlateResult,
    column: RectangularColumn | RoundColumn,
    distance: float,
    opening_reach: float,
    square: bool = False,
) -> Perimeter:
    """Return the shortest control perimeter on the plate at a distance [m] from a column (EN 1992-1-1 6.4.2).

    It runs around the column, with rounded corners, and ends where it meets the plate's edge (Figure 6.13), or runs
    straight out to one or several near edges at a right angle, if that is shorter (Figure 6.15). Lengths of the free
    edge itself do not count, nor what lies between the tangents from the column's center to an opening within
    `opening_reach` [m] (Figure 6.14; an opening longer along the ray than across it is not widened as there). With
    `square` its corners are square, as those of ACI 318-19 22.6.4.1.
    """
    from shapely.affinity import translate

    plan = outline(plate)
    x0, y0, x1, y1 = plan.bounds
    # about the column's center, as curves meet with few digits far from x = y = 0
    plan, footprint = (translate(part, -column.x, -column.y) for part in (plan, column.footprint()))
    near = same_place(x0, x1, y0, y1)
    where = f"a column at {format_place((column.x, column.y))} m"
    if footprint.area == 0 or not plan.buffer(near).covers(footprint):
        raise InputError([Issue("column", where, "a footprint that lies on the plate")])
    join: Literal["mitre", "round"] = "mitre" if square else "round"
    found = [_cut_off(plan, swept.buffer(distance, quad_segs=QUARTER_CHORDS, join_style=join), footprint, near)
             for swept in _swept(plan, footprint, distance, near)]  # fmt: skip
    inside, legs = min(found, key=lambda one: float(np.linalg.norm(one[1][:, 1] - one[1][:, 0], axis=1).sum()))
    u = _effective(plan, footprint, legs, opening_reach)
    if not u > near:
        raise InputError([Issue("column", where, f"some plate at {distance:g} m from it", "take a smaller distance")])
    return Perimeter(legs + np.array([column.x, column.y]), translate(inside, column.x, column.y), u)


def shape_of(legs: Array) -> tuple[Shape, Array]:
    """Return how a perimeter of legs (l, 2, 2) runs, and the direction (2,) from end to end, of a closed one x.

    It is told by the angle that it turns: all around the column, half around at an edge, a quarter at a corner. One
    that hardly turns cuts the slab from edge to edge, which is one-way shear and no punching.
    """
    from shapely import get_coordinates, get_parts, line_merge, linestrings, multilinestrings

    chains = [get_coordinates(chain) for chain in get_parts(line_merge(multilinestrings(linestrings(legs))))]
    turned = 0.0
    for chain in chains:
        steps = np.diff(chain, axis=0)
        if (chain[0] == chain[-1]).all():
            steps = np.vstack([steps, steps[:1]])
        angles = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
        turned += abs(float(np.degrees(angles[-1] - angles[0])))
    shape = next(name for name, least in TURNED.items() if turned > least)
    longest = max(chains, key=len)
    chord = longest[-1] - longest[0]
    if shape == "closed" or not chord.any():
        return shape, np.array([1.0, 0.0])
    return shape, chord / np.linalg.norm(chord)


def reduced_share(legs: Array, footprint: Polygon, along: Array, d: float) -> float:
    """Return u_1* / u_1 of a perimeter at an edge that runs `along` (2,), by Figure 6.20a.

    Of legs at a right angle to the edge the least of 1.5 d and half of the column's side counts, from its inner face.
    """
    from shapely import get_coordinates

    inward = np.array([-along[1], along[0]])
    inward = inward * np.sign(inward @ (centroid(legs) - legs[0, 0]) or 1.0)
    across = get_coordinates(footprint) @ inward
    least = across.max() - min(1.5 * d, 0.5 * np.ptp(across))
    start, end = legs[:, 0] @ inward - least, legs[:, 1] @ inward - least
    length = np.linalg.norm(legs[:, 1] - legs[:, 0], axis=1)
    size = np.abs(start) + np.abs(end)
    # of a leg that crosses the limit, the part beyond it
    beyond = np.divide(np.maximum(start, 0) + np.maximum(end, 0), size, out=np.zeros_like(size), where=size > 0)
    return float(length @ beyond / length.sum())


def centroid(legs: Array) -> Array:
    """Return the centroid (2,) [m] of straight pieces (l, 2, 2) of a perimeter."""
    length = np.linalg.norm(legs[:, 1] - legs[:, 0], axis=1)
    return np.asarray(length @ legs.mean(axis=1) / length.sum())


def moduli(legs: Array, axes: Array) -> Array:
    """Return W_1 = int |e| dl (2,) [m2] of a perimeter, e along x and along y from axes (2,) [m], by 6.40."""
    length = np.linalg.norm(legs[:, 1] - legs[:, 0], axis=1)[:, None]
    start, end = legs[:, 0] - axes, legs[:, 1] - axes
    size = np.abs(start) + np.abs(end)
    crossing = np.divide(start**2 + end**2, 2 * size, out=np.zeros_like(size), where=size > 0)
    return np.asarray((length * np.where(start * end >= 0, size / 2, crossing)).sum(axis=0))


def face_length(plate: PlateResult, column: RectangularColumn | RoundColumn, d: float) -> float:
    """Return u_0 [m], the length of a column's perimeter that counts for the check at its face (EN 1992-1-1 6.4.5(3)).

    All of it within the plate; of a rectangular column at an edge c_2 + 3 d at most, at a corner 3 d. c_2 is the side
    along the edge, d the effective depth [m]. Openings that do not touch the column do not shorten it.
    """
    line = perimeter(plate, column, 0.0, 0.0)
    if isinstance(column, RoundColumn):
        return line.length
    along_x, along_y = np.abs(line.legs[:, 1] - line.legs[:, 0]).sum(axis=0)
    cut_x, cut_y = along_x < (2 - SAME_SIDE) * column.width_x, along_y < (2 - SAME_SIDE) * column.width_y
    most = line.length
    if cut_x and cut_y:
        most = 3 * d
    elif cut_x or cut_y:
        most = float(along_x if cut_x else along_y) + 3 * d
    return min(line.length, most)


def outline(plate: PlateResult) -> Polygon | MultiPolygon:
    """Return the plate in plan, its openings as holes, curved sides as chords."""
    from shapely import build_area, linestrings, multilinestrings

    # the border of two sections is no edge: its nodes stand once for each section, at exactly the same place
    _, first, same = np.unique(plate.nodes + 0.0, axis=0, return_index=True, return_inverse=True)
    sides = first[sides_on_boundary(same.reshape(-1)[plate.elements])]
    N, _ = lagrange(np.linspace(-1, 1, SIDE_CHORDS + 1))
    curves = np.einsum("ta,sax->stx", N, plate.nodes[sides][:, [0, 2, 1]])
    return build_area(multilinestrings(linestrings(curves)))


def _swept(plan: Polygon | MultiPolygon, footprint: Polygon, distance: float, near: float) -> list[Polygon]:
    """Return the footprint itself, and stretched at a right angle over near edges of the plate, one and several."""
    from shapely import LineString, MultiPoint, get_coordinates, get_parts
    from shapely.geometry.polygon import orient

    ways = []
    for part in get_parts(plan):
        for a, b in pairwise(get_coordinates(orient(part).exterior.simplify(near))):
            apart = LineString([a, b]).distance(footprint)
            if apart <= distance:
                along = (b - a) / np.linalg.norm(b - a)
                outward = np.array([along[1], -along[0]])
                far = ((get_coordinates(footprint) - a) @ outward).min()
                ways.append((apart, (abs(far) + distance) * outward))
    ways = sorted(ways, key=lambda way: way[0])[:NEAREST_EDGES]
    swept = []
    for count in range(len(ways) + 1):
        for chosen in combinations(ways, count):
            points = get_coordinates(footprint)
            for _, way in chosen:
                points = np.vstack([points, points + way])
            swept.append(MultiPoint(points).convex_hull)
    return swept


def _cut_off(plan: Polygon | MultiPolygon, region: Polygon, footprint: Polygon, near: float) -> tuple[Polygon, Array]:
    """Return the part of the plate in a region that holds the column, and the legs (l, 2, 2) of its inner border."""
    from shapely import distance, get_coordinates, get_parts, intersection, points
    from shapely.geometry.polygon import orient

    parts = get_parts(intersection(plan, region))
    inside = orient(max(parts, key=lambda part: part.intersection(footprint).area))
    rings = [get_coordinates(ring) for ring in (inside.exterior, *inside.interiors)]
    legs = np.concatenate([np.stack([ring[:-1], ring[1:]], axis=1) for ring in rings])
    legs = legs[np.linalg.norm(legs[:, 1] - legs[:, 0], axis=1) > near]
    return inside, legs[distance(points(legs.mean(axis=1)), plan.boundary) > near]


def _effective(plan: Polygon | MultiPolygon, footprint: Polygon, legs: Array, reach: float) -> float:
    """Return the length [m] of legs without the part between the tangents to openings within reach of the column."""
    from shapely import MultiPoint, get_coordinates, get_parts, linestrings, multilinestrings, union_all

    center = get_coordinates(footprint.centroid)[0]
    openings = [hole for part in get_parts(plan) for hole in part.interiors if hole.distance(footprint) < reach]
    x0, y0, x1, y1 = plan.bounds
    shadows = []
    for opening in openings:
        ray = get_coordinates(opening) - center
        ray *= 1e3 * np.hypot(x1 - x0, y1 - y0) / np.linalg.norm(ray, axis=1, keepdims=True)
        shadows.append(MultiPoint(np.vstack([center, center + ray])).convex_hull)
    return float(multilinestrings(linestrings(legs)).difference(union_all(shadows)).length)


def _shear(plate: PlateResult, line: Perimeter) -> tuple[float, float]:
    """Return - int q_n ds [N] along a perimeter, n outwards, and the largest - q_n [N/m] on it."""
    mesh = Mesh(plate.nodes, plate.elements)
    crossed = pieces(mesh, line.legs)
    piece, s, ds = crossed.gauss()
    nodes, N = interpolation(mesh, crossed, piece, s)
    q_x, q_y = (np.einsum("pa,pa->p", N, field[nodes]) for field in (plate.shear_x, plate.shear_y))
    none = np.zeros_like(q_x)
    q_n = rotate_to_cut(none, none, none, q_x, q_y, crossed.along[crossed.leg[piece]])[3]
    return float(-(ds @ q_n)), float(-q_n.min())
