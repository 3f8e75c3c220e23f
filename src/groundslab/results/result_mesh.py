"""What all results on one mesh have in common: the plate by its sections, its patches, the whole beside its mirror."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem import plate
from groundslab.fem.assembly import congruent
from groundslab.fem.load_vectors import nodal_area
from groundslab.fem.mesh import Mesh, mirror, row_by_row
from groundslab.fem.problem import Problem
from groundslab.fem.shape_functions import distinct, gauss, jacobian, q9
from groundslab.model.model import Model
from groundslab.results import patch_recovery
from groundslab.results.discontinuities import apart, loaded, walls
from groundslab.results.edge_forces import EdgeSides, edge_lengths, edge_sides
from groundslab.results.patch_recovery import Patches

#: Fields that change sign in the mirror x = 0 and in the mirror y = 0.
ODD = (
    {"rotation_x", "shear_x", "moment_xy"},
    {"rotation_y", "shear_y", "moment_xy"},
)
#: Fields that are a node's share of a whole, of which each side of a mirror has a part.
SHARED = {"area", "contact_area", "edge_length"}
#: The 2 x 2 Gauss points in the order that an element's mirror image has them.
XI_TURNED = np.array([2, 3, 0, 1])


@dataclass(frozen=True, slots=True)
class MirroredMesh:
    """The whole of a mesh of which a half or a quarter was computed: nodes and elements row by row."""

    mesh: Mesh
    node: Integers  # (n,): of the meshed part
    element: Integers  # (m,)
    odd: tuple[Array, Array]  # (n,): what fields that are odd about x = 0 and about y = 0 are multiplied with
    odd_elements: tuple[Array, Array]  # (m,)
    shares: Array  # (n,): how many parts meet at each node

    def nodal(self, name: str, field: Array) -> Array:
        """Return a nodal field of the whole (n,) from that of the meshed part."""
        found: Array = field[self.node]
        for axis in (0, 1):
            if name in ODD[axis]:
                found = found * self.odd[axis]
        return found * self.shares if name in SHARED else found

    def by_element(self, name: str, field: Array) -> Array:
        """Return a field of elements of the whole (m,) from that of the meshed part."""
        found: Array = field[self.element]
        for axis in (0, 1):
            if name in ODD[axis]:
                found = found * self.odd_elements[axis]
        return found


@dataclass(frozen=True, slots=True)
class Frame:
    """A mesh of the plate, with what recovers its section forces and makes the whole of it.

    A node on the border of two sections or of a void, or along a line support, stands once for each side, so that
    nothing is averaged across. Section forces are smooth in parts, which end at edges of loads, too.
    """

    mesh: Mesh  # the meshed part of the plate by its sections
    node: Integers  # (k,): which node of the problem's mesh each of its nodes is
    area: Array  # (k,) [m2]: share of each
    depth: Integers  # (k,): at which of the problem's depths the ground lies under most of its elements' area
    edges: EdgeSides  # along the plate's edge, openings' edges too
    edge_length: Array  # (k,) [m]: share of the edge's length of each node
    nodal_edge_length: Array  # (n,) [m]: of the nodes of the problem's mesh
    mean: Array  # (mp, 9): from nodal values to the mean over an element
    matrices: Array  # (kinds, 20, 27): from unknowns to section forces at 2 x 2 Gauss points
    kind: Integers  # (mp,): which of them an element has
    smooth: Integers  # (mp, 9): elements of the parts; their nodes come first in the patches
    images: tuple[tuple[int, Flags], ...]  # axes of symmetry, and the elements whose images beyond it have patches too
    patches: Patches
    plate: MirroredMesh
    ground: MirroredMesh

    def at_nodes(self, values: Array, names: Sequence[str], sizes: Sequence[Array]) -> Array:
        """Return values at the nodes of the plate's elements (mp, 9, k) from those at their 2 x 2 Gauss points.

        The values (mp, 4, k) are called by names (k,), which tell which of them change sign in a mirror; sizes are
        as in patches.nodal.
        """
        for axis, copied in self.images:
            sign = np.array([-1.0 if name in ODD[axis] else 1.0 for name in names])
            values = np.vstack([values, sign * values[copied][:, XI_TURNED]])
        at_nodes: Array = patch_recovery.nodal(self.patches, values, sizes)[self.smooth]
        return at_nodes


def frame(model: Model, problem: Problem) -> Frame:
    """Return the frame of the results of a model on one mesh."""
    supported = walls(model, problem)
    depth = problem.depths.dominant
    mesh, node = by_section(problem, supported, depth)
    smooth, _ = by_section(problem, np.concatenate([supported, loaded(model, problem)]))
    matrices, kind = section_matrices(problem)
    edges = edge_sides(problem)
    parts, points, images = smooth, q9(gauss(2)[0])[0] @ mesh.xy, list[tuple[int, Flags]]()
    for axis in (0, 1):
        if problem.symmetry[axis]:
            parts, points, copied = _beyond_the_line(parts, points, axis)
            images.append((axis, copied))
    at_nodes = np.empty(len(node), dtype=np.int64)
    at_nodes[mesh.elements] = depth[:, None]
    return Frame(
        mesh=mesh,
        node=node,
        area=nodal_area(mesh, np.arange(len(mesh.elements))),
        depth=at_nodes,
        edges=edges,
        edge_length=edge_lengths(edges, mesh.elements, len(mesh.nodes)),
        nodal_edge_length=edge_lengths(edges, problem.mesh.elements[problem.plate_elements], len(problem.mesh.nodes)),
        mean=_means(mesh),
        matrices=matrices,
        kind=kind,
        smooth=smooth.elements,
        images=tuple(images),
        patches=patch_recovery.around(parts.nodes, parts.elements, points),
        plate=whole(mesh, problem.symmetry),
        ground=whole(problem.mesh, problem.symmetry),
    )


def whole(mesh: Mesh, symmetry: tuple[bool, bool]) -> MirroredMesh:
    """Return the whole of a mesh of which a part was computed."""
    node, element = np.arange(len(mesh.nodes)), np.arange(len(mesh.elements))
    odd, odd_elements = [np.ones(len(node))] * 2, [np.ones(len(element))] * 2
    shares = np.ones(len(node))
    for axis in (0, 1):
        if not symmetry[axis]:
            continue
        mesh, source, side = mirror(mesh, axis)
        on_axis = mesh.nodes[:, axis] == 0.0
        node, element = node[source], np.tile(element, 2)
        odd, odd_elements = [each[source] for each in odd], [np.tile(each, 2) for each in odd_elements]
        # on the axis the means of both sides' odd fields vanish; those of the meshed side alone need not
        odd[axis] = odd[axis] * np.where(on_axis, 0.0, side)
        odd_elements[axis] = odd_elements[axis] * np.repeat([1.0, -1.0], len(element) // 2)
        shares = shares[source] * np.where(on_axis, 2.0, 1.0)
    mesh, old, order = row_by_row(mesh)
    x, y = (each[old] for each in odd)
    in_x, in_y = (each[order] for each in odd_elements)
    return MirroredMesh(mesh, node[old], element[order], (x, y), (in_x, in_y), shares[old])


def by_section(problem: Problem, creases: Integers, depth: Integers | None = None) -> tuple[Mesh, Integers]:
    """Return the mesh of the plate whose nodes stand once for each section they belong to; which node each was.

    Nodes along creases (k, 3) stand once for each side, so that nothing is averaged across them; so do those between
    elements over ground at different depths (mp,).
    """
    elements, n = problem.mesh.elements[problem.plate_elements], len(problem.mesh.nodes)
    key = elements + n * problem.section[:, None]
    if len(creases):
        key = key + n * len(problem.bending) * apart(elements, creases, n)
    if depth is not None and depth.any():
        key = key + n * (key.max() // n + 1) * depth[:, None]
    keys, own = distinct(key)
    return Mesh(problem.mesh.nodes[keys % n], own), keys % n


def section_matrices(problem: Problem) -> tuple[Array, Integers]:
    """Return the matrices (kinds, 20, 27) to section forces at 2 x 2 Gauss points, and each plate element's kind."""
    xy, sections = problem.mesh.nodes[problem.mesh.elements[problem.plate_elements]], len(problem.bending)
    shapes, shape = congruent(xy)
    pairs, kind = np.unique(shape * sections + problem.section, return_inverse=True)
    D, S = problem.bending[pairs % sections], problem.shear[pairs % sections]
    matrices = plate.section_matrices(problem.element, gauss(2)[0], xy[shapes[pairs // sections]], D, S)
    return matrices.reshape(len(pairs), 20, 27), kind


def _means(mesh: Mesh) -> Array:
    """Return int N dA of each element over its area, (m, 9)."""
    points, weights = gauss(3)
    N, dN = q9(points)
    share = jacobian(dN, mesh.xy)[2] * weights
    means: Array = share @ N / share.sum(axis=1, keepdims=True)
    return means


def _beyond_the_line(mesh: Mesh, points: Array, axis: int) -> tuple[Mesh, Array, Flags]:
    """Return the mesh and its Gauss points with the images of the elements near a symmetry line, and which these are.

    Two rings of them, so that a corner node on the line has the patch it would have in the whole plate, and so has its
    neighbour across. The mesh's own nodes come first.
    """
    near = mesh.nodes[:, axis] == 0.0
    for _ in range(2):
        copied = near[mesh.elements].any(axis=1)
        near[mesh.elements[copied]] = True
    doubled, _, _ = mirror(mesh, axis)
    turn = np.where(np.arange(2) == axis, -1.0, 1.0)
    images = np.concatenate([np.ones(len(copied), dtype=bool), copied])
    # an image runs through its reference square with xi turned round
    more = np.vstack([points, turn * points[copied][:, XI_TURNED]])
    return Mesh(doubled.nodes, doubled.elements[images]), more, copied
