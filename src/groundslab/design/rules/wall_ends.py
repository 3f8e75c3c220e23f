"""What punches the slab at ends and corners of walls: the shear force of the slab across perimeters around them.

What the end of a wall carries to the slab is not known from the wall's load, which presses all along it. So what
punches is the shear force that the slab takes away from there. Codes say at what distances, and what resists it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, partial
from typing import Literal

import numpy as np

from groundslab.accuracy.values import estimate_error
from groundslab.arrays import Array, made_once_by
from groundslab.design.demands.by_plate import plate_under
from groundslab.design.demands.edge_strip import plates_that_count
from groundslab.design.demands.loads.wall_loads import WallLoads, forces_on_walls, loads_on_wall
from groundslab.design.demands.perimeter_loads import footprint_of, thickness_at
from groundslab.design.demands.perimeter_pieces import WeightedLegs, what_counts
from groundslab.design.demands.perimeters import FAR, Openings, Perimeter, SketchedPerimeter, outline, shadow_of
from groundslab.design.demands.wall_perimeters import (
    MOST_ACROSS,
    MOST_AROUND,
    LoadedArea,
    WallPerimeters,
    half_length,
    loaded_area,
    wall_perimeters,
)
from groundslab.design.demands.zones.thinner_slab import Share, depth_share, shares_at, thinner_parts
from groundslab.design.rules.calculation import BY_CHORDS, MEGA, Step, axis_step
from groundslab.design.rules.combinations import ultimate_results
from groundslab.messages import Message, Name
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.model.structure.columns import Column
from groundslab.model.structure.wall_ends import WallEnd, wall_ends
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult, Results

#: beta at an end and at a corner of walls (DIN EN 1992-1-1/NA, Figure NA.6.21.1).
BETA: Mapping[str, float] = {"end": 1.35, "corner": 1.20}
#: Where it is shown how much of walls counts.
FIGURE = "DIN EN 1992-1-1/NA Figure NA.6.12.1"
#: What the symbols of the length that counts are told apart by from those of the whole perimeter.
COUNTED = "counted"
#: The openings that count, of a slab's thickness and its effective depth [m].
Reach = Callable[[float, float], Openings]


@dataclass(frozen=True, slots=True)
class WallSite:
    """An end or a corner of walls on its plate, and the perimeters around it."""

    area: LoadedArea
    column: Column  # as wide along x and y as the loaded area
    d: float  # effective depth [m]
    perimeters: WallPerimeters
    pulls: bool = False  # whether the walls pull up, so that the bars in tension are those at the top
    shear: Callable[[int], Array] | None = field(default=None, repr=False, compare=False)  # on legs of one [N]

    @property
    def face(self) -> Literal["bottom", "top"]:
        """Return the face whose bars are in tension."""
        return "top" if self.pulls else "bottom"

    def sketch(self, a: float) -> SketchedPerimeter:
        """Return what a sketch of the perimeter at a distance a [m] shows, with the slab's shear force across it.

        Places are along the first wall and to its left, from where the wall ends, or from where the axes meet.
        """
        from shapely import MultiPoint, Polygon, union_all

        k = self._position(a)
        legs, shares = self.perimeters.legs[k]
        shear = None if self.shear is None else self.shear(k)
        whole = WeightedLegs(legs, shear=shear)
        counted = tuple(WeightedLegs(legs[shares == share], float(share)) for share in np.unique(shares) if share > 0)
        area, run = self.area, self.area.run[0]
        sides = zip(area.outer, area.along, area.run, area.outward, (self.end.legs[0], self.end.legs[-1]), strict=True)
        quads = []
        for start, along, way, out, leg in sides:
            face = np.array([start, start + along * way])
            quads.append(Polygon(np.vstack([face, face[::-1] - leg.thickness * out])))
        loaded = union_all(quads)
        inside = MultiPoint(np.vstack([legs.reshape(-1, 2), area.points])).convex_hull
        line = Perimeter(what_counts(counted), legs, legs, inside, bool((shares < 1).any()), (), loaded)
        about = area.center, np.array([run, [-run[1], run[0]]]), np.array(self.end.place)
        further = ((COUNTED, SketchedPerimeter(line, counted, *about)),) if (shares < 1).any() else ()
        return SketchedPerimeter(line, (whole,), *about, further)

    def _position(self, a: float) -> int:
        """Return the position of the perimeter at a distance [m]."""
        return int(np.argmin(np.abs(self.perimeters.distances - a)))

    def course_steps(self, a: float, symbols: tuple[str, str, str, str], clause: str) -> Iterator[Step]:
        """Yield how long the perimeter at a distance a [m] is, as much of the walls counting as counts.

        The symbols are those of the effective depth, of the distance, of the whole length on the plate and of what
        counts of it.
        """
        d, distance, whole, counted = symbols
        k = self._position(a)
        yield axis_step(self.area.run)
        legs = (self.end.legs[0],) if self.end.kind == "end" else (self.end.legs[0], self.end.legs[-1])
        for n, (leg, along) in enumerate(zip(legs, self.area.along, strict=False), 1):
            name = Name(leg.wall)
            yield Step(Message("thickness of {wall}", wall=name), f"b_{n}", leg.thickness, "m")
            yield Step(Message("length of {wall} from here on", wall=name), f"L_{n}", leg.length, "m")
            formula = f"min(L_{n}, 2 * b_{n}, {MOST_AROUND:g} * {d} - min(b_{n}, {MOST_ACROSS:g} * {d})) / 2"
            by_figure = half_length(leg, self.d)
            if along < by_figure:
                formula = f"min({formula}, {along / self.d:g} * {d})"
            words = Message("length along a side of {wall} that counts, a_1 / 2", wall=name)
            yield Step(words, f"l_{n}", along, "m", formula, FIGURE)
        formula = f"2 * l_1 + alpha * {distance}" if len(legs) == 1 else f"l_1 + l_2 + alpha * {distance}"
        if self.area.across:
            across = f"min(b_1, {MOST_ACROSS:g} * {d})" if len(legs) == 1 else ""
            yield Step(
                "width across the end that counts, b_1 of the figure", "b_e", self.area.across, "m", across, FIGURE
            )
            formula = f"b_e + {formula}"
        turned = self.end.outer_angle - math.pi
        yield Step("angle that it turns by around the corners", "alpha", turned, "rad")
        u, on_plate = float(self.perimeters.u[k]), float(self.perimeters.whole[k])
        by_parts = self.area.across + sum(self.area.along) + turned * a
        follows = math.isclose(by_parts, on_plate, rel_tol=BY_CHORDS)
        yield Step("its length on the slab", whole, on_plate, "m", formula if follows else "", clause)
        if not math.isclose(u, on_plate, rel_tol=BY_CHORDS):
            yield Step("what counts of it, less openings, less in thinner slab", counted, u, "m", clause=clause)

    def whole(self, a: float) -> float:
        """Return how long the perimeter at a distance a [m] is on the plate [m]."""
        return float(self.perimeters.whole[self._position(a)])

    def force_steps(self, a: float, V: float, symbols: tuple[str, str], clause: str) -> Iterator[Step]:
        """Yield the shear force V [N] of the slab across the perimeter at a distance a [m], by its mean."""
        whole, force = symbols
        mean = V / float(self.perimeters.whole[self._position(a)])
        words = "mean shear force of the slab across it, by integration along it"
        yield Step(words, "v_m", mean / 1e3, "kN/m")
        yield Step(
            "shear force of the slab across the perimeter", force, V / MEGA, "MN", f"v_m * {whole} / 1000", clause
        )

    @property
    def end(self) -> WallEnd:
        """Return which end or corner it is."""
        return self.area.end

    @property
    def beta(self) -> float:
        """Return by what v_Ed is larger than its mean, as the force does not act in the perimeter's center."""
        return BETA[self.end.kind]


@dataclass(frozen=True, slots=True)
class WallPunching:
    """What punches at an end or a corner of walls that press on the slab, or pull at it, in one combination."""

    site: WallSite
    results: CombinationResult
    V: Array  # (k,): the slab's shear force across each perimeter, away from walls that press [N]
    error: Callable[[int], float | None]  # of the one across a perimeter, by its position [N]

    @property
    def v(self) -> Array:
        """Return the largest stress on each perimeter (k,) [Pa]."""
        return self.of_force(self.V)

    def of_force(self, V: Array) -> Array:
        """Return the stresses that forces (k,) [N] make."""
        return self.site.beta * V / (self.site.perimeters.u * self.site.d)

    def error_of_stress(self, position: int) -> float | None:
        """Return the error of the stress on a perimeter [Pa]."""
        error = self.error(position)
        return None if error is None else self.site.beta * error / float(self.site.perimeters.u[position] * self.site.d)


def loaded_ends(model: Model) -> tuple[WallEnd, ...]:
    """Return the ends and corners of walls through which any load acts."""
    loaded = forces_on_walls(model)
    if not loaded:
        return ()
    return tuple(
        end
        for end in wall_ends(model.placed_walls, model.spans_of_walls)
        if any(leg.wall in loaded for leg in end.legs)
    )


@made_once_by(lambda results, model: (results.plate.nodes, model))
def _known_sites(results: CombinationResult, model: Model) -> dict[bool, list[WallSite]]:  # noqa: ARG001
    """Return the sites of a model, as they are added, where walls press (False) and where they pull."""
    return {}


def punching_walls(
    combined: Results,
    steel: Reinforcement,
    distances: Array,
    openings: Reach,
    most_along: float = np.inf,
    share: Share = depth_share,
) -> Iterator[WallPunching]:
    """Yield what punches at ends and corners of walls at distances over d (k,), in all ultimate combinations.

    Of walls no more than most_along d counts on each side, and of perimeters a share in thinner slab.

    Of a line force along the plate's edge that does not relieve, the worse of both distributions counts (`edge_strip`).
    """
    model, results = combined.model, ultimate_results(combined)
    if not (model.walls and results):
        return
    first = results[0]
    counts = openings, share
    forces = forces_at_ends(model, results)
    sites_by_way = _known_sites(first, model)
    for pulls in (False, True):
        if pulls not in sites_by_way and any((force < 0) if pulls else (force > 0) for force in forces.values()):
            sites_by_way[pulls] = [*_sites(first, steel, distances, counts, (most_along, pulls))]
    sites = [site for of_way in sites_by_way.values() for site in of_way]
    if not sites:
        return
    nodes = np.unique(np.concatenate([site.perimeters.nodes for site in sites]))

    def plates(mesh: CombinationResult) -> tuple[PlateResult, ...]:
        return plates_that_count(mesh, relieves=steel.line_force_relieves, nodes=nodes)

    for result in results:
        coarser = cache(lambda mesh=result.coarser: () if mesh is None else plates(mesh))
        here = plates(result)
        for site in sites:
            force = forces[result.combination, site.end.name]
            if force < 0 if site.pulls else force > 0:
                yield _punching(result, site, here, coarser)


def _punching(
    result: CombinationResult,
    site: WallSite,
    plates: tuple[PlateResult, ...],
    coarser: Callable[[], tuple[PlateResult, ...]],
) -> WallPunching:
    """Return what punches at a site, by the plates that count and those on the coarser mesh.

    As both meshes may agree by accident, a force has the largest error of itself and those next to it.
    """

    def shear(plates_of_mesh: tuple[PlateResult, ...]) -> Array:
        sign = -1.0 if site.pulls else 1.0
        largest: Array = np.max([sign * site.perimeters.shear(plate) for plate in plates_of_mesh], axis=0)
        return largest

    def on_legs(position: int) -> Array:
        sign, legs = -1.0 if site.pulls else 1.0, site.perimeters.legs[position]
        return max((sign * legs.shear(plate) for plate in plates), key=lambda on_each: float(on_each.sum()))

    V, before = shear(plates), cache(lambda: shear(coarser()))

    def error(position: int) -> float | None:
        if result.comparison is None or not coarser():
            return None
        near = slice(max(position - 1, 0), position + 2)
        pairs = zip(V[near].tolist(), before()[near].tolist(), strict=True)
        return max(estimate_error(*pair, result.comparison) for pair in pairs)

    return WallPunching(replace(site, shear=on_legs), result, V, error)


def forces_at_ends(model: Model, results: Sequence[CombinationResult]) -> dict[tuple[str, str], float]:
    """Return by how much loads press at ends and corners of walls [N/m], negative if they pull.

    They are the loads that act through the walls; by combination and name.
    """
    ends = loaded_ends(model)
    walls = {wall.name: (wall.length, loads_on_wall(model, wall)) for wall in model.placed_walls} if ends else {}
    return {(result.combination, end.name): _force(end, walls, result) for result in results for end in ends}


def _force(end: WallEnd, walls: Mapping[str, tuple[float, WallLoads]], result: CombinationResult) -> float:
    """Return by how much the loads of the walls, of known length [m], of an end or a corner press there [N/m]."""
    force = 0.0
    for leg in end.legs:
        length, loads = walls[leg.wall]
        force += loads.at(leg.share * length, loads.in_combination(result)[0])
    return force


def _sites(
    results: CombinationResult,
    steel: Reinforcement,
    distances: Array,
    counts: tuple[Reach, Share],
    walls: tuple[float, bool],
) -> Iterator[WallSite]:
    """Yield the ends and corners of walls with some plate beyond them, by how much counts and whether they pull."""
    (openings, share), (most_along, pulls) = counts, walls
    for end in loaded_ends(results.model):
        x, y = end.place
        plan = outline(plate_under(results, x, y))
        column = _column(loaded_area(end, np.inf), end.name)
        thickness = thickness_at(results, footprint_of(column))
        d = thickness - sum(steel.top_axes if pulls else steel.bottom_axes) / 2
        area, footprint = loaded_area(end, d, most_along), footprint_of(column).footprint()
        far = FAR * (float(distances[-1]) * d + max(column.width_x or 0.0, column.width_y or 0.0))
        shadow = shadow_of(plan, footprint, area.center, openings(thickness, d), far)
        thinner = thinner_parts(results, footprint, thickness, float(distances[-1]) * d)
        shares = partial(shares_at, parts=thinner, share=share, d=d) if thinner else None
        perimeters = wall_perimeters(results.plate, plan, area, distances * d, shadow, shares)
        if len(perimeters.distances):
            yield WallSite(area, column, d, perimeters, pulls)


def _column(area: LoadedArea, name: str) -> Column:
    """Return a column as wide along x and y as a loaded area."""
    (x0, y0), (x1, y1) = area.points.min(axis=0), area.points.max(axis=0)
    return Column(name=name, x=(x0 + x1) / 2, y=(y0 + y1) / 2, width_x=x1 - x0, width_y=y1 - y0)
