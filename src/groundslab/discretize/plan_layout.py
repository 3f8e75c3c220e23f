"""The plan of a problem as a mesh: plate, ground beyond it, lines of symmetry, outer edges."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable
from dataclasses import dataclass, field, replace

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.discretize.plan.borders import add_borders, on_lines
from groundslab.discretize.plan.load_borders import follow_kinks, follow_loads
from groundslab.discretize.symmetry import symmetries
from groundslab.fem.foundation import Column, decay_length, edge_decay
from groundslab.fem.hanging import connect
from groundslab.fem.mesh import (
    GRADING,
    Mesh,
    divide_graded,
    extrude,
    first_at_place,
    graded_size,
    grid,
    separate,
    sides_on_boundary,
)
from groundslab.fem.parts.mesh_plan import MeshPlan
from groundslab.fem.shape_functions import unique_integers
from groundslab.fem.sparse.elimination import elimination_order
from groundslab.fem.vlasov import Soil
from groundslab.geometry.plan import Place, Plan, Ring, Segment, make_segments, rectangle
from groundslab.meshing.sizing import Sources
from groundslab.model.consistency import usual_size
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads.beside import distances_beyond
from groundslab.model.model import Model
from groundslab.model.plates.other_plates import first_sections
from groundslab.model.settings import SIDES, Side
from groundslab.model.structure.members import curved_beams
from groundslab.model.structure.spans import paths_on_plates
from groundslab.model.supports import plan_of_plate

#: A mesh is made coarser for the nested iteration while its plate keeps at least this many elements each way.
COARSEST = 3
#: Of an infinite ground, this many decay lengths are meshed before the tails begin.
MESHED_DECAYS = 1.0
#: Of a continuum, whose settlement beyond the plate needs no mesh, this share of the plate's longer side is shown.
SHOWN_SHARE = 0.5
#: Elements at an edge with ground beyond are at most this share of the length over which the ground dies out there...
EDGE_SHARE = 0.5
#: ... but not smaller than this share of the largest ones: then the force along the edge is next to nothing.
EDGE_LEAST = 1 / 16
AXIS: dict[Side, int] = {"left": 0, "right": 0, "bottom": 1, "top": 1}
OUTWARD: dict[Side, int] = {"left": -1, "right": 1, "bottom": -1, "top": 1}


Meshed = tuple[Mesh, Integers, Integers]


@dataclass(slots=True)
class Meshes:
    """Meshes by what they were made from, so that models of the same shape share them: sections and ranks with each."""

    made: dict[Hashable, Meshed] = field(default_factory=dict)
    local: Sources | None = None  # smaller elements that all of them have in places
    closed: bool = False  # whether no further ones are kept

    def of(self, source: Hashable, make: Callable[[], tuple[Mesh, Integers]]) -> Meshed:
        """Return the mesh of a source, made now if there is none."""
        meshed = self.made.get(source)
        if meshed is None:
            mesh, section = make()
            moving, *_ = connect(mesh.elements)
            graded = not np.array_equal(moving, mesh.elements)
            meshed = mesh, section, elimination_order(Mesh(mesh.nodes, moving), graded)
            if not self.closed:
                self.made[source] = meshed
        return meshed


@dataclass(frozen=True, slots=True)
class Layout:
    """The meshed part of a plan."""

    mesh: Mesh
    rank: Integers  # (n,): order of elimination of the nodes
    plate_elements: Integers  # (mp,)
    section: Integers  # (mp,): which section each plate element has
    plate: Integers  # (mp,): which plate it belongs to
    source: Integers  # (n,): which node each one is, of those along joints that every plate has for itself
    mesh_plan: MeshPlan
    outer: Integers  # (s, 3: end, end, middle): sides on the outer edge of the meshed ground
    outer_axis: Integers  # (s,): the axis across each of them
    origin: Place = (0.0, 0.0)  # where x = y = 0 lies in the plan that was given, for messages

    @property
    def symmetry(self) -> tuple[bool, bool]:
        """Return whether symmetry along x, and along y, is used."""
        return self.mesh_plan.symmetry

    @property
    def plate_edges(self) -> Integers:
        """Return the sides (b, 3: end, end, middle) of the plate's edge, openings' too; lines of symmetry are none."""
        sides = sides_on_boundary(self.mesh.elements[self.plate_elements])
        for axis in (0, 1):
            if self.symmetry[axis]:
                sides = sides[(self.mesh.nodes[sides, axis] != 0.0).any(axis=1)]
        return sides

    @property
    def plate_lengths(self) -> Array:
        """Return the longer side of each plate's meshed part, (plates,) [m]."""
        xy = self.mesh.xy[self.plate_elements]
        low, high = np.full((self.plate.max() + 1, 2), np.inf), np.full((self.plate.max() + 1, 2), -np.inf)
        np.minimum.at(low, self.plate, xy.min(axis=1))
        np.maximum.at(high, self.plate, xy.max(axis=1))
        lengths: Array = (high - low).max(axis=1)
        return lengths

    @property
    def plate_nodes(self) -> Integers:
        """Return the nodes of the plate, ascending."""
        return unique_integers(self.mesh.elements[self.plate_elements])[0]


def layout(model: Model, grounds: list[Soil | Column], coarsening: int, margin: float, meshes: Meshes) -> Layout:
    """Return the layout of a model; `coarsening` halves the counts so many times.

    With a `margin` above 1 the meshed strip of ground beyond is made wider by (margin - 1) times its width, at least by
    as many lengths over which the ground dies out, with further rows of elements; the rest of the mesh stays as it is.
    """
    symmetry, width = symmetries(model), _width_beyond(model, grounds)
    wider = (margin - 1) * max(width, _longest_decay(model, grounds)) if width and margin > 1 else 0.0
    divided = coarsening == 0 and not uniform(model, symmetry, width)
    source, make, arcs = _mesh_of(model, grounds, symmetry, width, coarsening + divided, meshes.local)
    meshed = meshes.of(source, make)
    if divided:
        coarser = meshed
        source = source, "halved"
        meshed = meshes.of(source, lambda: _divide(coarser, arcs))
    if wider:
        narrow = meshed
        meshed = meshes.of((source, wider), lambda: _widen(model, symmetry, narrow, wider))
    if model.joints:
        joined = meshed
        meshed = meshes.of((source, wider, "separate"), lambda: _separate(model, joined))
    mesh, section, rank = meshed
    plate_elements = np.flatnonzero(section >= 0)
    outer, axis = _outer_sides(model, symmetry, mesh)
    section = section[plate_elements]
    plate = np.searchsorted(first_sections(model.every_plate), section, side="right") - 1
    first_at = first_at_place(mesh) if model.joints else np.arange(len(mesh.nodes))
    mesh_plan = _mesh_plan(model, symmetry, width)
    return Layout(mesh, rank, plate_elements, section, plate, first_at, mesh_plan, outer, axis, model.origin)


def _separate(model: Model, joined: Meshed) -> tuple[Mesh, Integers]:
    """Return a mesh whose plates share no nodes, and the sections."""
    mesh, section, _ = joined
    plate = np.searchsorted(first_sections(model.every_plate), section, side="right") - 1
    return separate(mesh, np.where(section >= 0, plate, -1)), section


def _divide(coarser: Meshed, arcs: list[Segment]) -> tuple[Mesh, Integers]:
    """Return a mesh with every element cut into four, and the sections."""
    from groundslab.meshing.refinement import halve

    return halve(coarser[0], arcs), np.repeat(coarser[1], 4)


def _mesh_of(
    model: Model,
    grounds: list[Soil | Column],
    symmetry: tuple[bool, bool],
    width: float,
    coarsening: int,
    local: Sources | None,
) -> tuple[Hashable, Callable[[], tuple[Mesh, Integers]], list[Segment]]:
    """Return what a mesh is made from, with ground beyond of a width [m], what makes it, and arcs that it follows."""
    edge_size = _edge_size(model, grounds, coarsening)
    if uniform(model, symmetry, width):
        counts = _counts(model, symmetry, coarsening)
        widths = _widths(model, width)
        source = model.plate.sides, symmetry, counts, model.mesh.counts, tuple(widths.values()), edge_size
        return source, lambda: _make_grid(model, symmetry, counts, widths, edge_size), []
    plan, size = plan_of(model, symmetry, width), _size(model) * 2**coarsening
    if local is not None:
        local = local[0], local[1] * 2**coarsening
    of_plan = plan, size, edge_size, model.mesh.adaptive
    return of_plan, lambda: _make_plan_mesh(plan, size, edge_size, local, model.mesh.adaptive), plan.arcs()


def uniform(model: Model, symmetry: tuple[bool, bool], width: float) -> bool:
    """Return whether a plate's mesh is a grid of equal rectangles: one with given counts, or on which all borders lie.

    width [m] is that of the ground beyond.
    """
    if not model.plain or model.mesh.adaptive or model.mesh.refine:
        return False
    borders = model.void_rings + model.zone_rings
    if model.mesh.counts is not None or not borders:
        return True
    if width:  # its lines come closer towards the plate's edges
        return False
    x, y = model.plate.sides
    nx, ny = (count * (1 + half) for count, half in zip(_counts(model, symmetry, 0), symmetry, strict=True))
    lines = np.linspace(-x / 2, x / 2, nx + 1), np.linspace(-y / 2, y / 2, ny + 1)
    x0, x1, y0, y1 = _reach(model, width)
    return all(on_lines(ring, lines, ((x0, x1), (y0, y1))) for ring in borders)


def _mesh_plan(model: Model, symmetry: tuple[bool, bool], width: float) -> MeshPlan:
    """Return what is decided on the mesh of a model; width [m] is that of the ground beyond."""
    followed = () if uniform(model, symmetry, width) else plan_of(model, symmetry, width).borders

    def numbers_of(rings: tuple[Ring, ...]) -> tuple[int, ...]:
        return tuple(number for number, ring in enumerate(rings) if ring in followed)

    return MeshPlan(symmetry, numbers_of(model.zone_rings), numbers_of(model.void_rings), has_coarser(model, symmetry))


def _widths(model: Model, width: float) -> dict[Side, float]:
    """Return how wide the meshed ground is on each side of the plate [m], width [m] of it beside plate and loads.

    A margin is as wide as it is described: loads lie on it.
    """
    widths: dict[Side, float] = {side: width if side in model.beyond.sides else 0.0 for side in SIDES}
    if width and model.beyond.kind == "infinite":
        for side, distance in distances_beyond(model.plate, model.loads, model.plates).items():
            widths[side] += max(distance, 0.0)
    return widths


def _reach(model: Model, width: float) -> tuple[float, float, float, float]:
    """Return the rectangle x0, x1, y0, y1 around the plate and so wide a ground beyond it [m]."""
    grow, (x0, x1, y0, y1) = _widths(model, width), model.bounds
    return x0 - grow["left"], x1 + grow["right"], y0 - grow["bottom"], y1 + grow["top"]


def coarsest(model: Model) -> int:
    """Return how often the counts of a model's mesh can be halved for the nested iteration.

    One that is made for the errors follows loads and borders: meshes beyond the next coarser one are hardly smaller.
    """
    if not model.analysis.nested:
        return 0
    if model.mesh.adaptive and not isinstance(model.ground, ContinuousGround):
        return 1
    times, symmetry = 0, symmetries(model)
    while COARSEST <= min(_counts(model, symmetry, times + 1)) < min(_counts(model, symmetry, times)):
        times += 1
    return times


def has_coarser(model: Model, symmetry: tuple[bool, bool]) -> bool:
    """Return whether the next coarser mesh has clearly fewer elements."""
    return 2 * math.prod(_counts(model, symmetry, 1)) <= math.prod(_counts(model, symmetry, 0))


def _counts(model: Model, symmetry: tuple[bool, bool], coarsening: int) -> tuple[int, int]:
    """Return the numbers of elements along x and y in the part of the plate that is meshed, of several the least."""
    lengths = [min(plate.sides[axis] for plate in model.every_plate) for axis in (0, 1)]
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
    if isinstance(model.ground, ContinuousGround):
        return SHOWN_SHARE * max(model.plate.sides)
    return MESHED_DECAYS * _longest_decay(model, grounds)


def _columns(grounds: list[Soil | Column]) -> list[Column]:
    """Return the columns of grounds that carry shear, with a usual mode where it is not known yet."""
    columns = [ground if isinstance(ground, Column) else ground.column(ground.gamma or 1.0) for ground in grounds]
    return [column for column in columns if np.linalg.eigvalsh(column.A1).min() > 0]


def _longest_decay(model: Model, grounds: list[Soil | Column]) -> float:
    """Return the longest length over which a mode of the ground dies out [m], at most twice the plate's longer side."""
    longest = max((1 / float(edge_decay(column).decay.min()) for column in _columns(grounds)), default=0.0)
    return min(longest, 2 * max(model.sides))


def _edge_size(model: Model, grounds: list[Soil | Column], coarsening: int) -> float:
    """Return the largest size of elements at the plate's edges with ground beyond, beside them on the plate too [m]."""
    largest = _size(model)
    if model.mesh.counts is not None:
        largest = max(length / count for length, count in zip(model.plate.sides, model.mesh.counts, strict=True))
    if model.ground_reaches:
        wanted = [EDGE_SHARE * decay_length(column) for column in _columns(grounds)]
        largest = min(largest, max(min(wanted, default=largest), EDGE_LEAST * largest))
    return largest * 2.0**coarsening


def _make_grid(
    model: Model, symmetry: tuple[bool, bool], counts: tuple[int, int], widths: dict[Side, float], edge_size: float
) -> tuple[Mesh, Integers]:
    """Return the grid of a plain rectangle and its ground beyond, and each element's section, -1 beyond."""
    lines, inside = [], []
    for axis, (length, count) in enumerate(zip(model.plate.sides, counts, strict=True)):
        low, high = 0.0 if symmetry[axis] else -length / 2, length / 2
        size = (high - low) / count
        reached = {OUTWARD[side]: width for side, width in widths.items() if width and AXIS[side] == axis}
        if symmetry[axis]:
            reached.pop(-1, None)
        inner = np.linspace(low, high, count + 1)
        if reached and model.mesh.counts is None:
            inner = towards_edges(low, high, size, np.array([side * length / 2 for side in reached]), edge_size)
        beyond = {outward: distances_beyond_edge(width, min(size, edge_size), size, length / 2)
                  for outward, width in reached.items()}  # fmt: skip
        before = -length / 2 - beyond[-1][::-1] if -1 in reached else np.zeros(0)
        after = length / 2 + beyond[1] if 1 in reached else np.zeros(0)
        lines.append(np.concatenate([before, inner, after]))
        inside.append(np.repeat([False, True, False], [len(before), len(inner) - 1, len(after)]))
    return grid(lines[0], lines[1]), np.where((inside[1][:, None] & inside[0]).ravel(), 0, -1)


def _widen(model: Model, symmetry: tuple[bool, bool], narrow: Meshed, wider: float) -> tuple[Mesh, Integers]:
    """Return a mesh whose ground beyond the plate is so much wider [m], by further rows of elements, and its sections.

    The rows continue the growth of the elements that the mesh ends with.
    """
    mesh, section, _ = narrow
    for side in model.beyond.sides:
        axis, outward = AXIS[side], OUTWARD[side]
        if symmetry[axis] and outward < 0:
            continue
        across = outward * mesh.xy[:, :, axis]
        outermost = across.max(axis=1) == across.max()
        last = float(np.ptp(across[outermost], axis=1).max())
        mesh = extrude(mesh, axis, outward, distances_beyond_edge(wider, last, np.inf, 1.0))
    return mesh, np.concatenate([section, np.full(len(mesh.elements) - len(section), -1)])


def _size(model: Model) -> float:
    """Return the largest side that an element may have [m]; on smaller plates it is less, see `local_sizes`."""
    if model.mesh.size is not None:
        return model.mesh.size
    return max(usual_size(plate.sides) for plate in model.every_plate)


def _make_plan_mesh(
    plan: Plan, size: float, edge_size: float, local: Sources | None, adaptive: bool
) -> tuple[Mesh, Integers]:
    """Return the mesh of a plate of any shape and its ground beyond, and each element's section, -1 beyond."""
    from groundslab import meshing

    if adaptive:
        meshed = meshing.adaptable(plan, size, edge_size, local)
    else:
        meshed = meshing.mesh(plan, size, edge_size=edge_size, local=local)
    return Mesh(meshed.nodes, meshed.elements), meshed.section


def plan_of(model: Model, symmetry: tuple[bool, bool], width: float) -> Plan:
    """Return the plan of what is meshed, with the borders of voids and soil zones that a mesh can follow.

    And with the places where loads on beams and walls have kinks.

    Zone i of the plate is section i; ground beyond fills the rectangle that is `width` [m] wider. Of a symmetric plate
    only the part beyond the lines of symmetry is meshed.
    """
    low = [0.0 if mirrored else -np.inf for mirrored in symmetry]

    def meshed(x0: float, x1: float, y0: float, y1: float) -> Ring:
        return rectangle(max(x0, low[0]), x1, max(y0, low[1]), y1)

    beyond = meshed(*_reach(model, width)) if width else None
    lines = tuple(path for beam in model.members for path in paths_on_plates(beam, model.plate, model.plates))
    plan = plan_of_plate(model.plate, model.supports, beyond, model.plates, lines)
    if any(symmetry):
        plan = replace(plan, outline=meshed(*model.plate.bounds))
    plan = follow_kinks(plan, model, [edge for line in lines for edge in make_segments(*line)])
    curved = curved_beams(model.members, model.every_plate)
    plan = add_borders(plan, (*curved, *model.void_rings, *model.zone_rings))
    plan = replace(plan, origin=model.origin)
    return follow_loads(plan, model) if model.mesh.adaptive else plan


def _outer_sides(model: Model, symmetry: tuple[bool, bool], mesh: Mesh) -> tuple[Integers, Integers]:
    """Return the sides (s, 3) of the mesh beyond which there was ground to mesh, and the axis across each (s,)."""
    sides = sides_on_boundary(mesh.elements)
    outer, axes = [np.zeros((0, 3), dtype=np.int64)], [np.zeros(0, dtype=np.int64)]
    for side in model.beyond.sides if model.ground_reaches else ():
        axis = AXIS[side]
        if symmetry[axis] and OUTWARD[side] < 0:
            continue
        coordinate = OUTWARD[side] * mesh.nodes[:, axis]
        on_side = sides[(coordinate[sides] == coordinate.max()).all(axis=1)]
        outer.append(on_side)
        axes.append(np.full(len(on_side), axis))
    return np.concatenate(outer), np.concatenate(axes)


def towards_edges(low: float, high: float, size: float, edges: Array, edge_size: float) -> Array:
    """Return lines from low to high [m], at most `size` apart, which come as close as `edge_size` at the edges (e,)."""
    limit = graded_size(edges, edge_size)
    return np.append(low, divide_graded(lambda x: np.minimum(size, limit(x)), low, high))


def distances_beyond_edge(width: float, first: float, size: float, scale: float) -> Array:
    """Return the distances of lines from the edge that they follow, up to the last one at `width` [m].

    Intervals are at most `first` long at the edge and grow as fast as elements may, but at the distance d they are at
    most size * (1 + d / scale). There are two at least.
    """
    return divide_graded(
        lambda d: np.minimum(np.minimum(first + GRADING * d, size * (1 + d / scale)), width / 2), 0.0, width
    )
