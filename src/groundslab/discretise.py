"""From the description of a problem to its arrays: the one door between Model and Problem."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable

import numpy as np

from groundslab import plate
from groundslab.assembly import number, scatter
from groundslab.errors import Fault, InputError
from groundslab.ground import Column, Layer, consistent_stack, interface_stack, single, tail
from groundslab.mesh import Mesh, elimination_order, functions_at, grid, lines_beyond
from groundslab.model import (
    Layered,
    Model,
    Pasternak,
    PatchLoad,
    PointLoad,
    SoilLayer,
    UniformLoad,
    Vlasov,
    Void,
    Winkler,
)
from groundslab.problem import BETA_X, TOP, Problem, W
from groundslab.shape import COLUMN, ROW, Array, Flags, Integers, gauss_line, lagrange
from groundslab.vlasov import Soil

#: A mesh is made coarser for the nested iteration while its plate keeps at least this many elements each way.
COARSEST = 3
#: Of an infinite ground, this many decay lengths are meshed before the tails begin.
MESHED_DECAYS = 1.0
#: Positions closer than this, relative to the longer side of the plate, are one.
SAME_PLACE = 1e-9
AXIS = {"left": 0, "right": 0, "bottom": 1, "top": 1}
OUTWARD = {"left": -1, "right": 1, "bottom": -1, "top": 1}


def discretise(model: Model, coarsening: int = 0, margin: float = 1.0) -> Problem:
    """Return the arrays of a model; `coarsening` halves the counts so many times, `margin` widens the ground beyond."""
    symmetry = symmetries(model)
    ground = ground_of(model)
    mesh, on_plate = _mesh(model, symmetry, coarsening, margin * _width_beyond(model, ground))
    plate_elements = np.flatnonzero(on_plate)
    element = plate.ELEMENTS[model.plate.element]
    sheet = model.plate
    edges, corners = _infinite_edges(model, symmetry, mesh)
    surfaces = _surfaces(ground)
    present = _present(model, symmetry, mesh, plate_elements, element, surfaces)
    rank = elimination_order(mesh)
    load = _loads(model, symmetry, mesh, plate_elements, element, present.shape[1])
    if not load.any():
        fault = Fault("loads", "loads that are all zero", "at least one load that is not", "nothing would settle")
        raise InputError([fault])
    return Problem(
        mesh=mesh,
        plate_elements=plate_elements,
        element=element,
        bending=plate.bending_rigidity(sheet.E, sheet.nu, sheet.thickness)[None],
        shear=np.array([plate.shear_rigidity(sheet.E, sheet.nu, sheet.thickness, sheet.shear_factor)]),
        section=np.zeros(len(plate_elements), dtype=np.int64),
        ground=ground,
        rank=rank,
        unknown=number(rank, present),
        load=load,
        initial_gap=_initial_gap(model, symmetry, mesh, plate_elements, coarsening == 0),
        tensionless=model.contact.tensionless,
        edges=edges,
        corners=corners,
        symmetry=symmetry,
    )


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
    if model.mesh.symmetry == "off":
        return False, False
    return _symmetric(model, 0), _symmetric(model, 1)


def _symmetric(model: Model, axis: int) -> bool:
    low, high = (("left", "right"), ("bottom", "top"))[axis]
    edges = model.plate.edges
    if getattr(edges, low) != getattr(edges, high) or ((low in model.beyond.sides) != (high in model.beyond.sides)):
        return False
    if model.mesh.counts is not None and model.mesh.counts[axis] % 2:
        return False
    size = max(model.plate.length_x, model.plate.length_y)

    def key(numbers: Iterable[float]) -> tuple[float, ...]:
        return tuple(round(value / size, 9) + 0.0 for value in numbers)

    here: Counter[tuple[object, ...]] = Counter()
    there: Counter[tuple[object, ...]] = Counter()
    for item in (*model.loads, *model.contact.voids):
        if isinstance(item, UniformLoad):
            continue
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
    lengths = model.plate.length_x, model.plate.length_y
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
    return MESHED_DECAYS * min(longest, 2 * max(model.plate.length_x, model.plate.length_y))


def _mesh(model: Model, symmetry: tuple[bool, bool], coarsening: int, width: float) -> tuple[Mesh, Flags]:
    """Return the mesh of plate and ground beyond, and which of its elements lie under the plate."""
    lines, inside = [], []
    for axis, (length, count) in enumerate(
        zip((model.plate.length_x, model.plate.length_y), _counts(model, symmetry, coarsening), strict=True)
    ):
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
    return grid(lines[0], lines[1]), (inside[1][:, None] & inside[0]).ravel()


def _side_nodes(mesh: Mesh, side: str) -> Integers:
    """Return the nodes of the mesh's outer side, in ascending order of the coordinate along it."""
    columns, rows = 2 * len(mesh.x) - 1, 2 * len(mesh.y) - 1
    table = np.arange(columns * rows).reshape(rows, columns)
    nodes: dict[str, Integers] = {"left": table[:, 0], "right": table[:, -1], "bottom": table[0], "top": table[-1]}
    return nodes[side]


def _outer_sides(model: Model, symmetry: tuple[bool, bool]) -> list[str]:
    """Return the sides of the mesh beyond which there was ground to mesh."""
    if model.beyond.kind == "none":
        return []
    return [side for side in model.beyond.sides if OUTWARD[side] > 0 or not symmetry[AXIS[side]]]


def _infinite_edges(model: Model, symmetry: tuple[bool, bool], mesh: Mesh) -> tuple[Integers, Integers]:
    """Return the outer sides (e, 3: end, end, middle) and corner nodes (c,) beyond which the ground is infinite."""
    edges = [np.zeros((0, 3), dtype=np.int64)]
    sides = _outer_sides(model, symmetry) if model.beyond.kind == "infinite" else []
    for side in sides:
        nodes = _side_nodes(mesh, side)
        edges.append(np.column_stack([nodes[:-1:2], nodes[2::2], nodes[1::2]]))
    corners = [
        np.intersect1d(_side_nodes(mesh, a), _side_nodes(mesh, b))[0]
        for a in sides
        for b in sides
        if AXIS[a] == 0 and AXIS[b] == 1
    ]
    return np.concatenate(edges), np.array(corners, dtype=np.int64)


def _surfaces(ground: Soil | Column) -> int:
    if isinstance(ground, Column):
        return ground.surfaces
    return len(ground.layers) if ground.way == "interface" else 1


def _present(
    model: Model,
    symmetry: tuple[bool, bool],
    mesh: Mesh,
    plate_elements: Integers,
    element: plate.PlateElement,
    surfaces: int,
) -> Flags:
    """Return which unknowns exist and are not held at zero, (n, F)."""
    n = len(mesh.nodes)
    under = np.zeros(n, dtype=bool)
    under[mesh.elements[plate_elements]] = True
    present = np.ones((n, TOP + surfaces), dtype=bool)
    present[:, :TOP] = under[:, None]
    present[:, TOP] = model.contact.tensionless | ~under
    if not element.centre_w:
        present[mesh.elements[plate_elements, 8], W] = False

    half = np.array([model.plate.length_x, model.plate.length_y]) / 2
    for side, axis in AXIS.items():
        along = 1 - axis
        if symmetry[axis] and OUTWARD[side] < 0:
            present[mesh.nodes[:, axis] == 0.0, BETA_X + axis] = False
            continue
        kind = getattr(model.plate.edges, side)
        on_edge = under & (mesh.nodes[:, axis] == OUTWARD[side] * half[axis])
        if kind in ("hinged", "soft", "clamped"):
            present[on_edge, W] = False
        if kind in ("hinged", "clamped"):
            present[on_edge, BETA_X + along] = False
        if kind == "clamped":
            present[on_edge, BETA_X + axis] = False
    if model.beyond.kind == "margin" and model.beyond.edge == "fixed":
        for side in _outer_sides(model, symmetry):
            present[_side_nodes(mesh, side), TOP:] = False
    return present


def _loads(
    model: Model,
    symmetry: tuple[bool, bool],
    mesh: Mesh,
    plate_elements: Integers,
    element: plate.PlateElement,
    fields: int,
) -> Array:
    """Return the nodal loads (n, F) [N]; distributed ones are integrated exactly over the meshed part of the plate."""
    half = np.array([model.plate.length_x, model.plate.length_y]) / 2
    by_element = np.zeros((len(mesh.elements), 9))
    for load in model.loads:
        if isinstance(load, PointLoad):
            by_element += _point(load, symmetry, mesh)
            continue
        extent = np.array([-half, half]).T if isinstance(load, UniformLoad) else np.array([load.x, load.y])
        x, y = np.clip(extent, -half[:, None], half[:, None])
        Ix, Iy = _interval_integrals(mesh.x, *x), _interval_integrals(mesh.y, *y)
        by_element += load.q * (Iy[:, None, ROW] * Ix[None, :, COLUMN]).reshape(-1, 9)
    if not element.centre_w:
        T = element.w_functions(mesh.xy[plate_elements])
        by_element[plate_elements] = np.einsum("ea,eab->eb", by_element[plate_elements], T)
    load_table = np.zeros((len(mesh.nodes), fields))
    load_table[:, W] = scatter(mesh.elements, by_element, len(mesh.nodes))
    return load_table


def _point(load: PointLoad, symmetry: tuple[bool, bool], mesh: Mesh) -> Array:
    """Return the element loads (m, 9) of a point load; on a line of symmetry each side takes half of it."""
    loads = np.zeros((len(mesh.elements), 9))
    share = 1.0
    on_axis = SAME_PLACE * np.ptp(mesh.nodes, axis=0).max()
    for value, mirrored in zip((load.x, load.y), symmetry, strict=True):
        if mirrored and value < -on_axis:
            return loads
        share *= 0.5 if mirrored and value <= on_axis else 1.0
    owner, N = functions_at(mesh, np.array([[load.x, load.y]]))
    loads[owner[0]] = share * load.P * N[0]
    return loads


def _interval_integrals(lines: Array, start: float, end: float) -> Array:
    """Return the integrals (i, 3) [m] of the quadratic functions of each interval of lines over start .. end."""
    low, high = np.clip(lines[:-1], start, end), np.clip(lines[1:], start, end)
    points, weights = gauss_line(3)
    x = (low + high)[:, None] / 2 + (high - low)[:, None] / 2 * points
    length = np.diff(lines)[:, None]
    xi = 2 * (x - lines[:-1, None]) / length - 1
    integrals: Array = np.einsum("ip,ipa->ia", (high - low)[:, None] / 2 * weights, lagrange(xi)[0])
    return integrals


def _initial_gap(
    model: Model, symmetry: tuple[bool, bool], mesh: Mesh, plate_elements: Integers, finest: bool
) -> Array:
    """Return the initial gap at every node (n,) [m], zero beyond the plate."""
    gap = np.zeros(len(mesh.nodes))
    under = np.unique(mesh.elements[plate_elements])
    gap[under] = model.contact.gap
    x, y = mesh.nodes[under].T
    extra = np.zeros(len(under))
    near = SAME_PLACE * max(model.plate.length_x, model.plate.length_y)
    faults: list[Fault] = []
    mend = "make the elements smaller than the void"
    for place, void in enumerate(model.contact.voids, start=1):
        inside = (x >= void.x[0] - near) & (x <= void.x[1] + near) & (y >= void.y[0] - near) & (y <= void.y[1] + near)
        if finest and not inside.any() and not _mirrored_away(void, symmetry):
            faults.append(Fault(f"contact.voids[{place}]", "a void between the nodes", "one that holds a node", mend))
        extra = np.where(inside, np.maximum(extra, void.depth), extra)
    if faults:
        raise InputError(faults)
    gap[under] += extra
    return gap


def _mirrored_away(void: Void, symmetry: tuple[bool, bool]) -> bool:
    """Return whether a void lies on the side of a mirror that is not meshed; its image is there."""
    return (symmetry[0] and void.x[1] < 0) or (symmetry[1] and void.y[1] < 0)


def layer_of(layer: SoilLayer) -> Layer:
    """Return the kernel's layer of a described one."""
    bottom = layer.E if layer.E_bottom is None else layer.E_bottom
    change = bottom - layer.E
    moduli = (layer.E, change, 0.0) if layer.variation == "linear" else (layer.E, 0.0, change)
    return Layer(layer.thickness, moduli, layer.nu)


def ground_of(model: Model) -> Soil | Column:
    """Return the ground: a column of constants, or soil whose constants follow from gamma."""
    ground = model.ground
    if isinstance(ground, Winkler):
        return single(winkler_modulus(model), 0.0)
    if isinstance(ground, Pasternak):
        return single(ground.k0, ground.k1)
    printed = ground.formulas == "as printed"
    gamma = None if ground.gamma == "iterate" else float(ground.gamma)
    if isinstance(ground, Vlasov):
        layers = tuple(layer_of(layer) for layer in ground.layers)
        by_profile = ground.mode == "profile" or (ground.mode == "auto" and len(layers) > 1)
        return Soil(layers, "profile" if by_profile else "sinh", printed, gamma)
    return _layered(ground, printed, gamma)


def _layered(ground: Layered, printed: bool, gamma: float | None) -> Soil | Column:
    if ground.coupling == "consistent":
        return consistent_stack(consistent_parts(ground))
    soil = [layer for layer in ground.layers if isinstance(layer, SoilLayer)]
    if soil:
        return Soil(tuple(layer_of(layer) for layer in soil), "interface", printed, gamma)
    given = [layer for layer in ground.layers if not isinstance(layer, SoilLayer)]
    return interface_stack(np.array([layer.k0 for layer in given]), np.array([layer.k1 for layer in given]))


def consistent_parts(ground: Layered) -> list[Layer]:
    """Return the layers of a consistent stack, each split into its sublayers."""
    soil = [layer for layer in ground.layers if isinstance(layer, SoilLayer)]
    return [part for layer in soil for part in layer_of(layer).split(layer.sublayers)]


def winkler_modulus(model: Model) -> float:
    """Return k [Pa/m], given or by Selvadurai's k = 2 E / (a ln(1 + 2 H / a)) with a the longer side (paper (3.1))."""
    ground = model.ground
    assert isinstance(ground, Winkler)
    if ground.k is not None:
        return ground.k
    assert ground.selvadurai is not None
    a = max(model.plate.length_x, model.plate.length_y)
    return 2 * ground.selvadurai.E / (a * math.log(1 + 2 * ground.selvadurai.depth / a))
