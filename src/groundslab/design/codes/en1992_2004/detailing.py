"""How bars end and lap in a case by EN 1992-1-1, and what areas the cracks of laid bars would need."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.design.codes.en1992_2004 import anchorage, cracking
from groundslab.design.codes.en1992_2004.annex import annex_of
from groundslab.design.codes.en1992_2004.materials_of_case import least_cover, materials, strengths, widest_crack
from groundslab.design.demands.support_moments import bar_moments
from groundslab.design.rules.calculation import MEGA, Step
from groundslab.design.rules.combinations import solved_results
from groundslab.design.rules.detailing_rule import BendRule, DetailingRule, EndingBar
from groundslab.fem.cracked_section import mean_tensile_strength
from groundslab.model.design.laid_bars import axis_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.results import Results

#: The largest aggregate [m] that distances of bars count on, if the case has none.
AGGREGATE = 0.020
#: Clear distance of bars: the least [m], the factor of the aggregate's size, and what is added to it [m] (8.2(2)).
CLEAR = (0.020, 1.0, 0.005)
#: Diameters in that of the mandrel, of bars up to a diameter [m] and of thicker ones (Table 8.1N).
MANDRELS, THIN = (4, 7), 0.016
#: Straight part of a link's hook beyond its bend: times the diameter, at least [m], of one turned by more than 90
#: degrees and of one of 90 (Figure 8.5 a, b).
HOOK, BEND = (5, 0.050), (10, 0.070)
#: Of a diameter [m].
ROUNDING = 1e-9
#: Halvings of the interval in which an area is looked for: to 1 / 1000 of it and less.
HALVINGS = 14


def _length(steel: Reinforcement, bar: EndingBar, *, lap: bool) -> float:
    """Return the anchorage or lap [m] of a bar."""
    good = anchorage.good_bond(bar.below, bar.above)
    c_d = min(bar.axis - bar.diameter / 2, (bar.spacing - bar.diameter) / 2)  # Figure 8.3
    find = anchorage.lap_length if lap else anchorage.anchorage_length
    return find(*materials(steel), bar.diameter, c_d, good)


def anchorage_steps(steel: Reinforcement, bar: EndingBar, n: int) -> Iterator[Step]:
    """Yield how the anchorage length of bars number n is found."""
    concrete, bars = materials(steel)
    good = anchorage.good_bond(bar.below, bar.above)
    f_bd = anchorage.bond_stress(concrete, bar.diameter, good) / MEGA
    c_d = min(bar.axis - bar.diameter / 2, (bar.spacing - bar.diameter) / 2)
    basic = anchorage.basic_length(concrete, bars, bar.diameter, good)
    f_ctm = mean_tensile_strength(min(concrete.f_ck, anchorage.MOST_BOND)) / MEGA
    yield Step("concrete below the axis of the bar", f"h_b,{n}", bar.below, "m", clause="Figure 8.2")
    words = "factor of good bond" if good else "factor of poor bond"
    yield Step(words, f"eta_1,{n}", 1.0 if good else anchorage.POOR, clause="8.4.2(2)")
    formula = f"min(1, (132 - 1000 * phi_{n}) / 100)"
    eta_2 = min(1.0, (132 - bar.diameter * 1e3) / 100)
    yield Step("factor of the diameter", f"eta_2,{n}", eta_2, "", formula, "8.4.2(2)")
    yield Step("mean tensile strength, of C60/75 at most", "f_ctm", f_ctm, "MPa", clause="Table 3.1")
    yield Step("partial factor", "gamma_C", concrete.gamma_c, clause="2.4.2.4")
    formula = f"2.25 * eta_1,{n} * eta_2,{n} * {anchorage.CHARACTERISTIC:g} * f_ctm / gamma_C"
    yield Step("bond stress", f"f_bd,{n}", f_bd, "MPa", formula, "8.4.2(2), 8.2")
    yield Step("design yield strength", "f_yd", bars.f_yd / MEGA, "MPa", clause="3.2.7(2)")
    formula = f"phi_{n} / 4 * f_yd / f_bd,{n}"
    yield Step("basic anchorage length", f"l_rqd,{n}", basic, "m", formula, "8.4.3(2), 8.3")
    words = "lesser of the cover and half the clear distance of bars"
    yield Step(words, f"c_d,{n}", c_d, "m", clause="Figure 8.3")
    relieves = concrete.annex.cover_relieves
    formula = f"min(1, max(0.7, 1 - 0.15 * (c_d,{n} - phi_{n}) / phi_{n}))" if relieves else ""
    alpha_2 = anchorage.cover_factor(concrete, bar.diameter, c_d)
    yield Step("factor of the cover", f"alpha_2,{n}", alpha_2, "", formula, "Table 8.2")
    formula = f"max(alpha_2,{n} * l_rqd,{n}, 0.3 * l_rqd,{n}, 10 * phi_{n}, 0.1)"
    length = anchorage.anchorage_length(concrete, bars, bar.diameter, c_d, good)
    yield Step("anchorage length", f"l_b,{n}", length, "m", formula, "8.4.4(1), 8.4, 8.6")


def _spacing(steel: Reinforcement, thickness: float) -> float:
    """Return the largest spacing [m] where slabs are bent most, which holds everywhere then (9.3.1.1(3))."""
    times, least, most = annex_of(steel.annex).spacing_bent_most
    return min(max(times * thickness, least), most)


def _clear(steel: Reinforcement, diameter: float) -> float:
    """Return the clear distance of bars [m] at least (8.2(2))."""
    least, times, more = CLEAR
    return max(diameter, least, times * (steel.aggregate or AGGREGATE) + more)


def crack_area(combined: Results, steel: Reinforcement, layer: str, diameter: float, spacing: float) -> Array:
    """Return the areas (n,) [m2/m] that bars of a layer need at the nodes for cracks; see `DetailingRule`.

    A_s,min of 7.1 where a face is in tension in any combination; and in the quasi-permanent ones w_k <= w_max with bars
    that are elastic, for the largest moment: both grow with it. w_k falls as the area grows.
    """
    results, w_max = solved_results(combined), widest_crack(steel)
    plate = results[0].plate
    if w_max is None:
        return np.zeros(len(plate.nodes))
    (concrete, bars), f_yk = materials(steel), strengths(steel)[1]
    thickness = results[0].elements.at_nodes(plate)[0]
    moments = {result.combination: np.abs(getattr(bar_moments(result, steel), layer)) for result in results}
    tension = np.max(list(moments.values()), axis=0) > 0
    lasting = [moments[result.combination] for result in results if result.limit_state == "quasi-permanent"]
    low = np.where(tension, cracking.minimum_area(thickness, concrete, f_yk), 0.0)
    if not lasting:
        return low
    m = np.max(lasting, axis=0)
    cover = axis_of(steel, layer) - diameter / 2

    def too_wide(nodes: Integers, area: Array) -> Flags:
        of_area = cracking.Bars(diameter, spacing, cover, area)
        width = cracking.crack_width(m[nodes], thickness[nodes], of_area, concrete, bars)
        yields = cracking.bar_stress(m[nodes], thickness[nodes], of_area, concrete, bars) > f_yk
        return np.asarray((width > w_max) | yields)

    bent = np.flatnonzero(m > 0)
    wide = bent[too_wide(bent, low[bent])]
    return _halved(low, wide, concrete.annex.most_bars * thickness, too_wide)


def _halved(low: Array, wide: Integers, most: Array, too_wide: Callable[[Integers, Array], Flags]) -> Array:
    """Return areas (n,) between low and most (n,) [m2/m] at which cracks are not too wide, those of some nodes more."""
    area, below, above = low.copy(), low[wide], most[wide]
    never = too_wide(wide, above)
    for _ in range(HALVINGS):
        middle = (below + above) / 2
        more = too_wide(wide, middle)
        below, above = np.where(more, middle, below), np.where(more, above, middle)
    area[wide] = np.where(never, np.inf, above)
    return area


def _mandrel(diameter: float) -> float:
    """Return the least diameter of the mandrel [m] (Table 8.1N)."""
    return diameter * MANDRELS[diameter > THIN + ROUNDING]


def _hook(diameter: float, angle: float) -> float:
    """Return the straight length beyond the bend of a link's hook [m] (Figure 8.5)."""
    times, least = HOOK if angle > 90 else BEND
    return max(times * diameter, least)


RULE = DetailingRule(
    anchorage=lambda steel, bar: _length(steel, bar, lap=False),
    lap=lambda steel, bar: _length(steel, bar, lap=True),
    shift=lambda d, _: d,  # 9.2.1.3(2): a_l = d without links
    least_cover=lambda steel, _, diameter: least_cover(steel, diameter),
    least_clear=_clear,
    spacing=_spacing,
    edge_leg=2.0,  # Figure 9.8
    crack_area=crack_area,
    crack_spacing=None,
    anchorage_steps=anchorage_steps,
    bends=BendRule(_mandrel, _mandrel, _hook, "8.3, 8.5"),
    clauses={"anchorage": "8.4.4", "laps": "8.7.3", "shift": "9.2.1.3(2)", "edges": "9.3.1.4"},
)
