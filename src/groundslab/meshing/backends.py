"""Who makes the cells of a mesh: Gmsh where it can be loaded, else Netgen."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import Plan
from groundslab.meshing import gmsh_door, gmsh_drawing
from groundslab.meshing import netgen as front
from groundslab.meshing.cells import Cells
from groundslab.meshing.sizing import Sources

#: From a plan, the wanted size [m], where smaller ones are wanted, and the distance at which they are doubled beyond,
#: to cells of twice these sizes; further ones if the first cannot be made into a good mesh.
Maker = Callable[[Plan, float, Sources, float], Iterator[Cells]]


def with_gmsh(plan: Plan, size: float, smaller: Sources, scale: float) -> Iterator[Cells]:
    """Yield Gmsh's cells, once."""
    with gmsh_door.session() as gmsh:
        cells = gmsh_drawing.cells_of(gmsh, plan, size, smaller, scale)
    yield cells


def with_netgen(plan: Plan, size: float, smaller: Sources, scale: float) -> Iterator[Cells]:
    """Yield Netgen's cells, made in several ways."""
    yield from front.cells_of(plan, size, smaller, scale)


def choose() -> Maker:
    """Return the first maker that can be loaded, or say how to get one."""
    gmsh = _obstacle(gmsh_door.load)
    if gmsh is None:
        return with_gmsh
    netgen = _obstacle(front.load)
    if netgen is None:
        return with_netgen
    broken = [
        f"a {name} that cannot be loaded ({error})"
        for name, error in (("Gmsh", gmsh), ("Netgen", netgen))
        if not isinstance(error, ModuleNotFoundError)
    ]
    got = " and ".join(["a plan with oblique edges or arcs", *broken])
    system = f" (on Debian and Ubuntu with apt-get install {gmsh_door.SYSTEM_LIBRARIES})"
    mend = f"pip install groundslab[mesh]{system}, or pip install groundslab[netgen]"
    raise InputError([Issue("mesh", got, "Gmsh or Netgen to mesh it", mend)])


def available() -> bool:
    """Return whether any maker can be loaded, so that a mesh can follow oblique edges and arcs."""
    return _obstacle(gmsh_door.load) is None or _obstacle(front.load) is None


def _obstacle(load: Callable[[], Any]) -> Exception | None:
    """Return what keeps a module from being loaded, if anything; Netgen refuses other Pythons with a RuntimeError."""
    try:
        load()
    except (ImportError, OSError, RuntimeError) as error:
        return error
    return None
