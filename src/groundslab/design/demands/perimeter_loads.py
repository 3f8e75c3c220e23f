"""What acts inside a perimeter: the force that punches, pressure of the ground, line force of the edge, other loads.

No code's formulas are in here. What relieves a column's force is counted apart: the ground's pressure inside the
perimeter (EN 1992-1-1 6.4.4(2)), and the line force along the plate's edge, which is no pressure and relieves nothing
unless the case says so. Where it adds to what punches, it always counts.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple, TypeVar

import numpy as np

from groundslab.arrays import Array, Integers, made_once
from groundslab.design.demands.loads import column_loads
from groundslab.design.demands.loads.building_loads import BUILDING
from groundslab.design.demands.loads.edge_lengths import edge_inside
from groundslab.design.demands.perimeters import Footprint, Perimeter, RectangularColumn, RoundColumn
from groundslab.fem import load_vectors
from groundslab.fem.assembly import scatter
from groundslab.fem.mesh import Mesh
from groundslab.geometry.plan import FLAT
from groundslab.messages import Message
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.model.plates.region import PlateRegion
from groundslab.model.structure.columns import Column
from groundslab.model.supports import LineSupport
from groundslab.results.records import SupportResult
from groundslab.results.results import CombinationResult, Results

if TYPE_CHECKING:
    from shapely import LineString, Polygon
    from shapely.geometry.base import BaseGeometry

#: What lies inside a perimeter that runs out to a corner is at most so many times its distance away.
CORNER_REACH = 1 + math.sqrt(2)
#: Places so near to each other along a beam [m] are one.
NEAR_BY = 1e-6
#: Forces below this share of the largest of a kind are rounding.
ROUNDING = 1e-9


Place = TypeVar("Place")
Key = TypeVar("Key")
Demand = TypeVar("Demand")
#: What a check knows of the place of a column (False) or a pile (True), by its name, and whether it pulls.
Places = dict[tuple[tuple[bool, str], bool], Place]
#: How far from the face of a column or a pile punching is checked [m], and one-way shear beyond.
Reach = Mapping[tuple[bool, str], float]


def pushing_forces(
    results: Sequence[CombinationResult],
    forces: Sequence[PunchingForce],
    model: Model,
    of_places: tuple[
        Callable[[CombinationResult, Model], Places[Place]], Callable[[CombinationResult, PunchingForce], Place]
    ],
) -> Iterator[tuple[PunchingForce, Place, list[CombinationResult]]]:
    """Yield the forces, each way that it acts, what a check knows of the place of each, and the combinations.

    What is known of a place is made once for a mesh, and kept. One that pushes in some combinations and pulls in others
    comes twice, and so does one that turns the plate by moments alone, which press one side down and the other up.
    """
    kept, make = of_places
    least = rounding(forces, results)
    for punching in (way for force in forces for way in force.ways):
        pushing = [result for result in results if _acts(punching.pushing(result), least)]
        if pushing:
            sections, key = kept(pushing[0], model), (punching.key, punching.pulls)
            if key not in sections:
                sections[key] = make(pushing[0], punching)
            yield punching, sections[key], pushing


def _acts(pushing: Array, least: float) -> bool:
    """Return whether a force [N] with moments [N m] (3,) pushes, or turns without a force; what is less is rounding."""
    force, *moments = pushing
    return bool(force > least or (force >= -least and np.abs(moments).max() > least))


def only_turns(pushing: Array) -> bool:
    """Return whether of a force [N] with moments [N m] (3,) the moments act alone; the force is none, or rounding."""
    return bool(pushing[0] <= ROUNDING * np.abs(pushing[1:]).max())


def add_worse(demands: dict[Key, Demand], key: Key, demand: Demand, used: Callable[[Demand], float]) -> None:
    """Add a demand to those found by a key; of two ways in one combination the one that uses more of what resists."""
    if key not in demands or used(demand) > used(demands[key]):
        demands[key] = demand


def rounding(forces: Sequence[PunchingForce], results: Sequence[CombinationResult]) -> float:
    """Return below what a force is none [N]: rounding of the largest force or moment of a kind."""
    acting = (np.abs(force.acting(result)).max() for force in forces for result in results)
    return ROUNDING * float(max(acting, default=0.0))


@dataclass(frozen=True)
class PunchingForce:
    """A column on the plate or a pile below it, whose force punches the plate.

    One that pulls, tied to the far face of the plate, punches it the other way as if it stood there and pushed.
    """

    column: Column  # of a pile, one with its place and diameter
    by_case: Mapping[str, Array]  # (3,): P [N], M_x and M_y [N m] of a column, by load case
    support: int | None = None  # number of the pile among the supports, from 0
    pulls: bool = False

    @property
    def name(self) -> str:
        """Return the name of the column or pile."""
        return self.column.name

    @property
    def from_below(self) -> bool:
        """Return whether it punches upwards and has the tension at the top: a pile that pushes, a column that pulls."""
        return (self.support is not None) != self.pulls

    @property
    def key(self) -> tuple[bool, str]:
        """Return what no other column or pile has."""
        return self.support is not None, self.name

    @property
    def ways(self) -> tuple[PunchingForce, PunchingForce]:
        """Return it as one that pushes, and as one that pulls."""
        return replace(self, pulls=False), replace(self, pulls=True)

    @property
    def columns(self) -> tuple[str, ...]:
        """Return the names of the columns whose loads its force is."""
        return (self.name,) if self.support is None else ()

    @property
    def supports(self) -> tuple[int, ...]:
        """Return the numbers of the supports whose forces are in its force."""
        return () if self.support is None else (self.support,)

    @property
    def at_zone(self) -> bool:
        """Return whether it is a thicker zone of the plate, with what stands on it."""
        return False

    def edges_within(self, _: float) -> float:
        """Return how far away edges are that perimeters may run out to if these are shorter [m], by the depth [m]."""
        return math.inf

    def area_inside(self, line: Perimeter, distance: float) -> Polygon:  # noqa: ARG002
        """Return where what acts counts as inside of a perimeter at a distance [m]."""
        return line.inside

    @cached_property
    def footprint(self) -> Footprint:
        """Return the footprint of the column or pile on the plate."""
        return footprint_of(self.column)

    @property
    def place(self) -> tuple[float, float]:
        """Return its center [m]."""
        return self.column.x, self.column.y

    def pushing(self, results: CombinationResult) -> Array:
        """Return its force on the plate [N] the way it punches, and its moments [N m] (3,) in a combination.

        Moments are those that press the side of larger x or y that way.
        """
        return -self.acting(results) if self.pulls else self.acting(results)

    def acting(self, results: CombinationResult) -> Array:
        """Return its force [N], of a column downwards and of a pile upwards, and its moments [N m] (3,)."""
        if self.support is None:
            return column_loads.factored_sums(results, self.by_case)
        pile = results.supports[self.support]
        return np.array([pile.total, -float(pile.moment_x.sum()), -float(pile.moment_y.sum())])

    def thickness(self, results: CombinationResult) -> float:
        """Return the thickness of the plate that it punches [m]: the least one under it."""
        return thickness_at(results, self.footprint)

    def depth(self, results: CombinationResult, steel: Reinforcement) -> float:
        """Return the effective depth [m], to the mean of the axes of the bars in tension."""
        return self.thickness(results) - sum(steel.top_axes if self.from_below else steel.bottom_axes) / 2


def punching_columns(model: Model) -> tuple[PunchingForce, ...]:
    """Return the columns of a model."""
    return tuple(PunchingForce(column, column_loads.by_column(model, column.name)) for column in model.columns)


def punching_piles(model: Model) -> tuple[PunchingForce, ...]:
    """Return the piles of a model, and the other point supports that have a diameter."""
    return tuple(
        PunchingForce(
            Column(
                name=support.name or Message("support {number}", number=number),
                x=support.x,
                y=support.y,
                diameter=support.diameter,
            ),
            {},
            number - 1,
        )
        for number, support in enumerate(model.supports, start=1)
        if not isinstance(support, LineSupport) and support.diameter is not None
    )


def reach_without(combined: Results, *groups: tuple[Sequence[PunchingForce], Collection[str]]) -> Reach:
    """Return d [m] for those of some forces that have no perimeter, by their names: shear is checked from there on."""
    steel, result = combined.model.reinforcement, next(iter(combined.results.values()))
    assert steel is not None
    return {
        force.key: force.depth(result, steel) for forces, missing in groups for force in forces if force.name in missing
    }


def footprint_of(column: Column) -> Footprint:
    """Return a column's footprint."""
    if column.diameter is not None:
        return RoundColumn(column.x, column.y, column.diameter)
    assert column.width_x is not None
    assert column.width_y is not None
    return RectangularColumn(column.x, column.y, column.width_x, column.width_y, column.angle)


def thickness_at(results: CombinationResult, footprint: Footprint) -> float:
    """Return the plate's least thickness under a footprint [m]."""
    plate, thickness = results.plate, results.elements.thickness
    known = _thicknesses(thickness, plate.nodes, plate.elements)
    if footprint not in known:
        known[footprint] = _thickness_at(Mesh(plate.nodes, plate.elements), thickness, footprint)
    return known[footprint]


@made_once
def _thicknesses(thickness: Array, nodes: Array, elements: Integers) -> dict[Footprint, float]:  # noqa: ARG001
    """Return the least thickness [m] under footprints on a mesh, as they are added."""
    return {}


def _thickness_at(mesh: Mesh, thickness: Array, footprint: Footprint) -> float:
    """Return the least of the elements' thicknesses (m,) [m] under a footprint."""
    part = footprint.footprint()
    elements = load_vectors.find_elements_near(mesh, part)
    covered = load_vectors.areas_within(mesh, elements, part)
    return float(thickness[elements[covered > 1e-9 * covered.max()]].min())


def effective_depth(results: CombinationResult, footprint: Footprint, steel: Reinforcement) -> float:
    """Return the least thickness under a footprint less the mean distance of the bottom bars' axes [m]."""
    return thickness_at(results, footprint) - sum(steel.bottom_axes) / 2


@dataclass(frozen=True, slots=True)
class PerimeterLoads:
    """What lies inside a perimeter, the same in every combination."""

    nodes: Integers  # (k,)
    area: Array  # (k,): these nodes' shares of the area inside [m2]
    edge_nodes: Integers  # (e,)
    edge: Array  # (e,): these nodes' shares of the length of the plate's edge inside [m]
    others: Mapping[str, Array]  # (3,): other loads [N] and their first moments [N m], by load case
    supports: tuple[int, ...] = ()  # numbers of the other supports inside, from 0
    crossings: tuple[Crossing, ...] = ()  # of beams
    joints: tuple[HandedOver, ...] = ()  # by other plates
    weights: Mapping[str, tuple[float, float]] = field(default_factory=dict)  # unit weight [N/m3], volume [m3], by case

    def of_cases(self, results: CombinationResult) -> tuple[CaseInside, ...]:
        """Return what the load cases of a combination have inside, and all of the building above together."""
        factors = column_loads.factors_of(results)
        above = sum(
            factors[case] * float(sums[0])
            for case, sums in self.others.items()
            if factors.get(case) and case.startswith(BUILDING)
        )
        cases = tuple(
            CaseInside(case, factors[case], float(sums[0]), *self.weights.get(case, (0.0, 0.0)))
            for case, sums in self.others.items()
            if factors.get(case) and sums[0] and not case.startswith(BUILDING)
        )
        return (*cases, CaseInside(BUILDING, 1.0, above, 0.0, 0.0)) if above else cases

    @property
    def size(self) -> float:
        """Return the area of the plate inside [m2]."""
        return float(self.area.sum())


class CaseInside(NamedTuple):
    """What a load case has inside a perimeter."""

    case: str  # BUILDING of all that the building above puts there
    factor: float  # in the combination
    force: float  # of all its loads there but for those of the column itself, downwards [N]
    unit_weight: float  # of the slab, if its weight is in this case [N/m3]
    volume: float  # of the slab inside [m3]


@dataclass(frozen=True, slots=True)
class HandedOver:
    """What a joint hands over inside a perimeter."""

    joint: int  # number, from 0
    down: float  # sign of its force where that presses down
    part: Polygon  # inside the perimeter
    near: float  # what is so far from it at most is inside [m]

    def acting(self, results: CombinationResult) -> Array:
        """Return its force on the plate inside, downwards [N], and its first moments (3,) [N m]."""
        from shapely import dwithin, points

        joint = results.joints[self.joint]
        inside = dwithin(self.part, points(joint.nodes), self.near)
        return self.down * _with_moments(joint.force[inside], joint.nodes[inside])


@dataclass(frozen=True, slots=True)
class Crossing:
    """Where a beam runs into a perimeter (sign -1) or out of it (sign 1)."""

    beam: int  # number, from 0
    way: float  # along the beam, from its start [m]
    sign: float
    place: Array  # (2,) [m]
    along: Array  # (2,): the beam's direction

    def acting(self, results: CombinationResult) -> Array:
        """Return the beam's force on what is inside, downwards [N], and its first moments (3,) [N m]."""
        beam = results.beams[self.beam].at(np.array([self.way]))
        M, V, T = (float(force[0]) for force in (beam.moment, beam.own_shear, beam.torsion))
        left = np.array([-self.along[1], self.along[0]])
        return self.sign * np.array([V, *(V * self.place - M * self.along - T * left)])


class MomentParts(NamedTuple):
    """What the moments of all forces by their places about a perimeter's center are made of, along two axes.

    Of loads inside they are those of forces downwards, of the ground those of forces upwards.
    """

    own: Array  # (2,): of the column or pile itself [N m]
    away: Array  # (2,): its center from that of the perimeter [m]
    others: Array  # (2,): of other loads inside [N m]
    pressure: Array  # (2,): of the ground's pressure inside [N m]
    edge: Array  # (2,): of the line force along the plate's edge inside, where it counts [N m]
    supports: Array  # (2,): of other supports inside, as far as they add [N m]

    def along(self, frame: Array) -> MomentParts:
        """Return them along other axes (2, 2), a unit vector in each row."""
        return MomentParts(*(frame @ part for part in self))


@dataclass(frozen=True, slots=True)
class PunchingShear:
    """What punches on a perimeter in one combination."""

    V: float  # force that punches, less or more what else acts inside [N]
    moments: Array  # (2,): of all that about the perimeter's center [N m]
    pressure: float  # of the ground inside [N]
    edge: float  # line force of the ground along the plate's edge inside [N]
    others: float  # other loads inside, shear forces of beams across the perimeter, and what joints add inside [N]
    supported: bool  # whether another support acts inside; what it adds to V is counted, what it takes off is not
    parts: MomentParts  # of the moments
    cases: tuple[CaseInside, ...] = ()  # what load cases have in the other loads


@dataclass(frozen=True, slots=True)
class LoadsNear:
    """The elements, loads and supports near a column or pile, from which those inside its perimeters are taken."""

    elements: Integers
    shapes: column_loads.Shapes  # without the loads of the column itself
    supports: tuple[tuple[int, BaseGeometry], ...]  # numbers and places of the other supports
    joints: tuple[tuple[int, float], ...] = ()  # numbers of the plate's joints, and the sign of their force downwards

    def inside(self, results: CombinationResult, part: Polygon) -> PerimeterLoads:
        """Return the loads inside a perimeter that cuts off a part of the plate."""
        (loads,) = self.inside_each(results, [part])
        return loads

    def inside_each(self, results: CombinationResult, parts: Sequence[Polygon]) -> list[PerimeterLoads]:
        """Return the loads inside each of several perimeters."""
        mesh = Mesh(results.plate.nodes, results.plate.elements)
        shares = load_vectors.integrate_over_polygons(mesh, self.elements, parts, rule=load_vectors.SHAPE_POINTS)
        return [self._inside(results, mesh, part, share) for part, share in zip(parts, shares, strict=True)]

    def _inside(self, results: CombinationResult, mesh: Mesh, part: Polygon, shares: Array) -> PerimeterLoads:
        """Return the loads inside a perimeter by the elements' shares int N dA (k, 9) [m2] of its area."""
        area = scatter(mesh.elements[self.elements], shares, len(mesh.nodes))
        nodes = np.flatnonzero(area)
        others = column_loads.acting_inside(results, part, (), self.shapes, (self.elements, shares))
        supports = tuple(number for number, place in self.supports if part.intersects(place))
        crossings = tuple(_crossings(results.model, part))
        near = FLAT * max(results.model.sides)
        joints = tuple(HandedOver(number, down, part, near) for number, down in self.joints)
        edge = edge_inside(results.plate, part)
        weights = column_loads.weights_inside(results, self.shapes, (self.elements, shares))
        return PerimeterLoads(nodes, area[nodes], *edge, others, supports, crossings, joints, weights)


def reach_of(line: Perimeter, distance: float) -> float:
    """Return how far from the footprint a perimeter at a distance runs at most, straight out to edges too [m]."""
    return distance + sum(line.setbacks)


def loads_near(results: CombinationResult, punching: PunchingForce, within: float) -> LoadsNear:
    """Return the loads near a column or pile whose perimeters are within a distance [m]."""
    from shapely import LineString, Point

    model = results.solved_model
    part = punching.footprint.footprint().buffer(CORNER_REACH * within)
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    supports = tuple(
        (number, LineString(support.points) if support.edges else Point(support.points[0]))
        for number, support in enumerate(model.supports)
        if number not in punching.supports
    )
    shapes = column_loads.shapes_around(model, part, punching.columns)
    joints = tuple(_joints_of(results, punching.place))
    return LoadsNear(load_vectors.find_elements_near(mesh, part), shapes, supports, joints)


def _joints_of(results: CombinationResult, place: tuple[float, float]) -> Iterator[tuple[int, float]]:
    """Yield the numbers of the joints of the plate at a place, and the sign of their force downwards on it."""
    model = results.solved_model
    if not results.joints:
        return
    here = model.every_plate[PlateRegion(model.plate, model.plates).plate_at(place)].name
    for number, joint in enumerate(model.joints):
        if here in joint.between:
            yield number, 1.0 if joint.between[1] == here else -1.0


def punching_shear(
    results: CombinationResult, inside: PerimeterLoads, punching: PunchingForce, center: Array, *, edge_relieves: bool
) -> PunchingShear:
    """Return the punching force and moments on a perimeter about its center (2,) [m] in a combination.

    Of a column V is its force and the other loads inside less the ground's pressure there; of a pile, or a column that
    pulls, its force and the pressure less the loads. What beams carry out of the perimeter does not punch. The edge's
    line force inside is taken off only where the case says so, but added in any case where it adds. What joints with
    other plates and other supports inside take off is not counted either, as each support may stand on the perimeter
    itself; what they add is, which is on the safe side: a perimeter around all of them is longer.
    """
    sign = -1.0 if punching.from_below else 1.0
    plate = results.plate
    force, *own_moments = punching.pushing(results)
    pressure = _with_moments(inside.area * plate.pressure[inside.nodes], plate.nodes[inside.nodes])
    edge = _with_moments(inside.edge * plate.line_force[inside.edge_nodes], plate.nodes[inside.edge_nodes])
    others = column_loads.factored_sums(results, inside.others)
    others = sum((crossing.acting(results) for crossing in inside.crossings), others)
    handed = [joint.acting(results) for joint in inside.joints]
    others = sum((force for force in handed if sign * force[0] > 0), others)
    acting = np.array([force, *(force * np.array(punching.place))]) + sign * (others - pressure)
    counted = edge if edge_relieves or sign * edge[0] < 0 else np.zeros(3)
    acting = acting - sign * counted
    along = [-sign * _force_of(results.supports[number]) for number in inside.supports]
    adding = sum((force for force in along if force[0] > 0), np.zeros(3))
    acting = acting + adding
    moments = np.array(own_moments) + acting[1:] - acting[0] * center
    supported = any(force[0] for force in along)
    of_each = (forces[1:] - forces[0] * center for forces in (others, pressure, counted, adding))
    parts = MomentParts(np.array(own_moments), np.array(punching.place) - center, *of_each)
    sums = float(pressure[0]), float(edge[0]), float(others[0])
    return PunchingShear(float(acting[0]), moments, *sums, supported, parts, inside.of_cases(results))


def _force_of(support: SupportResult) -> Array:
    """Return the force of a support on the plate, upwards [N], and its first moments (3,) [N m]."""
    return _with_moments(support.force, support.nodes)


def _crossings(model: Model, part: Polygon) -> Iterator[Crossing]:
    """Yield where beams run into a part of the plate, and out of it; their ends inside are none."""
    for number, beam in enumerate(model.members):
        axis = beam.to_shapely(FLAT * max(model.sides))
        for start, end in _stretches(axis, part):
            for way, sign in ((start, -1.0), (end, 1.0)):
                if NEAR_BY < way < axis.length - NEAR_BY:
                    before, after = (np.array(axis.interpolate(way + step).coords[0]) for step in (-NEAR_BY, NEAR_BY))
                    along = (after - before) / np.linalg.norm(after - before)
                    yield Crossing(number, way * beam.length / axis.length, sign, (before + after) / 2, along)


def _stretches(axis: LineString, part: Polygon) -> list[tuple[float, float]]:
    """Return from where to where along an axis [m] it lies in a part of the plate, also if it crosses itself there."""
    import shapely

    places = shapely.get_coordinates(axis)
    pieces = np.stack([places[:-1], places[1:]], axis=1)
    starts = np.cumsum([0.0, *np.linalg.norm(pieces[:, 1] - pieces[:, 0], axis=1)])
    shapely.prepare(part)
    lines = shapely.linestrings(pieces)
    met = np.flatnonzero(shapely.intersects(part, lines))
    parts, which = shapely.get_parts(shapely.intersection(lines[met], part), return_index=True)
    corners, of = shapely.get_coordinates(parts, return_index=True)
    piece = met[which[of]]
    ways = starts[piece] + np.linalg.norm(corners - pieces[piece, 0], axis=1)
    spans = sorted((ways[of == number].min(), ways[of == number].max()) for number in np.unique(of))
    whole: list[tuple[float, float]] = []
    for start, end in spans:
        if whole and start <= whole[-1][1] + NEAR_BY:
            whole[-1] = whole[-1][0], max(end, whole[-1][1])
        else:
            whole.append((start, end))
    return whole


def _with_moments(forces: Array, places: Array) -> Array:
    """Return the sum of forces (k,) [N] at places (k, 2) [m] and their first moments (3,)."""
    return np.array([forces.sum(), *(forces @ places)])
