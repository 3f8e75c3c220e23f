"""Footprints of loads that are too small for the mesh: elements that do not see them cannot tell their error either."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.fem.mesh import Mesh, locate_nearest
from groundslab.fem.shape_functions import areas
from groundslab.model.loads.acting import PointForce
from groundslab.results.results import CombinationResult

#: A footprint is resolved by elements up to so many times as long as its shorter side.
RESOLVED = 1.5


@dataclass(frozen=True, slots=True)
class Unresolved:
    """How many footprints the mesh does not resolve, and side of footprint and element where it is worst [m]."""

    count: int
    footprint: float
    element: float


def find_unresolved(results: CombinationResult) -> Unresolved | None:
    """Return what the mesh does not resolve of the footprints of forces and supports, None if it resolves all.

    Without a footprint they count as if they had one of a thickness, over which moments are means.
    """
    model = results.solved_model
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    thinnest = min(plate.thickness for plate in model.every_plate)
    forces = [shape for _, shape in model.acting if isinstance(shape, PointForce)]
    footprints = [(*force.place, min(force.ring.sides) if force.ring else thinnest) for force in forces]
    footprints += [(*support.points[0], thinnest) for support in model.supports if not support.edges]
    if not footprints:
        return None
    x, y, side = np.array(footprints, dtype=float).T
    element = np.sqrt(areas(mesh.xy[locate_nearest(mesh, np.column_stack([x, y]))[0]]))
    worst = int(np.argmax(element / side))
    if element[worst] <= RESOLVED * side[worst]:
        return None
    return Unresolved(int((element > RESOLVED * side).sum()), float(side[worst]), float(element[worst]))
