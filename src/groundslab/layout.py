"""The plan of a problem as a mesh: plate, ground beyond it, lines of symmetry, outer edges."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from groundslab.actions import AreaLoad, LineLoad, PatchLoad, PointLoad, SelfWeight, UniformLoad
from groundslab.ground import Column, tail
from groundslab.mesh import Mesh, grid, lines_beyond, sides_on_boundary
from groundslab.model import SHORT_SIDE_ELEMENTS, Model
from groundslab.plan import Plan, rectangle
from groundslab.shape import Integers
from groundslab.vlasov import Soil

#: A mesh is made coarser for the nested iteration while its plate keeps at least this many elements each way.
COARSEST = 3
#: Of an infinite ground, this many decay lengths are meshed before the tails begin.
MESHED_DECAYS = 1.0
AXIS = {"left": 0, "right": 0, "bottom": 1, "top": 1}
OUTWARD = {"left": -1, "right": 1, "bottom": -1, "top": 1}


@dataclass(frozen=True, slots=True)
class Layout:
    """The meshed part of a plan."""

    mesh: Mesh
    plate_elements: Integers  # (mp,)
    section: Integers  # (mp,): which section each plate element has
    symmetry: tuple[bool, bool]
    outer: Integers  # (s, 3: end, end, middle): sides on the outer edge of the meshed ground
    outer_axis: Integers  # (s,): the axis across each of them


def layout(model: Model, ground: Soil | Column, coarsening: int, margin: float) -> Layout:
    """Return the layout of a model; `coarsening` halves the counts so many times, `margin` widens the ground beyond."""
    symmetry = symmetries(model)
    width = margin * _width_beyond(model, ground)
    if model.plate.plain:
        mesh, section = _plain_mesh(model, symmetry, coarsening, width)
    else:
        mesh, section = _drawn_mesh(model, coarsening, width)
    plate_elements = np.flatnonzero(section >= 0)
    outer, axis = _outer_sides(model, symmetry, mesh)
    return Layout(mesh, plate_elements, section[plate_elements], symmetry, outer, axis)


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
    if model.mesh.symmetry == "off" or not model.plate.plain:
        return False, False
    return _symmetric(model, 0), _symmetric(model, 1)


def _symmetric(model: Model, axis: int) -> bool:
    low, high = (("left", "right"), ("bottom", "top"))[axis]
    edges = model.plate.edges
    if getattr(edges, low) != getattr(edges, high) or ((low in model.beyond.sides) != (high in model.beyond.sides)):
        return False
    if model.mesh.counts is not None and model.mesh.counts[axis] % 2:
        return False
    size = max(model.plate.sides)

    def key(numbers: Iterable[float]) -> tuple[float, ...]:
        return tuple(round(value / size, 9) + 0.0 for value in numbers)

    here: Counter[tuple[object, ...]] = Counter()
    there: Counter[tuple[object, ...]] = Counter()
    for item in (*model.loads, *model.contact.voids):
        if isinstance(item, UniformLoad | SelfWeight):
            continue
        if isinstance(item, AreaLoad | LineLoad):
            return False
        if isinstance(item, PointLoad):
            place = [(item.x, item.x), (item.y, item.y)]
            value = item.P
        else:
            place = [item.x, item.y]
            value = item.q if isinstance(item, PatchLoad) else item.depth
        image = list(place)
        image[axis] = (-place[axis][1], -place[axis][0])
        here[(type(item).__name__, value, *key(place[0] + place[1]))] += 1
        there[(type(item).__name__, value, *key(image[0] + image[1]))] += 1
    return here == there


def _counts(model: Model, symmetry: tuple[bool, bool], coarsening: int) -> tuple[int, int]:
    """Return the numbers of elements along x and y in the part of the plate that is meshed."""
    lengths = model.plate.sides
    if model.mesh.counts is not None:
        counts = [c // 2 if s else c for c, s in zip(model.mesh.counts, symmetry, strict=True)]
    else:
        size = model.mesh.size if model.mesh.size is not None else min(lengths) / 24
        halves = [length / 2 if s else length for length, s in zip(lengths, symmetry, strict=True)]
        counts = [max(1, math.ceil(length / size - 1e-9)) for length in halves]
    nx, ny = (max(1, math.ceil(c / 2**coarsening)) for c in counts)
    return nx, ny


def _width_beyond(model: Model, ground: Soil | Column) -> float:
    """Return the width of the meshed ground beyond the plate [m]."""
    if model.beyond.kind == "none":
        return 0.0
    if model.beyond.width is not None:
        return model.beyond.width
    column = ground if isinstance(ground, Column) else ground.column(ground.gamma or 1.0)
    longest = 1 / float(tail(column).decay.min())
    return MESHED_DECAYS * min(longest, 2 * max(model.plate.sides))


def _plain_mesh(model: Model, symmetry: tuple[bool, bool], coarsening: int, width: float) -> tuple[Mesh, Integers]:
    """Return the grid of a plain rectangle and its ground beyond, and each element's section, -1 beyond."""
    lines, inside = [], []
    for axis, (length, count) in enumerate(zip(model.plate.sides, _counts(model, symmetry, coarsening), strict=True)):
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


def _drawn_mesh(model: Model, coarsening: int, width: float) -> tuple[Mesh, Integers]:
    """Return the mesh of a plate of any shape and its ground beyond, and each element's section, -1 beyond."""
    from groundslab import mesher

    size = model.mesh.size if model.mesh.size is not None else min(model.plate.sides) / SHORT_SIDE_ELEMENTS
    found = mesher.mesh(plan_of(model, width), size * 2**coarsening)
    return Mesh(found.nodes, found.elements), found.section


def plan_of(model: Model, width: float) -> Plan:
    """Return the plan of a model: zone i is section i; ground beyond fills the rectangle that is `width` [m] wider."""
    plate = model.plate
    beyond = None
    if width:
        grow = {side: width if side in model.beyond.sides else 0.0 for side in OUTWARD}
        x0, x1, y0, y1 = plate.bounds
        beyond = rectangle(x0 - grow["left"], x1 + grow["right"], y0 - grow["bottom"], y1 + grow["top"])
    return Plan(
        plate.ring(),
        tuple(shape.ring() for shape in plate.openings),
        tuple((zone.shape.ring(), number) for number, zone in enumerate(plate.zones, start=1)),
        beyond,
    )


def _outer_sides(model: Model, symmetry: tuple[bool, bool], mesh: Mesh) -> tuple[Integers, Integers]:
    """Return the sides (s, 3) of the mesh beyond which there was ground to mesh, and the axis across each (s,)."""
    sides, found, axes = (
        sides_on_boundary(mesh.elements),
        [np.zeros((0, 3), dtype=np.int64)],
        [np.zeros(0, dtype=np.int64)],
    )
    for side in model.beyond.sides if model.beyond.kind != "none" else ():
        axis = AXIS[side]
        if symmetry[axis] and OUTWARD[side] < 0:
            continue
        coordinate = OUTWARD[side] * mesh.nodes[:, axis]
        on_side = sides[(coordinate[sides] == coordinate.max()).all(axis=1)]
        found.append(on_side)
        axes.append(np.full(len(on_side), axis))
    return np.concatenate(found), np.concatenate(axes)
