"""Equilibrium of design strips, piece by piece between their cuts: what acts on a piece against its section forces.

With V and M of `section_cuts`, the loads L and the forces P of ground and supports on the piece from cut i - 1 to i,
each with its lever l from cut i - 1, the shear Q of both sides with outward normals, and their twisting moments S,

    V_{i-1} - V_i = Q + L - P,        M_{i-1} - M_i = S - V_i (s_i - s_{i-1}) - l (Q + L - P).

Loads, ground and supports know nothing of section forces, which are averaged at nodes: what is left is their error.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers, made_once_by
from groundslab.design.demands.cuts.section_cuts import StripResult, cut_along, rotate_to_cut
from groundslab.design.demands.loads.column_loads import acting_inside, factored_sums
from groundslab.design.demands.loads.edge_lengths import edge_inside
from groundslab.errors import InputError
from groundslab.fem import load_vectors
from groundslab.fem.assembly import scatter
from groundslab.fem.mesh import Mesh
from groundslab.model.model import Model
from groundslab.model.outputs import OutputStrip
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: Sides are read so far inside of a strip, relative to its width.
INSIDE = 1e-6
#: Pieces are cut so far before stations, and what is that near to a side is on the strip, relative to its width.
BESIDE, ROUNDING = 1e-7, 1e-9
#: What section forces of a side are made of.
FORCES = ("moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
#: Samples this near to a cut are at it [m].
NEAR = 1e-9


@dataclass(frozen=True, slots=True)
class StripBalance:
    """Forces on the piece of a strip between each cut and the one before it, (c,) each; 0 at the first."""

    loads: Array  # L, downwards [N]
    reactions: Array  # P of ground and supports, upwards [N]
    sides: Array  # Q of both sides, downwards beyond them [N]
    shear: Array  # what is left of V_{i-1} - V_i [N]
    moment: Array  # what is left of M_{i-1} - M_i [N m]

    @property
    def columns(self) -> tuple[Array, ...]:
        """Return all of them, in this order."""
        return self.loads, self.reactions, self.sides, self.shear, self.moment


@dataclass(frozen=True, slots=True)
class _Piece:
    """What may act on a piece of a strip, the same in every combination on a mesh."""

    begin: float  # of its begin, along the strip's direction from the origin of the plan [m]
    nodes: Integers  # (k,)
    area: Array  # (k,): these nodes' shares of its area [m2]
    edge_nodes: Integers  # (e,)
    edge: Array  # (e,): these nodes' shares of the length of the plate's edge on it [m]
    loads: Mapping[str, Array]  # (3,): forces [N] and first moments [N m] by load case
    shape: BaseGeometry  # with what is on its border


def strip_balance(results: CombinationResult, strip: OutputStrip, cuts: StripResult) -> StripBalance | None:
    """Return the forces on the pieces of a strip; None where beams, walls or joints carry forces, too."""
    if results.model.members or results.joints:
        return None
    axis = np.array(strip.end) - strip.start
    axis = axis / np.linalg.norm(axis)
    pieces, key = _pieces(results, results.solved_model), (strip.name, cuts.s.tobytes())
    if key not in pieces:
        # what stands at a cut belongs to the piece that begins there
        off = np.where(np.arange(len(cuts.s)) < len(cuts.s) - 1, -BESIDE, BESIDE) * strip.width
        pieces[key] = [_piece(results, strip, axis, span) for span in pairwise((cuts.s + off).tolist())]
    acting = [_acting(results, piece, axis) for piece in pieces[key]]
    loads, reactions = (np.array(forces).reshape(-1, 2) for forces in zip(*acting, strict=True))
    sides, twist = _sides(results, strip, axis, cuts.s)
    down = loads - reactions + sides
    shear = cuts.shear[:-1] - cuts.shear[1:] - down[:, 0]
    moment = cuts.moment[:-1] - cuts.moment[1:] - twist + cuts.shear[1:] * np.diff(cuts.s) + down[:, 1]
    columns = (loads[:, 0], reactions[:, 0], sides[:, 0], shear, moment)
    return StripBalance(*(np.concatenate([[0.0], column]) for column in columns))


@made_once_by(lambda results, model: (results.plate.nodes, model))
def _pieces(results: CombinationResult, model: Model) -> dict[tuple[str, bytes], list[_Piece]]:  # noqa: ARG001
    """Return the pieces of strips on a mesh, as they are added."""
    return {}


def _piece(results: CombinationResult, strip: OutputStrip, axis: Array, span: tuple[float, float]) -> _Piece:
    """Return the piece of a strip between two ways along it [m]."""
    from shapely import LineString

    begin, end = (np.array(strip.start) + way * axis for way in span)
    part = LineString([begin, end]).buffer(strip.width / 2, cap_style="flat")
    plate = results.plate
    mesh = Mesh(plate.nodes, plate.elements)
    elements = load_vectors.find_elements_near(mesh, part)
    shares = load_vectors.integrate_over_polygon(mesh, elements, part)
    area = scatter(mesh.elements[elements], shares, len(mesh.nodes))
    nodes = np.flatnonzero(area)
    loads = acting_inside(results, part, (), shares=(elements, shares))
    near = part.buffer(ROUNDING * strip.width)
    return _Piece(float(begin @ axis), nodes, area[nodes], *edge_inside(plate, part), loads, near)


def _acting(results: CombinationResult, piece: _Piece, axis: Array) -> tuple[Array, Array]:
    """Return the loads and the reactions [N] on a piece, each with its moment about the piece's begin [N m], (2,)."""
    from shapely import intersects, points

    def with_lever(force: float, first: Array) -> Array:
        return np.array([force, first @ axis - force * piece.begin])

    plate = results.plate
    force, *first = factored_sums(results, piece.loads)
    pressed, along_edge = piece.area * plate.pressure[piece.nodes], piece.edge * plate.line_force[piece.edge_nodes]
    places = plate.nodes[piece.nodes], plate.nodes[piece.edge_nodes]
    reactions = with_lever(float(pressed.sum()), pressed @ places[0])
    reactions += with_lever(float(along_edge.sum()), along_edge @ places[1])
    for support in results.supports:
        on = intersects(points(support.nodes), piece.shape)
        reactions += with_lever(float(support.force[on].sum()), support.force[on] @ support.nodes[on])
        reactions[1] -= np.array([support.moment_x[on].sum(), support.moment_y[on].sum()]) @ axis
    return with_lever(float(force), np.array(first)), reactions


def _sides(results: CombinationResult, strip: OutputStrip, axis: Array, ways: Array) -> tuple[Array, Array]:
    """Return the shear of both sides of pieces between ways (c,) [m], and their twist [N m].

    The shear [N] stands beside its moment about the begin of each piece [N m], (c - 1, 2).
    """
    left, middle = np.array([-axis[1], axis[0]]), np.array(strip.start) + ways[:, None] * axis
    shear, twist = np.zeros((len(ways) - 1, 2)), np.zeros(len(ways) - 1)
    for sign in (-1.0, 1.0):  # the right side runs along the strip, the left one back
        places = middle + sign * (0.5 - INSIDE) * strip.width * left
        try:
            cut = cut_along(results.plate, places if sign < 0 else places[::-1])
        except InputError:
            continue
        m_x, m_y, m_xy, q_x, q_y = (cut.values[name] for name in FORCES)
        _, _, m_nt, q_n = rotate_to_cut(m_x, m_y, m_xy, q_x, q_y, np.broadcast_to(-sign * axis, (len(cut.s), 2)))
        way = ways[0] + cut.s if sign < 0 else ways[-1] - cut.s
        for samples in cut.parts():
            for number, (low, high) in enumerate(pairwise(ways.tolist())):
                on = np.flatnonzero((way[samples] >= low - NEAR) & (way[samples] <= high + NEAR)) + samples.start
                s = cut.s[on]
                shear[number] += np.trapezoid(q_n[on], s), np.trapezoid(q_n[on] * (way[on] - low), s)
                twist[number] -= sign * np.trapezoid(m_nt[on], s)
    return shear, twist
