"""Planes of symmetry of a model."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace

from groundslab.model.loads import load_types as loads
from groundslab.model.model import Model


def symmetries(model: Model) -> tuple[bool, bool]:
    """Return whether the problem is its own mirror image about x = 0 and about y = 0 (and the mesh may use it)."""
    varying = model.soil_zones or model.boreholes or model.contact.gaps
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
    placed = [_placed(load, model) for load in model.loads]
    voids = [_Placed(("void", void.depth), void.x, void.y) for void in model.contact.voids if void.shape is None]
    if None in placed or len(voids) < len(model.contact.voids):
        return False
    here, there = Counter[tuple[object, ...]](), Counter[tuple[object, ...]]()
    for item in (*placed, *voids):
        if item is not None and item.x is not None and item.y is not None:
            here[item.key(max(model.plate.sides))] += 1
            there[item.mirrored(axis).key(max(model.plate.sides))] += 1
    return here == there


@dataclass(frozen=True)
class _Placed:
    """Something on a rectangle or at a point of the plan; x and y are None if it is everywhere."""

    what: tuple[object, ...]
    x: tuple[float, float] | None = None
    y: tuple[float, float] | None = None

    def mirrored(self, axis: int) -> _Placed:
        """Return its image in the mirror across an axis."""
        assert self.x is not None
        assert self.y is not None
        low, high = (self.x, self.y)[axis]
        return replace(self, **{"xy"[axis]: (-high, -low)})

    def key(self, size: float) -> tuple[object, ...]:
        """Return what equals that of the same thing at the same place, relative to a size."""
        assert self.x is not None
        assert self.y is not None
        return (*self.what, *(round(value / size, 9) + 0.0 for value in (*self.x, *self.y)))


def _placed(load: loads.AnyLoad, model: Model) -> _Placed | None:
    """Return a load as something that has a mirror image; None if symmetry is not to be expected of it."""
    if isinstance(load, loads.SelfWeight | loads.TemperatureLoad):
        return _Placed(())
    if isinstance(load, loads.PointLoad):
        own = load.on(model.columns)
        if own.M_x or own.M_y:
            return None
        assert own.x is not None
        assert own.y is not None
        what = ("point", own.case, own.P, own.width_x, own.width_y, own.diameter)
        return _Placed(what, (own.x, own.x), (own.y, own.y))
    if isinstance(load, loads.UniformLoad | loads.PatchLoad) and (load.slope, load.bend) == (
        loads.NO_SLOPE,
        loads.NO_BEND,
    ):
        return (
            _Placed(("patch", load.case, load.q), load.x, load.y) if isinstance(load, loads.PatchLoad) else _Placed(())
        )
    return None
