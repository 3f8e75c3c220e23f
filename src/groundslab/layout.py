"""The plan of a problem as a mesh: plate, ground beyond it, lines of symmetry, outer edges."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Hashable
from dataclasses import dataclass, field, replace

import numpy as np

from groundslab.actions import (
    NO_BEND,
    NO_SLOPE,
    AnyLoad,
    PatchLoad,
    PointLoad,
    SelfWeight,
    TemperatureLoad,
    UniformLoad,
)
from groundslab.ground import Column, tail
from groundslab.mesh import Mesh, elimination_order, grid, lines_beyond, sides_on_boundary
from groundslab.model import SHORT_SIDE_ELEMENTS, Model, plan_of_plate
from groundslab.plan import Plan, rectangle
from groundslab.shape import Integers, distinct
from groundslab.vlasov import Soil

#: A mesh is made coarser for the nested iteration while its plate keeps at least this many elements each way.
COARSEST = 3
#: Of an infinite ground, this many decay lengths are meshed before the tails begin.
MESHED_DECAYS = 1.0
AXIS = {"left": 0, "right": 0, "bottom": 1, "top": 1}
OUTWARD = {"left": -1, "right": 1, "bottom": -1, "top": 1}


Meshed = tuple[Mesh, Integers, Integers]


@dataclass(slots=True)
class Meshes:
    """Meshes by what they were made from, so that models of the same shape share them: sections and ranks with each."""

    made: dict[Hashable, Meshed] = field(default_factory=dict)
    closed: bool = False  # whether no further ones are kept

    def of(self, source: Hashable, make: Callable[[], tuple[Mesh, Integers]]) -> Meshed:
        """Return the mesh of a source, made now if there is none."""
        found = self.made.get(source)
        if found is None:
            mesh, section = make()
            found = mesh, section, elimination_order(mesh)
            if not self.closed:
                self.made[source] = found
        return found


@dataclass(frozen=True, slots=True)
class Layout:
    """The meshed part of a plan."""

    mesh: Mesh
    rank: Integers  # (n,): order of elimination of the nodes
    plate_elements: Integers  # (mp,)
    section: Integers  # (mp,): which section each plate element has
    symmetry: tuple[bool, bool]
    outer: Integers  # (s, 3: end, end, middle): sides on the outer edge of the meshed ground
    outer_axis: Integers  # (s,): the axis across each of them

    @property
    def plate_nodes(self) -> Integers:
        """Return the nodes of the plate, ascending."""
        return distinct(self.mesh.elements[self.plate_elements])[0]


def layout(model: Model, grounds: list[Soil | Column], coarsening: int, margin: float, meshes: Meshes) -> Layout:
    """Return the layout of a model; `coarsening` halves the counts so many times, `margin` widens the ground beyond."""
    symmetry = symmetries(model)
    width = margin * _width_beyond(model, grounds)
    source: Hashable
    if model.plain:
        counts = _counts(model, symmetry, coarsening)
        source = model.plate.sides, symmetry, counts, model.beyond.sides if width else (), width
        mesh, section, rank = meshes.of(source, lambda: _plain_mesh(model, symmetry, counts, width))
    else:
        plan, size = plan_of(model, width), _size(model) * 2**coarsening
        mesh, section, rank = meshes.of((plan, size), lambda: _drawn_mesh(plan, size))
    plate_elements = np.flatnonzero(section >= 0)
    outer, axis = _outer_sides(model, symmetry, mesh)
    return Layout(mesh, rank, plate_elements, section[plate_elements], symmetry, outer, axis)


def coarsest(model: Model) -> int:
    """Return how often the counts of a model's mesh can be halved for the nested iteration."""
    if not model.analysis.nested:
        return 0
    times, symmetry = 0, symmetries(model)
    while COARSEST <= min(_counts(model, symmetry, times + 1)) < min(_counts(model, symmetry, times)):
        times += 1
    return times


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


def _placed(load: AnyLoad, model: Model) -> _Placed | None:
    """Return a load as something that has a mirror image; None if symmetry is not to be expected of it."""
    if isinstance(load, SelfWeight | TemperatureLoad):
        return _Placed(())
    if isinstance(load, PointLoad):
        own = load.on(model.columns)
        if own.M_x or own.M_y:
            return None
        assert own.x is not None
        assert own.y is not None
        what = ("point", own.case, own.P, own.width_x, own.width_y, own.diameter)
        return _Placed(what, (own.x, own.x), (own.y, own.y))
    if isinstance(load, UniformLoad | PatchLoad) and (load.slope, load.bend) == (NO_SLOPE, NO_BEND):
        return _Placed(("patch", load.case, load.q), load.x, load.y) if isinstance(load, PatchLoad) else _Placed(())
    return None


def _counts(model: Model, symmetry: tuple[bool, bool], coarsening: int) -> tuple[int, int]:
    """Return the numbers of elements along x and y in the part of the plate that is meshed."""
    lengths = model.plate.sides
    if model.mesh.counts is not None:
        counts = [c // 2 if s else c for c, s in zip(model.mesh.counts, symmetry, strict=True)]
    else:
        halves = [length / 2 if s else length for length, s in zip(lengths, symmetry, strict=True)]
        counts = [max(1, math.ceil(length / _size(model) - 1e-9)) for length in halves]
    nx, ny = (max(1, math.ceil(c / 2**coarsening)) for c in counts)
    return nx, ny


def _width_beyond(model: Model, grounds: list[Soil | Column]) -> float:
    """Return the width of the meshed ground beyond the plate [m]; of several grounds, the widest decides."""
    if not model.ground_reaches:
        return 0.0
    if model.beyond.width is not None:
        return model.beyond.width
    columns = [ground if isinstance(ground, Column) else ground.column(ground.gamma or 1.0) for ground in grounds]
    longest = max(1 / float(tail(column).decay.min()) for column in columns)
    return MESHED_DECAYS * min(longest, 2 * max(model.plate.sides))


def _plain_mesh(
    model: Model, symmetry: tuple[bool, bool], counts: tuple[int, int], width: float
) -> tuple[Mesh, Integers]:
    """Return the grid of a plain rectangle and its ground beyond, and each element's section, -1 beyond."""
    lines, inside = [], []
    for axis, (length, count) in enumerate(zip(model.plate.sides, counts, strict=True)):
        low = 0.0 if symmetry[axis] else -length / 2
        own = np.linspace(low, length / 2, count + 1)
        first = (length / 2 - low) / count
        before, after = np.zeros(0), np.zeros(0)
        for side in model.beyond.sides if width else ():
            if AXIS[side] == axis and OUTWARD[side] > 0:
                after = lines_beyond(length / 2, width, first, length / 2)
            elif AXIS[side] == axis and not symmetry[axis]:
                before = lines_beyond(-length / 2, -width, first, length / 2)[::-1]
        lines.append(np.concatenate([before, own, after]))
        inside.append(np.repeat([False, True, False], [len(before), count, len(after)]))
    return grid(lines[0], lines[1]), np.where((inside[1][:, None] & inside[0]).ravel(), 0, -1)


def _size(model: Model) -> float:
    """Return the largest side that an element may have [m]."""
    return model.mesh.size if model.mesh.size is not None else min(model.plate.sides) / SHORT_SIDE_ELEMENTS


def _drawn_mesh(plan: Plan, size: float) -> tuple[Mesh, Integers]:
    """Return the mesh of a plate of any shape and its ground beyond, and each element's section, -1 beyond."""
    from groundslab import mesher

    found = mesher.mesh(plan, size)
    return Mesh(found.nodes, found.elements), found.section


def plan_of(model: Model, width: float) -> Plan:
    """Return the plan of a model: zone i is section i; ground beyond fills the rectangle that is `width` [m] wider."""
    beyond = None
    if width:
        grow = {side: width if side in model.beyond.sides else 0.0 for side in OUTWARD}
        x0, x1, y0, y1 = model.plate.bounds
        beyond = rectangle(x0 - grow["left"], x1 + grow["right"], y0 - grow["bottom"], y1 + grow["top"])
    return plan_of_plate(model.plate, model.supports, beyond)


def _outer_sides(model: Model, symmetry: tuple[bool, bool], mesh: Mesh) -> tuple[Integers, Integers]:
    """Return the sides (s, 3) of the mesh beyond which there was ground to mesh, and the axis across each (s,)."""
    sides, found, axes = (
        sides_on_boundary(mesh.elements),
        [np.zeros((0, 3), dtype=np.int64)],
        [np.zeros(0, dtype=np.int64)],
    )
    for side in model.beyond.sides if model.ground_reaches else ():
        axis = AXIS[side]
        if symmetry[axis] and OUTWARD[side] < 0:
            continue
        coordinate = OUTWARD[side] * mesh.nodes[:, axis]
        on_side = sides[(coordinate[sides] == coordinate.max()).all(axis=1)]
        found.append(on_side)
        axes.append(np.full(len(on_side), axis))
    return np.concatenate(found), np.concatenate(axes)
