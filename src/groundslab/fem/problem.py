"""The arrays that an analysis works on.

Fields of a node: W, BETA_X, BETA_Y of the plate; TOP, which is the settlement of the ground's surface, under the plate
relative to the plate's; then the settlements of the lower surfaces. Under the plate w_0 = w + h, and the gap is h + g0.
Where joints have play, their slip at nodes of the second plate comes next; then what sections of walls turn by; where
beams are eccentric, the displacements u, v in the plane of their plates; unknowns of the building above, which stand at
some nodes that mean nothing to them, come last. What bears on single unknowns (the ground where the plate may lift off,
supports, the ends of the play) stands beside the matrix.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from operator import attrgetter

import numpy as np

from groundslab.arrays import Array, Flags, Integers, made_once_by
from groundslab.fem.bearings import Links, Measures
from groundslab.fem.continuum.elastic_ground import ElasticGround
from groundslab.fem.foundation import Column
from groundslab.fem.hanging import find_hanging
from groundslab.fem.mesh import Mesh
from groundslab.fem.parts.beams import Beams
from groundslab.fem.parts.building import Building
from groundslab.fem.parts.contact import ContactConditions
from groundslab.fem.parts.mesh_plan import MeshPlan
from groundslab.fem.parts.plates import Plates
from groundslab.fem.shape_functions import unique_integers
from groundslab.fem.vlasov import Soil

W, BETA_X, BETA_Y, TOP = range(4)
#: The middles of an element's sides.
MIDSIDES = slice(4, 8)


@dataclass(frozen=True, slots=True)
class Loading:
    """What acts together: forces, the curvature that temperature or shrinkage would give, settlements of supports."""

    load: Array  # (n, F) [N, N m]: in TOP those on the ground's surface beside the plate
    free_curvature: Array  # (mp, 2) [1/m]: beta_x,x and beta_y,y that each plate element would take freely
    settlement: Array  # (s,) [m]: of each support
    size: Array  # (plates,) [N]: sizes of all forces on each, and of moments over its length, whatever they cancel
    beside: Array  # (f, 3): places x, y [m] and forces [N] of what presses an elastic continuum beside the plate
    on_spans: Array  # (l, 6): loads on spans of beams over openings, see `parts.spans`

    def __add__(self, other: Loading) -> Loading:
        """Return the sum of two loadings."""
        return Loading(
            self.load + other.load,
            self.free_curvature + other.free_curvature,
            self.settlement + other.settlement,
            self.size + other.size,
            np.vstack([self.beside, other.beside]),
            np.vstack([self.on_spans, other.on_spans]),
        )

    def scale(self, factor: float) -> Loading:
        """Return the loading multiplied by a factor."""
        many = factor * self.load, factor * self.free_curvature, factor * self.settlement
        size, beside = abs(factor) * self.size, self.beside * [1.0, 1.0, factor]
        return Loading(*many, size, beside, self.on_spans * [1.0, 1.0, *[factor] * 4])


@dataclass(frozen=True, slots=True)
class Problem:
    """One mesh with everything on it, in SI units. n nodes, m elements, F fields, S surfaces of the ground."""

    mesh: Mesh
    plate: Plates
    ground: Soil | Column
    constants: tuple[Array, Array]  # (L,) each: k0 [Pa/m] and k1 [Pa m], means under the plate; of soil, nothing
    rank: Integers  # (n,): order of elimination of the nodes
    unknown: Integers  # (n, F): number of each unknown, -1 where there is none or it is held at zero
    surfaces: int  # S; their fields may be followed by slips of joints that have play
    cases: tuple[Loading, ...]  # the load cases by themselves
    loading: Loading  # what is to be solved for
    contact: ContactConditions  # between plate and ground, and at supports
    shear_at_edges: bool  # whether the ground carries shear, so that a line force acts along them, too
    links: Links  # across joints between plates
    beams: Beams  # along sides of the plates' elements
    edges: Integers  # (e, 3): end, end and middle node of each outer side on which infinite ground follows
    corners: Integers  # (c,): nodes at which two such edges meet
    mesh_plan: MeshPlan
    origin: tuple[float, float] = (0.0, 0.0)  # [m]: where x = y = 0 lies in the plan that was given, for messages
    building: Building | None = None  # above, which joins footprints on the plates
    in_plane: tuple[int, ...] = ()  # the fields of u and v, none where no beam is eccentric
    elastic: ElasticGround | None = None  # bears the plate, instead of columns, whose constants are zero then

    @property
    def symmetry(self) -> tuple[bool, bool]:
        """Return whether symmetry along x, and along y, is used."""
        return self.mesh_plan.symmetry

    @property
    def load(self) -> Array:
        """Return the nodal loads (n, F) [N, N m]; what presses on the ground at the plate's edge is in W and in TOP."""
        return self.loading.load

    @property
    def plate_load(self) -> Array:
        """Return the nodal loads on the plate alone (n, 3) [N, N m]."""
        load = self.loading.load[:, :TOP].copy()
        # on an elastic continuum what presses beside the plate is in TOP alone
        if self.elastic is None:
            load[self.plate.nodes, W] -= self.loading.load[self.plate.nodes, TOP]
        return load + self.turned(self.loading.load)

    def nodes_of(self, plate: int) -> Integers:
        """Return the nodes of one of the plates, ascending."""
        return unique_integers(self.mesh.elements[self.plate.elements[self.plate.number == plate]])[0]

    @property
    def plate_at_nodes(self) -> Integers:
        """Return the number of the plate that each node belongs to, -1 beside all plates, (n,)."""
        number = np.full(len(self.mesh.nodes), -1)
        number[self.mesh.elements[self.plate.elements]] = self.plate.number[:, None]
        return number

    @property
    @made_once_by(attrgetter("mesh.nodes", "plate.number"))
    def length(self) -> float:
        """Return the longer side of the largest plate's meshed part [m], times which a rotation is a displacement."""
        numbers = range(len(self.plate.names))
        return max(float(np.ptp(self.mesh.nodes[self.nodes_of(number)], axis=0).max()) for number in numbers)

    @property
    def measures(self) -> Measures:
        """Return what displacements and forces are measured by."""
        has, size = self.unknown >= 0, self.unknown.max(initial=-1) + 1
        lever, plate = np.ones(size), np.full(size, -1)
        turns = self.unknown[:, self.turning]
        lever[turns[turns >= 0]] = self.length
        if len(self.plate.names) == 1:
            return Measures(lever)
        plate[self.unknown[has]] = np.broadcast_to(self.plate_at_nodes[:, None], self.unknown.shape)[has]
        return Measures(lever, plate)

    @property
    def turning(self) -> Integers:
        """Return the fields that are slopes: those of the plate, and of the sections of walls."""
        fields = np.unique(self.beams.theta)
        return np.array([BETA_X, BETA_Y, *fields[fields > 0]])

    def with_followers(self, U: Array) -> Array:
        """Return a table of unknowns (n, F) in which sections of walls and the building above follow the plate."""
        b = self.beams
        if not b.deep.any() and self.building is None:
            return U
        table = U.copy()
        deep = b.deep
        sides = b.sides[deep]
        table[sides, b.theta[deep, None]] = (b.along[deep] * U[sides, BETA_X : BETA_Y + 1]).sum(axis=2)
        return table if self.building is None else self.building.with_own(table)

    def turned(self, forces: Array) -> Array:
        """Return what couples of forces (n, F) on sections of walls are for the plate that these turn with, (n, 3)."""
        b, moments = self.beams, np.zeros((len(forces), TOP))
        for field in set(b.theta[b.deep].tolist()):
            mask, along = b.theta == field, np.zeros((len(forces), 2))
            along[b.sides[mask]] = b.along[mask]
            moments[:, BETA_X : BETA_Y + 1] += forces[:, field, None] * along
        return moments

    def nodal_sizes(self, forces: Array) -> Array:
        """Return the largest of the forces (n, F) at each node, moments over the plate's length, (n,) [N]."""
        lever = np.ones(forces.shape[1])
        lever[self.turning] = self.length
        sizes: Array = (np.abs(forces) / lever).max(axis=1)
        return sizes

    def combine(self, factors: Array) -> Problem:
        """Return the problem under the sum of its load cases times factors (cases,)."""
        first, *others = (case.scale(factor) for case, factor in zip(self.cases, factors, strict=True) if factor != 0)
        return replace(self, loading=sum(others, first))


def membrane_unknowns(problem: Problem, U: Array) -> Array:
    """Return u and v of each plate element (mp, 18) from U (n, F), less those of its center.

    Strains are the same; stiffness times what an element moves as a whole would be rounding alone.
    """
    elements = problem.mesh.elements[problem.plate.elements]
    return np.concatenate([U[elements, field] - U[elements[:, 8:], field] for field in problem.in_plane], axis=1)


def plate_unknowns(problem: Problem, U: Array) -> Array:
    """Return w, beta_x and beta_y of each plate element (mp, 27) from U (n, F), less the plane that fits best.

    Strains are the same; stiffness times what a nearly rigid plate moves as a whole would be rounding alone.
    """
    motions, elements = planes(problem), problem.mesh.elements[problem.plate.elements]
    if len(problem.plate.names) == 1:
        return _less_plane(motions, U, elements)
    u = np.empty((len(elements), 27))
    for number in range(len(problem.plate.names)):
        mask = problem.plate.number == number
        u[mask] = _less_plane(motions, U, elements[mask])
    return u


def _less_plane(motions: Array, U: Array, elements: Integers) -> Array:
    """Return w, beta_x and beta_y of elements (m, 27) less the plane that fits best, motions being (n, 3, 3)."""
    corners = elements[:, :4].ravel()
    plane = np.linalg.lstsq(motions[corners, W], U[corners, W], rcond=None)[0]
    moved = U[:, :TOP] - motions @ plane
    u: Array = np.concatenate([moved[elements, field] for field in (W, BETA_X, BETA_Y)], axis=1)
    return u


def planes(problem: Problem) -> Array:
    """Return the rigid motions w = 1, x, y of a plate as W, BETA_X and BETA_Y at every node, (n, 3, 3)."""
    nodes = problem.mesh.nodes
    x, y = nodes.T
    motions = np.zeros((len(nodes), TOP, 3))
    motions[:, W] = np.column_stack([np.ones_like(x), x, y])
    motions[:, BETA_X, 1] = motions[:, BETA_Y, 2] = 1.0
    return motions


def move_plates(problem: Problem, motions: Array) -> Array:
    """Return W, BETA_X and BETA_Y at every node (n, 3, d) by motions of all plates (3 plates, d), zero beside them.

    A single plate's are continued beyond it.
    """
    alone = planes(problem)
    if len(problem.plate.names) == 1:
        moved: Array = alone @ motions
        return moved
    moved = np.zeros((len(alone), TOP, motions.shape[1]))
    for number in range(len(problem.plate.names)):
        nodes = problem.nodes_of(number)
        moved[nodes] = alone[nodes] @ motions[3 * number : 3 * number + 3]
    return moved


def motion_rows(problem: Problem, nodes: Integers, field: Integers) -> Array:
    """Return what the rigid motions of all plates do to W, BETA_X or BETA_Y of some nodes of plates, (k, 3 plates)."""
    rows = np.column_stack([np.ones(len(nodes)), problem.mesh.nodes[nodes]])
    for turned in (BETA_X, BETA_Y):
        rows[field == turned] = np.arange(3) == turned
    count = len(problem.plate.names)
    if count == 1:
        return rows
    by_plate = np.zeros((len(nodes), 3 * count))
    columns = 3 * problem.plate_at_nodes[nodes][:, None] + np.arange(3)
    np.put_along_axis(by_plate, columns, rows, axis=1)
    return by_plate


def free_motions(problem: Problem, mirrored: bool = False) -> Array:
    """Return the rigid motions w = a + b x + c y that the supports which act both ways allow, as columns (3 plates, d).

    Of a plate of which a part is meshed those that its mirrors allow, or, mirrored, those of the full plate.
    """
    if len(problem.plate.names) > 1:
        every = _block_diagonal([free_motions(plate, mirrored) for plate, _ in single_plates(problem)])
        return _without_steps(problem, every)
    nodes, b = problem.plate.nodes, problem.contact.bearing
    fixed = problem.unknown[:, : BETA_Y + 1] < 0
    fixed[find_hanging(problem.mesh.elements)[:, 0]] = False
    both = b.law.bilateral
    fixed[b.node[both], b.field[both]] = True
    for axis in (0, 1):
        if mirrored and problem.symmetry[axis]:
            fixed[problem.mesh.nodes[:, axis] == 0.0, BETA_X + axis] = False
    fixed = fixed[nodes]
    x, y = problem.mesh.nodes[nodes].T
    # slopes times the plate's length are settlements
    length = float(np.ptp(problem.mesh.nodes[nodes], axis=0).max())
    scale, ones, zeros = np.array([1.0, 1 / length, 1 / length]), np.ones_like(x), np.zeros_like(x)
    own_w = np.ones(len(nodes), dtype=bool)
    if not problem.plate.element.center_w:
        own_w[np.isin(nodes, problem.mesh.elements[problem.plate.elements, 8])] = False
    constraints = np.vstack(
        [
            np.column_stack([ones, x, y])[fixed[:, W] & own_w],
            length * np.column_stack([zeros, ones, zeros])[fixed[:, BETA_X]],
            length * np.column_stack([zeros, zeros, ones])[fixed[:, BETA_Y]],
        ]
    )
    for axis in (0, 1):
        if mirrored and problem.symmetry[axis]:
            constraints = np.vstack([constraints, constraints * mirror_motion(axis)])
    _, sizes, V = np.linalg.svd(np.linalg.qr(np.vstack([constraints * scale, np.zeros((3, 3))]), mode="r"))
    rank = int((sizes > 1e-10 * sizes.max()).sum())
    motions: Array = scale[:, None] * V[rank:].T
    return motions


def _without_steps(problem: Problem, motions: Array) -> Array:
    """Return those combinations of motions (3 plates, d) that make no step across joints that hold plates together.

    Where a member goes on across a joint they make no kink, either.
    """
    links = problem.links
    moving = links.holds & links.fields[:, :TOP].any(axis=1)
    first, second = links.nodes[moving].T
    if not len(first):
        return motions
    size = np.ptp(problem.mesh.nodes[problem.plate.nodes], axis=0).max()
    scale = np.tile([1.0, 1 / size, 1 / size], len(problem.plate.names))
    # about the plates' middle, in which settlements and slopes are alike
    unit = np.linalg.qr(scale[:, None] ** -1 * motions)[0]
    field = np.argmax(links.fields[moving], axis=1)
    of_first, of_second = (motion_rows(problem, nodes, field) for nodes in (first, second))
    steps = (np.where(field == W, 1.0, size)[:, None] * (of_first - of_second) * scale) @ unit
    _, sizes, V = np.linalg.svd(np.linalg.qr(np.vstack([steps, np.zeros((unit.shape[1],) * 2)]), mode="r"))
    rank = int((sizes > 1e-9 * sizes.max(initial=0.0)).sum())
    kept: Array = scale[:, None] * (unit @ V[rank:].T)
    return kept


def _block_diagonal(blocks: list[Array]) -> Array:
    """Return the matrix with blocks along its diagonal; those without columns have rows alone."""
    if len(blocks) == 1:
        return blocks[0]
    from scipy.linalg import block_diag

    matrix: Array = block_diag(*blocks)
    return matrix


def mirror_motion(axis: int) -> Array:
    """Return what a motion (a, b, c) is multiplied with in the mirror across an axis."""
    return np.where(np.arange(3) == axis + 1, -1.0, 1.0)


def single_plates(problem: Problem) -> Iterator[tuple[Problem, Flags]]:
    """Yield each plate by itself, with the loads and bearings on it, and which of all bearings (c,) these are."""
    return (_restrict(problem, (number,)) for number in range(len(problem.plate.names)))


def joined_plates(problem: Problem) -> Iterator[tuple[Problem, Flags]]:
    """Yield the plates that joints hold to each other together, each other one by itself, as `single_plates`."""
    if not problem.links.holds.any():
        return single_plates(problem)
    groups = groups_of_plates(problem, problem.links.holds)
    return (_restrict(problem, tuple(np.flatnonzero(groups == n).tolist())) for n in range(groups.max() + 1))


def groups_of_plates(problem: Problem, joining: Flags) -> Integers:
    """Return the number of the group that each plate belongs to, (plates,), which some of the links (l,) join."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    count = len(problem.plate.names)
    plates, others = problem.plate_at_nodes[problem.links.nodes[joining]].T
    together = coo_array((np.ones(len(plates)), (plates, others)), shape=(count, count))
    group: Integers = connected_components(together, directed=False)[1]
    return group


def _restrict(problem: Problem, numbers: tuple[int, ...]) -> tuple[Problem, Flags]:
    """Return the problem of some of the plates, and which of all bearings (c,) are on them."""
    if len(numbers) == len(problem.plate.names):
        return problem, np.ones(len(problem.contact.bearing.law), dtype=bool)
    elements = np.isin(problem.plate.number, numbers)
    nodes = unique_integers(problem.mesh.elements[problem.plate.elements[elements]])[0]
    held = np.isin(problem.contact.bearing.node, nodes)
    load = np.zeros_like(problem.load)
    load[nodes] = problem.load[nodes]
    restricted = replace(
        problem,
        plate=replace(
            problem.plate,
            elements=problem.plate.elements[elements],
            nodes=nodes,
            number=np.searchsorted(numbers, problem.plate.number[elements]),
            names=tuple(problem.plate.names[number] for number in numbers),
        ),
        contact=replace(problem.contact, bearing=problem.contact.bearing.select(held)),
        links=problem.links.select(np.asarray(np.isin(problem.links.nodes, nodes).all(axis=1))),
        loading=replace(problem.loading, load=load, size=problem.loading.size[list(numbers)]),
        elastic=None if problem.elastic is None else problem.elastic.under(numbers),
    )
    return restricted, held


def settlement_by_loads_beside(problem: Problem, places: Array) -> Array:
    """Return what loads beside the plate settle an elastic continuum at places (p, 2), (p,) [m]."""
    beside = problem.loading.beside
    if problem.elastic is None or not len(beside):
        return np.zeros(len(places))
    return problem.elastic.settle_by(beside[:, 2], beside[:, :2], places)
