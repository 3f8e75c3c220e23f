"""The mesh of results: the plate by its sections, patches for recovery, the full plate from its meshed part."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem.hanging import find_hanging
from groundslab.fem.load_vectors import nodal_area
from groundslab.fem.mesh import SIDES, Mesh, bounding_boxes, locate, mirror, renumber_by_rows, sides_along
from groundslab.fem.problem import Problem
from groundslab.fem.shape_functions import determinants, gauss, q9, unique_integers
from groundslab.geometry.plan import Place, Segment
from groundslab.model.loads.acting import LineForce, borders_of
from groundslab.model.loads.spreading import lines_without_width
from groundslab.model.model import Model
from groundslab.model.remarks.singular_places import near_places, singular_places
from groundslab.results import patch_recovery
from groundslab.results.edge_forces import EdgeSides, edge_lengths, edge_sides
from groundslab.results.patch_recovery import Patches

if TYPE_CHECKING:
    from scipy.sparse import csr_array

#: Fields that change sign in the mirror x = 0 and in the mirror y = 0.
ANTISYMMETRIC = ({"rotation_x", "shear_x", "moment_xy"}, {"rotation_y", "shear_y", "moment_xy"})
#: Fields that are shares, of which each side of a mirror has a part.
SHARED = {"area", "contact_area", "edge_length"}
#: Rings and rays of the points by which a field is integrated over a disc; no ray runs along an axis or a diagonal.
RINGS, RAYS = 4, 16
#: Those closer to a singular place than this share of the disc's diameter are replaced by so many by so many, and of
#: these again those that are as many times closer.
CLOSE, DIVIDED, TIMES = 0.15, 3, 2
#: Elements no larger than this share of a disc's radius need its mean at their corners only.
SMALL = 1 / 8
#: Of so many nodes at a time, to spare memory.
CHUNK = 512
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
        found = _mirror(name, field[self.node], self.odd)
        return found * self.shares if name in SHARED else found

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
class DiscMeans:
    """What takes nodal fields of the plate (n,) to their means over discs at r of its nodes.

    Such a mean exists where the value at a point does not. Far from edges it is the value under a force that has spread
    at 45 degrees from the surface to the middle plane, over a disc as wide as the plate is thick.
    """

    nodes: Integers  # (r,)
    matrix: csr_array  # (r, n)
    between: Integers  # (k,): nodes of small elements that have the mean of their corners' means
    corners: Integers  # (k, 4)

    def apply(self, field: Array) -> Array:
        """Return a field with its means at these nodes."""
        if not len(self.nodes):
            return field
        found = field.copy()
        found[self.nodes] = self.matrix @ field
        found[self.between] = found[self.corners].mean(axis=1)
        return found


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
    means: DiscMeans  # of section forces of the full plate where they are singular

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
    parts, points, images = smooth, q9(gauss(2)[0])[0] @ mesh.xy, list[tuple[int, Flags]]()
    for axis in (0, 1):
        if problem.symmetry[axis]:
            parts, points, copied = _beyond_the_line(parts, points, axis)
            images.append((axis, copied))
    at_nodes = np.empty(len(node), dtype=np.int64)
    at_nodes[mesh.elements] = depth[:, None]
    full = mirror_to_full(mesh, problem.symmetry)
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
        means=make_disc_means(
            model, full.mesh, problem.plate.section[full.element], problem.plate.thickness[full.element]
        ),
    )


def make_disc_means(model: Model, mesh: Mesh, section: Integers, thickness: Array) -> DiscMeans:
    """Return the means over discs as wide as the plate is thick, of nodes within a thickness of singular places.

    The mesh is that of the full plate; section (m,) and thickness (m,) [m] are those of its elements. What of a disc
    lies off the plate or in another section is left out.
    """
    from scipy.sparse import csr_array, vstack

    of_node, t = np.zeros(len(mesh.nodes), dtype=np.int64), np.zeros(len(mesh.nodes))
    of_node[mesh.elements], t[mesh.elements] = section[:, None], thickness[:, None]
    singular = [place for places in singular_places(model).values() for place in places]
    near = near_places(singular, mesh.nodes, t)
    between, corners = _between_corners(mesh, near, t / 2)
    near[between] = False
    nodes = np.flatnonzero(near)
    boxes = bounding_boxes(mesh) if len(nodes) else None
    parts = [csr_array((0, len(mesh.nodes)))]
    for start in range(0, len(nodes), CHUNK):
        some = nodes[start : start + CHUNK]
        row, offset, weight = _disc_points(mesh.nodes[some], t[some] / 2, singular)
        element, place = locate(mesh, mesh.nodes[some[row]] + offset, boxes=boxes)
        inside = (element >= 0) & (section[element] == of_node[some[row]])
        row, share = row[inside], weight[inside]
        total = np.bincount(row, weights=share, minlength=len(some))
        # beside a sharp corner no point may be left: the value stays
        alone = np.flatnonzero(total == 0)
        N = q9(place[inside])[0] * (share / total[row])[:, None]
        values = np.concatenate([N.ravel(), np.ones(len(alone))])
        rows = np.concatenate([np.repeat(row, N.shape[1]), alone])
        columns = np.concatenate([mesh.elements[element[inside]].ravel(), some[alone]])
        parts.append(csr_array((values, (rows, columns)), shape=(len(some), len(mesh.nodes))))
    return DiscMeans(nodes, vstack(parts, format="csr"), between, corners)


def _between_corners(mesh: Mesh, near: Flags, radius: Array) -> tuple[Integers, Integers]:
    """Return which nodes lie halfway between corners near singular places, (k,), and these corners, (k, 4).

    Only of elements that are small beside discs of a radius (n,) [m], over whose size a mean changes. Where nodes hang,
    the middle of a longer side is a corner of others.
    """
    xy, corner = mesh.xy[:, :4], mesh.elements[:, :4]
    longest = np.linalg.norm(xy - np.roll(xy, 1, axis=1), axis=2).max(axis=1)
    small = mesh.elements[near[corner].all(axis=1) & (longest <= SMALL * radius[corner[:, 0]])]
    corners = np.full((len(mesh.nodes), 4), -1)
    for start, end, middle in SIDES:
        corners[small[:, middle]] = small[:, [start, end, start, end]]
    corners[small[:, 8]] = small[:, :4]
    corners[mesh.elements[:, :4]] = -1
    between = np.flatnonzero(near & (corners[:, 0] >= 0))
    return between, corners[between]


def _disc_points(centres: Array, radius: Array, singular: Sequence[Place]) -> tuple[Integers, Array, Array]:
    """Return points that integrate over discs (r,): whose they are (p,), where from the centre (p, 2), weights (p,).

    Parts of a disc near a singular place, around which fields change much, are divided.
    """
    from scipy.spatial import KDTree

    # a part is a piece of a ring and of a ray; by squares of the radius, rings have the sizes of Gauss's weights
    x, of_ring = np.polynomial.legendre.leggauss(RINGS)
    ring, ray = (each.ravel() for each in np.indices((RINGS, RAYS)))
    height, wide = of_ring / 2, 2 * np.pi / RAYS
    first = np.column_stack([(np.cumsum(height) - height)[ring], height[ring], wide * ray, np.full(len(ring), wide)])
    row, part = np.repeat(np.arange(len(centres)), len(first)), np.tile(first, (len(centres), 1))
    squared = np.tile((1 + x[ring]) / 2, len(centres))
    tree, parts = KDTree(singular), (np.arange(DIVIDED) / DIVIDED for _ in range(2))
    steps = np.column_stack([each.ravel() for each in np.meshgrid(*parts)])
    found = []
    for time in range(TIMES + 1):
        angle = part[:, 2] + part[:, 3] / 2
        offset = (radius[row] * np.sqrt(squared) * (np.cos(angle), np.sin(angle))).T
        close = np.zeros(len(row), dtype=bool)
        if time < TIMES:
            reach = CLOSE * 2 * radius[row] / DIVIDED**time
            close = tree.query(centres[row] + offset, distance_upper_bound=reach.max(initial=0))[0] <= reach
        found.append((row[~close], offset[~close], (part[:, 1] * part[:, 3] / (2 * np.pi))[~close]))
        row, part = np.repeat(row[close], len(steps)), np.repeat(part[close], len(steps), axis=0)
        part[:, [0, 2]] += np.tile(steps, (int(close.sum()), 1)) * part[:, [1, 3]]
        part[:, [1, 3]] /= DIVIDED
        squared = part[:, 0] + part[:, 1] / 2
    rows, offsets, weights = (np.concatenate(each) for each in zip(*found, strict=True))
    return rows, offsets, weights


def _lines_of_jumps(model: Model) -> Iterator[Segment]:
    """Yield the lines across which section forces jump: those of forces and couples, of line supports and beams."""
    for _, shape in model.acting:
        if isinstance(shape, LineForce):
            yield from lines_without_width(model.plate, shape, model.plates)
    for each in (*model.supports, *model.members):
        yield from each.edges


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
        odd, odd_elements = [each[source] for each in odd], [np.tile(each, 2) for each in odd_elements]
        # on the axis the means of both sides' odd fields vanish; those of the meshed side alone need not
        odd[axis] = odd[axis] * np.where(on_axis, 0.0, side)
        odd_elements[axis] = odd_elements[axis] * np.repeat([1.0, -1.0], len(element) // 2)
        shares = shares[source] * np.where(on_axis, 2.0, 1.0)
    mesh, old, order = renumber_by_rows(mesh)
    x, y = (each[old] for each in odd)
    in_x, in_y = (each[order] for each in odd_elements)
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
    keys, own = unique_integers(key)
    return Mesh(problem.mesh.nodes[keys % n], own), keys % n


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
    nodes, own = sides[owner, which], number[owner[:, None], SIDES[which]]
    key = (whole[nodes[:, 2:]] * n + nodes)[own >= 0]
    order = np.argsort(key, kind="stable")
    same, own = np.flatnonzero(np.diff(key[order]) == 0), own[own >= 0][order]
    links = np.vstack([own[same], own[same + 1]])
    least, before = np.arange(count), np.full(count, -1)
    while (least != before).any():  # at most as often as elements meet at a node
        before = least.copy()
        for some, others in (links, links[::-1]):
            np.minimum.at(least, some, before[others])
    result = np.zeros(elements.shape, dtype=np.int64)
    result[meets] = unique_integers(least)[1]
    return result
