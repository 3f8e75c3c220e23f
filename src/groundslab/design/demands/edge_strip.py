"""The line force along the plate's edge, spread over a strip beside it, for checks that it must not relieve.

On ground with shear a line force f stands for a strong increase of the reactions near the edge (Kerr 1964). No soil
bears a line: what it carries it carries by pressure. Here that is f / b over a strip as wide as the ground's surface
takes to die out, b = L, sqrt(k1/k0) for one surface (docs/theory.md, infinite ground), at most as wide as the plate
reaches from its edge. So the forces on the ground stay the same, and at the distance s < b from the edge the shear
force across the plate changes by what f is ahead of its share in the strip,

    q'_n = q_n + f (1 - s / b),    n outwards

Only a force that presses on the plate counts, and each side of an element by itself, so that at a corner both add up.
"""

from __future__ import annotations

import math
from dataclasses import replace
from operator import attrgetter
from typing import NamedTuple

import numpy as np

from groundslab.arrays import Array, Integers, made_once_by
from groundslab.design.demands.by_plate import farthest_from_edges, results_by_plate
from groundslab.fem.foundation import decay_length, interface_stack
from groundslab.fem.mesh import sides_on_boundary
from groundslab.fem.shape_functions import lagrange
from groundslab.results.contact_zone import has_line_force
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult

#: A layer without shear has so little of it that the ground's surface has a decay, as a share of the largest k1.
LEAST_SHEAR = 1e-9
#: A place this near to the end of a side, as a share of its length, lies at the end.
ON_SIDE = 1e-6
#: Places are looked for in strips as wide as a power of this [m], which combinations have in common.
WIDER = 1.25


@made_once_by(attrgetter("nodes", "elements"))
def _pairs_of(plate: PlateResult) -> dict[tuple[float, bytes], tuple[Integers, Integers]]:  # noqa: ARG001
    """Return pairs of sides and nodes that may lie in a strip beside them, as they are added, by width and nodes."""
    return {}


def line_force_share(results: CombinationResult) -> float:
    """Return how much of the ground's whole force on the plate is line force along its edge, 0 where it has none."""
    if not has_line_force(results):
        return 0.0
    plate = results.plate
    carried, along = float(plate.contact_force.sum()), float(plate.line_force @ plate.edge_length)
    return along / carried if carried > 0 else 0.0


class Strip(NamedTuple):
    """The strip beside the plate's edge that the line force is spread over."""

    k0: tuple[float, ...]  # of each layer [N/m3]
    k1: tuple[float, ...]  # [N/m]
    decay: float  # L [m]
    farthest: float  # of the plate from its edge [m]

    @property
    def width(self) -> float:
        """Return b [m]."""
        return min(self.decay, self.farthest)


def strip_of(results: CombinationResult) -> Strip:
    """Return the strip that the line force is spread over."""
    k0, k1 = (np.array(constant) for constant in (results.constants.k0, results.constants.k1))
    decay = decay_length(interface_stack(k0, np.maximum(k1, LEAST_SHEAR * k1.max())))
    return Strip(tuple(k0.ravel().tolist()), tuple(k1.ravel().tolist()), decay, farthest_from_edges(results))


def strip_width(results: CombinationResult) -> float:
    """Return the width b [m] of the strip that the line force is spread over."""
    return strip_of(results).width


def plates_that_count(
    results: CombinationResult, *, relieves: bool, nodes: Integers | None = None
) -> tuple[PlateResult, ...]:
    """Return the plate as it is and, unless the line force along its edge relieves it, with that force spread.

    At some nodes (k,) only, if they are given.
    """
    if relieves or not has_line_force(results):
        return (results.plate,)
    return results.plate, spread_edge_force(results, nodes)


def spread_edge_force(results: CombinationResult, nodes: Integers | None = None) -> PlateResult:
    """Return the plate with pressure and shear forces as they are with the line force spread over the strip.

    At some nodes (k,) only, if they are given.
    """
    plate = results.plate
    if not has_line_force(results):
        return plate
    asked = np.arange(len(plate.nodes)) if nodes is None else nodes
    (sides, f), b = _sides(results), strip_width(results)
    places, cached_pairs = plate.nodes[asked], _pairs_of(plate)
    width = WIDER ** math.ceil(math.log(b, WIDER))
    key = width, asked.tobytes()
    pairs = cached_pairs[key] if key in cached_pairs else cached_pairs.setdefault(key, _pairs(places, sides, width))
    pressure, shear = np.zeros(len(plate.nodes)), np.zeros((len(plate.nodes), 2))
    pressure[asked], shear[asked] = _spread(places, sides, f, b, pairs)
    return replace(
        plate,
        pressure=plate.pressure + pressure,
        shear_x=plate.shear_x + shear[:, 0],
        shear_y=plate.shear_y + shear[:, 1],
    )


def _sides(results: CombinationResult) -> tuple[Array, Array]:
    """Return the sides of elements along the plates' edges: nodes (k, 3, 2) [m] and line forces (k, 3) [N/m].

    In the order start, middle, end; the plate lies to the left. A force that pulls is none.
    """
    ends, f = [], []
    for plate in results_by_plate(results).values():
        sides = _along_edge(plate)
        ends.append(plate.nodes[sides])
        f.append(np.maximum(plate.line_force[sides], 0.0))
    return np.concatenate(ends), np.concatenate(f)


@made_once_by(attrgetter("nodes", "elements"))
def _along_edge(plate: PlateResult) -> Integers:
    """Return the sides of elements along a plate's edge (k, 3: start, middle, end)."""
    # the border of two sections is no edge: its nodes stand once for each section, at exactly the same place
    _, first, same = np.unique(plate.nodes + 0.0, axis=0, return_index=True, return_inverse=True)
    sides: Integers = first[sides_on_boundary(same.reshape(-1)[plate.elements])][:, [0, 2, 1]]
    return sides


def _spread(places: Array, sides: Array, f: Array, b: float, pairs: tuple[Integers, Integers]) -> tuple[Array, Array]:
    """Return pressure (n,) [Pa] and change of the shear force (n, 2) [N/m] at places (n, 2) [m] by elements' sides.

    Pairs of sides and places are those that may lie in the strip of width b [m].
    """
    side, place = pairs
    start, length = sides[:, 0], np.linalg.norm(sides[:, 2] - sides[:, 0], axis=1)
    along = (sides[:, 2] - start) / length[:, None]
    outwards = np.stack([along[:, 1], -along[:, 0]], axis=1)
    off = places[place] - start[side]
    s = -np.einsum("px,px->p", off, outwards[side])
    t = 2 * np.einsum("px,px->p", off, along[side]) / length[side] - 1
    inside = (np.abs(t) <= 1 + ON_SIDE) & (s >= -ON_SIDE * length[side]) & (s <= b)
    side, place, s, t = side[inside], place[inside], np.maximum(s[inside], 0.0), t[inside]
    acting = np.einsum("pa,pa->p", lagrange(t)[0], f[side]) * _share_at_ends(place, sides, side, t)
    pressure, shear = np.zeros(len(places)), np.zeros((len(places), 2))
    np.add.at(pressure, place, acting / b)
    np.add.at(shear, place, (acting * (1 - s / b))[:, None] * outwards[side])
    return pressure, shear


def _pairs(places: Array, sides: Array, b: float) -> tuple[Integers, Integers]:
    """Return pairs of sides and places that may lie in the strip of width b [m] beside them."""
    import shapely

    reach = shapely.buffer(shapely.linestrings(sides[:, [0, 2]]), b * (1 + ON_SIDE), quad_segs=2)
    side, place = shapely.STRtree(shapely.points(places)).query(reach)
    return side, place


def _share_at_ends(place: Integers, sides: Array, side: Integers, t: Array) -> Array:
    """Return the share (p,) of a side's force at a place: where two sides meet, half of that of each."""
    at_end = np.abs(np.abs(t) - 1) <= ON_SIDE
    end = np.where((t > 0)[:, None], sides[side, 2], sides[side, 0]) + 0.0
    share = np.ones(len(place))
    if at_end.any():
        keys = np.column_stack([place[at_end], end[at_end]])
        _, inverse, count = np.unique(keys, axis=0, return_inverse=True, return_counts=True)
        share[at_end] = 1 / count[inverse.reshape(-1)]
    return share
