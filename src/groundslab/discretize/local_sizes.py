"""Where the elements of a model are smaller from the start: what the file refines, and footprints of forces."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.geometry.plan import Ring
from groundslab.meshing.sizing import Sources, along
from groundslab.model.columns import footprint
from groundslab.model.loads.load_types import PatchLoad, PointLoad
from groundslab.model.model import Model

#: Places in a part that is refined are so many to a side of an element there.
PLACES_PER_SIDE = 2
#: Largest number of such places in one part.
MOST_PLACES = 100_000


def local_sizes(model: Model) -> Sources | None:
    """Return places (k, 2) [m] with the sizes (k,) [m] that elements have there at most, None without such places.

    Footprints count where the mesh is adaptive: elements that do not see them cannot tell their error either.
    """
    found = [(_places(part.shape.ring(), part.size), part.size) for part in model.mesh.refine]
    if model.mesh.adaptive:
        found += [(np.array([middle]), side) for middle, side in _footprints(model)]
    if not found:
        return None
    places = np.concatenate([where for where, _ in found])
    return places, np.concatenate([np.full(len(where), size) for where, size in found])


def _places(ring: Ring, size: float) -> Array:
    """Return places (p, 2) all over what a ring encloses, and along it."""
    import shapely

    x0, x1, y0, y1 = ring.bounds
    spacing = max(size / PLACES_PER_SIDE, float(np.sqrt((x1 - x0) * (y1 - y0) / MOST_PLACES)))
    nx, ny = (int(np.ceil(length / spacing)) + 1 for length in (x1 - x0, y1 - y0))
    X, Y = np.meshgrid(np.linspace(x0, x1, nx), np.linspace(y0, y1, ny))
    raster = np.column_stack([X.ravel(), Y.ravel()])
    inside = shapely.intersects_xy(ring.polygon(1e-3 * spacing), *raster.T)
    return np.concatenate([raster[inside], along(ring, spacing)])


def _footprints(model: Model) -> Iterator[tuple[tuple[float, float], float]]:
    """Yield middle and shorter side [m] of the footprints of forces, and of small patches."""
    for load in model.loads:
        if isinstance(load, PointLoad):
            own = load.on(model.columns)
            assert own.x is not None
            assert own.y is not None
            ring = footprint(own.x, own.y, own.width_x, own.width_y, own.diameter)
        elif isinstance(load, PatchLoad):
            ring = footprint(sum(load.x) / 2, sum(load.y) / 2, load.x[1] - load.x[0], load.y[1] - load.y[0], None)
        else:
            continue
        if ring is not None:
            x0, x1, y0, y1 = ring.bounds
            yield ((x0 + x1) / 2, (y0 + y1) / 2), min(x1 - x0, y1 - y0)
