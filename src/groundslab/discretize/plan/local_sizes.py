"""Where elements are smaller from the start: in what the file refines, and at footprints of forces and supports."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.discretize.ground import grounds_of
from groundslab.fem.foundation import Column
from groundslab.fem.plate import bending_rigidity
from groundslab.geometry.plan import Ring, circle
from groundslab.meshing.sizing import Sources, along
from groundslab.model.consistency import usual_size
from groundslab.model.loads.acting import AreaPressure, PointForce, rings_of
from groundslab.model.model import Model
from groundslab.model.plates.other_plates import AnyPlate
from groundslab.model.remarks.singular_places import forces_without_footprint

#: Places in a part that is refined are so many to a side of an element there.
PLACES_PER_SIDE = 2
#: What is asked for there, as a share of what is wanted: in a small part elements come out larger by up to a third.
SURE = 0.72
#: Largest number of such places in one part.
MOST_PLACES = 100_000
#: Footprints are to have so many elements across, two of the next coarser mesh, which are halved; where there are many
#: of them, half as many: most of these do not govern.
ACROSS, MANY = 4, 100
#: The first of adaptive meshes has no elements larger than the elastic length, but for it at most so many on the
#: shorter side.
MOST_ON_SHORT_SIDE = 96


def local_sizes(model: Model) -> Sources | None:
    """Return places (k, 2) and the size (k,) [m] that elements have there at most, None without such places.

    Footprints and elastic length count where the mesh is adaptive: elements that do not see them cannot tell their
    error either.
    """
    sizes: list[tuple[Array, float]] = []
    sizes += [(_places(part.shape.ring(), part.size), SURE * part.size) for part in model.mesh.refine]
    if model.mesh.adaptive:
        for plate in model.every_plate:
            sizes += _sizes_on(plate, model)
        footprints = [*_footprints(model)]
        across = ACROSS if len(footprints) <= MANY else ACROSS / 2
        sizes += [(places, width / across) for places, width in map(_inside, footprints)]
    if not sizes:
        return None
    places = np.concatenate([where for where, _ in sizes])
    return places, np.concatenate([np.full(len(where), size) for where, size in sizes])


def _sizes_on(plate: AnyPlate, model: Model) -> Iterator[tuple[Array, float]]:
    """Yield places (p, 2) on a plate with the size of elements [m] there, if it is less than usual."""
    least, usual = min(plate.sides) / MOST_ON_SHORT_SIDE, usual_size(plate.sides)
    size = max(_elastic_length(plate, model), least)
    if size < usual or model.plates:
        size = min(size, usual)
        yield _places(plate.ring(), size), size


def _elastic_length(plate: AnyPlate, model: Model) -> float:
    """Return the least elastic length (D / k)^(1/4) [m], k being the pressure on the ground over its settlement."""
    parts = [(plate.E, plate.nu, plate.thickness)]
    parts += [(zone.E or plate.E, zone.nu or plate.nu, zone.thickness or plate.thickness) for zone in plate.zones]
    grounds = [ground if isinstance(ground, Column) else ground.first_column() for ground in grounds_of(model)]
    k = max(1 / float(np.linalg.inv(column.A0)[0, 0]) for column in grounds)
    return float((min(bending_rigidity(*part)[0, 0] for part in parts) / k) ** 0.25)


def _places(ring: Ring, size: float) -> Array:
    """Return places (p, 2) all over what a ring encloses, and along it."""
    import shapely

    a, b = ring.sides
    spacing = max(size / PLACES_PER_SIDE, float(np.sqrt(a * b / MOST_PLACES)))
    raster = _raster(ring.bounds, math.ceil(a / spacing) + 1, math.ceil(b / spacing) + 1)
    inside = shapely.intersects_xy(ring.polygon(1e-3 * spacing), *raster.T)
    return np.concatenate([raster[inside], along(ring, spacing)])


def _raster(bounds: tuple[float, float, float, float], nx: int, ny: int) -> Array:
    """Return nx times ny places (p, 2) on the rectangle x0, x1, y0, y1 [m]."""
    X, Y = np.meshgrid(np.linspace(*bounds[:2], nx), np.linspace(*bounds[2:], ny))
    return np.column_stack([X.ravel(), Y.ravel()])


def _inside(ring: Ring) -> tuple[Array, float]:
    """Return nine places (9, 2) on a footprint, and its least width [m]."""
    if ring.rectilinear or not ring.straight:
        return _raster(ring.bounds, 3, 3), min(ring.sides)
    # a rectangle at an angle
    a, b, _, d = np.array(ring.points)
    u, v = (part.reshape(-1, 1) for part in np.meshgrid([0, 0.5, 1], [0, 0.5, 1]))
    return a + u * (b - a) + v * (d - a), min(math.dist(a, b), math.dist(a, d))


def _footprints(model: Model) -> Iterator[Ring]:
    """Yield the footprints of forces, a thickness wide where there are none, and rectangles under pressure."""
    t = min(plate.thickness for plate in model.every_plate)
    for _, shape in model.acting:
        if isinstance(shape, PointForce) or (isinstance(shape, AreaPressure) and shape.rings[0].is_rectangle):
            yield from rings_of(shape)
    yield from (circle(place, t / 2) for place in forces_without_footprint(model))
    yield from (circle(support.points[0], t / 2) for support in model.supports if not support.edges)
