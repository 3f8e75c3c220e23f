"""The arrays that an analysis works on.

Fields of a node: W, BETA_X, BETA_Y of the plate; TOP, which is the settlement of the ground's surface, under the plate
relative to the plate's; then the settlements of the lower surfaces. Under the plate w_0 = w + h, and the gap is h + g0.
Where joints have play, their slip at nodes of the second plate comes last. What bears on single unknowns (the ground
where the plate may lift off, supports, the ends of the play) stands beside the matrix.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.fem import plate
from groundslab.fem.bearings import Bearings, Links
from groundslab.fem.concrete.cracked_section import CrackedSections
from groundslab.fem.continuum.elastic_ground import ElasticGround
from groundslab.fem.foundation import Column
from groundslab.fem.mesh import Mesh
from groundslab.fem.shape_functions import unique_integers
from groundslab.fem.vlasov import Soil

W, BETA_X, BETA_Y, TOP = range(4)
#: Shares of an element's area that differ by less than this are equal.
TIE = 1e-6
#: The middles of an element's sides.
MIDSIDES = slice(4, 8)


@dataclass(frozen=True, slots=True)
class Loading:
    """What acts together: forces, the curvature that temperature or shrinkage would give, settlements of supports."""

    load: Array  # (n, F) [N, N m]: in TOP those on the ground's surface beside the plate
    free_curvature: Array  # (mp, 2) [1/m]: beta_x,x and beta_y,y that each plate element would take freely
    settlement: Array  # (s,) [m]: of each support
    size: float  # [N]: sizes of all forces on the plate, and of moments over its length, whatever they cancel
    beside: Array  # (f, 3): places x, y [m] and forces [N] of what presses an elastic continuum beside the plate

    def __add__(self, other: Loading) -> Loading:
        """Return the sum of two loadings."""
        return Loading(
            self.load + other.load,
            self.free_curvature + other.free_curvature,
            self.settlement + other.settlement,
            self.size + other.size,
            np.vstack([self.beside, other.beside]),
        )

    def scale(self, factor: float) -> Loading:
        """Return the loading multiplied by a factor."""
        many = factor * self.load, factor * self.free_curvature, factor * self.settlement
        return Loading(*many, abs(factor) * self.size, self.beside * [1.0, 1.0, factor])


@dataclass(frozen=True, slots=True)
class Bearing:
    """All that bears on single unknowns: first the gap of each plate node; then bottoms of voids; then the supports."""

    law: Bearings  # (c,); levels without settlements of the supports
    node: Integers  # (c,)
    field: Integers  # (c,): W, BETA_X, BETA_Y or TOP
    support: Integers  # (c,): number of the support, -1 for the ground
    length: Array  # (c,) [m]: the share of a line support, 0 for all else
    depth: Integers  # (c,): at which of the depths the ground lies; 0 for supports

    def select(self, which: Flags) -> Bearing:
        """Return some of the bearings by a mask (c,)."""
        others = (getattr(self, each.name)[which] for each in fields(self) if each.name != "law")
        return Bearing(self.law.select(which), *others)


def largest_share(share: Array) -> Integers:
    """Return which depth has the largest of the shares (m, d), of equal ones, but for rounding, the deepest."""
    largest: Integers = np.argmax(share + TIE * np.arange(share.shape[1]), axis=1)
    return largest


@dataclass(frozen=True, slots=True)
class Depths:
    """How deep the ground lies under the plate, by the parts of elements that voids take.

    The gap of a node is that of the least depth among its elements. Ground without shear can lie deeper beside it: that
    part bears by itself. Where it does, an element's mass matrix gives way to one that is diagonal.
    """

    depth: Array  # (d,) [m], ascending: 0 first, infinite for cavities
    area_fraction: Array  # (mp, d): of each plate element
    shallowest: Integers  # (n,): number of the least depth at each node
    area: Array  # (n, d) [m2]: each node's share of the area in each depth
    mass_kinds: Array  # (k, 10): factor on the mass matrix, and share of each node's area on the diagonal
    mass_kind: Integers  # (m,): which of these each element has
    stepped: bool  # whether the ground is without shear, so that depths may differ within an element

    @property
    def dominant(self) -> Integers:
        """Return the number of the depth that takes most of each plate element, (mp,)."""
        return largest_share(self.area_fraction)

    def at_shallowest(self, values: Array, nodes: Integers) -> Array:
        """Return the values (n, d) for the least depth at some nodes (k,)."""
        return values[nodes, self.shallowest[nodes]]


@dataclass(frozen=True, slots=True)
class Problem:
    """One mesh with everything on it, in SI units. n nodes, m elements, F fields, S surfaces of the ground."""

    mesh: Mesh
    plate_elements: Integers  # (mp,)
    plate_nodes: Integers  # (np,), ascending
    element: plate.PlateElement
    bending: Array  # (k, 3, 3) [N m]: rigidities of the plate's sections, or of its elements where these have cracked
    shear: Array  # (k,) [N/m]
    rigidity: Integers  # (mp,): which of these each plate element has
    section: Integers  # (mp,): number of each plate element's section: 0 outside all zones, else the zone's, from 1
    plate_number: Integers  # (mp,): which of several plates it belongs to
    plate_names: tuple[str, ...]
    thickness: Array  # (mp,) [m]: of each plate element
    ground: Soil | Column
    constants: tuple[Array, Array]  # (L,) each: k0 [Pa/m] and k1 [Pa m], means under the plate; of soil, nothing
    rank: Integers  # (n,): order of elimination of the nodes
    unknown: Integers  # (n, F): number of each unknown, -1 where there is none or it is held at zero
    surfaces: int  # S; their fields may be followed by slips of joints that have play
    cases: tuple[Loading, ...]  # the load cases by themselves
    loading: Loading  # what is to be solved for
    initial_gap: Array  # (n,) [m]
    depths: Depths
    bearing: Bearing
    tensionless: bool
    limit_pressure: float  # [Pa]; infinite if there is none
    plate_edges: Integers  # (b, 3): sides of the plate's edge, openings' too; the plate lies to the left
    shear_at_edges: bool  # whether the ground carries shear, so that a line force acts along them, too
    links: Links  # across joints between plates
    edges: Integers  # (e, 3): end, end and middle node of each outer side on which infinite ground follows
    corners: Integers  # (c,): nodes at which two such edges meet
    symmetry: tuple[bool, bool]
    cracking: CrackedSections | None = None  # how the plate's elements crack, if they do
    elastic: ElasticGround | None = None  # bears the plate, instead of columns, whose constants are zero then
    stiffness: Array | None = None  # (mp, 2) [N m2/m]: of elements that have cracked, along x and y

    @property
    def load(self) -> Array:
        """Return the nodal loads (n, F) [N, N m]; what presses on the ground at the plate's edge is in W and in TOP."""
        return self.loading.load

    @property
    def plate_load(self) -> Array:
        """Return the nodal loads on the plate alone (n, 3) [N, N m]."""
        load = self.loading.load[:, :TOP].copy()
        load[self.plate_nodes, W] -= self.loading.load[self.plate_nodes, TOP]
        return load

    def nodes_of(self, plate: int) -> Integers:
        """Return the nodes of one of the plates, ascending."""
        return unique_integers(self.mesh.elements[self.plate_elements[self.plate_number == plate]])[0]

    def combine(self, factors: Array) -> Problem:
        """Return the problem under the sum of its load cases times factors (cases,)."""
        first, *others = (case.scale(factor) for case, factor in zip(self.cases, factors, strict=True) if factor != 0)
        return replace(self, loading=sum(others, first))


def plate_unknowns(problem: Problem, U: Array) -> Array:
    """Return w, beta_x and beta_y of each plate element (mp, 27) from U (n, F), less the plane that fits best.

    Strains are the same; stiffness times what a nearly rigid plate moves as a whole would be rounding alone.
    """
    motions, elements = planes(problem), problem.mesh.elements[problem.plate_elements]
    corners = elements[:, :4].ravel()
    plane = np.linalg.lstsq(motions[corners, W], U[corners, W], rcond=None)[0]
    moved = U[:, :TOP] - motions @ plane
    u: Array = np.concatenate([moved[elements, field] for field in (W, BETA_X, BETA_Y)], axis=1)
    return u


def planes(problem: Problem) -> Array:
    """Return the rigid motions w = 1, x, y of each plate as W, BETA_X and BETA_Y at every node, (n, 3, 3 plates).

    Of a single plate they are continued beyond it; of several each has its own.
    """
    nodes = problem.mesh.nodes
    x, y = nodes.T
    motions = np.zeros((len(nodes), TOP, 3))
    motions[:, W] = np.column_stack([np.ones_like(x), x, y])
    motions[:, BETA_X, 1] = motions[:, BETA_Y, 2] = 1.0
    if len(problem.plate_names) == 1:
        return motions
    every = np.zeros((len(nodes), TOP, 3 * len(problem.plate_names)))
    for number in range(len(problem.plate_names)):
        own = problem.nodes_of(number)
        every[own, :, 3 * number : 3 * number + 3] = motions[own]
    return every


def single_plates(problem: Problem) -> list[tuple[Problem, Flags]]:
    """Return each plate by itself, with the loads and bearings on it, and which of all bearings (c,) these are."""
    return [_restrict(problem, (number,)) for number in range(len(problem.plate_names))]


def joined_plates(problem: Problem) -> list[tuple[Problem, Flags]]:
    """Return the plates that joints hold to each other together, each other one by itself, as `single_plates`."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    count, links = len(problem.plate_names), problem.links
    plate = np.full(len(problem.mesh.nodes), -1)
    plate[problem.mesh.elements[problem.plate_elements]] = problem.plate_number[:, None]
    one, other = plate[links.nodes[links.holds]].T
    groups = connected_components(coo_array((np.ones(len(one)), (one, other)), shape=(count, count)), directed=False)[1]
    return [_restrict(problem, tuple(np.flatnonzero(groups == n).tolist())) for n in range(groups.max() + 1)]


def _restrict(problem: Problem, numbers: tuple[int, ...]) -> tuple[Problem, Flags]:
    """Return the problem of some of the plates, and which of all bearings (c,) are on them."""
    if len(numbers) == len(problem.plate_names):
        return problem, np.ones(len(problem.bearing.law), dtype=bool)
    elements = np.isin(problem.plate_number, numbers)
    nodes = unique_integers(problem.mesh.elements[problem.plate_elements[elements]])[0]
    held = np.isin(problem.bearing.node, nodes)
    load = np.zeros_like(problem.load)
    load[nodes] = problem.load[nodes]
    own = replace(
        problem,
        plate_elements=problem.plate_elements[elements],
        plate_nodes=nodes,
        plate_number=np.searchsorted(numbers, problem.plate_number[elements]),
        plate_names=tuple(problem.plate_names[number] for number in numbers),
        bearing=problem.bearing.select(held),
        links=problem.links.select(np.asarray(np.isin(problem.links.nodes, nodes).all(axis=1))),
        loading=replace(problem.loading, load=load),
        elastic=None if problem.elastic is None else problem.elastic.under(numbers),
    )
    return own, held


def settlement_by_loads_beside(problem: Problem, places: Array) -> Array:
    """Return what loads beside the plate settle an elastic continuum at places (p, 2), (p,) [m]."""
    beside = problem.loading.beside
    if problem.elastic is None or not len(beside):
        return np.zeros(len(places))
    return problem.elastic.settle_by(beside[:, 2], beside[:, :2], places)
