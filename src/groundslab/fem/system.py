"""The equations of a problem: element matrices, the matrix of plate and ground, right-hand side, tables of unknowns."""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from groundslab.arrays import Array, Flags, Indices, Integers, made_once_by
from groundslab.fem import assembly
from groundslab.fem.assembly import Pattern
from groundslab.fem.bearings import SURFACE, Bearings
from groundslab.fem.element_blocks import Blocks, blocks
from groundslab.fem.foundation import EDGE_MASS, EDGE_SLOPE, Column, EdgeDecay, edge_decay
from groundslab.fem.hanging import carry, connect
from groundslab.fem.parts import beams, building
from groundslab.fem.problem import TOP, Problem, W
from groundslab.fem.sparse.symmetric import Symmetric
from groundslab.fem.vlasov import Soil

if TYPE_CHECKING:
    from scipy.sparse import csr_array

#: The ground's surface goes on across joints by links so many times as stiff as an element of it.
RIGID_LINK = 1e5


def current_bearings(problem: Problem, factor: float, slip: Array) -> Bearings:
    """Return the bearings under a share of the loading, with their plastic slip (c,) [m] of earlier increments.

    Along the plate's edge the limit of the ground's pressure does not limit the line force.
    """
    b = problem.contact.bearing
    law = b.law
    settled = np.append(problem.loading.settlement, 0.0)[b.support]  # none for the ground, whose support is -1
    settled = np.where(b.field == W, factor * settled, 0.0)
    limit_force = np.where(on_plate_edge(problem) & (law.limit_force > 0), np.inf, law.limit_force)
    return replace(law, offset=law.offset + settled - law.sign * slip, limit_force=limit_force)


def on_plate_edge(problem: Problem) -> Flags:
    """Return which bearings (c,) are ground that carries shear at nodes on the plate's edge."""
    b = problem.contact.bearing
    if not problem.shear_at_edges:
        return np.zeros(len(b.law), dtype=bool)
    on_edge = np.zeros(len(problem.mesh.nodes), dtype=bool)
    on_edge[problem.plate.edges] = True
    return (b.support < 0) & on_edge[b.node]


@dataclass(frozen=True, slots=True)
class System:
    """A problem with its pattern and its element matrices; both hold for every column of ground."""

    problem: Problem
    pattern: Pattern
    blocks: Blocks
    beams: Array  # (b, 3, 3, 6, 6): stiffness of the pieces of beams, see `parts.beams`
    building: tuple[Integers, Array] | None = None  # node pairs and blocks of the building above, see `parts.building`


def build_system(problem: Problem, like: System | None = None) -> System:
    """Return the system of a problem; what is the same in a similar system on the same mesh is reused."""
    mesh, unknown, linked = problem.mesh, problem.unknown, _linked(problem)
    along_beams = beams.stiffness(problem.beams, mesh.nodes)
    if like is None or like.problem.mesh is not mesh:
        pattern = _pattern(problem)
        return System(problem, pattern, blocks(problem), along_beams, _of_building(problem, pattern))
    earlier = like.problem
    depths, earlier_depths = problem.contact.depths, earlier.contact.depths
    sheet, earlier_sheet = problem.plate, earlier.plate
    same_unknowns = np.array_equal(earlier.unknown, unknown) and np.array_equal(_linked(earlier), linked)
    same_plate = earlier_sheet.element is sheet.element and all(
        np.array_equal(a, b)
        for a, b in (
            (earlier_sheet.rigidity, sheet.rigidity),
            (earlier_sheet.bending, sheet.bending),
            (earlier_sheet.shear, sheet.shear),
            (earlier_sheet.membrane, sheet.membrane),
            (earlier_depths.mass_kind, depths.mass_kind),
            (earlier_depths.mass_kinds, depths.mass_kinds),
        )
    )
    pattern = like.pattern if same_unknowns else _pattern(problem)
    above = _of_building(problem, pattern)
    return System(problem, pattern, like.blocks if same_plate else blocks(problem), along_beams, above)


def _of_building(problem: Problem, pattern: Pattern) -> tuple[Integers, Array] | None:
    """Return the node pairs and blocks of the building above, None without one."""
    return None if problem.building is None else building.blocks(problem.building, pattern)


def _pattern(problem: Problem) -> Pattern:
    """Return the pattern of a problem's unknowns."""
    moving, *_ = connect(problem.mesh.elements)
    return assembly.build_pattern(moving, problem.rank, problem.unknown, _linked(problem))


def _linked(problem: Problem) -> Integers:
    """Return the pairs of nodes (l, 2) that links, spans and the building join, which no element may."""
    spans = problem.beams.sides[problem.beams.spans, :2]
    linked, above = np.concatenate([problem.links.nodes, spans]), problem.building
    return linked if above is None else np.concatenate([linked, above.pairs()])


def surface_fields(surface: int) -> tuple[int, ...]:
    """Return the fields whose sum is the settlement of a surface of the ground."""
    return (W, TOP) if surface == 0 else (TOP + surface,)


def stiffness(s: System, column: Column) -> Symmetric:
    """Return the matrix of plate and ground together; the ground's column may differ between elements.

    One of many, as gamma is iterated, is the sum of what is kept for all of them.
    """
    if column.varies or _iterated(s.problem):
        return _sum_of_parts(s, column)
    b, F = s.blocks, s.pattern.unknown.shape[1]

    def matrices(kinds: Integers) -> Array:
        part = b.of(kinds)
        K, ground = part.between_unknowns(F, s.problem.in_plane), functools.cache(part.ground)
        for a, c in _coupled(column):
            for i, j in itertools.product(surface_fields(a), surface_fields(c)):
                mass, slope = ground(*_of_plate(s.problem, i, j))
                K[..., i, j] += column.A0[a, c] * mass + column.A1[a, c] * slope
        return K

    return s.pattern.matrix(assembly.assemble(s.pattern, b.kind, matrices, *_further_blocks(s, column)))


def _iterated(problem: Problem) -> bool:
    """Return whether the ground's column is one of many that are tried."""
    return isinstance(problem.ground, Soil) and problem.ground.gamma is None


@dataclass(frozen=True, slots=True)
class _GroundPart:
    """What two surfaces of the ground add to a matrix where A0 = 1, and where A1 = 1.

    By the element (k, m), or the sums (k,) over all elements for ground that is the same under each.
    """

    entry: Indices  # (k,): to which addends
    mass: Array | csr_array
    slope: Array | csr_array


@dataclass(frozen=True, slots=True)
class _Parts:
    """What a matrix has whatever the ground under the elements is, and what the ground adds."""

    plate: Array  # (addends,)
    entry: Indices  # (pairs, F, F)
    ground: dict[tuple[int, int, bool], _GroundPart]  # by two surfaces, and whether elements differ; as it is asked for


def _sum_of_parts(s: System, column: Column) -> Symmetric:
    """Return the matrix of plate and ground, which is linear in A0 and A1 of each element."""
    parts = _parts(s)
    data = parts.plate.copy()
    for a, c in _coupled(column):
        part = _ground_part(parts, s, (a, c, column.varies))
        A0, A1 = column.A0[..., a, c], column.A1[..., a, c]
        data[part.entry] += part.mass @ A0 + part.slope @ A1 if column.varies else part.mass * A0 + part.slope * A1
    pairs, blocks = _further_blocks(s, column)
    entry = parts.entry[pairs]
    data[entry[entry >= 0]] += blocks[entry >= 0]
    return s.pattern.matrix(data)


@made_once_by(lambda s: (s.blocks.plate, s.pattern))
def _parts(s: System) -> _Parts:
    """Return what the matrices of a system on different ground have in common."""
    b, p = s.blocks, s.pattern
    F = p.unknown.shape[1]
    none = np.zeros(0, dtype=np.int64), np.zeros((0, F, F))
    in_plane = s.problem.in_plane
    plate_alone = assembly.assemble(p, b.kind, lambda kinds: b.of(kinds).between_unknowns(F, in_plane), *none)
    return _Parts(plate_alone, assembly.entries_of_pairs(p), {})


def _ground_part(parts: _Parts, s: System, which: tuple[int, int, bool]) -> _GroundPart:
    """Return what two surfaces of the ground add, by the element if elements differ."""
    from scipy.sparse import vstack

    if which not in parts.ground:
        a, c, varies = which
        entry: list[Indices] = []
        sums: tuple[list[Any], list[Any]] = [], []
        for i, j in itertools.product(surface_fields(a), surface_fields(c)):
            places = parts.entry[:, i, j]
            mask = places >= 0
            entry.append(places[mask])
            for addends, matrices in zip(sums, s.blocks.ground(*_of_plate(s.problem, i, j)), strict=True):
                by_element = assembly.sums_over_elements(s.pattern, s.blocks.kind, matrices)
                addends.append((by_element if varies else by_element.sum(axis=1))[mask])
        join: Callable[..., Any] = functools.partial(vstack, format="csr") if varies else np.concatenate
        parts.ground[which] = _GroundPart(np.concatenate(entry), *map(join, sums))
    return parts.ground[which]


def _coupled(column: Column) -> Iterator[tuple[int, int]]:
    """Yield the pairs of the ground's surfaces whose A0 and A1 couple them."""
    for a, c in itertools.product(range(column.surfaces), repeat=2):
        if column.A0[..., a, c].any() or column.A1[..., a, c].any():
            yield a, c


def _of_plate(problem: Problem, i: int, j: int) -> tuple[bool, bool]:
    """Return whether the fields i and j are w of a plate whose center hangs on its other nodes."""
    hangs = not problem.plate.element.center_w
    return hangs and i == W, hangs and j == W


def edge_decays(problem: Problem, column: Column) -> tuple[EdgeDecay, EdgeDecay]:
    """Return the infinite ground beyond the outer edges and at their corners.

    Where the ground varies, each edge and each corner continues the column of the element inside it.
    """
    if not column.varies:
        everywhere = edge_decay(column)
        return everywhere, everywhere
    elements = problem.mesh.elements
    inside = np.empty(len(problem.mesh.nodes), dtype=np.int64)
    inside[elements] = np.arange(len(elements))[:, None]
    return edge_decay(column.at(inside[problem.edges[:, 2]])), edge_decay(column.at(inside[problem.corners]))


def _further_blocks(s: System, column: Column) -> tuple[Integers, Array]:
    """Return what no element adds: which node pairs (t,), ascending, and their blocks (t, F, F)."""
    parts = [_tail_blocks(s, column)]
    if len(s.problem.links.joint):
        parts.append(_link_blocks(s, column))
    if len(s.beams):
        parts.append(_beam_blocks(s))
    if s.building is not None:
        parts.append(s.building)
    if len(parts) == 1:
        return parts[0]
    return building.sum_by_pair([pairs for pairs, _ in parts], [blocks for _, blocks in parts])


def _link_blocks(s: System, column: Column) -> tuple[Integers, Array]:
    """Return the node pairs (t,) of links and their blocks (t, F, F)."""
    links = s.problem.links
    first, second = links.nodes.T
    both = links.fields[:, :, None] & links.fields[:, None, :]
    block = link_stiffness(s, column)[:, None, None] * both
    pairs = [s.pattern.pairs(a, b) for a, b in ((first, first), (second, second), (first, second))]
    return np.concatenate(pairs), np.concatenate([block, block, -block])


def beam_fields(problem: Problem) -> Iterator[tuple[Integers, Integers, Integers]]:
    """Yield pieces of beams (k,), the fields that move them, and which of w, beta_x, beta_y, u, v, theta these are."""
    common = [*range(TOP), *problem.in_plane]
    for field in np.unique(problem.beams.theta).tolist():
        pieces = np.flatnonzero(problem.beams.theta == field)
        kinds = [*range(len(common)), *([beams.THETA] if field else [])]
        yield pieces, np.array([*common, *([field] if field else [])]), np.array(kinds)


def beam_unknowns(problem: Problem, U: Array) -> Array:
    """Return w, beta_x, beta_y, u, v and theta of the nodes of beams (b, 3, 6) from U (n, F), zeros for what is not."""
    sides = problem.beams.sides
    unknowns = np.zeros((*sides.shape, beams.FIELDS))
    for pieces, fields, kinds in beam_fields(problem):
        unknowns[pieces[:, None, None], np.arange(3)[:, None], kinds] = U[sides[pieces][..., None], fields]
    return unknowns


def _beam_blocks(s: System) -> tuple[Integers, Array]:
    """Return the node pairs (t,) of beams and their blocks (t, F, F), rows being of the node eliminated first."""
    sides, rank, F = s.problem.beams.sides, s.pattern.rank, s.pattern.unknown.shape[1]
    pairs, addends = [], []
    for a, c in itertools.combinations_with_replacement(range(3), 2):
        first, second = sides[:, a], sides[:, c]
        block = np.zeros((len(sides), F, F))
        turned = (rank[first] > rank[second])[:, None, None]
        blocks = np.where(turned, s.beams[:, c, a], s.beams[:, a, c])
        for pieces, fields, kept in beam_fields(s.problem):
            block[np.ix_(pieces, fields, fields)] = blocks[np.ix_(pieces, kept, kept)]
        pairs.append(s.pattern.pairs(first, second))
        addends.append(block)
    return np.concatenate(pairs), np.concatenate(addends)


def link_stiffness(s: System, column: Column) -> Array:
    """Return the stiffness of each link (l,) [N/m], 0 where nodes share the unknown.

    Links of the ground's surface are much stiffer than the ground.
    """
    b, links = s.blocks, s.problem.links
    k = np.where(links.shared, 0.0, links.stiffness)
    ground = np.abs(column.A0).max() * np.abs(b.mass).max() + np.abs(column.A1).max() * np.abs(b.slope).max()
    return np.where(np.isinf(k), RIGID_LINK * ground, k)


def link_forces(s: System, U: Array, column: Column, joints: bool) -> Array:
    """Return the forces (n, F) with which elastic joints resist, or links of the ground's surface."""
    links = s.problem.links
    counts = (links.joint != SURFACE) == joints
    stiffness = np.where(counts, link_stiffness(s, column), 0.0)
    return links.spread(stiffness * links.difference(U), len(U))


def _tail_blocks(s: System, column: Column) -> tuple[Integers, Array]:
    """Return the infinite ground's springs on outer edges and corners (docs/theory.md, infinite ground).

    Which node pairs (t,) they belong to, ascending, and their blocks (t, F, F).
    """
    problem, p = s.problem, s.pattern
    F = p.unknown.shape[1]
    if not len(problem.edges):
        return np.zeros(0, dtype=np.int64), np.zeros((0, F, F))
    t, at_corners = edge_decays(problem, column)
    length = edge_lengths(problem)
    a, b = np.triu_indices(3)
    pair = p.pairs(problem.edges[:, a], problem.edges[:, b])
    mass, slope = length[:, None] * EDGE_MASS[a, b], EDGE_SLOPE[a, b] / length[:, None]
    at_corner = p.pairs(problem.corners, problem.corners)
    spring, along, corner = t.spring, t.slope, at_corners.corner

    pairs, number = np.unique(np.concatenate([pair.ravel(), at_corner]), return_inverse=True)
    on_edges, on_corners = number[: pair.size].reshape(pair.shape), number[pair.size :]
    blocks = np.zeros((len(pairs), F, F))
    for i in range(column.surfaces):
        for j in range(column.surfaces):
            block = blocks[:, TOP + i, TOP + j]
            np.add.at(block, on_edges, spring[..., i, j, None] * mass + along[..., i, j, None] * slope)
            np.add.at(block, on_corners, corner[..., i, j])
    return pairs, blocks


def edge_lengths(problem: Problem) -> Array:
    """Return the lengths (e,) [m] of the outer sides on which infinite ground follows."""
    ends = problem.mesh.nodes[problem.edges[:, :2]]
    length: Array = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    return length


def right_hand_side(s: System, factor: float) -> Array:
    """Return f (size,): the loads times a factor."""
    p = s.pattern
    f = np.zeros(p.size)
    has = p.unknown >= 0
    np.add.at(f, p.unknown[has], factor * s.problem.load[has])
    return f


def nodal_table(problem: Problem, u: Array) -> Array:
    """Return unknowns (size,) as a table (n, F), with zeros where there is no unknown but at hanging nodes."""
    table = np.zeros(problem.unknown.shape)
    has = problem.unknown >= 0
    table[has] = u[problem.unknown[has]]
    return carry(problem.mesh.elements, table)


def surface_settlement(s: System, U: Array) -> Array:
    """Return the settlement of every surface of the ground at every node, (S, n) [m], from the table U (n, F)."""
    top = U[:, TOP].copy()
    under = s.problem.plate.nodes
    top[under] += plate_settlement(s, U)[under]
    # beside the plate a node may hang on a side that begins at its edge
    top = carry(s.problem.mesh.elements, top)
    return np.vstack([top, U[:, TOP + 1 : TOP + s.problem.surfaces].T])


def plate_settlement(s: System, U: Array) -> Array:
    """Return the plate's settlement at every node (n,) [m], dependent centers included."""
    problem = s.problem
    w: Array = U[:, W].copy()
    if not problem.plate.element.center_w:
        elements = problem.mesh.elements[problem.plate.elements]
        at_centre = s.blocks.T[:, 8][s.blocks.kind[problem.plate.elements]]
        w[elements[:, 8]] = np.einsum("ea,ea->e", at_centre, w[elements])
    return w
