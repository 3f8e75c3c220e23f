"""Footprints of loads that are too small for the mesh: elements that do not see them cannot tell their error either."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.fem.mesh import Mesh, locate_nearest
from groundslab.fem.shape_functions import areas
from groundslab.model.loads.load_types import PointLoad
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
    model, mesh = results.solved_model, Mesh(results.plate.nodes, results.plate.elements)
    found, least = [], min(plate.thickness for plate in model.every_plate)
    for load in (each.on(model.columns) for each in model.loads if isinstance(each, PointLoad)):
        sides = [side for side in (load.width_x, load.width_y, load.diameter) if side]
        found.append((load.x, load.y, min(sides, default=least)))
    found += [(each.x, each.y, least) for each in model.supports if each.kind != "line"]
    if not found:
        return None
    x, y, side = np.array(found, dtype=float).T
    element = np.sqrt(areas(mesh.xy[locate_nearest(mesh, np.column_stack([x, y]))[0]]))
    worst = int(np.argmax(element / side))
    if element[worst] <= RESOLVED * side[worst]:
        return None
    return Unresolved(int((element > RESOLVED * side).sum()), float(side[worst]), float(element[worst]))
