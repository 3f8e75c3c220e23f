"""Nine-node meshes of plans: grids where everything runs along x and y, else quadrilaterals from Gmsh.

Gmsh is asked for a mesh of twice the wanted size, whose triangles and quadrilaterals are then cut into smaller
quadrilaterals here. Nodes on arcs, midside nodes too, are put exactly on them.
"""

from __future__ import annotations

from groundslab.mesher.door import session
from groundslab.mesher.drawing import cells_of
from groundslab.mesher.grids import rectilinear
from groundslab.mesher.jacobians import Quality, quality
from groundslab.mesher.planmesh import PlanMesh, check, check_area, finished
from groundslab.mesher.quads import all_quadrilaterals, mend, nine_nodes, smoothed, without_flat_corners
from groundslab.mesher.sizes import doubling, sources
from groundslab.plan import Plan, sections

__all__ = ["PlanMesh", "Quality", "mesh", "quality", "rectilinear", "sources", "unstructured"]


def mesh(plan: Plan, size: float, beyond_growth: float | None = None) -> PlanMesh:
    """Return a mesh with sides of at most about `size` [m], smaller where the plan asks for it.

    On the ground beyond, elements grow: at `beyond_growth` [m] from the plate they are twice as large (default: half
    the plate's longer side).
    """
    return rectilinear(plan, size, beyond_growth) if plan.rectilinear else unstructured(plan, size, beyond_growth)


def unstructured(plan: Plan, size: float, beyond_growth: float | None = None) -> PlanMesh:
    """Return a mesh of quadrilaterals that follows every edge of a plan, straight or arc."""
    check(plan, size)
    places, sizes = sources(plan, size)
    with session() as gmsh:
        cells = cells_of(gmsh, plan, size, (places, sizes), doubling(plan, beyond_growth))
    nodes, quadrilaterals, drawn = all_quadrilaterals(without_flat_corners(cells))
    nodes = smoothed(nodes, quadrilaterals, drawn)
    mend(nodes, quadrilaterals, drawn)
    nodes, elements = nine_nodes(nodes, quadrilaterals, drawn)
    result = finished(nodes, elements, sections(plan, nodes[elements[:, 8]]))
    check_area(plan, result)
    return result
