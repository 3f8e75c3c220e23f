"""Which openings count by EN 1992-1-1 6.4.2(3), and the perimeter u_0 at a column's face by its 6.4.5(3).

The clause has the whole periphery of a column inside the slab, c_2 + 3 d <= c_2 + 2 c_1 of one flush with an edge, and
3 d <= c_1 + c_2 of one flush with a corner; c_2 is the side along the edge. It says nothing of a column that stands a
little inside. There its sides across an edge are taken to run straight out to it, as the control perimeters of
Figure 6.15 do, each longer by the setback s; the shortest of these lengths counts, as 6.4.2(4) says of perimeters:

    u_0 = min(whole periphery, c_2 + 2 s + min(3 d, 2 c_1), s_1 + s_2 + min(3 d, c_1 + c_2))

It is the clause's at s = 0, grows by 2 s, and is the whole periphery where 2 s reaches 2 c_1 + c_2 - min(3 d, 2 c_1):
nothing jumps. What lies between the tangents to openings does not count (6.4.2(3)).

The clause has no perimeter partly in a thinner slab, of depth d_t, such as one that leaves a thicker zone. There a
length counts by what the slab resists, v_Rd,c max(1, 2 d_t / a_t) d_t, over that at the column, v_Rd,c (2 d / a) d, and
no more than there. a_t is how far the perimeter lies from the thicker slab, which loads the thinner one as 6.4.2(8) to
(11) say of column heads; no more than a less the least distance of the thinner slab. v_Rd,c is not less in a thinner
slab with the same bars, and its growth is left out.
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.demands.line_properties import total_length
from groundslab.design.demands.perimeters import (
    NearEdge,
    Openings,
    Surroundings,
    choose,
    outside,
    stretch,
    way_around,
)
from groundslab.design.demands.zones.thinner_slab import ThinnerPart

#: An opening counts up to this distance from the column, in effective depths (6.4.2(3)).
OPENING_REACH = 6.0
#: Distances from thicker slab [m] are not less.
ROUNDING = 1e-9
#: At a face an edge or the two edges of a corner are near, no more.
CORNER_EDGES = 2
#: Two edges meet in a corner if the cosine of the angle between them is less than this.
CORNER = 0.9


def openings(d: float) -> Openings:
    """Return the openings that count for an effective depth d [m], with the width of Figure 6.14."""
    return Openings(OPENING_REACH * d, widened=True)


def share_of_thinner(part: ThinnerPart, a: float, d: float) -> float:
    """Return the share of a perimeter's length that counts in a thinner part, at a from the face [m].

    d is the effective depth at the column [m]. It is max(1, 2 d_t / a_t) a d_t / (2 d^2) by 6.4.4(2), at most 1.
    """
    d_t = max(0.0, d - part.by)
    beyond = max(a - part.away, ROUNDING)
    return min(1.0, max(1.0, 2 * d_t / beyond) * a * d_t / (2 * d**2))


def face_length(around: Surroundings, d: float) -> float:
    """Return u_0 [m] of a footprint on a plate, with an effective depth d [m]; 0 if no plate is left around it."""
    from shapely import get_coordinates

    points = get_coordinates(around.footprint)
    # an edge farther away than half the periphery cannot shorten it
    near = [edge for edge in around.edges if edge.setback <= around.footprint.length / 2]
    ways = []
    for edges in choose(near, at_most=CORNER_EDGES):
        legs = way_around(around, stretch(around, edges))
        whole = total_length(legs)
        if whole > 0:
            counted = total_length(outside(legs, around.shadow))
            ways.append(min(whole, _most(edges, points, d)) * counted / whole)
    return min(ways, default=0.0)


def _most(edges: tuple[NearEdge, ...], points: Array, d: float) -> float:
    """Return the largest length [m] that counts of a column of corners (k, 2) with sides out to edges."""
    setbacks = sum(edge.setback for edge in edges)
    if len(edges) == 1:
        outward = edges[0].outward
        c_2 = float(np.ptp(points @ np.array([-outward[1], outward[0]])))
        return c_2 + 2 * setbacks + 3 * d
    if len(edges) == 2 and abs(edges[0].outward @ edges[1].outward) < CORNER:
        return setbacks + 3 * d
    return np.inf
