"""Stirrups that two-way shear by ACI 318-19 takes at columns and piles: their perimeters (22.6.7, 8.7.6).

The legs of a perimeter are on all sides of what punches, A_v = (A_v / s) s. The first is at d / 2 from the face at
most, the next ones d / 2 from each other, legs along it 2 d (Table 8.7.6.3); bars are no thicker than d / 16
(22.6.7.1). Perimeters follow until v_u <= phi v_c on the section d / 2 beyond the outermost one (22.6.4.2, 22.6.6.1).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.aci318 import punching as aci318
from groundslab.design.codes.aci318.checks.laid_links import laid_links
from groundslab.design.codes.aci318.checks.two_way_demand import (
    TwoWay,
    demand_on,
    openings_of,
    section_at,
    used,
)
from groundslab.design.codes.aci318.materials import PHI_SHEAR
from groundslab.design.codes.aci318.materials_of_case import materials
from groundslab.design.demands.by_plate import plate_under
from groundslab.design.demands.perimeter_loads import PunchingForce
from groundslab.design.demands.perimeters import Surroundings, perimeter_at, surroundings
from groundslab.design.rules.calculation import Support
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.punching import Demands, forces_that_punch
from groundslab.design.rules.punching_links.demand import (
    Arrangement,
    LinkDemand,
    LinkLimit,
    LinkRow,
    by_depth,
    rounded_down,
)
from groundslab.messages import Message
from groundslab.model.design.punching_links import PunchingLinks
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import CombinationResult, Results

#: Distances over the effective depth: of the first perimeter and of each from the next, and of legs (Table 8.7.6.3).
APART, ALONG = 0.5, 2.0
#: The effective depth over the diameter, at least (22.6.7.1).
LEAST_SLENDER = 16.0
#: The same of headed studs where v_u is at most this times phi (f'c)^(1/2), in MPa (Table 8.7.7.1.2).
APART_STUDS, LIGHTLY_STRESSED = 0.75, 0.5
#: Perimeters at least and at most.
LEAST_ROWS, MOST_ROWS = 2, 20
CLAUSES = "ACI 318-19 22.6.7, 8.7.6"


def links(combined: Results, steel: Reinforcement, support: Support, demands: Demands[TwoWay]) -> Iterator[LinkDemand]:
    """Yield what of those that punch in one way needs stirrups, with perimeters, or why they do not help."""
    if support == "wall end":
        for name in dict.fromkeys(name for _, name in demands.found):
            worst = _worst(demands.found, name, steel)
            if used(worst, steel) > 1 or steel.links_at(name) is not None:
                why = "stirrups at ends of walls are not laid out by this code here"
                yield LinkDemand("wall end", name, worst.place, worst.combination, CLAUSES, why, unknown=True)
        return
    forces = forces_that_punch(combined, support)
    yield from _of_forces(ultimate_results(combined), steel, support, forces, demands.found)


def _worst(demands: Mapping[tuple[str, str], TwoWay], name: str, steel: Reinforcement) -> TwoWay:
    """Return the demand at one column, pile or end of a wall that uses most."""
    of_name = [demand for (_, of), demand in demands.items() if of == name]
    return max(of_name, key=partial(used, steel=steel))


def _of_forces(
    results: Sequence[CombinationResult],
    steel: Reinforcement,
    support: Support,
    forces: Sequence[PunchingForce],
    demands: Mapping[tuple[str, str], TwoWay],
) -> Iterator[LinkDemand]:
    """Yield the columns, piles or zones that need stirrups."""
    for punching in forces:
        of_force = {
            pair: demand for pair, demand in demands.items() if pair[1] == punching.name and not demand.supported
        }
        laid = steel.links_at(punching.name)
        needing = [demand for demand in of_force.values() if laid is not None or used(demand, steel) > 1]
        if not needing:
            continue
        worst = max(needing, key=lambda demand: demand.v_u)
        studs = laid is not None and laid.kind == "studs"
        arrangement = _refused(steel, needing, studs) or _arrangement(results, steel, punching, worst)
        yield LinkDemand(support, punching.name, punching.place, worst.combination, CLAUSES, arrangement)


def _arrangement(
    results: Sequence[CombinationResult], steel: Reinforcement, punching: PunchingForce, worst: TwoWay
) -> Arrangement | str:
    """Return the perimeters around a column or pile, by the combination that needs most, or why there are none."""
    d, first = worst.d, results[0]
    s = rounded_down(APART * d)
    counts = [count for way in punching.ways if (count := _count(results, way, steel, d, s)) is not None]
    laid = steel.links_at(punching.name)
    if len(counts) < len(punching.ways) and laid is None:
        return Message(
            "stirrups would go on beyond {most_rows:g} d from the face, as v_u hardly falls outwards",
            most_rows=MOST_ROWS * APART,
        )
    area, count = aci318.links(worst.v_u, d, worst.b_o, *materials(steel)) * s, max(counts, default=MOST_ROWS)
    plate, far = plate_under(first, *punching.place), (count + 1) * s
    if laid is not None:
        far = max(far, laid.distances[-1] + d)
    around = surroundings(plate, punching.footprint, far, openings_of(first, punching))
    options = _options([LinkRow((n + 1) * s, area, ALONG * d) for n in range(count)], d)
    rows, limits = partial(_rows, steel, worst), partial(_limits, results, steel, punching, worst)
    return Arrangement(punching.thickness(first), options, partial(_legs, around), around.plan, rows, limits)


def _rows(steel: Reinforcement, worst: TwoWay, laid: PunchingLinks) -> tuple[LinkRow, ...]:
    """Return what each perimeter of links that are given needs."""
    links = laid_links(worst, steel)
    assert links is not None
    v_s = max(worst.v_u / PHI_SHEAR - links.v_c, 0.0)
    area = v_s * worst.b_o * links.s / materials(steel)[1].f_yt
    if laid.kind == "studs":
        area = max(area, aci318.least_studs(links.s, worst.b_o, *materials(steel)))
    steps = by_depth(worst.d, ALONG, "8.7.6.3, 8.7.7.1.2")
    return tuple(LinkRow(distance, area, ALONG * worst.d, steps) for distance in laid.distances)


def _limits(
    results: Sequence[CombinationResult],
    steel: Reinforcement,
    punching: PunchingForce,
    worst: TwoWay,
    laid: PunchingLinks,
) -> Iterator[LinkLimit]:
    """Yield what 22.6.4.2, 22.6.7.1, 8.7.6.3 and 8.7.7.1.2 ask of links that are given."""
    concrete, d = materials(steel)[0], worst.d
    studs = laid.kind == "studs"
    clause = "8.7.7.1.2" if studs else "8.7.6.3"
    wide = studs and worst.v_u <= PHI_SHEAR * LIGHTLY_STRESSED * concrete.root
    first, apart = "distance of the inner perimeter from the face", "distance of perimeters"
    yield LinkLimit(first, laid.distances[0] * 1e3, APART * d * 1e3, "mm", clause, steps=by_depth(d, APART, clause))
    if laid.apart is not None:
        most_apart = APART_STUDS if wide else APART
        steps = by_depth(d, most_apart, clause)
        yield LinkLimit(apart, laid.apart * 1e3, most_apart * d * 1e3, "mm", clause, steps=steps)
    if not studs:
        steps = by_depth(d, 1 / LEAST_SLENDER, "22.6.7.1")
        yield LinkLimit(
            "diameter of links", laid.diameter * 1e3, d / LEAST_SLENDER * 1e3, "mm", "22.6.7.1", steps=steps
        )
    beyond = [
        v_u
        for way in punching.ways
        if (v_u := _beyond(results, way, steel, d, laid.distances[-1] + APART * d)) is not None
    ]
    most = PHI_SHEAR * aci318.with_links(concrete, d)
    stress = "stress d / 2 beyond the outer perimeter"
    yield LinkLimit(stress, max(beyond, default=0.0) / 1e6, most / 1e6, "MPa", "22.6.4.2, 22.6.6.1")


def _legs(around: Surroundings, distance: float) -> Array:
    """Return the pieces (l, 2, 2) [m] that count of the perimeter at a distance [m] from a column or pile."""
    return perimeter_at(around, distance, near=np.inf).legs


def _refused(steel: Reinforcement, needing: Sequence[TwoWay], studs: bool) -> str:
    """Return why stirrups do not help, or studs that are given; empty if they do."""
    concrete = materials(steel)[0]
    if studs:
        most_used = max(demand.v_u for demand in needing) / (PHI_SHEAR * aci318.most_with_studs(concrete))
        words = Message("studs do not suffice: v_u is {used:.3g} phi 0.66 (f'c)^(1/2) (22.6.6.3)", used=most_used)
        return words if most_used > 1 else ""
    most = PHI_SHEAR * aci318.most_with_links(concrete)
    used = max(demand.v_u for demand in needing) / most
    if used > 1:
        return Message("stirrups do not suffice: v_u is {used:.3g} phi 0.498 (f'c)^(1/2) (22.6.6.3)", used=used)
    return (
        "the slab is too thin for stirrups (22.6.7.1)"
        if min(demand.d for demand in needing) < aci318.LEAST_DEPTH
        else ""
    )


def _count(
    results: Sequence[CombinationResult], punching: PunchingForce, steel: Reinforcement, d: float, s: float
) -> int | None:
    """Return how many perimeters s apart [m] there are until concrete alone resists beyond them, None if too many."""
    most = PHI_SHEAR * aci318.with_links(materials(steel)[0], d)
    for count in range(LEAST_ROWS, MOST_ROWS + 1):
        v_u = _beyond(results, punching, steel, d, count * s + APART * d)
        if v_u is None or v_u <= most:
            return count
    return None


def _beyond(
    results: Sequence[CombinationResult], punching: PunchingForce, steel: Reinforcement, d: float, distance: float
) -> float | None:
    """Return the largest v_u [Pa] on the section at a distance [m], None where nothing pushes or none is left.

    Beyond the last one the slab is cut from edge to edge, or ends.
    """
    pushing = [result for result in results if punching.pushing(result)[0] > 0]
    section = section_at(pushing[0], punching, d, distance, square=False) if pushing else ""
    if isinstance(section, str):
        return None
    return max(demand_on(result, section, punching, steel).v_u for result in pushing)


def _options(rows: list[LinkRow], d: float) -> Callable[[float], Iterator[tuple[LinkRow, ...]]]:
    """Return the perimeters that a diameter may have."""

    def options(diameter: float) -> Iterator[tuple[LinkRow, ...]]:
        if diameter <= d / LEAST_SLENDER:
            yield tuple(rows)

    return options
