"""The perimeter u_0 at a column's face, by EN 1992-1-1 6.4.5(3), Figure 6.20 and, set back from an edge, Figure 6.15.

The clause has the whole periphery of a column inside the slab, c_2 + 3 d <= c_2 + 2 c_1 of one flush with an edge, and
3 d <= c_1 + c_2 of one flush with a corner; c_2 is the side along the edge. It says nothing of a column that stands a
little inside. There its sides across an edge are taken to run straight out to it, as the control perimeters of
Figure 6.15 do, each longer by the setback s; the shortest of these lengths counts, as 6.4.2(4) says of perimeters:

    u_0 = min(whole periphery, c_2 + 2 s + min(3 d, 2 c_1), s_1 + s_2 + min(3 d, c_1 + c_2))

It is the clause's at s = 0, grows by 2 s, and is the whole periphery where 2 s reaches 2 c_1 + c_2 - min(3 d, 2 c_1):
nothing jumps. What lies between the tangents to openings does not count (6.4.2(3)).
"""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.line_properties import total_length
from groundslab.design.perimeters import NearEdge, Surroundings, outside, stretched_over, way_around

#: Two edges meet in a corner if the cosine of the angle between them is less than this.
CORNER = 0.9


def face_length(around: Surroundings, d: float) -> float:
    """Return u_0 [m] of a footprint on a plate, with an effective depth d [m]."""
    from shapely import get_coordinates

    points = get_coordinates(around.footprint)
    # an edge farther away than half the periphery cannot shorten it
    near = [edge for edge in around.edges if edge.setback <= around.footprint.length / 2]
    ways = []
    for edges, region in stretched_over(around, near):
        legs = way_around(around, region)
        whole = total_length(legs)
        if whole > 0:
            counted = total_length(outside(legs, around.shadow))
            ways.append(min(whole, _most(edges, points, d)) * counted / whole)
    return min(ways)


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
