"""Smaller elements in places: those of a coarser mesh, cut into four again and again; nodes hang beside them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from groundslab.fem.hanging import find_hanging
from groundslab.fem.mesh import Mesh, sides_along
from groundslab.fem.shape_functions import areas
from groundslab.geometry.plan import Plan
from groundslab.meshing.plan_mesh import PlanMesh, finish
from groundslab.meshing.refinement import close, split
from groundslab.meshing.sizing import Sources, limit_of

#: Elements grow by this share of the distance from where smaller ones are required; where the mesh is made for an
#: accuracy, which says what else must be small, by more.
SLOPE, STEEP = 0.2, 0.5
#: An element is cut if it is so many times as large as required: its parts are then as much too small.
TOO_LARGE = 2**0.5
#: Elements are cut at most so often.
MOST_TIMES = 12


def divide(plan: Plan, plan_mesh: PlanMesh, size: float, local: Sources | None, slope: float = SLOPE) -> PlanMesh:
    """Return a mesh whose elements are cut up where they are larger than local sizes allow.

    Nothing hangs on edges, lines and arcs of the plan: what lies on both sides of them is cut alike. Along arcs, where
    the shear forces of a ring load are all alike, elements are, too: these oscillate where sides of different lengths
    meet.
    """
    borders = [edge for ring in plan.borders for edge in ring.segments()]
    # a border may lie along an edge of a plate, such as a joint
    edges = [edge for ring in replace(plan, borders=()).rings().values() for edge in ring.segments()]
    edges += plan.line_segments()
    arcs = [edge for edge in edges + borders if not edge.straight]
    rings = [edge for edge in borders if not edge.straight]
    limit = None if local is None else limit_of(local, size, slope)
    mesh, section = Mesh(plan_mesh.nodes, plan_mesh.elements), plan_mesh.section
    for _ in range(MOST_TIMES):
        marked = np.zeros(len(mesh.elements), dtype=bool)
        if limit is not None:
            marked = np.sqrt(areas(mesh.xy)) > TOO_LARGE * limit(mesh.xy[:, 8])
        along = sides_along(mesh, mesh.elements, rings)
        whole = np.concatenate([along[:, 2], sides_along(mesh, mesh.elements, edges)[:, 2]])
        _, near, middle, far = find_hanging(mesh.elements).T
        meets = np.isin(middle, whole) | np.isin(near, along) | np.isin(far, along)
        marked |= np.isin(mesh.elements[:, 4:8], middle[meets]).any(axis=1)
        if not marked.any():
            break
        mesh, parent = split(mesh, close(mesh, marked, whole), arcs)
        section = section[parent]
    return finish(plan, mesh.nodes, mesh.elements, section)
