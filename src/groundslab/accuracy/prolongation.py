"""Fields of a coarser mesh at the nodes of a finer one, by the shape functions of the elements."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.mesh import Mesh, local_coordinates, locate_nearest
from groundslab.fem.shape_functions import q9_values
from groundslab.results.mirroring import ResultMesh
from groundslab.results.recovery import MeshedFields

if TYPE_CHECKING:
    from scipy.sparse import csr_array

#: What belongs to the nodes of a mesh, not to what is computed on it.
OF_THE_MESH = ("area", "edge_length")
#: What contact bounds from below: parabolas between the coarser nodes may overshoot the least of their values.
OF_CONTACT = ("gap", "penetration", "pressure", "line_force")


@dataclass(frozen=True, slots=True)
class Prolongation:
    """What takes fields from a coarser mesh to a finer one of the same problem, shared by all combinations."""

    coarser: ResultMesh
    finer: ResultMesh
    plate: csr_array  # (k, kc): from nodal values to those at the finer nodes of the plate
    ground: csr_array  # (n, nc)
    element: Integers  # (mp,): the coarser element in which the center of each element of the plate lies

    def apply(self, fields: MeshedFields) -> MeshedFields:
        """Return fields on the coarser mesh as fields on the finer one, without section forces of elements."""
        names = [name for name in fields.nodal if name not in OF_THE_MESH]
        columns = np.column_stack([fields.nodal[name] for name in names])
        prolonged = dict(zip(names, (self.plate @ columns).T, strict=True))
        prolonged |= {name: np.maximum(prolonged[name], fields.nodal[name].min()) for name in OF_CONTACT}
        prolonged["in_contact"] = (prolonged["in_contact"] > 0.5).astype(np.float64)
        touches = fields.nodal["contact_area"]
        share = np.clip(self.plate @ (touches / fields.nodal["area"]), 0, 1) * self.finer.area
        prolonged["contact_area"] = share * (touches.sum() / share.sum()) if share.any() else share
        prolonged["line_force"] = np.where(self.finer.edge_length > 0, prolonged["line_force"], 0.0)
        return MeshedFields(
            forces=np.zeros((0, 9, 5)),
            nodal=prolonged | {"area": self.finer.area, "edge_length": self.finer.edge_length},
            elements={name: field[self.element] for name, field in fields.elements.items()},
            surfaces=(self.ground @ fields.surfaces.T).T,
            cells=fields.cells,
        )


def make_prolongation(coarser: ResultMesh, finer: ResultMesh, ground: tuple[Mesh, Mesh]) -> Prolongation:
    """Return what takes fields of plate and ground from a coarser mesh to a finer one.

    ground are the meshed parts of the ground, the coarser one first. Where the meshes are nested, nothing is taken
    across borders of sections, loads or supports.
    """
    plates = coarser.mesh, finer.mesh
    plate, element = _interpolation(*plates)
    alone = all(np.array_equal(a.elements, b.elements) for a, b in zip(plates, ground, strict=True))
    return Prolongation(coarser, finer, plate, plate if alone else _interpolation(*ground)[0], element)


def _interpolation(coarse: Mesh, fine: Mesh) -> tuple[csr_array, Integers]:
    """Return the matrix from values at coarser nodes to those at finer ones, and the coarser element of each finer one.

    A node lies in the coarser element that holds the center of one of its elements; where meshes are not nested, a
    little outside.
    """
    from scipy.sparse import csr_array

    parent = locate_nearest(coarse, fine.xy[:, 8])[0]
    owner = np.empty(len(fine.nodes), dtype=np.int64)
    owner[fine.elements] = np.arange(len(fine.elements))[:, None]
    element = parent[owner]
    N: Array = q9_values(local_coordinates(coarse, element, fine.nodes))
    nodes = coarse.elements[element]
    shape = len(fine.nodes), len(coarse.nodes)
    return csr_array((N.ravel(), nodes.ravel(), np.arange(0, nodes.size + 1, 9)), shape=shape), parent
