"""The building of a model on a mesh: the frame condensed to its bases, and the nodes over which these stand."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.discretize.frame import condensed
from groundslab.discretize.plan_layout import Layout
from groundslab.fem import load_vectors, plate
from groundslab.fem.assembly import scatter
from groundslab.fem.hanging import collect, find_hanging
from groundslab.fem.parts.building import FIELDS, Building
from groundslab.geometry.plan import FLAT
from groundslab.model.loads.acting import PointForce
from groundslab.model.model import Model
from groundslab.model.structure import building as described
from groundslab.model.structure.building import IN_A_ROW, Base, motions_of

if TYPE_CHECKING:
    from scipy.sparse import csr_array


def building_on(model: Model, plan: Layout, element: plate.PlateElement, present: Flags) -> Building | None:
    """Return the building of a model on its mesh; its unknowns are fields beyond those that are present (n, F)."""
    if model.building is None:
        return None
    every = bases_of(model)
    K, per_base = stiffness_of(model), _motions_of_each(model)
    length = max(model.sides)
    base, way = np.divmod(np.arange(len(K)), per_base)
    spread = _spread(every, plan, element, base, way, length)
    host, field = _hosts(plan, len(base), present.shape[1])
    K = _of_motions(K, np.where(way == 0, 1.0, length))
    return Building(tuple(base.name for base in every), base, way, spread, K, host, field, length)


def motion_stiffness(model: Model, building: Building, storeys: int) -> Array:
    """Return the stiffness (k, k) [N/m] of the lowest storeys alone between the motions of a building."""
    return _of_motions(stiffness_of(model, storeys), np.where(building.way == 0, 1.0, building.length))


def _of_motions(K: Array, lever: Array) -> Array:
    """Return the stiffness between motions, slopes by what they settle at a lever [m]."""
    scaled: Array = K / np.outer(lever, lever)
    return scaled


def with_building(present: Flags, building: Building | None) -> Flags:
    """Return which unknowns exist (n, F), with those of a building."""
    if building is None:
        return present
    extended = np.pad(present, ((0, 0), (0, int(building.field.max()) + 1 - present.shape[1])))
    extended[building.host, building.field] = True
    return extended


def bases_of(model: Model) -> tuple[Base, ...]:
    """Return where the building of a model stands."""
    assert model.building is not None
    chord = FLAT * max(model.sides)
    return described.bases(model.building, model.columns, model.walls, model.every_plate, chord)


def _hosts(plan: Layout, count: int, fields: int) -> tuple[Integers, Integers]:
    """Return nodes, and fields beyond so many, for a building's unknowns: the nodes that are eliminated last."""
    free = np.ones(len(plan.mesh.nodes), dtype=bool)
    free[find_hanging(plan.mesh.elements)[:, 0]] = False
    last = np.flatnonzero(free)
    last = last[np.argsort(-plan.rank[last])]
    number = np.arange(count)
    return last[number % len(last)], fields + number // len(last)


def _spread(
    every: Sequence[Base], plan: Layout, element: plate.PlateElement, base: Integers, way: Integers, length: float
) -> csr_array:
    """Return the nodal forces (3 n, k) of a unit force, or of a couple of the unit force times a length, on each base.

    The same pressures on footprints as those of loads on columns.
    """
    from scipy.sparse import coo_array

    mesh, n = plan.mesh, len(plan.mesh.nodes)
    node, motion, force = list[Integers](), list[Integers](), list[Array]()
    for number, foot in enumerate(every):
        part = foot.footprint
        elements = np.intersect1d(load_vectors.find_elements_near(mesh, part), plan.plate_elements)
        which = np.flatnonzero(base == number)
        table = np.zeros((n, len(which)))
        for column, direction in enumerate(way[which].tolist()):
            M = (length * (direction == 1), length * (direction == 2))
            pressure = PointForce(foot.place, float(direction == 0), M).pressure(part)
            forces = load_vectors.integrate_over_polygon(mesh, elements, part, pressure)
            if not element.center_w:
                forces = np.einsum("ea,eab->eb", forces, element.w_functions(mesh.xy[elements]))
            table[:, column] = scatter(mesh.elements[elements], forces, n)
        table = collect(mesh.elements, table)
        at, column_of = np.nonzero(table)
        node.append(at)
        motion.append(which[column_of])
        force.append(table[at, column_of])
    places = FIELDS * np.concatenate(node), np.concatenate(motion)
    return coo_array((np.concatenate(force), places), shape=(FIELDS * n, len(base))).tocsr()


def _motions_of_each(model: Model) -> int:
    """Return how many motions each base has: settlement alone, or slopes, too."""
    assert model.building is not None
    building = model.building
    return len(building.matrix) // len(building.nodes) if building.matrix else FIELDS


def stiffness_of(model: Model, storeys: int | None = None) -> Array:
    """Return the stiffness between bases, in N and m, of a frame that of its lowest storeys alone if these are named.

    What resists motions of everything together is rounding, or digits of a printed matrix, and is left out.
    """
    above = model.building
    assert above is not None
    every = bases_of(model)
    K = above.K if above.matrix else above.stiffness * condensed(above, every, storeys or len(above.storeys))
    # of bases in a row that only settle a tilt across it is none
    directions, sizes, _ = np.linalg.svd(motions_of(every, _motions_of_each(model)), full_matrices=False)
    Q = directions[:, sizes > IN_A_ROW * sizes.max()]
    rest = np.eye(len(K)) - Q @ Q.T
    projected: Array = rest @ K @ rest
    return (projected + projected.T) / 2
