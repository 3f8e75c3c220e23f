"""Nine-node meshes of plans: grids where everything runs along x and y, else quadrilaterals from Gmsh or Netgen.

They make a mesh of twice the required size, whose triangles and quadrilaterals are then cut into smaller
quadrilaterals here; for an accuracy only its triangles. Nodes on arcs, midside nodes too, are put exactly on them.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from itertools import islice

from groundslab.arrays import Array, Integers
from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import Plan
from groundslab.geometry.regions import sections
from groundslab.meshing import quadrangulation, sizing
from groundslab.meshing.backends import Maker, available, choose, with_netgen
from groundslab.meshing.grid import rectilinear
from groundslab.meshing.plan_mesh import PlanMesh, check, check_area, finish, on_bounds
from groundslab.meshing.quality import quality
from groundslab.meshing.sizing import Sources
from groundslab.meshing.splitting import STEEP, divide

__all__ = ["adaptable", "available", "choose", "mesh", "quality", "unstructured", "with_netgen"]

#: A mesh whose least scaled Jacobian exceeds this is good; else the next one that the maker has is looked at.
ENOUGH = 0.35
#: From the second on, one whose least exceeds this will do: triangles, which come last, become many more elements.
USABLE, SECOND = 0.2, 2
#: Such a next mesh takes the place of the one before if its least scaled Jacobian is larger by this.
CLEARLY = 0.05
#: So many meshes of a maker are looked at whose cells are not cut, and used if their least exceeds this.
WHOLE, POOR = 2, 0.12
#: Across narrow places they have so many cells as long as wide: one, twice as long.
NARROW = 0.5


def mesh(
    plan: Plan,
    size: float,
    beyond_growth: float | None = None,
    maker: Maker | None = None,
    edge_size: float | None = None,
    local: Sources | None = None,
    across: float = sizing.ACROSS,
) -> PlanMesh:
    """Return a mesh with sides of at most about `size` [m], smaller where the plan requires it.

    On the ground beyond, elements grow: at `beyond_growth` [m] from the plate they are twice as large (default: half
    the plate's longer side). Along the plate's edges on this ground, on both sides, they are at most `edge_size` [m]
    (default: `size`). Where no grid fits, `maker` makes the cells (default: what `choose` returns), `across` of them
    across narrow places. Near the places `local` elements have at most the sizes there, from where they grow.
    """
    if local is not None and not (local[1] < size).any():
        local = None
    if not plan.rectilinear:
        meshed = unstructured(plan, size, beyond_growth, maker, edge_size, across)
    else:
        meshed = rectilinear(plan, size, beyond_growth, edge_size)
    return meshed if local is None else divide(plan, meshed, size, local)


def adaptable(plan: Plan, size: float, edge_size: float, local: Sources | None) -> PlanMesh:
    """Return a mesh with as few elements as the plan allows, cut up where they are larger than local sizes allow.

    Elements have sides of at most about `size` [m], along edges on ground beyond `edge_size` [m]. Of a grid and a
    maker's cells, of which only triangles are cut, what has fewer is taken, or better ones.
    """
    candidates: list[PlanMesh] = []
    if plan.rectilinear:
        with suppress(InputError):  # of too many elements
            candidates.append(rectilinear(plan, size, None, edge_size))
    if available():
        with suppress(InputError):  # of a plan that the maker refuses
            candidates.extend(_from_whole_cells(plan, size / 2, edge_size / 2))
    if not candidates:
        return mesh(plan, size, edge_size=edge_size, local=local)
    # elements of good shape do what more of a poor shape do
    best = min(candidates, key=lambda candidate: len(candidate.elements) / candidate.quality.median**2)
    return divide(plan, best, size, local, STEEP)


def _from_whole_cells(plan: Plan, size: float, edge_size: float) -> Iterator[PlanMesh]:
    """Yield usable meshes of cells of twice a size [m], of which only the triangles are cut."""
    check(plan, size)
    smaller, scale = sizing.sources(plan, size, edge_size, NARROW), sizing.growth_distance(plan, None)
    for cells in islice(choose()(plan, size, smaller, scale), WHOLE):
        with suppress(InputError):
            meshed = _quadrilaterals(plan, *quadrangulation.cut_triangles(cells))
            if meshed.quality.worst > POOR:
                yield meshed


def unstructured(
    plan: Plan,
    size: float,
    beyond_growth: float | None = None,
    maker: Maker | None = None,
    edge_size: float | None = None,
    across: float = sizing.ACROSS,
) -> PlanMesh:
    """Return a mesh of quadrilaterals that follows every edge of a plan, straight or arc."""
    check(plan, size)
    scale = sizing.growth_distance(plan, beyond_growth)
    make = choose() if maker is None else maker
    best = None
    refused = InputError([Issue("plan", "a plan of which the mesher makes nothing", "one that can be meshed")])
    smaller = sizing.sources(plan, size, edge_size or size, across)
    for tried, cells in enumerate(make(plan, size, smaller, scale), start=1):
        try:
            result = _quadrilaterals(plan, *quadrangulation.make_elements(cells))
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


def _quadrilaterals(plan: Plan, nodes: Array, elements: Integers) -> PlanMesh:
    """Return nine-node quadrilaterals as a mesh, or say that there are bad ones."""
    result = finish(plan, on_bounds(plan, nodes), elements, sections(plan, nodes[elements[:, 8]]))
    check_area(plan, result)
    return result
