"""What stands on an industrial floor in a combination: forces that act as one, groups of two and four, line loads."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.design.codes.floors.yield_lines import Location
from groundslab.design.demands.loads.column_loads import factors_of
from groundslab.design.demands.perimeters import RectangularColumn, RoundColumn
from groundslab.geometry.plan import FLAT
from groundslab.model.loads.acting import AreaPressure, LineForce, PlateAction
from groundslab.model.loads.clipping import clip_line
from groundslab.model.loads.load_types import PointLoad
from groundslab.model.model import Model
from groundslab.model.plates.region import get_plate_region
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely import Polygon
    from shapely.geometry.base import BaseGeometry

#: Forces nearer to each other than so many thicknesses act as one on all that they enclose (TR34).
AS_ONE = 2.0
#: A corner of the outline turns by more than this [rad].
TURN = math.pi / 4 - 1e-9
#: Groups are looked for among so many nearest neighbors; two directions are at right angles to within this cosine.
NEIGHBORS, RIGHT = 12, 1e-3
#: A footprint that fills less of the rectangle around it is a circle: pi / 4 and a margin.
ROUND = 0.8
#: Areas that differ by a smaller share are the same.
SAME = 1e-9
WORST: tuple[Location, ...] = ("internal", "edge", "corner")


@dataclass(frozen=True, slots=True)
class Force:
    """A force P [N] at a place [m] on a circle of radius a [m]; what of it the slab carries is its share."""

    P: float
    a: float
    place: tuple[float, float]
    location: Location
    share: float
    shape: BaseGeometry  # what all of it stands on
    away: float = 0.0  # from the corner that it is near, or else from the nearest edge [m]
    cases: tuple[tuple[str, float, float], ...] = ()  # each case with its factor and its loads [N]


class LinePiece(NamedTuple):
    """A line load on the plate: the largest q [N/m] of its case, the case's factor, where it is."""

    case: str
    factor: float
    q: float
    away: float  # from edges [m]
    place: tuple[float, float]  # of its middle [m]


class Pressure(NamedTuple):
    """A pressure on an area or on the whole plate, and what others add there, with their factors."""

    case: str  # empty of what acts on the whole plate
    factor: float
    q: float  # the largest of it [Pa]
    over: float  # of others that it may overlap [Pa]
    everywhere: float  # on the whole plate [Pa]
    place: tuple[float, float]  # [m]

    @property
    def own(self) -> float:
        """Return it with its factor [Pa]."""
        return self.factor * self.q

    @property
    def total(self) -> float:
        """Return it with what others add [Pa]."""
        return self.own + self.over + self.everywhere


class Borders:
    """The edges and corners of a plate."""

    def __init__(self, model: Model) -> None:
        self.chord = 100 * FLAT * max(model.sides)
        self.ring = model.plate.ring().polygon(self.chord)
        self.openings = [opening.ring().polygon(self.chord) for opening in model.plate.openings]

    @cached_property
    def corners(self) -> Array:
        """The corners of the outline (c, 2) [m]."""
        from shapely import get_coordinates

        at = get_coordinates(self.ring.exterior)[:-1]
        before, after = at - np.roll(at, 1, axis=0), np.roll(at, -1, axis=0) - at
        cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
        turned = np.arctan2(cross, (before * after).sum(axis=1))
        corners: Array = at[turned * (1 if self.ring.exterior.is_ccw else -1) > TURN]
        return corners

    def locate(self, place: tuple[float, float], reach: float) -> tuple[Location, float, bool]:
        """Return where a place lies, near being within a reach [m], how far from the corner or the nearest edge [m].

        Last is whether it is near the plate's outline.
        """
        from shapely import Point

        point = Point(place)
        corner = float(np.hypot(*(self.corners - place).T).min(initial=np.inf))
        if corner < reach:
            return "corner", corner, True
        outer = float(self.ring.exterior.distance(point))
        if outer < reach:
            return "edge", outer, True
        away = min([outer, *(float(opening.distance(point)) for opening in self.openings)])
        return ("edge" if away < reach else "internal"), away, False


def forces(results: CombinationResult, borders: Borders, h: float, l: float, transfer: float) -> list[Force]:  # noqa: E741
    """Return the downward forces of a combination; those near each other are one on all that they enclose.

    Near an edge is nearer than l + a; there joints carry over a share of the force, but not at openings.
    """
    from shapely import union_all

    model = results.solved_model
    factors = factors_of(results)
    point_loads = [
        (factors[load.case] * load.P, load.on(model.columns), load)
        for load in model.loads
        if isinstance(load, PointLoad) and factors.get(load.case, 0.0) * load.P > 0
    ]
    P = np.array([force for force, _, _ in point_loads])
    places = np.array([(load.x, load.y) for _, load, _ in point_loads], dtype=float).reshape(-1, 2)
    grouped = []
    for members in _as_one(places, AS_ONE * h):
        shapes = [point_loads[n][1].to_shapely(borders.chord) for n in members]
        shape = union_all(shapes).convex_hull if len(shapes) > 1 else shapes[0]
        x, y = (P[members] @ places[members] / P[members].sum()).tolist()
        a = math.sqrt(shape.area / math.pi)
        location, away, at_outline = borders.locate((x, y), l + a)
        share = 1 - transfer if at_outline else 1.0
        cases = _by_case([point_loads[n][2] for n in members], factors)
        grouped.append(Force(float(P[members].sum()), a, (x, y), location, share, shape, away, cases))
    return grouped


def _by_case(loads: Sequence[PointLoad], factors: Mapping[str, float]) -> tuple[tuple[str, float, float], ...]:
    """Return each case of some loads, with its factor and the sum of its loads [N]."""
    sums: dict[str, float] = {}
    for load in loads:
        sums[load.case] = sums.get(load.case, 0.0) + load.P
    return tuple((case, factors[case], P) for case, P in sums.items())


def _as_one(places: Array, distance: float) -> list[Integers]:
    """Return the numbers of places (p, 2) that are joined by steps shorter than a distance [m]."""
    if not len(places):
        return []
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import KDTree

    n, pairs = len(places), KDTree(places).query_pairs(distance * (1 - 1e-9), output_type="ndarray")
    joined = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(n, n))
    count, label = connected_components(joined, directed=False)
    return [np.flatnonzero(label == number) for number in range(count)]


def groups(loads: list[Force], reach: float) -> Iterator[tuple[tuple[Force, ...], float]]:
    """Yield two forces with their distance [m], and four on a rectangle with the sum of its sides, within a reach."""
    if len(loads) < 2:
        return
    from scipy.spatial import KDTree

    places = np.array([load.place for load in loads])
    tree = KDTree(places)
    _, near = tree.query(places, k=min(NEIGHBORS + 1, len(loads)), distance_upper_bound=reach)
    seen = set[tuple[int, ...]]()
    for i, others in enumerate(near.tolist()):
        arms = [(j, places[j] - places[i]) for j in others if j != i and j < len(loads)]
        for j, v in arms:
            x = float(np.hypot(*v))
            if (pair := tuple(sorted((i, j)))) not in seen:
                seen.add(pair)
                yield (loads[i], loads[j]), x
            for k, w in arms:
                y = float(np.hypot(*w))
                if k <= j or abs(v @ w) > RIGHT * x * y:
                    continue
                off, m = tree.query(places[i] + v + w)
                four = tuple(sorted((i, j, k, int(m))))
                if off <= RIGHT * min(x, y) and four not in seen:
                    seen.add(four)
                    yield (loads[i], loads[j], loads[k], loads[int(m)]), x + y


def as_column(load: Force) -> RectangularColumn | RoundColumn:
    """Return a force's footprint for punching: a rectangle around it, or a circle where that is much larger.

    What is a rectangle at an angle stays one.
    """
    x0, y0, x1, y1 = load.shape.bounds
    x, y, width_x, width_y = (x0 + x1) / 2, (y0 + y1) / 2, x1 - x0, y1 - y0
    around = load.shape.oriented_envelope
    if around.area < (1 - SAME) * width_x * width_y and load.shape.area > (1 - SAME) * around.area:
        return _turned_rectangle(around)
    if load.shape.area < ROUND * width_x * width_y:
        return RoundColumn(x, y, 2 * load.a)
    return RectangularColumn(x, y, width_x, width_y)


def _turned_rectangle(around: Polygon) -> RectangularColumn:
    """Return a rectangle at an angle as a column's footprint."""
    (x, y), ((ax, ay), (bx, by), (cx, cy)) = around.centroid.coords[0], around.exterior.coords[:3]
    angle = math.degrees(math.atan2(by - ay, bx - ax))
    return RectangularColumn(x, y, math.hypot(bx - ax, by - ay), math.hypot(cx - bx, cy - by), angle)


def worst_location(loads: tuple[Force, ...]) -> Location:
    """Return the location of a group: that of its force nearest to edges and corners."""
    return max((load.location for load in loads), key=WORST.index)


def line_loads(results: CombinationResult, borders: Borders) -> Iterator[LinePiece]:
    """Yield each line load of a combination."""
    from shapely import LineString

    model = results.solved_model
    factors = factors_of(results)
    for load, shape in model.acting:
        if isinstance(shape, LineForce) and factors.get(load.case):
            for piece in clip_line(model.plate, shape, model.plates):
                line = LineString(piece.edge.at(np.linspace(0, 1, piece.edge.chords(borders.chord) + 1)))
                away = min(edge.distance(line) for edge in (borders.ring.exterior, *borders.openings))
                x, y = line.interpolate(0.5, normalized=True).coords[0]
                yield LinePiece(load.case, factors[load.case], max(piece.q), away, (x, y))


def pressures(results: CombinationResult) -> Iterator[Pressure]:
    """Yield each pressure of a combination with those that it may overlap, and a place in it.

    A pressure on the whole plate counts where its case is variable: goods are not everywhere all the time.
    """
    model = results.solved_model
    factors = factors_of(results)
    plate = get_plate_region(model.plate, model.plates).grown
    variable = {case.name for case in model.cases if case.action == "variable"}
    everywhere = 0.0
    parts: list[tuple[str, float, float, BaseGeometry]] = []
    for load, shape in model.acting:
        factor = factors.get(load.case, 0.0)
        if isinstance(shape, PlateAction) and load.case in variable:
            everywhere += factor * shape.pressure.q
        elif factor and isinstance(shape, AreaPressure) and shape.on == "plate":
            area = shape.to_shapely().intersection(plate)
            if area.area > 0:
                corners = np.array(area.convex_hull.exterior.coords)
                parts.append((load.case, factor, float(shape.pressure(corners).max()), area))
    if everywhere > 0:
        x0, x1, y0, y1 = model.bounds
        yield Pressure("", 0.0, 0.0, 0.0, everywhere, ((x0 + x1) / 2, (y0 + y1) / 2))
    for n, (case, factor, q, area) in enumerate(parts):
        over = sum(
            by * other
            for m, (_, by, other, at) in enumerate(parts)
            if m != n and by * other > 0 and area.intersects(at)
        )
        place = area.representative_point()
        yield Pressure(case, factor, q, over, everywhere, (place.x, place.y))
