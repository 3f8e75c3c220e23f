"""From described contact and supports to what bears on single unknowns: initial gaps, limits, points, lines."""

from __future__ import annotations

import itertools
import math

import numpy as np

from groundslab import contact
from groundslab.between import interpolated
from groundslab.contact import Bearings
from groundslab.errors import Fault, InputError
from groundslab.layout import Layout
from groundslab.mesh import SAME_PLACE, sides_along
from groundslab.model import LineSupport, Model, PointSupport, SettlementLoad, Void
from groundslab.problem import BETA_X, BETA_Y, TOP, Bearing, W, nodal_area
from groundslab.shape import Array, Flags, Integers

#: Arcs of voids are replaced by chords at most this far off, relative to the plate.
ARC_CHORD = 1e-6
#: Simpson's rule for the ends and the middle of a side: the share of its length that each node carries.
SIMPSON = np.array([1.0, 1.0, 4.0]) / 6


def initial_gap(model: Model, plan: Layout, finest: bool) -> tuple[Array, Flags]:
    """Return the initial gap at every node (n,) [m], zero beyond the plate, and at which nodes a cavity lies (n,)."""
    gap, cavity = np.zeros(len(plan.mesh.nodes)), np.zeros(len(plan.mesh.nodes), dtype=bool)
    under = plan.plate_nodes
    gap[under] = model.contact.gap
    extra = np.zeros(len(under))
    faults: list[Fault] = []
    for number, void in enumerate(model.contact.voids, start=1):
        inside = _inside(void, model, plan.mesh.nodes[under])
        if finest and not inside.any() and not _mirrored_away(void, plan.symmetry):
            mend = "make the elements smaller than the void"
            faults.append(Fault(f"contact.voids[{number}]", "a void between the nodes", "one that holds a node", mend))
        if void.depth is None:
            cavity[under[inside]] = True
        else:
            extra = np.where(inside, np.maximum(extra, void.depth), extra)
    if faults:
        raise InputError(faults)
    gap[under] += extra
    if model.contact.gaps:
        known = np.array([(point.x, point.y, point.gap) for point in model.contact.gaps])
        gap[under] += interpolated(known[:, :2], known[:, 2:], plan.mesh.nodes[under])[:, 0]
    return gap, cavity


def _inside(void: Void, model: Model, places: Array) -> Flags:
    """Return which places (p, 2) lie in a void or on its edge."""
    near = SAME_PLACE * max(model.plate.sides)
    if void.x is not None and void.y is not None:
        x, y = places.T
        inside: Flags = (x >= void.x[0] - near) & (x <= void.x[1] + near)
        inside &= (y >= void.y[0] - near) & (y <= void.y[1] + near)
        return inside
    from shapely import intersects_xy

    chord = ARC_CHORD * max(model.plate.sides)
    drawn = void.drawn(chord).buffer(2 * chord)
    return np.asarray(intersects_xy(drawn, places[:, 0], places[:, 1]), dtype=bool)


def _mirrored_away(void: Void, symmetry: tuple[bool, bool]) -> bool:
    """Return whether a void lies on the side of a mirror that is not meshed; its image is there."""
    return any(
        mirrored and extent is not None and extent[1] < 0
        for mirrored, extent in zip(symmetry, (void.x, void.y), strict=True)
    )


def ground_bearing(model: Model, plan: Layout, unknown: Integers, cavity: Flags) -> Bearing:
    """Return the ground under each plate node as a bearing on its gap, yielding at the limit pressure; none if glued.

    The largest force of a node is the limit pressure times its share of the area, and none over a cavity. Along edges
    of ground that carries shear it holds for the balance of the whole only: see problem.bearings.
    """
    under = plan.plate_nodes if model.contact.tensionless else np.zeros(0, np.int64)
    law = contact.gaps(unknown[under, TOP])
    capacity = law.capacity
    if model.contact.limit_pressure is not None:
        capacity = model.contact.limit_pressure * nodal_area(plan.mesh, plan.plate_elements)[under]
    capacity = np.where(cavity[under], 0.0, capacity)
    law = Bearings(law.at, law.sign, law.level, law.stiffness, capacity, law.both_ways)
    return Bearing(law, under, np.full(len(under), TOP), np.full(len(under), -1), np.zeros(len(under)))


def support_bearing(model: Model, plan: Layout, unknown: Integers) -> Bearing:
    """Return the supports as bearings on the settlement of their nodes, and on the rotation where that is elastic.

    A line's stiffness and limit are shared among its nodes by Simpson's rule. Of two rigid supports at one node the
    first one counts; they must be alike. Nodes that an edge holds already bear nothing else.
    """
    parts: list[Bearing] = []
    for number, support in enumerate(model.supports):
        if isinstance(support, PointSupport):
            nodes, share = np.array([node_at(plan, support.x, support.y)]), np.ones(1)
            if support.rotational_stiffness is not None:
                parts += [_elastic_turn(number, nodes, unknown, field, support.rotational_stiffness)
                          for field in (BETA_X, BETA_Y)]  # fmt: skip
        else:
            nodes, share = nodes_along(plan, support)
        there = unknown[nodes, W] >= 0
        nodes, share = nodes[there], share[there]
        one, pulls = np.ones(len(nodes)), support.acts == "in tension"
        law = Bearings(
            at=unknown[nodes, W],
            sign=one if pulls else -one,
            level=-support.gap * one if pulls else support.gap * one,
            stiffness=np.full(len(nodes), np.inf) if support.stiffness is None else support.stiffness * share,
            capacity=np.full(len(nodes), np.inf) if support.limit is None else support.limit * share,
            both_ways=np.full(len(nodes), support.acts == "both ways"),
        )
        length = np.zeros(len(nodes)) if isinstance(support, PointSupport) else share
        parts.append(Bearing(law, nodes, np.full(len(nodes), W), np.full(len(nodes), number), length))
    return _without_doubles(model, joined(*parts)) if parts else joined()


def joined(*parts: Bearing) -> Bearing:
    """Return several lists of bearings as one."""
    none = np.zeros(0, dtype=np.int64)
    nodes, fields, supports = ([getattr(part, name) for part in parts] for name in ("node", "field", "support"))
    law = contact.joined(contact.gaps(none), *(part.law for part in parts))
    length = np.concatenate([np.zeros(0), *(part.length for part in parts)])
    node, field, support = (np.concatenate([none, *each]) for each in (nodes, fields, supports))
    return Bearing(law, node, field, support, length)


def _elastic_turn(number: int, nodes: Integers, unknown: Integers, field: int, stiffness: float) -> Bearing:
    """Return the elastic restraint of a rotation at a support's node."""
    nodes = nodes[unknown[nodes, field] >= 0]
    one, endless = np.ones(len(nodes)), np.full(len(nodes), np.inf)
    law = Bearings(unknown[nodes, field], -one, 0 * one, stiffness * one, endless, np.ones(len(nodes), dtype=bool))
    return Bearing(law, nodes, np.full(len(nodes), field), np.full(len(nodes), number), 0 * one)


def _without_doubles(model: Model, b: Bearing) -> Bearing:
    """Return the bearings without the second of two rigid ones at a node; raise InputError if these differ."""
    rigid = np.isinf(b.law.stiffness) & (b.field == W)
    keep, first = np.ones(len(b.law), dtype=bool), dict[int, int]()
    faults: dict[str, Fault] = {}
    settled = [{(load.case, load.w) for load in model.loads if isinstance(load, SettlementLoad)
                and load.support == support.name} for support in model.supports]  # fmt: skip
    for i in np.flatnonzero(rigid):
        other = first.setdefault(int(b.law.at[i]), int(i))
        if other == i:
            continue
        keep[i] = False
        mine, theirs = (model.supports[b.support[j]] for j in (i, other))
        alike = (mine.acts, mine.gap, mine.limit) == (theirs.acts, theirs.gap, theirs.limit)
        if not alike or settled[b.support[i]] != settled[b.support[other]]:
            where = f"supports[{b.support[i] + 1}]"
            got = f"a rigid support that meets supports[{b.support[other] + 1}], which acts or settles otherwise"
            faults[where] = Fault(
                where, got, "rigid supports that are alike where they meet", "make one of them elastic"
            )
    if faults:
        raise InputError(list(faults.values()))
    names = ("at", "sign", "level", "stiffness", "capacity", "both_ways")
    law = Bearings(*(getattr(b.law, name)[keep] for name in names))
    return Bearing(law, b.node[keep], b.field[keep], b.support[keep], b.length[keep])


def fixed_nodes(model: Model, plan: Layout) -> Integers:
    """Return the nodes at which supports keep the plate from turning."""
    found = [np.zeros(0, dtype=np.int64)]
    for support in model.supports:
        if support.rotation == "fixed":
            if isinstance(support, PointSupport):
                found.append(np.array([node_at(plan, support.x, support.y)]))
            else:
                found.append(nodes_along(plan, support)[0])
    return np.unique(np.concatenate(found))


def node_at(plan: Layout, x: float, y: float) -> int:
    """Return the plate's node at a place that its mesh meets."""
    under = plan.plate_nodes
    distance = np.linalg.norm(plan.mesh.nodes[under] - [x, y], axis=1)
    nearest = int(np.argmin(distance))
    if distance[nearest] > 10 * SAME_PLACE * np.ptp(plan.mesh.nodes, axis=0).max():
        raise InputError([Fault("supports", f"no node at ({x:g}, {y:g}) m", "a mesh that meets every support")])
    return int(under[nearest])


def nodes_along(plan: Layout, support: LineSupport) -> tuple[Integers, Array]:
    """Return the nodes along a line support, and the length that belongs to each [m]."""
    sides = sides_along(plan.mesh, plan.mesh.elements[plan.plate_elements], list(itertools.pairwise(support.points)))
    length = np.linalg.norm(plan.mesh.nodes[sides[:, 1]] - plan.mesh.nodes[sides[:, 0]], axis=1)
    lengths = np.zeros(len(plan.mesh.nodes))
    np.add.at(lengths, sides, length[:, None] * SIMPSON)
    wanted = sum(math.dist(a, b) for a, b in itertools.pairwise(support.points))
    if abs(length.sum() - wanted) > 1e-6 * wanted:
        got = f"sides of elements along {length.sum():g} m of a line of {wanted:g} m"
        raise InputError([Fault("supports", got, "a mesh that meets every support")])
    nodes = np.flatnonzero(lengths)
    return nodes, lengths[nodes]
