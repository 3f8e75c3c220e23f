"""One-way shear by EN 1992-1-1 6.2 or ACI 318-19 22.5: where a slab needs links away from columns, where none help.

The shear force is the largest of any direction at a node, the bars that count are those of the face that is in tension
in that direction: those that are laid, or those that bending needs. Left out are places where it is not this that is
checked: near columns as far as punching is, which is 2 d unless that perimeter cuts the slab from edge to edge, and
within 2 d of supports and of the forces on a floor whose punching is checked by TR34; within a thickness of free edges
(a quarter of the width of a narrow slab), where the shear force along the edge is what the twisting moment has become;
and near singular places. Nearer to columns ACI 318 asks for means across the slab (`wide_beam`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.aci318 import shear as aci318
from groundslab.design.aci318.bending import LEAST
from groundslab.design.aci318.materials import PHI_SHEAR
from groundslab.design.by_plate import edges_of
from groundslab.design.checks.check import DesignCheck, Status
from groundslab.design.checks.wide_beam import cuts
from groundslab.design.en1992 import shear
from groundslab.design.floors.acting_loads import factors_of
from groundslab.design.tables import reinforcement
from groundslab.design.tables.punching.en1992 import demands
from groundslab.discretize.singular_places import near_singular
from groundslab.model.design.floors import TR34Floor
from groundslab.model.design.laid_bars import laid_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.loads.load_types import PointLoad
from groundslab.model.supports import LineSupport
from groundslab.results.fields import LAYERS, place_of
from groundslab.results.results import CombinationResult, Results

#: A slab with links is at least so thick [m] (9.3.2(1)).
LEAST_WITH_LINKS = 0.2


@dataclass(frozen=True, slots=True)
class _Section:
    """What the plate's nodes have in every combination."""

    d: Array  # (n,): effective depth, the lesser of both faces [m]
    thickness: Array  # (n,) [m]
    ratios: dict[str, Array]  # (n,): bars over the depth, by layer
    counts: Flags  # (n,): whether one-way shear is checked there


@dataclass(frozen=True, slots=True)
class _Worst:
    """Where a combination's shear force is largest against what needs no links."""

    results: CombinationResult
    place: tuple[float, float]  # [m]
    v: float  # [N/m]
    without_links: float  # [N/m]
    d: float  # [m]
    thickness: float  # [m]

    @property
    def used(self) -> float:
        """Return the force over what needs no links."""
        return self.v / self.without_links

    @property
    def where(self) -> str:
        """Return place and combination in words."""
        return f'({self.place[0]:.3f}, {self.place[1]:.3f}) m in "{self.results.combination}"'

    def check(self, status: Status, words: str, clause: str) -> DesignCheck:
        """Return the check of this place."""
        return DesignCheck(
            "one-way shear", status, words, demand=self.v / 1e3, resistance=self.without_links / 1e3, unit="kN/m",
            clause=clause, combination=self.results.combination, place=self.place,
        )  # fmt: skip


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the check of one-way shear over all ultimate combinations."""
    steel, results = combined.model.reinforcement, reinforcement.ultimate_results(combined)
    if steel is None or not results:
        return
    aci = steel.code == "ACI 318"
    section = _section(steel, results, {} if aci else demands(combined).reach)
    found = [_at_nodes(each, section, steel) for each in results] if section.counts.any() else []
    if aci:
        found += _across(results, section, steel)
    if found:
        worst = max(found, key=lambda one: one.used)
        yield (_by_aci318 if aci else _by_en1992)(steel, worst)


def _at_nodes(results: CombinationResult, section: _Section, steel: Reinforcement) -> _Worst:
    """Return the node that counts with the largest share of what needs no links."""
    v, without_links = _demand(results, section, steel)
    counts = section.counts & ~_near_forces(results, section.d)
    node = int(np.argmax(np.where(counts, v / without_links, -1.0)))
    place = place_of(results.plate.nodes, node)
    sizes = float(section.d[node]), float(section.thickness[node])
    return _Worst(results, place, float(v[node]), float(without_links[node]), *sizes)


def _across(results: list[CombinationResult], section: _Section, steel: Reinforcement) -> Iterator[_Worst]:
    """Yield the means over the cuts beside columns by ACI 318, in every combination."""
    concrete, _ = reinforcement.aci318_materials(steel)
    v_c = {layer: PHI_SHEAR * aci318.without_links(concrete, section.d, rho) for layer, rho in section.ratios.items()}
    for cut in cuts(results[0], steel):
        d, thickness = cut.mean(section.d), cut.mean(section.thickness)
        for each in results:
            yield _Worst(each, cut.place, *cut.forces(each.plate, v_c), d, thickness)


def _by_en1992(steel: Reinforcement, worst: _Worst) -> DesignCheck:
    """Return the check at the place that governs by EN 1992-1-1."""
    which = "laid" if steel.laid else "needed in bending"
    words = (
        f"v_Ed {worst.v / 1e3:.4g} kN/m at {worst.where} is {worst.used:.3g} times v_Rd,c "
        f"{worst.without_links / 1e3:.4g} kN/m with the bars that are {which} (6.2.2)"
    )
    status: Status = "no failure found"
    if worst.used > 1:
        concrete, bars = reinforcement.materials(steel, worst.results.limit_state)
        links = shear.required_links(np.array([worst.v]), np.array([worst.d]), concrete, bars)
        area = max(float(links.area[0]), shear.minimum_links(concrete, bars))
        thin = worst.thickness < LEAST_WITH_LINKS
        status = "fails" if np.isinf(area) or thin else "attention"
        words += (
            "; no links help (6.2.3(3))" if np.isinf(area)
            else "; too thin for links (9.3.2(1))" if thin
            else f"; links of {area * 1e4:.3g} cm2/m2 are needed there (6.2.3)"
        )  # fmt: skip
    return worst.check(status, words, "EN 1992-1-1 6.2.2, 6.2.3")


def _by_aci318(steel: Reinforcement, worst: _Worst) -> DesignCheck:
    """Return the check at the place that governs by ACI 318-19."""
    which = "laid" if steel.laid else "needed in bending"
    words = (
        f"v_u {worst.v / 1e3:.4g} kN/m at {worst.where} is {worst.used:.3g} times phi v_c "
        f"{worst.without_links / 1e3:.4g} kN/m with the bars that are {which} (22.5.5.1)"
    )
    status: Status = "no failure found"
    if worst.used > 1:
        area = aci318.links(worst.v, worst.d, *reinforcement.aci318_materials(steel))
        status = "fails" if np.isinf(area) else "attention"
        words += (
            "; no links help (22.5.1.2)" if np.isinf(area)
            else f"; links of {area * 1e4:.3g} cm2/m2 are needed there (22.5.8.5.3)"
        )  # fmt: skip
    return worst.check(status, words, "ACI 318-19 22.5.5.1")


def _section(steel: Reinforcement, results: list[CombinationResult], reach: Mapping[str, float]) -> _Section:
    """Return depths, bars and what counts at the plate's nodes."""
    plate = results[0].plate
    thickness = results[0].elements.at_nodes(plate)[0]
    d = thickness - max(sum(steel.bottom_axes), sum(steel.top_axes)) / 2
    if steel.laid:
        areas = {layer: laid_bars(steel, layer, plate.nodes).area for layer in LAYERS}
    else:
        found = reinforcement.required_areas(steel, results)
        areas = {layer: reinforcement.largest_areas(found, layer)[0] for layer in LAYERS}
    least = LEAST * thickness if steel.code == "ACI 318" else 0.0  # of a slab that has its least bars
    ratios = {layer: np.minimum(np.maximum(area, least) / d, shear.MOST_BARS) for layer, area in areas.items()}
    return _Section(d, thickness, ratios, _counts(results[0], d, thickness, reach))


def _counts(results: CombinationResult, d: Array, thickness: Array, reach: Mapping[str, float]) -> Flags:
    """Return at which nodes one-way shear is checked; `reach` is how far from columns punching is [m], else 2 d."""
    from shapely import LineString, Point, distance, points, union_all

    model, nodes = results.model, points(results.plate.nodes)
    chord = 1e-3 * max(model.sides)
    nearer = [distance(nodes, column.to_shapely(chord)) <= reach.get(column.name, 2 * d) for column in model.columns]
    stands = [LineString(each.points) if isinstance(each, LineSupport) else Point(each.x, each.y)
               for each in model.supports]  # fmt: skip
    far = distance(nodes, union_all(stands)) > 2 * d if stands else np.ones(len(nodes), dtype=bool)
    far = far & ~np.any(nearer, axis=0) if nearer else far
    from_edges = distance(nodes, edges_of(results))
    # of a narrow slab the middle half counts in any case
    inner = from_edges > np.minimum(thickness, from_edges.max() / 2)
    return np.asarray(far & inner & ~near_singular(model, results.plate.nodes, thickness))


def _near_forces(results: CombinationResult, d: Array) -> Flags:
    """Return which nodes are within 2 d of a force of a combination whose punching is checked as a floor's."""
    from shapely import distance, points, union_all

    model, factors = results.model, factors_of(results)
    if not isinstance(model.floor, TR34Floor):
        return np.zeros(len(d), dtype=bool)
    chord = 1e-3 * max(model.plate.sides)
    shapes = [
        load.on(model.columns).to_shapely(chord)
        for load in model.loads
        if isinstance(load, PointLoad) and factors.get(load.case, 0.0) * load.P > 0
    ]
    footprints = union_all([shape for shape in shapes if shape.area > 0])
    return np.asarray(distance(points(results.plate.nodes), footprints) <= 2 * d)


def _demand(results: CombinationResult, section: _Section, steel: Reinforcement) -> tuple[Array, Array]:
    """Return the largest shear force of any direction and what needs no links (n,) [N/m]."""
    plate = results.plate
    v, along = shear.principal_shear(plate.shear_x, plate.shear_y)
    twist = 2 * np.sqrt(along * (1 - along)) * np.sign(plate.shear_x * plate.shear_y)
    bottom = plate.moment_x * along + plate.moment_y * (1 - along) + plate.moment_xy * twist > 0
    rho_x, rho_y = (
        np.where(bottom, section.ratios[f"bottom_{axis}"], section.ratios[f"top_{axis}"]) for axis in ("x", "y")
    )
    rho = shear.ratio_along(along, rho_x, rho_y)
    if steel.code == "ACI 318":
        return v, PHI_SHEAR * aci318.without_links(reinforcement.aci318_materials(steel)[0], section.d, rho)
    return v, shear.resistance_without_links(reinforcement.materials(steel, results.limit_state)[0], section.d, rho)
