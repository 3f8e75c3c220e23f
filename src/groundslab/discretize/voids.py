"""How deep the ground lies below the plate: voids by the share of each element that they take; gaps by node."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.discretize.interpolation import interpolate_smoothly
from groundslab.discretize.plan_layout import Layout
from groundslab.errors import InputError, Issue
from groundslab.fem.assembly import scatter
from groundslab.fem.foundation import Column
from groundslab.fem.hanging import collect
from groundslab.fem.load_vectors import integrate_over_elements
from groundslab.fem.parts.contact import Depths, largest_share
from groundslab.fem.problem import MIDSIDES
from groundslab.fem.vlasov import Soil
from groundslab.geometry.area_shares import shares
from groundslab.model.ground import ContinuousGround
from groundslab.model.model import Model

#: A void that takes less than this share of an element takes none of it, and one that leaves less takes it all.
LEAST_SHARE = 0.01


@dataclass(frozen=True, slots=True)
class VoidShares:
    """What voids take of the elements of a plate."""

    drawn: Array  # (mp, v): share of each element in each void, where a deeper one does not lie over it
    depth: Array  # (d,) [m], ascending: 0 first, infinite for cavities
    of: Integers  # (v,): which depth each void has
    share: Array  # (mp, d): share of each element that counts as lying at each depth


def share_voids(model: Model, xy: Array, followed_voids: Collection[int], steps: bool) -> VoidShares:
    """Return what voids take of the elements (mp, 9, 2) of a plate, their share or, unless ground steps, all or none.

    Ground without shear may step along the border of a void, so that an element can lie in a void in part. The surface
    of ground with shear is continuous, and an element lies wholly in what takes the largest share of it.
    """
    depths = np.array([np.inf if void.depth is None else void.depth for void in model.contact.voids])
    order = np.argsort(depths, kind="stable")  # where voids overlap the deepest counts
    rings = [model.void_rings[k] for k in order]
    depth, of = np.unique([0.0, *depths], return_inverse=True)
    followed = [position for position, k in enumerate(order) if k in followed_voids]
    by_ring = shares(xy, rings, followed, max(model.sides))
    drawn = np.zeros((len(xy), len(depths)))
    drawn[:, order] = by_ring[:, 1:]
    parts = np.column_stack([by_ring[:, 0], drawn])
    share = np.stack([parts[:, of == k].sum(axis=1) for k in range(len(depth))], axis=1)
    if steps:
        share[share < LEAST_SHARE] = 0.0
        share /= share.sum(axis=1, keepdims=True)
    else:
        share = np.eye(len(depth))[largest_share(share)]
    return VoidShares(drawn, depth, of[1:], share)


def find_depths(model: Model, plan: Layout, ground: Soil | Column, finest: bool) -> Depths:
    """Return how deep the ground lies under each plate element and node.

    Of ground that bears by cells it is level. Raises InputError for a void that is lost on the finest mesh.
    """
    if isinstance(model.ground, ContinuousGround):
        return _at_nodes(plan, np.zeros(1), np.ones((len(plan.plate_elements), 1)), False)
    steps = isinstance(ground, Column) and ground.surfaces == 1 and not ground.A1.any()
    voids = share_voids(model, plan.mesh.xy[plan.plate_elements], plan.mesh_plan.followed_voids, steps)
    mask = voids.drawn > 0
    lost = mask.any(axis=0) & ~(mask & (voids.share[:, voids.of] > 0)).any(axis=0)
    if finest and lost.any():
        hint = "make the elements smaller than the void"
        raise InputError(
            [
                Issue(f"contact.voids[{k + 1}]", "a void between the nodes", "one that takes an element", hint)
                for k in np.flatnonzero(lost)
            ]
        )
    return _at_nodes(plan, voids.depth, voids.share, steps)


def _at_nodes(plan: Layout, depth: Array, share: Array, steps: bool) -> Depths:
    """Return depths from the share (mp, d) of each plate element that each depth (d,) takes."""
    mesh, elements = plan.mesh, plan.mesh.elements[plan.plate_elements]
    area = integrate_over_elements(mesh, plan.plate_elements)
    first = np.zeros(len(mesh.nodes), dtype=np.int64)
    for k in range(len(depth) - 1, -1, -1):
        first[elements[share[:, k] > 0]] = k
    by_node = np.stack([scatter(elements, share[:, [k]] * area, len(mesh.nodes)) for k in range(len(depth))], axis=1)
    by_node = collect(mesh.elements, by_node)
    rows, of = np.array([[1.0] + 9 * [0.0]]), np.zeros(len(mesh.elements), dtype=np.int64)
    if steps and len(depth) > 1:
        by_element = np.zeros((len(elements), 10))
        same = (share == 1.0) & (first[elements][..., None] == np.arange(len(depth))).all(axis=1)
        by_element[:, 0] = np.where(same.any(axis=1), 1.0, share[:, 0])
        by_element[:, 1:] = np.where(
            (first[elements] > 0) & ~same.any(axis=1)[:, None], np.take_along_axis(share, first[elements], axis=1), 0.0
        )
        rows, number = np.unique(np.vstack([rows, by_element]), axis=0, return_inverse=True)
        of = np.full(len(mesh.elements), number.ravel()[0])
        of[plan.plate_elements] = number.ravel()[1:]
    return Depths(depth, share, first, by_node, rows, of, steps)


def initial_gap(model: Model, plan: Layout) -> Array:
    """Return the initial gap at every node (n,) [m], without the depth of voids; zero beyond the plate."""
    gap, under = np.zeros(len(plan.mesh.nodes)), plan.plate_nodes
    gap[under] = model.contact.gap
    if model.contact.gaps:
        points = np.array([(point.x, point.y, point.gap) for point in model.contact.gaps])
        gap[under] += interpolate_smoothly(points[:, :2], points[:, 2], plan.mesh.nodes[under])
    return gap


def bottoms(plan: Layout, depths: Depths, column: Column) -> tuple[Integers, Integers, Array, Array]:
    """Return what ground without shear is below voids at nodes whose own gap is a smaller one, as springs.

    Nodes (s,), which depth each lies at (s,), stiffnesses (s,) [N/m] and areas (s,) [m2]; none for cavities.
    """
    mesh, elements = plan.mesh, plan.mesh.elements[plan.plate_elements]
    area = integrate_over_elements(mesh, plan.plate_elements)
    k0 = np.broadcast_to(column.A0[..., 0, 0], len(mesh.elements))[plan.plate_elements]
    nodes, which, stiffness, areas = [], [], [], []
    for k in np.flatnonzero(np.isfinite(depths.depth) & (depths.depth > 0)):
        deeper: Flags = (depths.area_fraction[:, [k]] > 0) & (depths.shallowest[elements] < k)
        part = np.where(deeper, depths.area_fraction[:, [k]] * area, 0.0)
        # the settlement of an element's center may hang on that of its other nodes
        part[:, MIDSIDES] += part[:, [8]] / 4
        part[:, 8] = 0.0
        sums = np.stack([scatter(elements, values, len(mesh.nodes)) for values in (part, k0[:, None] * part)], axis=1)
        sums = collect(mesh.elements, sums)
        at = np.flatnonzero(sums[:, 0])
        nodes.append(at)
        which.append(np.full(len(at), k))
        areas.append(sums[at, 0])
        stiffness.append(sums[at, 1])
    none = np.zeros(0, dtype=np.int64)
    return (
        np.concatenate([none, *nodes]), np.concatenate([none, *which]),
        np.concatenate([np.zeros(0), *stiffness]), np.concatenate([np.zeros(0), *areas]),
    )  # fmt: skip
