"""Fields of a coarser mesh at the nodes of a finer one, by the shape functions of the elements."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.assembly import scatter
from groundslab.fem.mesh import Mesh, local_coordinates, locate_nearest
from groundslab.fem.shape_functions import q9
from groundslab.results.recovery import MeshedFields
from groundslab.results.result_mesh import ResultMesh
from groundslab.solvers.solution import Solution

#: What belongs to the nodes of a mesh, not to what is computed on it.
OF_THE_MESH = ("area", "edge_length")


def prolong(
    fields: MeshedFields, coarse: Solution, frames: tuple[ResultMesh, ResultMesh], fine: Solution
) -> MeshedFields:
    """Return fields of a solution on a coarser mesh as fields of a finer one of the same problem.

    frames are the meshes of results of both, the coarser one first. Where meshes are nested, nothing is averaged across
    borders of sections, loads or supports.
    """
    own, target = frames
    where = _places(own.mesh, target.mesh)

    def nodal(field: Array) -> Array:
        return _mean(target.mesh, _values(field[own.mesh.elements], where))

    found = {name: nodal(field) for name, field in fields.nodal.items() if name not in OF_THE_MESH}
    found["in_contact"] = (found["in_contact"] > 0.5).astype(np.float64)
    share = fields.nodal["contact_area"] / fields.nodal["area"]
    found["contact_area"] = np.clip(nodal(share), 0, 1) * target.area
    found["line_force"] = np.where(target.edge_length > 0, found["line_force"], 0.0)
    found |= {"area": target.area, "edge_length": target.edge_length}
    center = where[0][:, 8]
    meshes = coarse.system.problem.mesh, fine.system.problem.mesh
    on_ground = _places(*meshes)
    surfaces = [_mean(meshes[1], _values(w[meshes[0].elements], on_ground)) for w in fields.surfaces]
    return MeshedFields(
        forces=np.stack([_values(fields.forces[..., k], where) for k in range(fields.forces.shape[2])], axis=-1),
        nodal=found,
        elements={name: field[center] for name, field in fields.elements.items()},
        surfaces=np.array(surfaces),
    )


def _places(coarse: Mesh, fine: Mesh) -> tuple[Integers, Array]:
    """Return in which element of a coarser mesh the nodes of a finer one's elements lie (m, 9), and where (m, 9, 2).

    All nodes of an element lie in the element that holds its center; where meshes are not nested, a little outside.
    """
    parent = np.repeat(locate_nearest(coarse, fine.xy[:, 8])[0], 9)
    place = local_coordinates(coarse.xy[parent], fine.xy.reshape(-1, 2))
    return parent.reshape(-1, 9), place.reshape(-1, 9, 2)


def _values(nodal: Array, where: tuple[Integers, Array]) -> Array:
    """Return values (m, 9) at places in elements from values at the nodes of these (c, 9)."""
    element, place = where
    N = q9(place.reshape(-1, 2))[0].reshape(*element.shape, 9)
    values: Array = np.einsum("eba,eba->eb", N, nodal[element])
    return values


def _mean(mesh: Mesh, values: Array) -> Array:
    """Return nodal values (n,) from those of elements (m, 9)."""
    n = len(mesh.nodes)
    mean: Array = scatter(mesh.elements, values, n) / np.bincount(mesh.elements.ravel(), minlength=n)
    return mean
