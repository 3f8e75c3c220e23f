"""What links that are given carry on a perimeter by EN 1992-1-1 6.4.5(1): v_Rd,cs, with all that counts of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from groundslab.design.codes.en1992_2004 import punching as en1992
from groundslab.design.codes.en1992_2004.checks.punching_demand import Demand, Stress
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.model.design.reinforcement import Reinforcement

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
    given = steel.links_at(demand.name)
    if given is None or stress.distance > given.distances[-1] + CROSSED * demand.d:
        return None
    concrete, bars = materials(steel, demand.limit_state)
    u, d = stress.u, demand.d
    if concrete.annex.links_alone:
        further = concrete.annex.link_rows[2]
        A_sw = min([sum(given.areas[:LEAST_ROWS]), *(area / further for area in given.areas[LEAST_ROWS:])])
        return LaidLinks(A_sw, 1.0, True, A_sw * en1992.effective_strength(d, bars.f_yd) / (u * d))
    s_r = given.apart or concrete.annex.link_rows[1] * d
    count = links_that_count(given.distances, stress.distance, s_r, d)
    A_sw = min(given.areas)
    v_Rd_cs = en1992.resistance_with_links(demand.resistance(stress), A_sw, count, u, d, bars.f_yd)
    return LaidLinks(A_sw, count, False, v_Rd_cs)
