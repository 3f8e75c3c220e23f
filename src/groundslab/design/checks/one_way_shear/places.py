"""Where a slab's one-way shear is read: at its nodes, and at d from walls and footprints, with what resists there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.design.bars.required_bars import largest_areas, required_areas
from groundslab.design.checks.one_way_shear.faces import Bearer, pressing, region_within_d, webs_of
from groundslab.design.checks.one_way_shear.necks import is_beside
from groundslab.design.demands.by_plate import distances_to_edges, farthest_from_edges, results_by_plate
from groundslab.design.demands.cuts.line_traversal import interpolation, pieces
from groundslab.design.demands.loads.column_loads import factors_of
from groundslab.design.demands.perimeter_loads import PunchingForce, Reach
from groundslab.design.demands.perimeters import outline
from groundslab.design.demands.zones.thicker_zones import SAME
from groundslab.design.rules.design_code import ShearRule
from groundslab.design.rules.wide_beam import Cut
from groundslab.fem.mesh import Mesh
from groundslab.model.design.averaging import along_axis
from groundslab.model.design.floors import TR34Floor
from groundslab.model.design.laid_bars import laid_bars, polygon_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.design.shear_links import ShearLinks
from groundslab.model.loads.acting import PointForce
from groundslab.model.remarks.singular_places import near_singular
from groundslab.model.supports import LineSupport
from groundslab.results.fields import LAYERS
from groundslab.results.plate_result import ElementResult, PlateResult
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: What the largest shear force in any direction, and the bars that count, are made of.
FORCES = ("moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")


@dataclass(frozen=True, slots=True)
class Places:
    """Places at which one-way shear is read, k of them, and what is the same there in every combination."""

    xy: Array  # (k, 2) [m]
    nodes: Integers  # (k, a): that the values come from
    weights: Array  # (k, a): of the nodes' values
    element: Integers  # (k,): whose own shear force counts if it is larger, -1 if none's
    d: Array  # (k,): effective depth, the lesser of both faces [m]
    thickness: Array  # (k,) [m]
    ratios: Mapping[str, Array]  # (k,): bars over the depth, by layer
    counts: Flags  # (k,): whether one-way shear is checked there
    links: Integers  # (k,): which links stand there, -1 if none
    of_plate: Flags  # (k, 2): whether shear along x and along y is the plate's, not that of a strip that is a beam

    def forces(self, plate: PlateResult, elements: ElementResult) -> dict[str, Array]:
        """Return moments [N m/m] and shear forces [N/m] by the names of FORCES, (k,) each."""
        forces = {name: self.mean(getattr(plate, name)) for name in FORCES}
        inside = {name: getattr(elements, name)[self.element] for name in ("shear_x", "shear_y")}
        size, its = (np.hypot(vector["shear_x"], vector["shear_y"]) for vector in (forces, inside))
        larger = (self.element >= 0) & (its > size)
        shear = {name: np.where(larger, values, forces[name]) for name, values in inside.items()}
        return forces | {
            name: values * of_plate for (name, values), of_plate in zip(shear.items(), self.of_plate.T, strict=True)
        }

    def mean(self, values: Array) -> Array:
        """Return nodal values (n,) at the places (k,)."""
        return np.asarray((self.weights * values[self.nodes]).sum(axis=1))

    def by_links(self, steel: Reinforcement) -> Iterator[tuple[Places, ShearLinks | None]]:
        """Yield the places without links, and those where some stand, with them."""
        yield self.of(self.counts & (self.links < 0)), None
        for number in np.unique(self.links[self.counts & (self.links >= 0)]).tolist():
            yield self.of(self.counts & (self.links == number)), steel.shear_links[number]

    def of(self, counts: Flags) -> Places:
        """Return the same places with others of them that count."""
        return replace(self, counts=counts)


@dataclass(frozen=True, slots=True)
class PlacesByReach:
    """Places beyond d from what presses on the plate in a combination, and nodes nearer to it."""

    beyond: tuple[Places, ...]  # nodes, and places at d
    within: Places  # nodes
    necks: tuple[Cut, ...]  # beyond d


@dataclass(frozen=True, slots=True)
class ShearPlaces:
    """The places of a slab, sorted in each combination by what presses on the plate there."""

    steel: Reinforcement
    nodes: Places
    bearers: list[Bearer]
    forces: Sequence[PunchingForce]  # whose punching is checked instead near them
    reach: Reach  # how far from them [m], else 2 d
    necks: list[Cut]  # across narrow parts of the slab
    links: Mapping[str, float]  # how far from the face outer links against punching are [m], by what has them
    beyond_links: float  # so far beyond these punching is checked, over d
    _known: dict[tuple[tuple[int, ...], ...], PlacesByReach] = field(default_factory=dict)

    def of(self, results: CombinationResult) -> PlacesByReach:
        """Return the places of a combination."""
        which = pressing(results, self.bearers)
        acting = tuple(number for number, force in enumerate(self.forces) if force.acting(results).any())
        if (which, acting) not in self._known:
            bearers = [self.bearers[position] for position in which]
            self._known[which, acting] = self._sort(results, bearers, [self.forces[number] for number in acting])
        return self._known[which, acting]

    def _sort(
        self, results: CombinationResult, bearers: list[Bearer], punching: Sequence[PunchingForce]
    ) -> PlacesByReach:
        """Return the places sorted by their distance from the faces of what presses on the plate."""
        from shapely import contains_xy

        nodes = self._away(results, self.nodes, punching)
        webs, axes = webs_of(results.solved_model)
        within_d = region_within_d(results.plate, bearers, nodes.d)
        region = within_d.union(webs)
        d = nodes.d
        necks = tuple(cut for cut in self.necks if not is_beside(results, cut, cut.mean(d), punching, bearers))
        if region.is_empty:
            return PlacesByReach((nodes,), nodes.of(np.zeros_like(nodes.counts)), necks)
        near, on_web = (np.asarray(contains_xy(part, *nodes.xy.T)) for part in (within_d, webs))
        beyond = nodes.of(nodes.counts & ~near & ~on_web)
        at_d = _on_border(results, self.steel, region, [*(bearer.shape for bearer in bearers), *axes], nodes)
        within = nodes.of(nodes.counts & near & ~on_web)
        return PlacesByReach(
            (beyond,) if at_d is None else (beyond, self._away(results, at_d, punching)), within, necks
        )

    def _away(self, results: CombinationResult, places: Places, punching: Sequence[PunchingForce]) -> Places:
        """Return places of which those do not count that are so near to what punches that punching is checked there.

        In slab thinner than under a column that is 2 d of the thinner slab, and around a thicker zone no place on it.
        """
        from shapely import distance, points

        counts, at_places = places.counts, points(places.xy)
        for force in punching:
            reach = np.minimum(self.reach.get(force.key, np.inf), 2 * places.d)
            if force.name in self.links:
                reach = np.maximum(reach, self.links[force.name] + self.beyond_links * places.d)
            near = distance(at_places, force.footprint.footprint()) <= reach
            if force.at_zone:
                near &= places.thickness <= force.thickness(results) * (1 + SAME)
            counts = counts & ~near
        return places.of(counts)


def nodes_of(steel: Reinforcement, rule: ShearRule, results: list[CombinationResult]) -> Places:
    """Return the plate's nodes."""
    plate = results[0].plate
    thickness = results[0].elements.at_nodes(plate)[0]
    d = thickness - max(sum(steel.bottom_axes), sum(steel.top_axes)) / 2
    if steel.laid:
        areas = {layer: laid_bars(steel, layer, plate.nodes).area for layer in LAYERS}
    else:
        required = required_areas(steel, results)
        areas = {layer: largest_areas(required, layer)[0] for layer in LAYERS}
    least = rule.least_share * thickness
    ratios = {layer: np.minimum(np.maximum(area, least) / d, rule.most_ratio) for layer, area in areas.items()}
    numbers = np.arange(len(d))
    counts = _counts(results[0], plate.nodes, d, thickness)
    ones = np.ones((len(d), 1))
    links, of_plate = _links_at(steel, plate.nodes), _of_plate(results[0], plate.nodes)
    return Places(
        plate.nodes, numbers[:, None], ones, np.full(len(d), -1), d, thickness, ratios, counts, links, of_plate
    )


def _on_border(
    results: CombinationResult, steel: Reinforcement, region: BaseGeometry, shapes: list[BaseGeometry], nodes: Places
) -> Places | None:
    """Return the places on the plate along the border of what lies within d of some shapes, None if there are none.

    There are three in each element that the border crosses. In an element that meets a line, whose nodes there have
    the mean of both sides, its own shear force is the better one where it is larger.
    """
    from shapely import STRtree, get_parts, union_all

    plan = union_all([outline(plate) for plate in results_by_plate(results).values()])
    legs = [leg for line in get_parts(region.boundary.intersection(plan)) for leg in _legs_of(line)]
    if not legs:
        return None
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    line = pieces(mesh, np.array(legs))
    piece = np.tile(np.arange(len(line.low)), 3)
    s = np.concatenate([line.low, (line.low + line.high) / 2, line.high])
    nearest, weights = interpolation(mesh, line, piece, s)
    d, thickness = ((weights * values[nearest]).sum(axis=1) for values in (nodes.d, nodes.thickness))
    ratios = {layer: (weights * rho[nearest]).sum(axis=1) for layer, rho in nodes.ratios.items()}
    xy = line.points(piece, s)
    meets = np.zeros(len(mesh.elements), dtype=bool)
    meets[STRtree(_polygons(mesh)).query(shapes, predicate="intersects")[1]] = True
    element = np.where(meets[line.element[piece]], line.element[piece], -1)
    counts, of_plate = _counts(results, xy, d, thickness), _of_plate(results, xy)
    return Places(xy, nearest, weights, element, d, thickness, ratios, counts, _links_at(steel, xy), of_plate)


def _links_at(steel: Reinforcement, xy: Array) -> Integers:
    """Return which links of a slab stand at places (k, 2) [m], -1 where none do; of several the first."""
    from shapely import covers, points

    which = np.full(len(xy), -1)
    for number in range(len(steel.shear_links) - 1, -1, -1):
        which[covers(polygon_of(steel.shear_links[number].shape.ring()), points(xy))] = number
    return which


def links_along(steel: Reinforcement, cut: Cut) -> ShearLinks | None:
    """Return the links that stand all along a cut, if any do."""
    from shapely import covers, linestrings

    legs = linestrings(cut.legs)
    return next((links for links in steel.shear_links if covers(polygon_of(links.shape.ring()), legs).all()), None)


def _of_plate(results: CombinationResult, xy: Array) -> Flags:
    """Return at which places (k, 2) shear along x and along y is the plate's, not that of a strip that is a beam."""
    from shapely import covers, points

    of_plate = np.ones((len(xy), 2), dtype=bool)
    for strip in results.model.output.beams:
        of_plate[covers(strip.area(), points(xy)), along_axis(strip)] = False
    return of_plate


def is_of_beam(results: CombinationResult, cut: Cut) -> bool:
    """Return whether the shear force over a cut is that of a strip that is a beam."""
    n_x, n_y = _of_plate(results, np.array([cut.place]))[0]
    return bool(not n_x if abs(cut.normal[0]) > abs(cut.normal[1]) else not n_y)


def _legs_of(line: BaseGeometry) -> list[Array]:
    """Return the straight legs (2, 2) of a line [m], nothing of a point."""
    from shapely import get_coordinates

    places = get_coordinates(line)
    return [np.array(leg) for leg in pairwise(places) if (leg[0] != leg[1]).any()]


def _polygons(mesh: Mesh) -> Array:
    """Return the elements as polygons of their corners (m,)."""
    from shapely import polygons

    cells: Array = polygons(mesh.xy[:, :4])
    return cells


def _counts(results: CombinationResult, xy: Array, d: Array, thickness: Array) -> Flags:
    """Return at which places (k, 2) one-way shear is checked, whatever acts.

    Within 2 d of a support whose diameter is not known nothing can be checked.
    """
    from shapely import MultiPoint, distance, points

    model = results.solved_model
    bare = [
        (support.x, support.y)
        for support in model.supports
        if not isinstance(support, LineSupport) and support.diameter is None
    ]
    far = ~(distance(points(xy), MultiPoint(bare)) <= 2 * d)
    # of a narrow slab the middle half counts in any case
    middle = farthest_from_edges(results) / 2
    inner = distances_to_edges(results, xy) > np.minimum(thickness, middle)
    return np.asarray(far & inner & ~near_singular(model, xy, thickness))


def near_forces(results: CombinationResult, xy: Array, d: Array) -> Flags:
    """Return which places are within 2 d of a force of a combination whose punching is checked as a floor's."""
    from shapely import distance, points, union_all

    model = results.solved_model
    factors = factors_of(results)
    if not isinstance(model.floor, TR34Floor):
        return np.zeros(len(d), dtype=bool)
    chord = 1e-3 * max(model.plate.sides)
    shapes = [
        point.to_shapely(chord)
        for load, point in model.acting
        if isinstance(point, PointForce) and factors.get(load.case, 0.0) * point.P > 0
    ]
    footprints = union_all([shape for shape in shapes if shape.area > 0])
    return np.asarray(distance(points(xy), footprints) <= 2 * d)
