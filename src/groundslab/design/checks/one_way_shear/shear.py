"""One-way shear by the code of the case: where a slab needs links away from columns, and where none help.

The shear force is the largest of any direction at a node, the bars that count are those of the face that is in tension
in that direction: those that are laid, or those that bending needs. Left out are places where it is not this that is
checked: near columns, piles and thicker zones whose force acts in the combination, as far as punching is, which is 2 d
unless that perimeter cuts the slab from edge to edge; within 2 d of point supports without a diameter, and of the
forces on a floor whose punching is checked by TR34; within a thickness of free edges (a quarter of the width of a
narrow slab), where the shear force along the edge is what the twisting moment has become; and near singular places.
Beside line loads, line supports and footprints that are no columns it begins at d from them (`faces`), up to which no
struts may fail by EN 1992-1-1. Beside columns means over cuts across the slab, at d from them, are checked, too
(`basis/wide_beam`): by ACI 318 at all of them, by the others where no other column shares the cut, as on pads and
strips. So are means over cuts across necks of the slab, as between two openings, at d from what bears there (`necks`).

Along strips that are beams the shear force is theirs, and what is judged here is that across them.

On ground with shear the line force along the slab's edge takes off shear forces beside it. The worse of both counts:
with it at the edge, and with it as pressure over a strip (`edge_strip`), unless the case lets it relieve.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from groundslab.accuracy.values import reduction_of
from groundslab.arrays import Array, Flags
from groundslab.design.checks.one_way_shear.faces import bearers
from groundslab.design.checks.one_way_shear.necks import neck_cuts
from groundslab.design.checks.one_way_shear.places import (
    FORCES,
    Places,
    ShearPlaces,
    is_of_beam,
    links_along,
    near_forces,
    nodes_of,
)
from groundslab.design.codes.registry import code_of
from groundslab.design.demands.design_moments import principal_shear, ratio_along
from groundslab.design.demands.edge_strip import plates_that_count, spread_edge_force
from groundslab.design.demands.perimeter_loads import punching_columns, punching_piles
from groundslab.design.demands.zones.thicker_zones import zone_forces
from groundslab.design.rules.calculation import Step
from groundslab.design.rules.check import NO_PLACE, DesignCheck, Status, not_judged, severity
from groundslab.design.rules.combinations import ultimate_results
from groundslab.design.rules.demand_errors import error_of_greatest, scaled
from groundslab.design.rules.design_code import DesignCode, ShearRule, no_rule
from groundslab.design.rules.punching import punched_names
from groundslab.design.rules.punching_links.demand import LinkLimit
from groundslab.design.rules.shear_demand import AlongForce, ShearDemand
from groundslab.design.rules.wide_beam import Cut, same
from groundslab.messages import Clause, Message, Name, Symbol, quantity
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.design.shear_links import ShearLinks
from groundslab.results.fields import place_of
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult, Results

#: What counts as rounding, relative.
ROUNDING = 1e-9
#: Depths are about the same if they differ by no more than this, relative.
ALIKE = 0.01
#: What is said where the code's rule for distances of links is not known here.
UNKNOWN_DISTANCES = "how far they may be from each other is not known here"


@dataclass(frozen=True, slots=True)
class ShearCase:
    """What one-way shear of a case is judged with."""

    combined: Results
    steel: Reinforcement
    code: DesignCode
    rule: ShearRule
    places: ShearPlaces

    @classmethod
    def of(cls, combined: Results) -> ShearCase | None:
        """Return it of all combinations; None without materials, ultimate results, or a rule of the code."""
        steel, results = combined.model.reinforcement, ultimate_results(combined)
        if steel is None or not results or (rule := (code := code_of(steel)).shear) is None:
            return None
        reach = {} if rule.reach is None else rule.reach(combined)
        model = combined.solved_model
        punching = (*punching_columns(model), *punching_piles(model), *zone_forces(combined))
        nodes = nodes_of(steel, rule, results)
        punched = punched_names(combined, code.punching.demands_of) if steel.links and code.punching is not None else ()
        links = {laid.of: laid.distances[-1] for laid in steel.links if laid.of in punched}
        necks = [cut for cut in neck_cuts(results[0], nodes.thickness) if not is_of_beam(results[0], cut)]
        places = ShearPlaces(steel, nodes, bearers(model), punching, reach, necks, links, rule.beyond_links)
        return cls(combined, steel, code, rule, places)

    def across(self) -> Iterator[ShearDemand]:
        """Yield the means over cuts beside columns and across necks of all combinations."""
        results = ultimate_results(self.combined)
        cuts = [] if self.rule.cuts is None else self.rule.cuts(results[0], self.steel)
        beside = [cut for cut in cuts if not is_of_beam(results[0], cut)]
        for result in results:
            yield from _across(result, self.places, self.steel, self.rule, beside)


def checks(combined: Results) -> Iterator[DesignCheck]:
    """Yield the check of one-way shear over all ultimate combinations."""
    steel = combined.model.reinforcement
    results = ultimate_results(combined)
    if steel is None or not results:
        return
    case = ShearCase.of(combined)
    if case is None:
        yield no_rule(code_of(steel), "one-way shear")
        return
    rule = case.rule
    demands = [demand for result in results for demand in _of_combination(result, case.places, steel, rule)]
    demands += case.across()
    if demands:
        yield _check(steel, case.code, rule, max(demands, key=lambda demand: _rank(steel, rule, demand)))
    else:
        words = "no place of the slab is far enough from what bears on it"
        yield not_judged("one-way shear", NO_PLACE, words)


def _check(steel: Reinforcement, code: DesignCode, rule: ShearRule, demand: ShearDemand) -> DesignCheck:
    """Return the check at the place that governs."""
    said = rule.words
    words: str = Message(
        "{force} {v:.4g kN/m} at {where} is {used:.3g} times {resistance} {without_links:.4g kN/m} with the bars "
        "{which} ({clause})",
        force=Symbol(said.force),
        v=demand.v / 1e3,
        where=demand.where,
        used=demand.used,
        resistance=Symbol(said.without_links),
        without_links=demand.without_links / 1e3,
        which="provided" if steel.laid else "needed for bending",
        clause=Clause(said.clause),
    )
    status = _status(steel, rule, demand)
    if demand.used > 1:
        if demand.links is not None and _links_help(steel, rule, demand):
            return _with_links(steel, code, rule, demand)
        area = rule.links(steel, demand)
        if demand.at_support:
            words += Message("; links do not suffice at the load there ({clause})", clause=Clause(said.at_support))
        elif np.isinf(area):
            words += Message("; links do not suffice ({clause})", clause=Clause(said.struts))
        elif demand.thickness < rule.least_thickness:
            words += Message("; too thin for links ({clause})", clause=Clause(said.thin))
        else:
            words += Message(
                "; links of {area:.3g cm2/m2} are needed there ({clause})", area=area * 1e4, clause=Clause(said.links)
            )
    return demand.check(status, words, f"{code.name} {said.cited}", rule.steps(steel, demand))


def _status(steel: Reinforcement, rule: ShearRule, demand: ShearDemand) -> Status:
    """Return how the check of a place ends."""
    if demand.used <= 1:
        return "no failure found"
    if not _links_help(steel, rule, demand):
        return "fails"
    if demand.links is None:
        return "attention"
    if max(limit.used for limit in _limits(steel, rule, demand)) > 1 + ROUNDING:
        return "fails"
    return "attention" if rule.link_distance is None else "no failure found"


def _links_help(steel: Reinforcement, rule: ShearRule, demand: ShearDemand) -> bool:
    """Return whether links can bear the force of a place: its struts hold, and the slab is thick enough for links."""
    return not np.isinf(rule.links(steel, demand)) and demand.thickness >= rule.least_thickness


def _rank(steel: Reinforcement, rule: ShearRule, demand: ShearDemand) -> tuple[int, float]:
    """Return what puts a place before others: how it ends, then its share of what is allowed.

    That is of what needs no links, or of links that are needed and given; inf where none help.
    """
    share = demand.used
    if share > 1 and not _links_help(steel, rule, demand):
        share = np.inf
    elif share > 1 and demand.links is not None:
        share = max(limit.used for limit in _limits(steel, rule, demand))
    return severity(_status(steel, rule, demand)), share


def _limits(steel: Reinforcement, rule: ShearRule, demand: ShearDemand) -> Iterator[LinkLimit]:
    """Yield what links that are given are judged by: their area, and how far their legs are from each other."""
    links, said = demand.links, rule.words
    assert links is not None
    needed = rule.links(steel, demand)
    yield LinkLimit("links", needed * 1e4, links.area * 1e4, "cm2/m2", said.links)
    if rule.link_distance is not None:
        apart = rule.link_distance(steel, demand).value
        yield LinkLimit("distance of legs", links.apart * 1e3, apart * 1e3, "mm", said.link_distance)


def _with_links(steel: Reinforcement, code: DesignCode, rule: ShearRule, demand: ShearDemand) -> DesignCheck:
    """Return the check of a place that needs links and has some."""
    assert demand.links is not None
    worst = max(_limits(steel, rule, demand), key=lambda limit: limit.used)
    holds = worst.used <= 1 + ROUNDING
    words: str = Message(
        "{force} {v:.4g kN/m} at {where} needs links; {name}: {what} {value} {sign} {limit} ({clause})",
        force=Symbol(rule.words.force), v=demand.v / 1e3, where=demand.where, name=Name(demand.links.name),
        what=worst.what, value=quantity(worst.value, worst.unit), sign="<=" if holds else ">",
        limit=quantity(worst.limit, worst.unit), clause=Clause(worst.clause),
    )  # fmt: skip
    unknown = rule.link_distance is None
    if unknown:
        words += Message("; {doubt}", doubt=UNKNOWN_DISTANCES)
    error = demand.error()
    if error is not None and worst.unit == "cm2/m2":
        error = (rule.links(steel, replace(demand, v=demand.v + error)) * 1e4) - worst.value
    return DesignCheck(
        "one-way shear", "fails" if not holds else "attention" if unknown else "no failure found", words,
        of=demand.links.name, demand=worst.value, resistance=worst.limit, unit=worst.unit,
        clause=f"{code.name} {rule.words.cited}", combination=demand.results.combination, place=demand.place,
        error=error if worst.unit == "cm2/m2" and error is not None and np.isfinite(error) else None,
        steps=tuple(_link_steps(steel, rule, demand)),
    )  # fmt: skip


def _link_steps(steel: Reinforcement, rule: ShearRule, demand: ShearDemand) -> Iterator[Step]:
    """Yield the calculation at a place that needs links and has some."""
    yield from rule.steps(steel, demand)
    area, *distances = _limits(steel, rule, demand)
    assert demand.links is not None
    yield Step("diameter of the legs that are given", "phi_w", demand.links.diameter, "m")
    yield Step("their distance along x", "s_x", demand.links.spacing_x, "m")
    yield Step("their distance along y", "s_y", demand.links.spacing_y, "m")
    formula = "3.14159265 * phi_w^2 / 4 / (s_x * s_y) * 10000"
    yield Step("links that are given", "a_prov", area.limit, "cm2/m2", formula)
    yield Step("links that are needed, the least ones at least", "a_req", area.value, "cm2/m2", clause=area.clause)
    yield Step("share used of the links", "eta_w", area.used, "", "a_req / a_prov", area.clause)
    if rule.link_distance is not None:
        yield rule.link_distance(steel, demand)
        yield Step("distance of the legs", "s_w", demand.links.apart, "m", "max(s_x, s_y)")
        yield Step("share used of their distance", "eta_s", distances[0].used, "", "s_w / s_max")


def _of_combination(
    results: CombinationResult, places: ShearPlaces, steel: Reinforcement, rule: ShearRule
) -> Iterator[ShearDemand]:
    """Yield the worst of the places of a combination, with the edge's line force where it acts and spread."""
    sorted_places = places.of(results)
    for plate in plates_that_count(results, relieves=steel.line_force_relieves):
        for beyond in sorted_places.beyond:
            for places_there, links in beyond.by_links(steel):
                yield from _worst(results, plate, places_there, steel, rule, links)
        if rule.struts_at_faces:
            for demand in _worst(results, plate, sorted_places.within, steel, rule):
                if np.isinf(rule.links(steel, demand)):
                    yield replace(demand, at_support=True)


def _worst(
    results: CombinationResult,
    plate: PlateResult,
    places: Places,
    steel: Reinforcement,
    rule: ShearRule,
    links: ShearLinks | None = None,
) -> Iterator[ShearDemand]:
    """Yield the places that count one of which ends worst of all, if any counts.

    These are, of each depth, the one with the largest share of what needs no links, and of those that need links the
    one with the largest force over its depth, by which struts and areas of links are judged, and the one with the
    least depth, by which distances of links are.
    """
    v, rho, along = read_demand(results, plate, places)
    without_links = rule.resistance(steel, results.limit_state, places.d, rho)
    counts = places.counts & ~near_forces(results, places.xy, places.d)
    used, spread = v / without_links, plate is not results.plate
    for alike in _alike(places, counts, rule.least_thickness):
        most = {int(np.argmax(np.where(alike, used, -1.0))): without_links}
        needing = alike & (used > 1)
        if needing.any():
            for values in (v / places.d, 1 / places.d):
                most.setdefault(int(np.argmax(np.where(needing, values, -1.0))), places.d)
        for k, per in most.items():
            sizes = float(v[k]), float(without_links[k]), float(places.d[k]), float(places.thickness[k])
            error = partial(_error, results, places.of(alike), per, k, spread=spread)
            yield ShearDemand(
                results, place_of(places.xy, k), *sizes, spread=spread, rho=float(rho[k]), along=along(k), error=error,
                links=links,
            )  # fmt: skip


def _alike(places: Places, counts: Flags, least: float) -> Iterator[Flags]:
    """Yield those of the places that count (k,) which have about the same depth, too thin for links apart."""
    kind = 2 * np.round(np.log(places.d) / ALIKE) + (places.thickness < least)
    for number in np.unique(kind[counts]).tolist():
        yield counts & (kind == number)


def _error(results: CombinationResult, places: Places, per: Array, k: int, *, spread: bool) -> float | None:
    """Return the error of the shear force at the place k with the largest force over something (k,) [N/m].

    That is what needs no links, of the finer mesh, or the depth.
    """
    at = places.counts
    error = error_of_greatest(
        results,
        lambda mesh: (read_demand(mesh, _plate(mesh, spread=spread), places)[0] / per)[at],
        lambda: places.mean(reduction_of(results, "shear_x"))[at],
    )
    return scaled(error, float(per[k]))


def _plate(results: CombinationResult, *, spread: bool) -> PlateResult:
    """Return the plate, the line force along its edge spread or not."""
    return spread_edge_force(results) if spread else results.plate


def _across(
    results: CombinationResult, places: ShearPlaces, steel: Reinforcement, rule: ShearRule, beside: Iterable[Cut]
) -> Iterator[ShearDemand]:
    """Yield the means over cuts beside columns and, away from what bears there, across necks, in a combination."""
    nodes, resistance = places.nodes, partial(rule.resistance, steel, results.limit_state)
    necks = places.of(results).necks
    middles, depths = np.array([cut.place for cut in necks]), np.array([cut.mean(nodes.d) for cut in necks])
    near = near_forces(results, middles.reshape(-1, 2), depths)
    for cut in (*beside, *(cut for cut, is_near in zip(necks, near, strict=True) if not is_near)):
        d_here, d, thickness = nodes.d[cut.nodes], cut.mean(nodes.d), cut.mean(nodes.thickness)
        for plate in plates_that_count(results, relieves=steel.line_force_relieves):
            spread, rho = plate is not results.plate, cut.ratio(nodes.ratios, cut.face(plate))
            without_links = cut.mean_here(resistance(d_here.ravel(), rho.ravel()).reshape(d_here.shape))
            ratio = None if same(d_here) is None else same(rho)
            yield ShearDemand(
                results, cut.place, cut.shear(results, plate), without_links, d, thickness,
                spread=spread, rho=ratio, across=True, error=partial(_error_across, results, cut, spread=spread),
                links=links_along(steel, cut),
            )  # fmt: skip


def _error_across(results: CombinationResult, cut: Cut, *, spread: bool) -> float | None:
    """Return the error of the mean shear force over a cut [N/m]."""
    return error_of_greatest(
        results,
        lambda mesh: np.array([cut.shear(mesh, _plate(mesh, spread=spread))]),
        lambda: np.array([cut.mean(reduction_of(results, "shear_x"))]),
    )


def read_demand(
    results: CombinationResult, plate: PlateResult, places: Places
) -> tuple[Array, Array, Callable[[int], AlongForce]]:
    """Return the largest shear force of any direction (k,) [N/m], and the ratio of bars in tension along it (k,).

    And a function that tells of a place what makes both.
    """
    f = places.forces(plate, results.elements)
    v, along = principal_shear(f["shear_x"], f["shear_y"])
    twist = 2 * np.sqrt(along * (1 - along)) * np.sign(f["shear_x"] * f["shear_y"])
    bottom = f["moment_x"] * along + f["moment_y"] * (1 - along) + f["moment_xy"] * twist > 0
    rho_x, rho_y = (
        np.where(bottom, places.ratios[f"bottom_{axis}"], places.ratios[f"top_{axis}"]) for axis in ("x", "y")
    )

    def about(k: int) -> AlongForce:
        m_x, m_y, m_xy, q_x, q_y = (float(f[name][k]) for name in FORCES)
        ratios = float(rho_x[k]), float(rho_y[k])
        return AlongForce((q_x, q_y), (m_x, m_y, m_xy), "bottom" if bottom[k] else "top", ratios)

    return v, ratio_along(along, rho_x, rho_y), about
