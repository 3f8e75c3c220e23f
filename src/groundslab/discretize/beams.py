"""Beams of a model on a mesh: the sides of elements along which they run, and what stiffness each piece has."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from itertools import chain, combinations, count

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.discretize.plan_layout import Layout
from groundslab.errors import InputError, Issue
from groundslab.fem.hanging import find_hanging
from groundslab.fem.mesh import select_along, sides_of
from groundslab.fem.parts.beams import Beams, lengths_of
from groundslab.fem.parts.membrane import held
from groundslab.fem.problem import BETA_X, BETA_Y, W
from groundslab.geometry.plan import Segment, format_place
from groundslab.model.model import Model
from groundslab.model.structure.beams import Beam
from groundslab.model.structure.spans import spans_as_segments
from groundslab.schema.wording import quote

#: Where an axis turns by more than this [rad], section forces jump, and the sections of walls turn apart.
KINK = 1e-3
#: A mesh meets a beam if it follows its line but for this share, which arcs as parabolas may take.
MET = 1e-4
#: The middle of an edge.
HALF = np.array([0.5])


def beams_on(model: Model, plan: Layout, sections: list[tuple[float, float, float]], fields: int) -> Beams:
    """Return the beams of a model on its mesh; sections are E [Pa], nu and thickness [m] of each of the plate's.

    A rib between two sections of the plate has as its flange the thinner one. What sections of walls turn by are fields
    beyond so many.
    """
    members = model.members
    if not members:
        none, zero = np.zeros((0, 3), dtype=np.int64), np.zeros(0)
        hinges, along = np.zeros((0, 2), dtype=bool), np.zeros((0, 3, 2))
        return Beams(none, none[:, 0], zero, zero, np.zeros((0, 4)), zero, hinges, hinges[:, 0], none[:, 0], along)
    every = _whole_sides(plan)
    parts = [_along(plan, every, beam, spans_as_segments(beam, model.plate, model.plates)) for beam in members]
    sides, start, length, angles = (np.concatenate(column) for column in zip(*parts, strict=True))
    number = np.repeat(np.arange(len(parts)), [len(pieces) for pieces, *_ in parts])
    beside = _sections_beside(plan, sides, np.array([t for _, _, t in sections]))
    rigidity, eccentricity = np.empty((len(sides), 4)), np.zeros(len(sides))
    released = np.zeros((len(sides), 2), dtype=bool)
    for which, section in np.unique(np.column_stack([number, beside]), axis=0).tolist():
        mask = (number == which) & (beside == section)
        rigidity[mask] = members[which].rigidities(*sections[section])
        eccentricity[mask] = members[which].eccentricity(sections[section][2])
    for which, beam in enumerate(members):
        released[np.flatnonzero(number == which)[[0, -1]], [0, 1]] = [end == "hinged" for end in beam.joined]
    wall = np.array(model.wall_of_members)[number]
    before, after = _across_joints(plan, sides, number, wall)
    met = np.arange(len(plan.mesh.nodes))
    across = np.concatenate([sides[before, 1], sides[after, 0]])
    met[across] = plan.source[across]
    smooth = _go_on(met[sides], angles)
    part, sign = _parts_of_walls(wall, met[sides], angles, smooth)
    field, along = _sections_of_walls(plan.mesh.nodes, sides, met, part, sign, fields)
    return Beams(sides, number, start, length, rigidity, eccentricity, released, smooth, field, along)


def _go_on(sides: Integers, angles: Array) -> Flags:
    """Return whether each piece (b, 3) begins where the one before ends, and without a corner, (b,)."""
    turn = _between_turns(angles[1:, 0] - angles[:-1, 1])
    return np.append(False, (np.abs(turn) <= KINK) & (sides[1:, 0] == sides[:-1, 1]))


def _between_turns(angle: Array) -> Array:
    """Return angles [rad] between half a turn to the right and half a turn to the left."""
    turned: Array = (angle + np.pi) % (2 * np.pi) - np.pi
    return turned


def _parts_of_walls(wall: Integers, sides: Integers, angles: Array, smooth: Flags) -> tuple[Integers, Array]:
    """Return the part from corner to corner that each piece of a wall belongs to, -1 of none, (b,).

    wall (b,) is its wall, -1 of none. Where two walls, or both ends of one, meet without a corner, one part goes on.
    With it 1 (b,), or -1 where a piece runs against its part.
    """
    part = np.where(wall < 0, -1, np.cumsum(~smooth | (np.diff(wall, prepend=-2) != 0)))
    sign = np.ones(len(part))
    # both ends of each part at their nodes: its piece, which end of it, and the direction out of the part
    ends = defaultdict[int, list[tuple[int, int, float]]](list)
    for number in np.unique(part[part >= 0]):
        pieces = np.flatnonzero(part == number)
        for piece, end in ((pieces[0], 0), (pieces[-1], 1)):
            ends[int(sides[piece, end])].append((piece, end, angles[piece, end] + (0.0 if end else np.pi)))
    for (piece, end, out), (other, other_end, other_out) in chain(*(combinations(met, 2) for met in ends.values())):
        straight_on = abs(_between_turns(np.array(out - other_out + np.pi))) <= KINK
        if not straight_on or part[piece] == part[other]:
            continue
        joined = part == part[other]
        # from an end to a beginning a part goes on as it runs
        against = sign[piece] * sign[other] * (1.0 if end != other_end else -1.0)
        sign[joined] *= against
        part[joined] = part[piece]
    return part, sign


def _sections_of_walls(
    nodes: Array, sides: Integers, met: Integers, part: Integers, sign: Array, fields: int
) -> tuple[Integers, Array]:
    """Return the field of theta (b,) of each piece of a wall, 0 of others, and the axis' direction at nodes (b, 3, 2).

    part (b,) is the part of a wall from corner to corner that a piece belongs to, -1 of none, and sign (b,) whether it
    runs with it; met (n,) is one node for those across joints at which members go on, elsewhere each itself. theta goes
    on along the part: another field is taken where another part has it at one of its nodes.
    """
    field = np.zeros(len(sides), dtype=np.int64)
    start, end, middle = (nodes[sides[:, k]] for k in range(3))
    spans = sides[:, 2] == sides[:, 0]
    middle[spans] = (start[spans] + end[spans]) / 2
    along = np.stack([2 * middle - 1.5 * start - 0.5 * end, 0.5 * start + 1.5 * end - 2 * middle, end - start], axis=1)
    along *= sign[:, None, None] / np.linalg.norm(along, axis=2, keepdims=True)
    taken: dict[int, Flags] = {}
    for number in np.unique(part[part >= 0]):
        pieces = np.flatnonzero(part == number)
        numbers = np.unique(sides[pieces])
        free = next(f for f in count(fields) if f not in taken or not taken[f][numbers].any())
        taken.setdefault(free, np.zeros(len(nodes), dtype=bool))[numbers] = True
        field[pieces] = free
        # one direction at a node, of both pieces there
        places, place = np.unique(met[sides[pieces]], return_inverse=True)
        mean = np.zeros((len(places), 2))
        np.add.at(mean, place.reshape(-1, 3), along[pieces])
        along[pieces] = (mean / np.linalg.norm(mean, axis=1, keepdims=True))[place.reshape(-1, 3)]
    return field, along


@dataclass(frozen=True, slots=True)
class MembersAcross:
    """Where beams and walls go on across joints: k pairs of nodes of both plates, and the fields that these share."""

    pairs: Integers  # (k, 2)
    shared: Flags  # (k, F)


def members_across(model: Model, plan: Layout, beams: Beams, in_plane: tuple[int, ...], fields: int) -> MembersAcross:
    """Return where the members of a model go on across joints; fields is F, in_plane the fields of u and v."""
    wall = np.array([*model.wall_of_members], dtype=np.int64)[beams.number]
    before, after = _across_joints(plan, beams.sides, beams.number, wall)
    shared = np.zeros((len(before), fields), dtype=bool)
    shared[:, [W, BETA_X, BETA_Y]] = True
    theta = np.where(beams.theta[before] == beams.theta[after], beams.theta[before], 0)
    goes_on = np.flatnonzero(theta)
    shared[goes_on, theta[goes_on]] = True
    both = (beams.rigidity[before, 3] > 0) & (beams.rigidity[after, 3] > 0)
    shared[np.ix_(both, in_plane)] = True
    return MembersAcross(np.column_stack([beams.sides[before, 1], beams.sides[after, 0]]), shared)


def _across_joints(plan: Layout, sides: Integers, number: Integers, wall: Integers) -> tuple[Integers, Integers]:
    """Return the pieces (k,) before joints that members cross, and those after, of one beam or wall each."""
    line = np.where(wall < 0, number, len(number) + wall)
    after = np.arange(len(sides))
    before = after - 1
    starts = np.flatnonzero(np.diff(line, prepend=-1))
    before[starts] = np.append(starts[1:], len(sides))[: len(starts)] - 1  # of a closed one its end, of others too
    end, start = sides[before, 1], sides[after, 0]
    joints = np.flatnonzero((end != start) & (plan.source[end] == plan.source[start]))
    return before[joints], after[joints]


def with_turning(present: Flags, beams: Beams) -> Flags:
    """Return which unknowns exist (n, F), with theta of walls."""
    extended = np.pad(present, ((0, 0), (0, max(0, int(beams.theta.max(initial=0)) + 1 - present.shape[1]))))
    deep = beams.deep
    extended[beams.sides[deep], beams.theta[deep, None]] = True
    return extended


def with_in_plane(model: Model, present: Flags, plan: Layout, beams: Beams) -> tuple[Flags, tuple[int, ...]]:
    """Return which unknowns exist (n, F) with u and v of plates whose beams are eccentric, and the fields of these."""
    eccentric = beams.rigidity[:, 3] > 0
    if not eccentric.any():
        return present, ()
    n, elements = len(plan.mesh.nodes), plan.mesh.elements[plan.plate_elements]
    along, free = np.zeros(n, dtype=bool), np.ones(n, dtype=bool)
    along[beams.sides[eccentric, 2]] = True
    free[find_hanging(plan.mesh.elements)[:, 0]] = False
    moving = np.zeros((n, 2), dtype=bool)
    parts = [np.unique(elements[plan.plate == number]) for number in np.unique(plan.plate[along[elements].any(axis=1)])]
    parts = [nodes[free[nodes]] for nodes in parts]
    moving[np.concatenate(parts)] = True
    fields = present.shape[1]
    in_plane = (fields, fields + 1)
    across = members_across(model, plan, beams, in_plane, fields + 2)
    moving &= ~held(plan.mesh.nodes, parts, across.pairs[across.shared[:, fields]])
    return np.hstack([present, moving]), in_plane


def _whole_sides(plan: Layout) -> Integers:
    """Return the sides of the plate's elements, of two halves beside a longer side the longer one."""
    sides = sides_of(plan.mesh, plan.mesh.elements[plan.plate_elements])
    return sides[~np.isin(sides[:, 2], find_hanging(plan.mesh.elements)[:, 0])]


def _along(
    plan: Layout, every: Integers, beam: Beam, spans: tuple[Segment, ...]
) -> tuple[Integers, Array, Array, Array]:
    """Return which of the sides lie along a beam, from its start to its end (b, 3), and of each start and length [m].

    Where it spans an opening there is one piece. Both are (b,), along the beam; and the angle of the beam's direction
    [rad] where each begins and ends, (b, 2).
    """
    mesh = plan.mesh
    pieces, starts, lengths, angles, before, left_over = [], [], [], [], 0.0, list(spans)
    for edge in beam.edges:
        sides = select_along(mesh, every, [edge])
        part = _parts(edge, mesh.nodes[sides[:, 2]])
        over = [span for span in left_over if edge.straight and edge.holds(span.at(HALF)[0], MET * edge.length)]
        left_over = [span for span in left_over if span not in over]
        if over:
            sides = np.vstack([sides, [_ends_of_span(plan, span) for span in over]])
            part = np.append(part, _parts(edge, np.concatenate([span.at(HALF) for span in over])))
        order = np.argsort(part)
        sides, left = sides[order], edge.left(part[order])
        way = mesh.nodes[sides[:, 1]] - mesh.nodes[sides[:, 0]]
        backwards = (way[:, 0] * left[:, 1] < way[:, 1] * left[:, 0]) & (sides[:, 2] != sides[:, 0])
        sides[backwards] = sides[backwards][:, [1, 0, 2]]
        xy = mesh.nodes[sides]
        alone = sides[:, 2] == sides[:, 0]
        length = np.where(alone, np.linalg.norm(xy[:, 1] - xy[:, 0], axis=1), lengths_of(xy))
        pieces.append(sides)
        starts.append(before + np.cumsum(length) - length)
        lengths.append(length)
        # between pieces of one edge there is no corner, whatever the mesh makes of an arc
        middles = np.sort(part)
        cuts = np.concatenate([[0.0], (middles[1:] + middles[:-1]) / 2, [1.0]])
        angle = np.array([edge.direction(float(cut)) for cut in cuts])
        angles.append(np.column_stack([angle[:-1], angle[1:]]))
        before += float(length.sum())
    if abs(before - beam.length) > MET * beam.length:
        said = f"sides of elements along {before:g} m of a line of {beam.length:g} m"
        raise InputError([Issue(f"beam {quote(beam.name)}", said, "a mesh that meets every beam")])
    return np.concatenate(pieces), np.concatenate(starts), np.concatenate(lengths), np.concatenate(angles)


def _ends_of_span(plan: Layout, span: Segment) -> list[int]:
    """Return the nodes at which a span starts and ends, as those of a piece."""
    under, ends = plan.plate_nodes, np.array([span.start, span.end])
    distance = np.linalg.norm(plan.mesh.nodes[under] - ends[:, None], axis=2)
    start, end = under[np.argmin(distance, axis=1)].tolist()
    if distance.min(axis=1).max() > MET * span.length:
        unmet_ends = f"no node at {format_place(span.start, plan.origin)} m or {format_place(span.end, plan.origin)} m"
        raise InputError([Issue("beams", unmet_ends, "a mesh that meets the ends of every span")])
    return [start, end, start]


def _parts(edge: Segment, places: Array) -> Array:
    """Return after which part of an edge each of some places (p, 2) on it comes, (p,)."""
    return np.array([edge.part((float(x), float(y))) for x, y in places])


def _sections_beside(plan: Layout, sides: Integers, thickness: Array) -> Integers:
    """Return the section of the plate beside each of some sides (b, 3), of two the thinner one, (b,)."""
    elements = plan.mesh.elements[plan.plate_elements]
    by_thickness = np.argsort(-thickness, kind="stable")
    of_node = np.full(len(plan.mesh.nodes), -1)
    for section in by_thickness:
        of_node[elements[plan.section == section]] = section
    return of_node[sides[:, 2]]
