"""Mesher back ends: Gmsh where it can be loaded, else Netgen."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import Plan
from groundslab.meshing import gmsh, netgen
from groundslab.meshing.cells import Cells
from groundslab.meshing.sizing import Sources

#: Takes a plan, the required size [m], where the plan requires smaller ones, and the distance at which sizes are
#: doubled beyond the plate; yields cells of twice these sizes, further ones if the first do not make a good mesh.
Maker = Callable[[Plan, float, Sources, float], Iterator[Cells]]


def with_gmsh(plan: Plan, size: float, smaller: Sources, scale: float) -> Iterator[Cells]:
    """Yield Gmsh's cells, then such as grow more gently, at last triangles."""
    for slope, triangles_alone in ((gmsh.SLOPE, False), (gmsh.GENTLE, False), (gmsh.GENTLE, True)):
        yield gmsh.cells_of(plan, size, smaller, scale, slope, triangles_alone)


with_netgen: Maker = netgen.cells_of


def choose() -> Maker:
    """Return the first back end that can be loaded; raises InputError that says how to install one."""
    broken = []
    for name, load, maker in (("Gmsh", gmsh.load, with_gmsh), ("Netgen", netgen.load, with_netgen)):
        error = _load_error(load)
        if error is None:
            return maker
        if not isinstance(error, ModuleNotFoundError):
            broken.append(f"a {name} that cannot be loaded ({error})")
    obstacles = " and ".join(["a plan with oblique edges or arcs", *broken])
    system = f" (on Debian and Ubuntu with apt-get install {gmsh.SYSTEM_LIBRARIES})"
    hint = f"pip install groundslab[mesh]{system}, or pip install groundslab[netgen]"
    raise InputError([Issue("mesh", obstacles, "Gmsh or Netgen to mesh it", hint)])


def available() -> bool:
    """Return whether any back end can be loaded, so that a mesh can follow oblique edges and arcs."""
    return _load_error(gmsh.load) is None or _load_error(netgen.load) is None


def _load_error(load: Callable[[], Any]) -> Exception | None:
    """Return the error of loading a module, if any; Netgen refuses other Pythons with a RuntimeError."""
    try:
        load()
    except (ImportError, OSError, RuntimeError) as error:
        return error
    return None
