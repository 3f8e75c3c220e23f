"""Planes of symmetry of a model."""

from __future__ import annotations

from collections import Counter

from groundslab.geometry.plan import Ring
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads.acting import Acting, AreaPressure, PlateAction, PointForce
from groundslab.model.model import Model

Interval = tuple[float, float]


def symmetries(model: Model) -> tuple[bool, bool]:
    """Return whether the problem is its own mirror image about x = 0 and about y = 0 (and the mesh may use it)."""
    varying = bool(model.soil_zones or model.boreholes or model.contact.gaps)
    # where the slab cracks, bars are stiffness, which may differ from side to side
    varying = varying or (model.cracking is not None and bool(model.reinforcement and model.reinforcement.zones))
    # Fourier transforms take the cells of the whole plate
    varying = varying or isinstance(model.ground, ContinuousGround)
    # a building joins the whole plate
    varying = varying or model.building is not None
    if model.mesh.symmetry == "off" or not model.plain or varying:
        return False, False
    return _symmetric(model, 0), _symmetric(model, 1)


def _symmetric(model: Model, axis: int) -> bool:
    low, high = (("left", "right"), ("bottom", "top"))[axis]
    edges = model.plate.edges
    if getattr(edges, low) != getattr(edges, high) or ((low in model.beyond.sides) != (high in model.beyond.sides)):
        return False
    if model.mesh.counts is not None and model.mesh.counts[axis] % 2:
        return False
    items = [_locate(load.case, shape) for load, shape in model.acting if not _is_everywhere(shape)]
    items += [(("void", void.depth), (void.x, void.y)) if void.x and void.y else None for void in model.contact.voids]
    here, mirrored = Counter[object](), Counter[object]()
    for item in items:
        if item is None:
            return False
        what, place = item
        here[what, _round(place, model)] += 1
        start, end = place[axis]
        mirrored[what, _round((*place[:axis], (-end, -start), *place[axis + 1 :]), model)] += 1
    return here == mirrored


def _round(place: tuple[Interval, ...], model: Model) -> tuple[float, ...]:
    """Return what is the same for equal places, whatever the rounding of their coordinates."""
    return tuple(round(value / max(model.plate.sides), 9) + 0.0 for interval in place for value in interval)


def _is_everywhere(shape: Acting) -> bool:
    """Return whether a shape is the same at every place of the plate."""
    return isinstance(shape, PlateAction) and shape.pressure.constant


def _locate(case: str, shape: Acting) -> tuple[tuple[object, ...], tuple[Interval, ...]] | None:
    """Return what acts, and its place along x and y; None if symmetry is not to be expected of it."""
    if isinstance(shape, PointForce) and not any(shape.M):
        if shape.ring is None:
            return ("force", case, shape.P), tuple((value, value) for value in shape.place)
        if shape.ring.is_rectangle or not shape.ring.straight:
            return ("force", case, shape.P, shape.ring.straight), _extents(shape.ring)
    if isinstance(shape, AreaPressure) and shape.pressure.constant and len(shape.rings) == 1:
        (ring,) = shape.rings
        if ring.is_rectangle:
            return ("pressure", case, shape.on, shape.pressure.q), _extents(ring)
    return None


def _extents(ring: Ring) -> tuple[Interval, ...]:
    """Return the intervals along x and along y that a curve covers."""
    x0, x1, y0, y1 = ring.bounds
    return (x0, x1), (y0, y1)
