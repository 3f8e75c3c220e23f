"""Links that punching by EN 1992-1-1 takes at columns, piles and ends of walls: their perimeters (6.4.5, 9.4.3).

    A_sw = (v_Ed - 0.75 v_Rd) u d / (n_s f_ywd,ef)       on each perimeter, the largest of all where v_Ed > v_Rd, 6.52
    0.3 d <= s_0 <= 0.5 d, s_r <= 0.75 d                 from the face, and from one to the next, Figure 9.10
    s_t <= 1.5 d within 2 d, 2 d beyond                  of legs along a perimeter, 9.4.3(1), and by 9.11
    a_out - 1.5 d                                        as far as the last one lies at least, 6.4.5(4)

with two perimeters at least (9.4.3(1)), and no fewer than the n_s = 1.5 d / s_r that 6.52 counts on; of a section
closer than 2 d only those within it count. By DIN EN 1992-1-1/NA the first two carry all of the force, each a half, and
each further one has 33 % of both.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004 import punching as en1992
from groundslab.design.codes.en1992_2004.checks.punching import (
    CROSSED,
    LEAST_ROWS,
    limited_with_links,
    links_that_count,
    with_remedy,
)
from groundslab.design.codes.en1992_2004.checks.punching_demand import (
    FARTHEST,
    LAST_LINKS,
    REACH,
    TOO_FAR,
    Demand,
    Stress,
    outer,
)
from groundslab.design.codes.en1992_2004.checks.wall_ends import at_ends
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.design.codes.en1992_2004.perimeters import openings
from groundslab.design.demands.by_plate import plate_under
from groundslab.design.demands.perimeter_loads import (
    PunchingForce,
    footprint_of,
    thickness_at,
)
from groundslab.design.demands.perimeters import (
    FAR,
    Surroundings,
    outline,
    outside,
    perimeter_at,
    shadow_of,
    surroundings,
)
from groundslab.design.demands.wall_perimeters import LoadedArea, course
from groundslab.design.rules.calculation import MEGA, Step, Support
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.punching import Demands, forces_that_punch
from groundslab.design.rules.punching_links.demand import (
    STEP,
    Arrangement,
    LinkDemand,
    LinkLimit,
    LinkRow,
    by_depth,
    rounded_down,
    rounded_up,
)
from groundslab.messages import Message
from groundslab.model.design.punching_links import PunchingLinks
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import CombinationResult, Results

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: The first perimeter is no closer to the face than this over the effective depth (Figure 9.10).
FIRST = 0.3
#: A closer radial distance that is tried too, over the effective depth.
CLOSER = 0.5
#: Legs along a perimeter within REACH and beyond are no farther apart than this over the effective depth (9.4.3(1)).
ALONG, ALONG_BEYOND = 1.5, 2.0
#: A slab with links is at least so thick [m] (9.3.2(1)).
LEAST_THICKNESS = 0.2
CLAUSES = "EN 1992-1-1 6.4.5, 9.4.3"


@dataclass(frozen=True, slots=True)
class _Required:
    """The links that all combinations need around one column, pile or end of a wall."""

    combination: str  # that needs most
    needs: tuple[tuple[float, float], ...]  # areas of all links that count [m2], and the sections' distances [m]
    last: float  # how far from the face the last one is at least [m]


def links(combined: Results, steel: Reinforcement, support: Support, demands: Demands[Demand]) -> Iterator[LinkDemand]:
    """Yield what of those that punch in one way needs links, with perimeters, or why they do not help."""
    if support == "wall end":
        yield from _of_walls(combined, steel, demands)
    else:
        forces = forces_that_punch(combined, support)
        yield from _of_forces(ultimate_results(combined)[0], steel, support, forces, demands)


def _of_forces(
    first: CombinationResult,
    steel: Reinforcement,
    support: Support,
    forces: Sequence[PunchingForce],
    punched: Demands[Demand],
) -> Iterator[LinkDemand]:
    """Yield the columns, piles or zones that need links."""
    for punching in forces:
        of_force = [demand for demand in punched.found.values() if demand.name == punching.name]
        required = _required(steel, of_force)
        if required is None and of_force and steel.links_at(punching.name) is not None:
            required = _Required(of_force[0].combination, (), 0.0)
        if required is None:
            continue
        # by the axes of the bars at either face where it pushes in some combinations and pulls in others
        d, thickness = min(demand.d for demand in of_force), punching.thickness(first)
        arrangement: Arrangement | str = _refused(steel, of_force, thickness, at_face=support != "zone") or _too_far(
            required, d
        )
        if not arrangement:
            plate = plate_under(first, *punching.place)
            around = surroundings(plate, punching.footprint, REACH * d, openings(d))
            arrangement = _arrangement(steel, required, d, thickness, partial(_legs, around), around.plan)
        yield LinkDemand(support, punching.name, punching.place, required.combination, CLAUSES, arrangement)


def _of_walls(combined: Results, steel: Reinforcement, punched: Demands[Demand]) -> Iterator[LinkDemand]:
    """Yield the ends and corners of walls that need links."""
    punching = at_ends(combined, steel)
    for name, (site, results) in {at_end.site.end.name: (at_end.site, at_end.results) for at_end in punching}.items():
        of_end = [demand for demand in punched.found.values() if demand.name == name]
        required = _required(steel, of_end)
        if required is None and of_end and steel.links_at(name) is not None:
            required = _Required(of_end[0].combination, (), 0.0)
        if required is None:
            continue
        footprint = footprint_of(site.column)
        thickness = thickness_at(results, footprint)
        arrangement: Arrangement | str = _refused(steel, of_end, thickness, at_face=False) or _too_far(required, site.d)
        if not arrangement:
            plan, around = outline(plate_under(results, *site.end.place)), footprint.footprint()
            far = FAR * (required.last + 2 * REACH * site.d + math.sqrt(around.area))
            shadow = shadow_of(plan, around, site.area.center, openings(site.d), far)
            lines = partial(_wall_legs, site.area, shadow)
            arrangement = _arrangement(steel, required, site.d, thickness, lines, plan)
        yield LinkDemand("wall end", name, site.end.place, required.combination, CLAUSES, arrangement)


def _arrangement(
    steel: Reinforcement,
    required: _Required,
    d: float,
    thickness: float,
    lines: Callable[[float], Array],
    plan: BaseGeometry,
) -> Arrangement:
    """Return how links may be arranged where the effective depth is d [m]."""

    def rows(laid: PunchingLinks) -> tuple[LinkRow, ...]:
        return _rows(steel, required, d, laid.distances, laid.diameter)

    limits = partial(_limits, steel, required, d)
    return Arrangement(thickness, _options(steel, required, d), lines, plan, rows, limits)


def _legs(around: Surroundings, distance: float) -> Array:
    """Return the pieces (l, 2, 2) [m] that count of the perimeter at a distance [m] from a column or pile."""
    return perimeter_at(around, distance).legs


def _wall_legs(area: LoadedArea, shadow: BaseGeometry, distance: float) -> Array:
    """Return those of the perimeter at a distance [m] from the end of a wall, also beyond the slab."""
    return outside(course(area, distance).legs, shadow)


def _required(steel: Reinforcement, demands: list[Demand]) -> _Required | None:
    """Return what the demands of all combinations need, None where none needs links."""
    with_needs = [(demand, needing) for demand in demands if (needing := _needing(demand))]
    if not with_needs:
        return None
    needs = {demand.combination: _needs(steel, demand, needing) for demand, needing in with_needs}
    combination = max(needs, key=lambda name: max(area for area, _ in needs[name]))
    last = max(outer(demand).last_links(demand.d) for demand, _ in with_needs)
    return _Required(combination, tuple(chain.from_iterable(needs.values())), last)


def _needing(demand: Demand) -> list[Stress]:
    """Return the perimeters of a demand on which concrete alone does not resist."""
    return [stress for stress in demand.around if stress.v_Ed > demand.resistance(stress) and not stress.supported]


def _needs(steel: Reinforcement, demand: Demand, needing: list[Stress]) -> list[tuple[float, float]]:
    """Return what each section needs of all links that count [m2], and its distance [m]; alone, the worst does."""
    concrete, bars = materials(steel, demand.limit_state)
    if concrete.annex.links_alone:
        worst = max(needing, key=demand.used)
        return [(en1992.links_alone(worst.v_Ed * worst.u * demand.d, demand.d, bars.f_yd), worst.distance)]
    return [
        (
            en1992.links_per_perimeter(stress.v_Ed, demand.resistance(stress), stress.u, demand.d, 1.0, bars.f_yd),
            stress.distance,
        )
        for stress in needing
    ]


def _refused(steel: Reinforcement, demands: list[Demand], thickness: float, *, at_face: bool) -> str:
    """Return why links do not help or are not allowed; empty if they are."""
    for demand in demands:
        concrete = materials(steel, demand.limit_state)[0]
        most = en1992.max_resistance(concrete)
        face = demand.face
        if most is not None and face is not None and face.v_Ed > most and not face.supported:
            why: str = Message(
                "links do not help: v_Ed is {v_Ed:.3g} v_Rd,max at the face (6.4.5(3))", v_Ed=face.v_Ed / most
            )
            return with_remedy(why, steel, demands, at_face=at_face)
        for _, stress, limit, _ in limited_with_links(demand, concrete.annex, at_face=at_face):
            if stress.v_Ed > limit and not stress.supported:
                k_max = concrete.annex.k_max
                why = Message("links do not suffice: v_Ed is more than {k_max:g} v_Rd,c (6.4.5(1))", k_max=k_max)
                return with_remedy(why, steel, demands, at_face=at_face)
    return "the slab is thinner than 200 mm, too thin for links (9.3.2(1))" if thickness < LEAST_THICKNESS else ""


def _too_far(required: _Required, d: float) -> str:
    """Return why links cannot end anywhere, as perimeters hardly grow outwards; empty if they can."""
    return TOO_FAR if required.last > FARTHEST * d else ""


def _options(steel: Reinforcement, required: _Required, d: float) -> Callable[[float], Iterator[tuple[LinkRow, ...]]]:
    """Return the perimeters that a diameter may have, for each radial distance."""
    annex = materials(steel)[0].annex
    first, most_apart, _ = annex.link_rows
    start = max(rounded_down(first * d), rounded_up(FIRST * d))

    def options(diameter: float) -> Iterator[tuple[LinkRow, ...]]:
        if diameter > annex.thickest_link * d:
            return
        for share in sorted({most_apart, min(CLOSER, most_apart)}, reverse=True):
            s_r = rounded_down(share * d)
            counted = LEAST_ROWS if annex.links_alone else max(LEAST_ROWS, round(CROSSED / share))
            count = max(counted, 1 + math.ceil((required.last - start) / s_r - 1e-9))
            yield _rows(steel, required, d, [start + number * s_r for number in range(count)], diameter)

    return options


def _rows(
    steel: Reinforcement, required: _Required, d: float, distances: Sequence[float], diameter: float
) -> tuple[LinkRow, ...]:
    """Return what perimeters at distances from the face with legs of a diameter [m] need, the inner one first."""
    concrete, bars = materials(steel)
    annex = concrete.annex
    s_r = max(np.diff(distances), default=annex.link_rows[1] * d)
    widest = en1992.widest_legs(math.pi * diameter**2 / 4, s_r, concrete, bars)
    alone = max((area for area, _ in required.needs), default=0.0)
    shared = max((area / links_that_count(distances, a, s_r, d) for area, a in required.needs), default=0.0)
    rows = []
    for number, distance in enumerate(distances):
        along = (ALONG if distance <= REACH * d else ALONG_BEYOND) * d
        area = alone * (0.5 if number < LEAST_ROWS else annex.link_rows[2]) if annex.links_alone else shared
        steps = _along(d, along / d, (diameter, float(s_r)), concrete, bars)
        rows.append(LinkRow(distance, area, min(along, widest), tuple(steps)))
    return tuple(rows)


def _along(d: float, share: float, legs: tuple[float, float], concrete: Concrete, bars: Steel) -> Iterator[Step]:
    """Yield how far legs of a diameter are from each other at most along perimeters s_r apart [m], by d and by 9.11."""
    diameter, s_r = legs
    yield Step("effective depth", "d", d * 1e3, "mm")
    yield Step("diameter of links", "phi_w", diameter * 1e3, "mm")
    yield Step("distance of perimeters, the largest", "s_r", s_r * 1e3, "mm")
    yield Step("strength of the concrete", "f_ck", concrete.f_ck / MEGA, "MPa")
    yield Step("yield strength", "f_yk", bars.f_yk / MEGA, "MPa")
    widest = en1992.widest_legs(math.pi * diameter**2 / 4, s_r, concrete, bars)
    formula = f"1.5 * pi / 4 * phi_w^2 * f_yk / ({en1992.LEAST_LEG:g} * sqrt(f_ck) * s_r)"
    yield Step("distance at which legs are the least links", "s_l", widest * 1e3, "mm", formula, "9.11")
    most = min(share * d, widest) * 1e3
    yield Step("the most that is allowed", "x_lim", most, "mm", f"min({share:g} * d, s_l)", "9.4.3(1), 9.4.3(2)")


def _limits(steel: Reinforcement, required: _Required, d: float, laid: PunchingLinks) -> Iterator[LinkLimit]:
    """Yield what 9.4.3 and 6.4.5(4) ask of links that are given."""
    annex = materials(steel)[0].annex
    first, most_apart, _ = annex.link_rows
    from_face = "distance of the inner perimeter from the face"
    farthest = max(first * d, rounded_up(FIRST * d))
    yield LinkLimit(from_face, laid.distances[0] * 1e3, farthest * 1e3, "mm", "9.4.3(4)", steps=_first(d, first))
    yield LinkLimit(from_face, laid.distances[0] * 1e3, FIRST * d * 1e3, "mm", "Figure 9.10", least=True,
                    steps=by_depth(d, FIRST, "Figure 9.10", least=True))  # fmt: skip
    if laid.apart is not None:
        yield LinkLimit("distance of perimeters", laid.apart * 1e3, most_apart * d * 1e3, "mm", "9.4.3(1)",
                        steps=by_depth(d, most_apart, "9.4.3(1)"))  # fmt: skip
    yield LinkLimit("number of perimeters", len(laid.distances), LEAST_ROWS, "", "9.4.3(1)", least=True)
    if required.last > 0:
        reach = "distance of the outer perimeter from the face"
        yield LinkLimit(reach, laid.distances[-1] * 1e3, required.last * 1e3, "mm", "6.4.5(4)", least=True,
                        steps=_reach(d, required.last))  # fmt: skip
    if math.isfinite(annex.thickest_link):
        yield LinkLimit("diameter of links", laid.diameter * 1e3, annex.thickest_link * d * 1e3, "mm", "annex",
                        steps=by_depth(d, annex.thickest_link, "annex"))  # fmt: skip


def _first(d: float, share: float) -> tuple[Step, ...]:
    """Return the steps to the largest distance of the inner perimeter from the face: a share of d, rounded up 0.3 d."""
    step = STEP * 1e3
    formula = f"max({share:g} * d, ceil({FIRST:g} * d / {step:g} - 0.000001) * {step:g})"
    most = max(share * d, rounded_up(FIRST * d)) * 1e3
    depth, limit = by_depth(d, share, "9.4.3(4)")
    return depth, replace(limit, value=most, formula=formula)


def _reach(d: float, last: float) -> tuple[Step, ...]:
    """Return the steps to the least distance of the outer perimeter from the face, last [m]."""
    out = Step("distance of the perimeter on which no links are needed", "a_out", (last + LAST_LINKS * d) * 1e3, "mm",
               clause="6.4.5(4), 6.54")  # fmt: skip
    limit = Step("the least that is allowed", "x_lim", last * 1e3, "mm", f"a_out - {LAST_LINKS:g} * d", "6.4.5(4)")
    return Step("effective depth", "d", d * 1e3, "mm"), out, limit
