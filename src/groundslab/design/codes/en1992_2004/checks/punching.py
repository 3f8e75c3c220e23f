"""Punching by EN 1992-1-1 6.4 of columns, piles, zones and walls' ends: at faces, within 2 d, and its links."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

from groundslab.design.codes.en1992_2004 import punching as en1992
from groundslab.design.codes.en1992_2004.annex import Annex
from groundslab.design.codes.en1992_2004.checks.punching_demand import (
    LAST_LINKS,
    REACH,
    TOO_FAR,
    Demand,
    Stress,
    limited_outermost,
    outer,
)
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.design.codes.en1992_2004.punching_remedies import in_words, least_change, ratio_for_links
from groundslab.design.rules.calculation import Support
from groundslab.design.rules.check import DesignCheck, Status
from groundslab.design.rules.demand_errors import error_of_ratio, scaled
from groundslab.design.rules.design_code import TensionBars
from groundslab.design.rules.punching import CALLED, Aspect, Demands
from groundslab.design.rules.punching_beta import WAYS
from groundslab.messages import Clause, Message, Name, joined
from groundslab.model.design.laid_bars import BESIDE
from groundslab.model.design.reinforcement import Reinforcement

#: What the checks around are called, and those at faces.
WITHIN_2D: Mapping[Support, str] = {
    "column": "punching within 2 d",
    "pile": "punching over piles within 2 d",
    "zone": "punching around thicker zones within 2 d",
    "wall end": "punching at walls' ends within 2 d",
}
AT_FACES: Mapping[Support, str] = {
    "column": "punching at the column's face", "pile": "punching at the pile's face",
}  # fmt: skip
#: 6.52 counts on the perimeters within this over the effective depth, and on none farther inside of a section.
CROSSED = 1.5
#: Perimeters of links, at least (9.4.3(1)); by the German annex the first two carry all.
LEAST_ROWS = 2


class LaidLinks(NamedTuple):
    """The links that count on one perimeter around."""

    A_sw: float  # of each perimeter, the least one; where links carry all, of the two inner ones together [m2]
    rows: float  # perimeters that count
    alone: bool  # whether links carry all
    resistance: float  # v_Rd,cs [Pa]


def links_that_count(distances: Sequence[float], a: float, s_r: float, d: float) -> float:
    """Return how many of the perimeters at distances from the face count for a section at a from it [m].

    They are no more than there are, but for the part of one that 1.5 d / s_r is above a whole number.
    """
    count = en1992.links_that_count(a, distances[0], s_r, d)
    within = max(1, sum(distance <= a + 1e-6 for distance in distances))
    return float(within) if within < math.floor(count) else count


def laid_links(demand: Demand, stress: Stress, steel: Reinforcement) -> LaidLinks | None:
    """Return what the links that are given do on a perimeter; None where none are, or it lies beyond them."""
    laid = steel.links_at(demand.name)
    if laid is None or stress.distance > laid.distances[-1] + CROSSED * demand.d:
        return None
    concrete, bars = materials(steel, demand.limit_state)
    u, d = stress.u, demand.d
    if concrete.annex.links_alone:
        further = concrete.annex.link_rows[2]
        A_sw = min([sum(laid.areas[:LEAST_ROWS]), *(area / further for area in laid.areas[LEAST_ROWS:])])
        return LaidLinks(A_sw, 1.0, True, A_sw * en1992.effective_strength(d, bars.f_yd) / (u * d))
    s_r = laid.apart or concrete.annex.link_rows[1] * d
    count = links_that_count(laid.distances, stress.distance, s_r, d)
    A_sw = min(laid.areas)
    v_Rd_cs = en1992.resistance_with_links(demand.resistance(stress), A_sw, count, u, d, bars.f_yd)
    return LaidLinks(A_sw, count, False, v_Rd_cs)


class Judged(NamedTuple):
    """A demand, the stress on one of its perimeters, and what resists it there."""

    demand: Demand
    stress: Stress
    resistance: float  # [Pa]
    linked: bool = False  # whether with the links that are given

    @property
    def name(self) -> str:
        """Return what punches."""
        return self.demand.name

    @property
    def supported(self) -> bool:
        """Return whether another support acts inside."""
        return self.stress.supported

    @property
    def share(self) -> float:
        """Return the stress over what resists it."""
        return self.stress.v_Ed / self.resistance


def aspects(support: Support, demands: Demands[Demand], steel: Reinforcement) -> Iterator[Aspect]:
    """Yield what is judged: of columns and piles v_Rd,max at faces where it is limited (6.4.5(3)); all within 2 d."""
    of_support = demands.found.values()
    if support in AT_FACES and en1992.max_resistance(materials(steel)[0]) is not None:
        at_face = [
            Judged(demand, demand.face, en1992.max_resistance(materials(steel, demand.limit_state)[0]) or 0.0)
            for demand in of_support
            if demand.face is not None
        ]
        yield Aspect(AT_FACES[support], at_face, _share, partial(_at_face, steel, support), says_missing=False)
    around = [judged for demand in of_support for judged in all_judged(demand, steel)]
    yield Aspect(WITHIN_2D[support], around, _share, partial(_within_2d, steel, support))


def _as_laid(demand: Demand, stress: Stress, steel: Reinforcement) -> Judged:
    """Return a demand on a perimeter with what resists it there: links count where they bear more than concrete."""
    links, without = laid_links(demand, stress, steel), demand.resistance(stress)
    if links is None or links.resistance <= without:
        return Judged(demand, stress, without)
    return Judged(demand, stress, links.resistance, linked=True)


def all_judged(demand: Demand, steel: Reinforcement) -> list[Judged]:
    """Return a demand on each perimeter that is judged, with what resists it there.

    Where links carry all of the force they are judged on the perimeter that governs without them.
    """
    judged = [_as_laid(demand, stress, steel) for stress in demand.around]
    alone = materials(steel, demand.limit_state)[0].annex.links_alone
    if alone and any(stressed.linked for stressed in judged):
        return [stressed for stressed in judged if stressed.stress is demand.governing]
    return judged


def governing(demand: Demand, steel: Reinforcement) -> Judged | None:
    """Return a demand where it uses most of what resists; None where there is no perimeter."""
    return max(all_judged(demand, steel), key=_share, default=None)


def used(demand: Demand, steel: Reinforcement) -> float:
    """Return v_Ed / v_Rd where it is largest, with the links that are given."""
    worst = governing(demand, steel)
    return worst.share if worst is not None else 0.0


def _at_face(steel: Reinforcement, support: Support, stresses: list[Judged]) -> DesignCheck:
    """Return whether punching exceeds v_Rd,max at any face."""
    check = _punching(AT_FACES[support], support, "v_Rd,max", stresses, "fails", "6.4.5(3)")
    if check.status != "fails":
        return check
    failing = max(stresses, key=_share).name
    demands = [stressed.demand for stressed in stresses if stressed.name == failing]
    return replace(check, words=with_remedy(check.words, steel, demands, at_face=True))


def _within_2d(steel: Reinforcement, support: Support, judged: list[Judged]) -> DesignCheck:
    """Return whether punching within 2 d needs links, or exceeds what they can carry.

    With the bars provided in tension, or with the most that count, whatever will be laid. What links can carry is
    limited at 2 d, or on all perimeters where the face has no limit of its own, as at ends of walls.
    """
    name = WITHIN_2D[support]
    annex = materials(steel)[0].annex
    counted = {id(stressed.stress) for stressed in judged}
    punching = {id(stressed.demand): stressed.demand for stressed in judged}.values()
    limited = (
        stressed for demand in punching for stressed in limited_with_links(demand, annex, at_face=support in AT_FACES)
    )
    most = [stressed for stressed in limited if id(stressed.stress) in counted]
    which = "the bars provided" if steel.laid else "the largest ratio that counts"
    limit = Message("{k_max:g} v_Rd,c with {which}", k_max=annex.k_max, which=which)
    without = _punching(name, support, Message("v_Rd with {which}", which=which), judged, "fails", "6.4.4(2)")
    needing = [stressed for stressed in judged if stressed.share > 1]
    if most:
        with_links = _punching(name, support, limit, most, "fails", "6.4.5(1)")
        if with_links.status == "fails":
            beyond = {stressed.name for stressed in most if stressed.share > 1}
            more = _more({stressed.name for stressed in needing} - beyond, support)
            failing = max(most, key=_share).name
            demands = [demand for demand in punching if demand.name == failing]
            words = with_remedy(with_links.words, steel, demands, at_face=support in AT_FACES)
            return replace(with_links, words=words + more)
        if with_links.hangs:
            low, high = with_links.between or (0.0, 0.0)
            words = Message(
                "{text}; {low:.3g} to {high:.3g} times {limit}, within the error",
                text=without.words,
                low=low,
                high=high,
                limit=limit,
            )
            without = replace(without, words=words)
    if not needing:
        return without if steel.laid else _without_bars(steel, without, judged)
    worst = max(needing, key=_share)
    if worst.linked:
        return replace(without, words=without.words + "; more or thicker legs are needed")
    if outer(worst.demand).is_too_far(worst.demand.d):
        return replace(
            without,
            words=Message("punching reinforcement is needed at {text}; {too_far}", text=without.words, too_far=TOO_FAR),
        )
    links, reach = _links(steel, worst), _outer(worst.demand, support)
    return replace(
        without,
        words=Message(
            "punching reinforcement is needed at {text}; {links}, {reach}", text=without.words, links=links, reach=reach
        ),
    )


def _share(stressed: Judged) -> float:
    return stressed.share


def limited_with_links(demand: Demand, annex: Annex, *, at_face: bool) -> list[Judged]:
    """Return the perimeters of a demand on which links are limited by k_max v_Rd,c, and this limit (6.4.5(1)).

    That is the outermost one, or all of them where the face has no limit of its own, by the annex or at walls.
    """
    stresses = demand.around[-1:] if limited_outermost(annex, at_face=at_face) else demand.around
    return [Judged(demand, stress, annex.k_max * demand.resistance(stress)) for stress in stresses]


def beyond_links(steel: Reinforcement, demand: Demand, *, at_face: bool) -> float:
    """Return the largest stress of a demand over the most that links can help against, on perimeters that count."""
    around = _beyond_around(steel, demand, at_face=at_face)
    return max(around, _beyond_face(steel, demand)) if at_face else around


def _beyond_face(steel: Reinforcement, demand: Demand) -> float:
    """Return the stress at the face over v_Rd,max; 0 without a face, or a limit there."""
    most = en1992.max_resistance(materials(steel, demand.limit_state)[0])
    has_limit = most is not None and demand.face is not None and not demand.face.supported
    return demand.face.v_Ed / most if has_limit and demand.face is not None and most is not None else 0.0


def bars_for_links(steel: Reinforcement, support: Support, demands: Demands[Demand]) -> Iterator[TensionBars]:
    """Yield the bars with which links suffice at columns and piles where they do not yet, if no more than count do."""
    if support not in AT_FACES or not steel.laid:
        return
    for name in dict.fromkeys(name for _, name in demands.found):
        of_name = [demand for (_, of), demand in demands.found.items() if of == name]
        if any(_beyond_face(steel, demand) > 1 for demand in of_name):
            continue
        beyond = [(demand, share) for demand in of_name if (share := _beyond_around(steel, demand, at_face=True)) > 1]
        ratios = [(_ratio_for_links(steel, demand, share), demand) for demand, share in beyond]
        areas = [(ratio * demand.d, demand) for ratio, demand in ratios if ratio is not None]
        if areas and len(areas) == len(ratios):
            area, demand = max(areas, key=lambda needed: needed[0])
            yield TensionBars(name, "top" if demand.pulls != (support == "pile") else "bottom", area, BESIDE * demand.d)


def _beyond_around(steel: Reinforcement, demand: Demand, *, at_face: bool) -> float:
    """Return the largest stress of a demand over k_max v_Rd on perimeters that count."""
    concrete = materials(steel, demand.limit_state)[0]
    limited = limited_with_links(demand, concrete.annex, at_face=at_face)
    return max((stressed.share for stressed in limited if not stressed.supported), default=0.0)


def _ratio_for_links(steel: Reinforcement, demand: Demand, beyond: float) -> float | None:
    """Return the ratio of bars with which v_Rd,c is so many times larger, None if more than those that count."""
    return ratio_for_links(*materials(steel, demand.limit_state), demand.d, demand.v_Rd_c * beyond)


def with_remedy(words: str, steel: Reinforcement, demands: list[Demand], *, at_face: bool) -> str:
    """Return words on links that do not suffice at a column, by its demands, and what helps, if anything is known."""
    helps = _remedy(steel, demands, at_face=at_face)
    return joined((words, helps), "; ") if helps else words


def _remedy(steel: Reinforcement, demands: list[Demand], *, at_face: bool) -> str:
    """Return in words what helps where links do not suffice at a column: bars, or a thickness and a loaded area.

    Bars do not help at the face, where struts fail in any combination, nor where as many as count are taken for
    granted. Thickness and area are those of the worst combinations around and at the face.
    """
    around = max(demands, key=partial(_beyond_around, steel, at_face=at_face))
    worst = {id(demand): demand for demand in (around, max(demands, key=partial(_beyond_face, steel)))}.values()
    struts_fail = at_face and any(_beyond_face(steel, demand) > 1 for demand in worst)
    beyond = _beyond_around(steel, around, at_face=at_face)
    ratio = _ratio_for_links(steel, around, beyond) if steel.laid and not struts_fail else None
    if ratio is not None:
        return Message(
            "bars in tension of {ratio:.2g} % of the section along both axes, within 3 d beside it, would do",
            ratio=100 * ratio,
        )
    count = partial(beyond_links, steel, at_face=at_face)

    def thicker(demand: Demand) -> Demand | None:
        return least_change(lambda more: demand.changed(more, 0.0), count)

    def wider(demand: Demand) -> Demand | None:
        return least_change(lambda more: demand.changed(0.0, more), count)

    thicknesses = [changed.thickness for demand in worst if (changed := thicker(demand)) is not None]
    controls = [changed.around[0].control for demand in worst if (changed := wider(demand)) is not None]
    sides = [control.widths for control in controls if control is not None]
    return in_words(
        max(thicknesses) if len(thicknesses) == len(worst) else None,
        max(sides) if len(sides) == len(worst) else None,
        REACH,
    )


def _without_bars(steel: Reinforcement, check: DesignCheck, judged: list[Judged]) -> DesignCheck:
    """Return a check that holds with the most bars as one that needs attention, if it asks for any: none are laid."""
    ratios = [
        (en1992.required_ratio(materials(steel, demand.limit_state)[0], demand.d, stress.v_Ed * share), demand)
        for demand, stress, *_ in judged
        for share in [demand.v_Rd_c / demand.resistance(stress)]
    ]
    ratio, demand = max(ratios, key=lambda needed: needed[0], default=(0.0, None))
    if demand is None or not ratio:
        return check
    needs = Message(
        "{name} needs bars in tension of {ratio:.2g} % of the section, and none are provided",
        name=Name(demand.name),
        ratio=100 * ratio,
    )
    return replace(check, status="attention", words=Message("{needs}: {text}", needs=needs, text=check.words))


def _more(needing: set[str], support: Support) -> str:
    """Return in words which others need links, beside those that links cannot help."""
    listed = Name(", ".join(sorted(needing)[:6]) + (" ..." if len(needing) > 6 else ""))
    return (
        Message(
            "; punching reinforcement is needed at {number} other {supports}: {names}",
            number=len(needing),
            supports=CALLED[support][0],
            names=listed,
        )
        if needing
        else ""
    )


def _links(steel: Reinforcement, worst: Judged) -> str:
    """Return the links that a perimeter needs, in words."""
    demand, stress, resistance, _ = worst
    concrete, bars = materials(steel, demand.limit_state)
    if concrete.annex.links_alone:
        A_sw = en1992.links_alone(stress.v_Ed * stress.u * demand.d, demand.d, bars.f_yd)
        return Message(
            "there {A_sw:.3g cm2} of vertical links in the two inner rows together (6.4.5(1) of the annex)",
            A_sw=A_sw * 1e4,
        )
    s_r = concrete.annex.link_rows[1] * demand.d
    first = concrete.annex.link_rows[0] * demand.d
    count = en1992.links_that_count(stress.distance, first, s_r, demand.d)
    A_sw = en1992.links_per_perimeter(stress.v_Ed, resistance, stress.u, demand.d, count, bars.f_yd)
    return Message(
        "there {A_sw:.3g cm2} of vertical links on each perimeter, {s_r:.2f m} apart (6.4.5(1), 9.4.3)",
        A_sw=A_sw * 1e4,
        s_r=s_r,
    )


def _outer(demand: Demand, support: Support) -> str:
    """Return in words where links are needed no more."""
    beyond = outer(demand)
    return Message(
        "to within {reach:.2f m} of the perimeter beyond which none are needed, u_out {u:.2f m} "
        "long, {distance:.2f m} from the {support} (6.4.5(4), 6.54)",
        reach=LAST_LINKS * demand.d,
        u=beyond.u,
        distance=beyond.distance,
        support=CALLED[support][0][:-1],
    )


def _at(stress: Stress, d: float) -> str:
    """Return where a perimeter runs."""
    return Message(" at {distance:.2g} d", distance=stress.distance / d) if stress.distance else ""


def _with(stress: Stress) -> str:
    """Return in words how moments count."""
    if stress.beta is None:
        return "by moments"
    words: str = Message("with beta {beta:.2f}", beta=stress.beta)
    if stress.way != "code":
        words += Message(" {way}", way=WAYS[stress.way])
    if stress.outward is not None:
        words += Message(" as a moment of {M:.3g kNm} bends the column outwards", M=stress.outward / 1e3)
    return words


def _punching(
    name: str, support: Support, limit: str, stresses: list[Judged], status: Status, clause: str
) -> DesignCheck:
    """Return whether any stress exceeds its limit, with the worst."""
    beyond = [stressed for stressed in stresses if stressed.share > 1]
    worst = max(stresses, key=_share)
    demand, stress, most, linked = worst
    if linked:
        limit, clause = "v_Rd,cs with the links given", "6.4.5(1), 6.52"
    beside = [stressed for stressed in stresses if stressed.demand.combination == demand.combination]
    error = error_of_ratio((stressed.stress.v_Ed, stressed.resistance, stressed.stress.error) for stressed in beside)
    numbers: dict[str, Any] = {
        "of": demand.name,
        "demand": max(stress.v_Ed, 0.0) / 1e6,
        "resistance": most / 1e6,
        "unit": "MPa",
        "clause": f"EN 1992-1-1 {clause}",
        "combination": demand.combination,
        "place": demand.place,
        "error": scaled(error, most / 1e6),
    }
    if beyond:
        count = len({stressed.name for stressed in beyond})
        words = Message(
            '{count} {many}; worst {name} in "{combination}": v_Ed {v_Ed:.3g MPa}{at}, {moments}, is '
            "{share:.3g} times {most:.3g MPa}, {limit} ({clause})",
            count=count,
            many=CALLED[support][0][: None if count > 1 else -1],
            name=Name(demand.name),
            combination=Name(demand.combination),
            v_Ed=stress.v_Ed / 1e6,
            at=_at(stress, demand.d),
            moments=_with(stress),
            share=worst.share,
            most=most / 1e6,
            limit=limit,
            clause=Clause(clause),
        )
        return DesignCheck(name, status, words, **numbers)
    words = Message(
        "v_Ed is at most {share:.3g} % of {limit}, {name}{at}",
        share=100 * max(worst.share, 0.0),
        limit=limit,
        name=Name(demand.name),
        at=_at(stress, demand.d),
    )
    return DesignCheck(name, "no failure found", words, **numbers)
