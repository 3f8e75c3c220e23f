"""Planes of symmetry of a model."""

from __future__ import annotations

from collections import Counter

from groundslab.model.ground import ContinuousGround
from groundslab.model.loads import load_types as loads
from groundslab.model.model import Model

Interval = tuple[float, float]


def symmetries(model: Model) -> tuple[bool, bool]:
    """Return whether the problem is its own mirror image about x = 0 and about y = 0 (and the mesh may use it)."""
    varying = bool(model.soil_zones or model.boreholes or model.contact.gaps)
    # where the slab cracks, bars are stiffness, which may differ from side to side
    varying = varying or (model.cracking is not None and bool(model.reinforcement and model.reinforcement.zones))
    # Fourier transforms take the cells of the whole plate
    varying = varying or isinstance(model.ground, ContinuousGround)
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
    items = [_locate(load, model) for load in model.loads if not _is_everywhere(load)]
    items += [(("void", each.depth), (each.x, each.y)) if each.x and each.y else None for each in model.contact.voids]
    here, there = Counter[object](), Counter[object]()
    for item in items:
        if item is None:
            return False
        what, place = item
        here[what, _round(place, model)] += 1
        start, end = place[axis]
        there[what, _round((*place[:axis], (-end, -start), *place[axis + 1 :]), model)] += 1
    return here == there


def _round(place: tuple[Interval, ...], model: Model) -> tuple[float, ...]:
    """Return what is the same for equal places, whatever the rounding of their coordinates."""
    return tuple(round(value / max(model.plate.sides), 9) + 0.0 for interval in place for value in interval)


def _is_everywhere(load: loads.AnyLoad) -> bool:
    """Return whether a load is the same at every place of the plate."""
    if isinstance(load, loads.UniformLoad):
        return (load.slope, load.bend) == (loads.NO_SLOPE, loads.NO_BEND)
    return isinstance(load, loads.SelfWeight | loads.TemperatureLoad | loads.ShrinkageLoad)


def _locate(load: loads.AnyLoad, model: Model) -> tuple[tuple[object, ...], tuple[Interval, ...]] | None:
    """Return what a load is and its place along x and y; None if symmetry is not to be expected of it."""
    if isinstance(load, loads.PointLoad):
        own = load.on(model.columns)
        if not own.M_x and not own.M_y:
            assert own.x is not None
            assert own.y is not None
            what = ("point", own.case, own.P, own.width_x, own.width_y, own.diameter)
            return what, ((own.x, own.x), (own.y, own.y))
    if isinstance(load, loads.PatchLoad) and (load.slope, load.bend) == (loads.NO_SLOPE, loads.NO_BEND):
        return ("patch", load.case, load.on, load.q), (load.x, load.y)
    return None
