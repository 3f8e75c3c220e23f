"""Mesher back ends: Gmsh where it can be loaded, else Netgen."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from groundslab.errors import InputError, Issue
from groundslab.geometry.plan import Plan
from groundslab.meshing import gmsh, netgen
from groundslab.meshing.cells import Cells
from groundslab.meshing.sizing import Sources

#: Takes a plan, the required size [m], where smaller ones are required, and the distance at which sizes are doubled
#: beyond the plate; yields cells of twice these sizes, further ones if the first do not make a good mesh.
Maker = Callable[[Plan, float, Sources, float], Iterator[Cells]]


def with_gmsh(plan: Plan, size: float, smaller: Sources, scale: float) -> Iterator[Cells]:
    """Yield Gmsh's cells, once."""
    with gmsh.session() as module:
        cells = gmsh.cells_of(module, plan, size, smaller, scale)
    yield cells


def with_netgen(plan: Plan, size: float, smaller: Sources, scale: float) -> Iterator[Cells]:
    """Yield Netgen's cells, with several settings."""
    yield from netgen.cells_of(plan, size, smaller, scale)


def choose() -> Maker:
    """Return the first back end that can be loaded; raises InputError that says how to install one."""
    gmsh_error = _load_error(gmsh.load)
    if gmsh_error is None:
        return with_gmsh
    netgen_error = _load_error(netgen.load)
    if netgen_error is None:
        return with_netgen
    broken = [
        f"a {name} that cannot be loaded ({error})"
        for name, error in (("Gmsh", gmsh_error), ("Netgen", netgen_error))
        if not isinstance(error, ModuleNotFoundError)
    ]
    found = " and ".join(["a plan with oblique edges or arcs", *broken])
    system = f" (on Debian and Ubuntu with apt-get install {gmsh.SYSTEM_LIBRARIES})"
    hint = f"pip install groundslab[mesh]{system}, or pip install groundslab[netgen]"
    raise InputError([Issue("mesh", found, "Gmsh or Netgen to mesh it", hint)])


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
