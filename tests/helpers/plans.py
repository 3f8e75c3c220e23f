"""Plans to be meshed, the two meshers, and what is asked of meshes."""

from __future__ import annotations

from collections import Counter
from functools import cache

import numpy as np
import pytest

from groundslab.fem.shape_functions import determinants, gauss, q9
from groundslab.geometry.plan import Plan, Ring, circle, rectangle
from groundslab.meshing import mesh
from groundslab.meshing.backends import Maker, with_gmsh, with_netgen
from groundslab.meshing.gmsh import load as load_gmsh
from groundslab.meshing.netgen import load as load_netgen
from groundslab.meshing.plan_mesh import PlanMesh

try:
    load_gmsh()
    NO_GMSH = ""
except (ImportError, OSError) as error:
    NO_GMSH = f"free meshes from Gmsh are NOT tested, it cannot be loaded: {error}"
try:
    load_netgen()
    NO_NETGEN = ""
except (ImportError, OSError, RuntimeError) as error:
    NO_NETGEN = f"free meshes from Netgen are NOT tested, it cannot be loaded: {error}"

needs_gmsh = pytest.mark.skipif(bool(NO_GMSH), reason=NO_GMSH)
needs_netgen = pytest.mark.skipif(bool(NO_NETGEN), reason=NO_NETGEN)

L_SHAPE = Ring(((0, 0), (10, 0), (10, 4), (4, 4), (4, 8), (0, 8)))
OBLIQUE = Ring(((0, 0), (10, 1), (12, 6), (7, 9), (1, 7)))
GRIDS = {
    "L with opening": Plan(L_SHAPE, (rectangle(1, 2, 1, 2.5),)),
    "L with ground": Plan(
        L_SHAPE,
        (rectangle(1, 2, 1, 2.5),),
        ((rectangle(-1, 3, 3, 20), 1),),
        rectangle(-8, 10, -8, 16),
        ((7.0, 1.3),),
        (((0.5, 6.2), (3.1, 6.2)),),
    ),
}
FREE = {
    "circle": Plan(circle((0, 0), 5)),
    "ring": Plan(circle((0, 0), 5), (circle((1.5, 0.5), 1.2),)),
    "oblique": Plan(OBLIQUE, points=((3.0, 3.0), (6.1, 5.2)), lines=(((2, 2), (8, 3), (9, 6)),)),
    "small opening": Plan(rectangle(0, 10, 0, 8), (circle((3, 3), 0.1),)),
    "narrow strip": Plan(rectangle(0, 10, 0, 8), (circle((3, 1.1), 1.0),)),
    "ground": Plan(circle((0, 0), 5), (circle((1, 1), 0.5),), ((circle((-5, 0), 2), 2),), circle((0, 0), 15)),
    "zones": Plan(OBLIQUE, (circle((5, 4), 1),), ((circle((5, 4), 2), 1), (rectangle(0, 6, 0, 2.5), 2))),
    "stadium": Plan(Ring(((0, 0), (10, 0), (10, 5), (0, 5)), (0, 1, 0, 0.3))),
    "far away": Plan(Ring(tuple((x + 5e5, y - 3e6) for x, y in OBLIQUE.points))),
    "small": Plan(Ring(tuple((x / 1e3, y / 1e3) for x, y in OBLIQUE.points))),
}
MAKERS = [
    pytest.param(with_gmsh, id="Gmsh", marks=needs_gmsh),
    pytest.param(with_netgen, id="Netgen", marks=needs_netgen),
]
ALL = [
    *(pytest.param(plan, None, id=name) for name, plan in GRIDS.items()),
    *(
        pytest.param(plan, *maker.values, id=f"{name}-{maker.id}", marks=maker.marks)
        for name, plan in FREE.items()
        for maker in MAKERS
    ),
]
SIDES = np.array([[0, 1, 4], [1, 2, 5], [2, 3, 6], [3, 0, 7]])


def size_of(plan: Plan, parts: int = 20) -> float:
    """Return a size of which so many fit along the longer side of the plate."""
    return float(max(np.ptp(plan.outline.flat(1e-3 * plan.extent), axis=0))) / parts


@cache
def meshed(plan: Plan, maker: Maker | None = None) -> PlanMesh:
    """Return the mesh of a plan with about twenty elements along its longer side."""
    return mesh(plan, size_of(plan), maker=maker)


def areas(result: PlanMesh) -> np.ndarray:
    """Return the area of each element."""
    points, weights = gauss(3)
    areas: np.ndarray = determinants(q9(points)[1], result.xy) @ weights
    return areas


def boundary(result: PlanMesh) -> np.ndarray:
    """Return the nodes of sides that belong to one element only."""
    sides = result.elements[:, SIDES].reshape(-1, 3)
    count = Counter(map(tuple, np.sort(sides[:, :2], axis=1).tolist()))
    only = [side for side in sides if count[min(side[:2]), max(side[:2])] == 1]
    return np.unique(only)


def holds(result: PlanMesh, place: tuple[float, float]) -> bool:
    """Return whether a place is a node, to the last bits."""
    return bool(np.abs(result.nodes - place).max(axis=1).min() <= 4e-16 * max(1.0, *map(abs, place)))
