"""Nine-node meshes of plans: grids where everything runs along x and y, else quadrilaterals from Gmsh or Netgen.

They make a mesh of twice the required size, whose triangles and quadrilaterals are then cut into smaller
quadrilaterals here. Nodes on arcs, midside nodes too, are put exactly on them.
"""

from __future__ import annotations

from contextlib import suppress

from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import Plan, sections
from groundslab.meshing import quadrangulation, sizing
from groundslab.meshing.backends import Maker, available, choose, with_netgen
from groundslab.meshing.cells import Cells
from groundslab.meshing.grid import rectilinear
from groundslab.meshing.plan_mesh import PlanMesh, check, check_area, finish, on_bounds
from groundslab.meshing.quality import quality
from groundslab.meshing.sizing import LocalExtents

__all__ = ["available", "choose", "mesh", "quality", "unstructured", "with_netgen"]

#: A mesh whose least scaled Jacobian exceeds this is good; else the next one that the maker has is looked at.
ENOUGH = 0.35
#: From the second on, one whose least exceeds this will do: triangles, which come last, become many more elements.
USABLE, SECOND = 0.2, 2
#: Such a next mesh takes the place of the one before if its least scaled Jacobian is larger by this.
CLEARLY = 0.05
#: Smaller elements in places make a grid of lines through the whole plan if it has no more than this many times the
#: elements that would do, or no more than the mesh that a maker has for them.
FEW = 1.5


def mesh(
    plan: Plan,
    size: float,
    beyond_growth: float | None = None,
    maker: Maker | None = None,
    edge_size: float | None = None,
    local: LocalExtents | None = None,
    across: int = sizing.ACROSS,
) -> PlanMesh:
    """Return a mesh with sides of at most about `size` [m], smaller where the plan requires it.

    On the ground beyond, elements grow: at `beyond_growth` [m] from the plate they are twice as large (default: half
    the plate's longer side). Along the plate's edges on this ground, on both sides, they are at most `edge_size` [m]
    (default: `size`); near the places `local` at most of the extents there, from where they grow. Narrow places have
    `across` elements across. Where a grid does
    not fit, or would have more elements, `maker` makes the cells (default: what `choose` returns).
    """
    if local is not None and not (local[1] < size).any():
        local = None
    if not plan.rectilinear:
        return unstructured(plan, size, beyond_growth, maker, edge_size, local, across)
    if local is None or not available():
        return rectilinear(plan, size, beyond_growth, edge_size, local)
    try:
        found = rectilinear(plan, size, beyond_growth, edge_size, local)
    except InputError:  # of too many elements
        return unstructured(plan, size, beyond_growth, maker, edge_size, local, across)
    needed = sizing.join(sizing.sources(plan, size, edge_size or size, across), sizing.isotropic(local))
    if len(found.elements) <= FEW * sizing.estimate_count(plan, size, needed):
        return found
    with suppress(InputError):
        other = unstructured(plan, size, beyond_growth, maker, edge_size, local, across)
        if len(other.elements) < len(found.elements):
            return other
    return found


def unstructured(
    plan: Plan,
    size: float,
    beyond_growth: float | None = None,
    maker: Maker | None = None,
    edge_size: float | None = None,
    local: LocalExtents | None = None,
    across: int = sizing.ACROSS,
) -> PlanMesh:
    """Return a mesh of quadrilaterals that follows every edge of a plan, straight or arc."""
    check(plan, size)
    scale = sizing.growth_distance(plan, beyond_growth)
    make = choose() if maker is None else maker
    best = None
    refused = InputError([Issue("plan", "a plan of which the mesher makes nothing", "one that can be meshed")])
    smaller = sizing.sources(plan, size, edge_size or size, across)
    elsewhere = None
    if local is not None:
        places, sizes = sizing.isotropic(local)
        elsewhere = places[sizes < size], sizes[sizes < size]
    for tried, cells in enumerate(make(plan, size, smaller, scale, elsewhere), start=1):
        try:
            result = _quadrilaterals(plan, cells)
        except InputError as error:
            refused = error
            continue
        if best is None or result.quality.worst > best.quality.worst + CLEARLY:
            best = result
        if best.quality.worst > (ENOUGH if tried < SECOND else USABLE):
            break
    if best is None:
        raise refused
    return best


def _quadrilaterals(plan: Plan, cells: Cells) -> PlanMesh:
    """Return cells cut into good nine-node quadrilaterals, or say that there are bad ones."""
    nodes, elements = quadrangulation.make_elements(cells)
    result = finish(plan, on_bounds(plan, nodes), elements, sections(plan, nodes[elements[:, 8]]))
    check_area(plan, result)
    return result
