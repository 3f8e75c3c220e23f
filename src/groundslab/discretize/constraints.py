"""Bearings and links of a problem from the described contact, supports and joints: gaps, limits, points, lines."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from itertools import count

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.discretize.beams import MembersAcross
from groundslab.discretize.plan_layout import Layout
from groundslab.discretize.voids import bottoms
from groundslab.errors import InputError, Issue
from groundslab.fem import bearings
from groundslab.fem.bearings import MEMBER, SURFACE, Bearings, Links, make_bearings
from groundslab.fem.foundation import Column
from groundslab.fem.mesh import sides_along, sides_on_boundary
from groundslab.fem.parts.contact import Bearing, Depths
from groundslab.fem.problem import BETA_X, BETA_Y, TOP, W
from groundslab.fem.shape_functions import unique_integers
from groundslab.fem.vlasov import Soil
from groundslab.geometry.plan import SAME_PLACE, format_place
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads.load_types import SettlementLoad
from groundslab.model.model import Model
from groundslab.model.plates.joints import play_of, stiffness_of
from groundslab.model.plates.other_plates import shared_line
from groundslab.model.supports import LineSupport, Pile, PointSupport

#: Simpson's rule for the ends and the middle of a side: the share of its length that each node carries.
SIMPSON = np.array([1.0, 1.0, 4.0]) / 6
#: A mesh meets a joint if it follows its line but for this share, which arcs as chords may take.
MET = 0.01
#: What a bearing has besides its law.
LOCATION = ("node", "field", "support", "length", "depth")


def ground_bearing(
    model: Model, plan: Layout, unknown: Integers, depths: Depths, ground: Soil | Column, gap: Array
) -> Bearing:
    """Return the ground under each plate node as a bearing on its gap, yielding at the limit pressure.

    There is none if the plate is glued to it, or bears on cells.

    The limit force is the limit pressure times the area that bears, zero over a cavity. Along edges of ground that
    carries shear it limits the overall balance only: see system.current_bearings. Where ground without shear lies
    deeper beside a node than under it, the deeper part is a spring on the plate's settlement, at its depth below the
    gap (n,) [m].
    """
    by_nodes = model.contact.tensionless and not isinstance(model.ground, ContinuousGround)
    under = plan.plate_nodes if by_nodes else np.zeros(0, np.int64)
    under = under[unknown[under, TOP] >= 0]  # hanging nodes have none
    limit = np.inf if model.contact.limit_pressure is None else model.contact.limit_pressure
    depth, area = depths.shallowest[under], depths.at_shallowest(depths.area, under)
    bottom = np.where(np.isinf(depths.depth), 0.0, depths.depth)[depth]
    limit_force = np.where(np.isinf(depths.depth[depth]), 0.0, limit * area)
    law = make_bearings(unknown[under, TOP], 1.0, -(gap[under] + bottom), limit_force=limit_force)
    gaps = _place(law, under, TOP, depth=depth)
    if not (depths.stepped and len(under)):
        return gaps
    assert isinstance(ground, Column)
    node, depth, stiffness, area = bottoms(plan, depths, ground)
    mask = unknown[node, W] >= 0
    node, depth, stiffness, area = (values[mask] for values in (node, depth, stiffness, area))
    law = make_bearings(unknown[node, W], -1.0, gap[node] + depths.depth[depth], stiffness, limit * area)
    return concatenate(gaps, _place(law, node, W, depth=depth))


def support_bearing(model: Model, plan: Layout, unknown: Integers) -> Bearing:
    """Return the supports as bearings on the settlement of their nodes, and on the rotation where that is elastic.

    A line's stiffness and limit are shared among its nodes by Simpson's rule. Of two rigid supports at one node the
    first one counts; they must be alike. Nodes that an edge holds already bear nothing else.
    """
    parts: list[Bearing] = []
    for number, support in enumerate(model.supports):
        if isinstance(support, Pile):
            node = np.array([node_at(plan, support.x, support.y)])
            # its limits, and what it settles, are those of the ground with its piles
            law = make_bearings(unknown[node, W], -1.0, 0.0, bilateral=True)
            parts.append(_place(law, node, W, number))
            continue
        if isinstance(support, PointSupport):
            nodes, share = np.array([node_at(plan, support.x, support.y)]), np.ones(1)
            if support.rotational_stiffness is not None:
                parts += [_elastic_turn(number, nodes, unknown, field, support.rotational_stiffness)
                          for field in (BETA_X, BETA_Y)]  # fmt: skip
        else:
            nodes, share = nodes_along(plan, support)
        mask = unknown[nodes, W] >= 0
        nodes, share = nodes[mask], share[mask]
        sign = 1.0 if support.acts == "in tension" else -1.0
        law = make_bearings(
            unknown[nodes, W],
            sign,
            -sign * support.gap,
            np.inf if support.stiffness is None else support.stiffness * share,
            np.inf if support.limit is None else support.limit * share,
            support.acts == "both ways",
        )
        parts.append(_place(law, nodes, W, number, 0.0 if isinstance(support, PointSupport) else share))
    return _without_doubles(model, concatenate(*parts)) if parts else concatenate()


@dataclass(frozen=True, slots=True)
class JointLine:
    """A joint on a mesh: k pairs of nodes of both plates, the length of each [m], and the field of its slip.

    A joint with play has a slip of its own at each pair, as a field of the second node that no other joint there has.
    """

    pairs: Integers  # (k, 2)
    length: Array  # (k,)
    slip: int  # 0 without play


def joint_lines(model: Model, plan: Layout, surfaces: int) -> list[JointLine]:
    """Return the joints of a model on its mesh; fields of slips follow those of the ground's surfaces."""
    names, lines = [plate.name for plate in model.every_plate], list[JointLine]()
    for joint in model.joints:
        sides = [names.index(name) for name in joint.between]
        pairs, length = _along_joint(plan, *sides)
        wanted = shared_line(*(model.every_plate[side] for side in sides)).length
        if abs(length.sum() - wanted) > MET * wanted:
            said = f"sides of elements along {length.sum():g} m of a line of {wanted:g} m"
            raise InputError([Issue("joints", said, "a mesh that meets every joint")])
        taken = {line.slip for line in lines if np.isin(line.pairs, pairs).any()}
        slip = next(field for field in count(TOP + surfaces) if field not in taken) if play_of(joint) else 0
        lines.append(JointLine(pairs, length, slip))
    return lines


def make_links(
    model: Model, plan: Layout, lines: list[JointLine], members: MembersAcross, surfaces: int, shear: bool
) -> Links:
    """Return the links across joints: shear by the difference of settlement, and the ground's surfaces, which go on.

    Where the ground carries no shear its surface may step, and does. Members that go on hold what they share.
    """
    fields = members.shared.shape[1]
    basis = np.eye(fields, dtype=bool)
    none = np.zeros((0, 2), dtype=np.int64), np.zeros((0, fields), dtype=bool), np.zeros(0)
    parts = [(*none, np.zeros(0, dtype=np.int64), np.zeros(0))]

    def add(pairs: Integers, added: Flags, k: Array, joint: int, length: Array) -> None:
        parts.append((pairs, np.tile(added, (len(pairs), 1)), k, np.full(len(pairs), joint), length))

    for number, (joint, line) in enumerate(zip(model.joints, lines, strict=True)):
        k = stiffness_of(joint) * line.length
        add(line.pairs, basis[W] | basis[line.slip] if line.slip else basis[W], k, number, line.length)
    again = np.flatnonzero(plan.source != np.arange(len(plan.source)))
    if shear and len(again):
        pairs = np.column_stack([plan.source[again], again])
        for added in (basis[W] | basis[TOP], *basis[TOP + 1 : TOP + surfaces]):
            add(pairs, added, np.full(len(pairs), np.inf), SURFACE, np.zeros(len(pairs)))
    hinged = _hinges(model, lines)
    for field in np.flatnonzero(members.shared.any(axis=0)):
        pairs = members.pairs[members.shared[:, field]]
        if field == W:
            pairs = np.array([pair for pair in pairs.tolist() if sorted(pair) not in hinged], np.int64).reshape(-1, 2)
        add(pairs, basis[field], np.full(len(pairs), np.inf), MEMBER, np.zeros(len(pairs)))
    return Links(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def _hinges(model: Model, lines: list[JointLine]) -> list[list[int]]:
    """Return the pairs of nodes that hinges hold together, each the lower one first."""
    hinges = [line.pairs for joint, line in zip(model.joints, lines, strict=True) if joint.kind == "hinge"]
    pairs: list[list[int]] = np.sort(np.concatenate([np.zeros((0, 2), dtype=np.int64), *hinges]), axis=1).tolist()
    return pairs


def joined_nodes(
    model: Model, lines: list[JointLine], members: MembersAcross, present: Flags
) -> tuple[Integers, Flags]:
    """Return which group each node is of in each field (n, F), and which unknowns are left (n, F).

    The nodes of one place that hinges or members hold together in a field are a group, else each node is its own. Held
    at zero at one of them, it is at all of them.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    n = len(present)
    group, left = np.tile(np.arange(n)[:, None], present.shape[1]), present.copy()
    hinges = np.reshape(_hinges(model, lines), (-1, 2)).astype(np.int64)
    for field in range(present.shape[1]):
        pairs = members.pairs[members.shared[:, field]]
        if field == W:
            pairs = np.concatenate([hinges, pairs])
        if not len(pairs):
            continue
        together = coo_array((np.ones(len(pairs)), pairs.T), shape=(n, n))
        group[:, field] = connected_components(together, directed=False)[1]
        held = np.unique(pairs)
        zero = group[held[~present[held, field]], field]
        left[held, field] = ~np.isin(group[held, field], zero)
    return group, left


def slip_bearing(model: Model, lines: list[JointLine], unknown: Integers) -> Bearing:
    """Return the play of joints as two rigid bearings on each slip, one for either way."""
    parts: list[Bearing] = []
    for joint, line in zip(model.joints, lines, strict=True):
        if line.slip:
            nodes, gap = line.pairs[:, 1], play_of(joint)
            for sign in (1.0, -1.0):
                law = make_bearings(unknown[nodes, line.slip], sign, -sign * gap)
                parts.append(_place(law, nodes, line.slip, len(model.supports)))
    return concatenate(*parts)


def _along_joint(plan: Layout, plate: int, other: int) -> tuple[Integers, Array]:
    """Return the pairs of nodes (k, 2) of two plates along the line that they share, and the length of each [m]."""
    elements, n = plan.mesh.elements[plan.plate_elements], len(plan.mesh.nodes)
    across = np.full(n, -1)
    beside = np.unique(elements[plan.plate == other])
    across[plan.source[beside]] = beside
    sides = sides_on_boundary(elements[plan.plate == plate])
    sides = sides[(across[plan.source[sides]] >= 0).all(axis=1)]
    a, b, middle = (plan.mesh.nodes[sides[:, k]] for k in range(3))
    length = np.linalg.norm(middle - a, axis=1) + np.linalg.norm(b - middle, axis=1)
    lengths = np.zeros(n)
    np.add.at(lengths, sides, length[:, None] * SIMPSON)
    nodes = np.flatnonzero(lengths)
    return np.column_stack([nodes, across[plan.source[nodes]]]), lengths[nodes]


def concatenate(*parts: Bearing) -> Bearing:
    """Return several lists of bearings as one."""
    none = np.zeros(0, dtype=np.int64)
    parts = (_place(make_bearings(none, 1.0, 0.0), none, W), *parts)
    return Bearing(
        bearings.concatenate(*(part.law for part in parts)),
        *(np.concatenate([getattr(part, name) for part in parts]) for name in LOCATION),
    )


def _place(
    law: Bearings, node: Integers, field: int, support: int = -1, length: Array | float = 0.0, depth: Integers | int = 0
) -> Bearing:
    """Return bearings on a field of nodes (c,): of the ground, or of the support with a number."""
    n = len(node)
    return Bearing(law, node, np.full(n, field), np.full(n, support), np.full(n, length), np.full(n, depth))


def _elastic_turn(number: int, nodes: Integers, unknown: Integers, field: int, stiffness: float) -> Bearing:
    """Return the elastic restraint of a rotation at a support's node."""
    nodes = nodes[unknown[nodes, field] >= 0]
    return _place(make_bearings(unknown[nodes, field], -1.0, 0.0, stiffness, bilateral=True), nodes, field, number)


def _without_doubles(model: Model, b: Bearing) -> Bearing:
    """Return the bearings without the second of two rigid ones at a node; raise InputError if these differ."""
    rigid = np.isinf(b.law.stiffness) & (b.field == W)
    keep, first = np.ones(len(b.law), dtype=bool), dict[int, int]()
    issues: dict[str, Issue] = {}
    settled = [{(load.case, load.w) for load in model.loads if isinstance(load, SettlementLoad)
                and load.support == support.name} for support in model.supports]  # fmt: skip
    for i in np.flatnonzero(rigid):
        other = first.setdefault(int(b.law.unknown[i]), int(i))
        if other == i:
            continue
        keep[i] = False
        mine, theirs = (model.supports[b.support[j]] for j in (i, other))
        alike = (mine.acts, mine.gap, mine.limit) == (theirs.acts, theirs.gap, theirs.limit)
        if not alike or settled[b.support[i]] != settled[b.support[other]]:
            where = f"supports[{b.support[i] + 1}]"
            meeting = f"a rigid support that meets supports[{b.support[other] + 1}], which acts or settles otherwise"
            issues[where] = Issue(
                where, meeting, "rigid supports that are alike where they meet", "make one of them elastic"
            )
    if issues:
        raise InputError(list(issues.values()))
    return b.select(keep)


def fixed_nodes(model: Model, plan: Layout) -> Integers:
    """Return the nodes at which supports keep the plate from turning."""
    nodes = [np.zeros(0, dtype=np.int64)]
    for support in model.supports:
        if support.rotation == "fixed":
            if not isinstance(support, LineSupport):
                nodes.append(np.array([node_at(plan, support.x, support.y)]))
            else:
                nodes.append(nodes_along(plan, support)[0])
    return unique_integers(np.concatenate(nodes))[0]


def node_at(plan: Layout, x: float, y: float) -> int:
    """Return the plate's node at a place that its mesh meets."""
    under = plan.plate_nodes
    distance = np.linalg.norm(plan.mesh.nodes[under] - [x, y], axis=1)
    nearest = int(np.argmin(distance))
    if distance[nearest] > 10 * SAME_PLACE * np.ptp(plan.mesh.nodes, axis=0).max():
        unmet_place = f"no node at {format_place((x, y), plan.origin)} m"
        raise InputError([Issue("supports", unmet_place, "a mesh that meets every support")])
    return int(under[nearest])


def nodes_along(plan: Layout, support: LineSupport) -> tuple[Integers, Array]:
    """Return the nodes along a line support, and the length that belongs to each [m]."""
    sides = sides_along(plan.mesh, plan.mesh.elements[plan.plate_elements], support.edges)
    length = np.linalg.norm(plan.mesh.nodes[sides[:, 1]] - plan.mesh.nodes[sides[:, 0]], axis=1)
    lengths = np.zeros(len(plan.mesh.nodes))
    np.add.at(lengths, sides, length[:, None] * SIMPSON)
    wanted = sum(math.dist(a, b) for a, b in itertools.pairwise(support.points))
    if abs(length.sum() - wanted) > 1e-6 * wanted:
        covered = f"sides of elements along {length.sum():g} m of a line of {wanted:g} m"
        raise InputError([Issue("supports", covered, "a mesh that meets every support")])
    nodes = np.flatnonzero(lengths)
    return nodes, lengths[nodes]
