"""The mesh of results: the plate by its sections, patches for recovery, the full plate from its meshed part."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, partial

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.hanging import find_hanging
from groundslab.fem.load_vectors import nodal_area
from groundslab.fem.mesh import SIDES, Mesh, mirror, renumber_by_rows, sides_along
from groundslab.fem.problem import Problem
from groundslab.fem.shape_functions import determinants, gauss, q9, q9_values, unique_integers
from groundslab.geometry.plan import Segment
from groundslab.model.loads.acting import LineForce, borders_of
from groundslab.model.loads.spreading import lines_without_width
from groundslab.model.model import Model
from groundslab.results import patch_recovery
from groundslab.results.disc_means import DiscMeans, make_disc_means
from groundslab.results.edge_forces import EdgeSides, edge_lengths, edge_sides
from groundslab.results.patch_recovery import Patches

#: Fields that change sign in the mirror x = 0 and in the mirror y = 0.
ANTISYMMETRIC = ({"rotation_x", "shear_x", "moment_xy"}, {"rotation_y", "shear_y", "moment_xy"})
#: Fields that are shares, of which each side of a mirror has a part.
SHARED = {"area", "contact_area", "edge_length"}
#: The 2 x 2 Gauss points in the order that an element's mirror image has them.
XI_TURNED = np.array([2, 3, 0, 1])


@dataclass(frozen=True, slots=True)
class MirroredMesh:
    """A full mesh of which a half or a quarter was computed: nodes and elements row by row."""

    mesh: Mesh
    node: Integers  # (n,): of the meshed part
    element: Integers  # (m,)
    odd: tuple[Array, Array]  # (n,): what fields that are odd about x = 0 and about y = 0 are multiplied with
    odd_elements: tuple[Array, Array]  # (m,)
    shares: Array  # (n,): how many parts meet at each node

    def nodal(self, name: str, field: Array) -> Array:
        """Return a nodal field of the full mesh (n,) from that of the meshed part."""
        mirrored = _mirror(name, field[self.node], self.odd)
        return mirrored * self.shares if name in SHARED else mirrored

    def by_element(self, name: str, field: Array) -> Array:
        """Return a field of elements of the full mesh (m,) from that of the meshed part."""
        return _mirror(name, field[self.element], self.odd_elements)


def _mirror(name: str, field: Array, odd: tuple[Array, Array]) -> Array:
    """Return a field with the signs that its values have on the mirrored sides."""
    for axis in (0, 1):
        if name in ANTISYMMETRIC[axis]:
            field = field * odd[axis]
    return field


@dataclass(frozen=True, slots=True)
class ResultMesh:
    """A mesh of the plate for results, with what recovers section forces and mirrors the meshed part.

    A node on the border of two sections or of a void, along a line load or support, or on the border of two soil zones
    without shear, stands once for each side, so that nothing is averaged across. Section forces are smooth in parts,
    which end at edges of loads, too.
    """

    mesh: Mesh  # the meshed part of the plate by its sections
    node: Integers  # (k,): which node of the problem's mesh each of its nodes is
    area: Array  # (k,) [m2]: share of each
    depth: Integers  # (k,): at which of the problem's depths the ground lies under most of its elements' area
    edges: EdgeSides  # along the plate's edge, openings' edges too
    edge_length: Array  # (k,) [m]: share of the edge's length of each node
    nodal_edge_length: Array  # (n,) [m]: of the nodes of the problem's mesh
    mean: Array  # (mp, 9): from nodal values to the mean over an element
    smooth: Integers  # (mp, 9): elements of the parts; their nodes come first in the patches
    images: tuple[tuple[int, Flags], ...]  # axes of symmetry, and the elements whose images beyond it have patches too
    patches: Patches
    plate: MirroredMesh
    ground: MirroredMesh
    make_means: Callable[[], DiscMeans]  # makes `means` once

    @property
    def means(self) -> DiscMeans:
        """Return the means of section forces of the full plate where they are singular.

        They are made when they are asked for: a mesh whose fields are only taken to a finer one has no need of them.
        """
        return self.make_means()

    def at_nodes(self, values: Array, names: Sequence[str], sizes: Sequence[Array]) -> Array:
        """Return values at the nodes of the plate's elements (mp, 9, k) from those at their 2 x 2 Gauss points.

        The values (mp, 4, k) are called by names (k,), which tell which of them change sign in a mirror; sizes are
        as in patch_recovery.recover_nodes.
        """
        for axis, copied in self.images:
            sign = np.array([-1.0 if name in ANTISYMMETRIC[axis] else 1.0 for name in names])
            values = np.vstack([values, sign * values[copied][:, XI_TURNED]])
        return patch_recovery.recover_nodes(self.patches, values, sizes)[self.smooth]


def make_result_mesh(model: Model, problem: Problem) -> ResultMesh:
    """Return the mesh for the results of a model."""
    elements, depth = problem.mesh.elements[problem.plate.elements], problem.contact.depths.dominant
    jumps = sides_along(problem.mesh, elements, _lines_of_jumps(model))
    borders = (edge for _, shape in model.acting for edge in borders_of(shape))
    kinks = sides_along(problem.mesh, elements, borders)
    zones = sides_along(problem.mesh, elements, _borders_of_springs(model))
    mesh, node = split_by_section(problem, np.concatenate([jumps, zones]), depth)
    smooth, _ = split_by_section(problem, np.concatenate([jumps, zones, kinks]))
    edges = edge_sides(problem)
    parts, points, images = smooth, q9_values(gauss(2)[0]) @ mesh.xy, list[tuple[int, Flags]]()
    for axis in (0, 1):
        if problem.symmetry[axis]:
            parts, points, copied = _beyond_the_line(parts, points, axis)
            images.append((axis, copied))
    at_nodes = np.empty(len(node), dtype=np.int64)
    at_nodes[mesh.elements] = depth[:, None]
    full = mirror_to_full(mesh, problem.symmetry)
    of_elements = problem.plate.section[full.element], problem.plate.thickness[full.element]
    return ResultMesh(
        mesh=mesh,
        node=node,
        area=nodal_area(mesh, np.arange(len(mesh.elements))),
        depth=at_nodes,
        edges=edges,
        edge_length=edge_lengths(edges, mesh.elements, len(mesh.nodes)),
        nodal_edge_length=edge_lengths(edges, elements, len(problem.mesh.nodes)),
        mean=_means(mesh),
        smooth=smooth.elements,
        images=tuple(images),
        patches=patch_recovery.make_patches(parts.nodes, parts.elements, points),
        plate=full,
        ground=mirror_to_full(problem.mesh, problem.symmetry),
        make_means=cache(partial(make_disc_means, model, full.mesh, *of_elements)),
    )


def _lines_of_jumps(model: Model) -> Iterator[Segment]:
    """Yield the lines across which section forces jump: those of forces and couples, of line supports and beams."""
    for _, shape in model.acting:
        if isinstance(shape, LineForce):
            yield from lines_without_width(model.plate, shape, model.plates)
    for member in (*model.supports, *model.members):
        yield from member.edges


def _borders_of_springs(model: Model) -> Iterator[Segment]:
    """Yield the borders of soil zones across which pressures jump: the ground carries no shear."""
    for ring in model.zone_rings if not model.ground_carries_shear else ():
        yield from ring.segments()


def mirror_to_full(mesh: Mesh, symmetry: tuple[bool, bool]) -> MirroredMesh:
    """Return the full mesh of a part that was computed."""
    node, element = np.arange(len(mesh.nodes)), np.arange(len(mesh.elements))
    odd, odd_elements = [np.ones(len(node))] * 2, [np.ones(len(element))] * 2
    shares = np.ones(len(node))
    for axis in (0, 1):
        if not symmetry[axis]:
            continue
        mesh, source, side = mirror(mesh, axis)
        on_axis = mesh.nodes[:, axis] == 0.0
        node, element = node[source], np.tile(element, 2)
        odd, odd_elements = [signs[source] for signs in odd], [np.tile(signs, 2) for signs in odd_elements]
        # on the axis the means of both sides' odd fields vanish; those of the meshed side alone need not
        odd[axis] = odd[axis] * np.where(on_axis, 0.0, side)
        odd_elements[axis] = odd_elements[axis] * np.repeat([1.0, -1.0], len(element) // 2)
        shares = shares[source] * np.where(on_axis, 2.0, 1.0)
    mesh, old, order = renumber_by_rows(mesh)
    x, y = (signs[old] for signs in odd)
    in_x, in_y = (signs[order] for signs in odd_elements)
    return MirroredMesh(mesh, node[old], element[order], (x, y), (in_x, in_y), shares[old])


def split_by_section(problem: Problem, creases: Integers, depth: Integers | None = None) -> tuple[Mesh, Integers]:
    """Return the mesh of the plate whose nodes stand once for each section they belong to; which node each was.

    Nodes along creases (k, 3) stand once for each side, so that nothing is averaged across them; so do those between
    elements over ground at different depths (mp,).
    """
    elements, n = problem.mesh.elements[problem.plate.elements], len(problem.mesh.nodes)
    key = elements + n * problem.plate.section[:, None]
    if len(creases):
        key = key + n * (problem.plate.section.max() + 1) * split_at(elements, creases, n)
    if depth is not None and depth.any():
        key = key + n * (key.max() // n + 1) * depth[:, None]
    keys, number = unique_integers(key)
    return Mesh(problem.mesh.nodes[keys % n], number), keys % n


def _means(mesh: Mesh) -> Array:
    """Return int N dA of each element over its area, (m, 9)."""
    points, weights = gauss(3)
    N, dN = q9(points)
    share = determinants(dN, mesh.xy) * weights
    means: Array = share @ N / share.sum(axis=1, keepdims=True)
    return means


def _beyond_the_line(mesh: Mesh, points: Array, axis: int) -> tuple[Mesh, Array, Flags]:
    """Return the mesh and its Gauss points with the images of the elements near a symmetry line, and which these are.

    Two rings of them, so that a corner node on the line has the patch it would have in the whole plate, and so has its
    neighbor across. The mesh's own nodes come first.
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


def split_at(elements: Integers, creases: Integers, n: int) -> Integers:
    """Return a number (m, 9) that tells apart, at each node on a crease (k, 3), the elements on its different sides.

    Elements round such a node belong together if one comes from one to the other without crossing a crease; elsewhere
    the number is 0. n is the number of nodes.
    """
    on_crease = np.zeros(n, dtype=bool)
    on_crease[creases] = True
    meets = on_crease[elements]
    count = int(meets.sum())
    number = np.full(elements.shape, -1)
    number[meets] = np.arange(count)
    sides = elements[:, SIDES]  # (m, 4, 3)
    owner, which = np.nonzero(on_crease[sides].any(axis=2) & ~np.isin(sides[..., 2], creases[:, 2]))
    # halves of a side count as the whole one
    whole, hanging = np.arange(n), find_hanging(elements)
    whole[hanging[:, 0]] = hanging[:, 2]
    nodes, numbers = sides[owner, which], number[owner[:, None], SIDES[which]]
    key = (whole[nodes[:, 2:]] * n + nodes)[numbers >= 0]
    order = np.argsort(key, kind="stable")
    same, numbers = np.flatnonzero(np.diff(key[order]) == 0), numbers[numbers >= 0][order]
    links = np.vstack([numbers[same], numbers[same + 1]])
    least, before = np.arange(count), np.full(count, -1)
    while (least != before).any():  # at most as often as elements meet at a node
        before = least.copy()
        for ends, others in (links, links[::-1]):
            np.minimum.at(least, ends, before[others])
    result = np.zeros(elements.shape, dtype=np.int64)
    result[meets] = unique_integers(least)[1]
    return result
