"""Design moments at columns, piles, ends of walls and across walls: at their faces, and as means over a width.

A plate's moment under a support that is small beside the slab has a peak that bars share: those that are laid across a
width of it. So the design moments at nodes near a support are replaced by the mean of those on a line across the bars,
over the width that the case says; the lines under a support are its faces. Means hold the integral: the bars over the
width bear what the peak asks for, as long as they lie in it.

The mean counts where the moment is larger in the middle of the line than on it: a moment of the other face, which is
largest beside a support, is left as it is.

A line ends where the plate does, at an opening, at a joint or at a step of its thickness. Where the lines of two
supports pass a node, the larger mean counts.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import cos, sin, sqrt
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from groundslab.arrays import Array, Flags, Integers, made_once_by
from groundslab.design.demands.design_moments import DesignMoments, design_moments
from groundslab.fem.mesh import Mesh, boxes_of, locate
from groundslab.fem.shape_functions import q9_values
from groundslab.geometry.plan import Segment
from groundslab.messages import Message
from groundslab.model.design.averaging import Averaging, along_axis
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.model.structure.wall_ends import WallEnd, wall_ends
from groundslab.model.supports import LineSupport
from groundslab.results.fields import LAYERS, place_of
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from scipy import sparse

#: Points at which a line reads moments, on each side of its middle.
SAMPLES = 32
#: Lines from a face of a support to where its means end.
LINES = 4
#: Lines across a strip of unit width per length, at least.
PER_WIDTH = 16
#: What counts as rounding, relative.
ROUNDING = 1e-9
#: Places closer than this over the size of what is looked at are the same.
SAME = 1e-9
#: Of moments across a wall are those whose bars turn from its normal by less [cosine].
ACROSS = sqrt(0.5)
#: How far from the axis of a wall moments across it are taken, over its thickness.
FROM_AXIS = {"face": 0.5, "quarter": 0.25}


@dataclass(frozen=True, slots=True)
class SupportArea:
    """Where a support stands, as a rectangle along x and y of its area, and the width of its means across x and y."""

    name: str
    center: tuple[float, float]  # [m]
    sides: tuple[float, float]  # along x and y [m]
    width: tuple[float, float]  # of lines along x and along y [m]


class Lines(NamedTuple):
    """Lines across the bars along one axis, and which of them count at which nodes.

    A node's mean is that of its first line, its second, or straight between them.
    """

    means: sparse.csr_array  # (s, n): mean of nodal values over each line
    middles: sparse.csr_array  # (s, n): the same over what of it is next to its middle, 0 of strips
    middle: Array  # (s, 2): of what of a line lies on the plate [m]
    length: Array  # (s,): of that [m]
    read: Integers  # (s,): at how many points it is read
    area: Integers  # (s,): which support's
    of_strip: Flags  # (s,): whether a strip's
    node: Integers  # (k,)
    first: Integers  # (k,)
    second: Integers  # (k,)
    share: Array  # (k,): of the second

    def of(self, values: Array) -> Array:
        """Return nodal values (n,) of one sign, with means where lines count."""
        sign = 1.0 if values.sum() >= 0 else -1.0
        read, counts = self._read(sign * values)
        largest, node = np.zeros(len(values)), self.node[counts]
        np.maximum.at(largest, node, read[counts])
        averaged = values.copy()
        averaged[node] = sign * largest[node]
        return averaged

    def width_at(self, values: Array, node: int) -> float | None:
        """Return the width [m] of the mean that a node has of nodal values (n,) of one sign; None where it has none."""
        read, counts = self._read(values if values.sum() >= 0 else -values)
        mine = np.flatnonzero(counts & (self.node == node))
        if not len(mine):
            return None
        k = mine[np.argmax(read[mine])]
        share = self.share[k]
        return float((1 - share) * self.length[self.first[k]] + share * self.length[self.second[k]])

    def _read(self, sizes: Array) -> tuple[Array, Flags]:
        """Return the means (k,) that nodes read of nodal sizes (n,), and whether they count."""
        means, peaked = self.over(sizes)
        counts = (peaked[self.first] | (self.share == 1)) & (peaked[self.second] | (self.share == 0))
        return (1 - self.share) * means[self.first] + self.share * means[self.second], counts

    def over(self, sizes: Array) -> tuple[Array, Flags]:
        """Return the means (s,) of nodal sizes (n,) over the lines, and whether they count."""
        means = self.means @ sizes
        return means, np.asarray(self.of_strip | (self.middles @ sizes >= means * (1 - ROUNDING)))


def bar_moments(results: CombinationResult, steel: Reinforcement) -> DesignMoments:
    """Return the design moments (n,) [N m/m] that bars are for: Wood's, with means and faces at supports."""
    peaks = design_moments(results.plate)
    lines = averaging_lines(results, steel)
    averaged = dict[str, Array]()
    for layer in LAYERS:
        of_layer, across = getattr(peaks, layer), lines[layer[-1] == "y"]
        averaged[layer] = of_layer if across is None else across.of(of_layer)
    return DesignMoments(**averaged)


class MomentOrigin(NamedTuple):
    """What the design moment of a layer at a node follows from: a mean over a width, or the plate's moments there."""

    width: float | None  # [m]
    along: float = 0.0  # bending moment of strips along the bars [N m/m]
    across: float = 0.0  # of strips across them [N m/m]
    twisting: float = 0.0  # [N m/m]


def origin_of(
    results: CombinationResult, steel: Reinforcement, layer: str, place: tuple[float, float], moment: float
) -> MomentOrigin:
    """Return what a layer's design moment [N m/m] at a node's place [m] follows from."""
    plate = results.plate
    of_layer = getattr(bar_moments(results, steel), layer)
    here = np.flatnonzero((np.abs(plate.nodes - place) <= SAME * np.ptp(plate.nodes)).all(axis=1))
    node = int(here[np.argmin(np.abs(np.abs(of_layer[here]) - abs(moment)))])
    lines = averaging_lines(results, steel)[layer[-1] == "y"]
    width = None if lines is None else lines.width_at(getattr(design_moments(plate), layer), node)
    if width is not None:
        return MomentOrigin(width)
    m_x, m_y = float(plate.moment_x[node]), float(plate.moment_y[node])
    along, across = (m_x, m_y) if layer[-1] == "x" else (m_y, m_x)
    return MomentOrigin(None, along, across, float(plate.moment_xy[node]))


@dataclass(frozen=True, slots=True)
class SupportMoment:
    """The design moment at a support for bars along one axis, at the face where it is larger, and the peak there."""

    support: str
    layer: str
    width: float  # of the line that it is the mean over, what of it lies on the plate [m]
    moment: float  # [N m/m]
    place: tuple[float, float]  # the line's middle [m]
    combination: str
    peak: float  # the largest at a node near the support in that combination [N m/m]
    peak_place: tuple[float, float]  # [m]


def moments_at_supports(results: Sequence[CombinationResult], steel: Reinforcement) -> list[SupportMoment]:
    """Return the largest design moment at each support over combinations, for bars along x and along y."""
    if not results:
        return []
    nodes = results[0].plate.nodes
    areas, lines = support_areas(results[0], steel), averaging_lines(results[0], steel)
    designs = {result.combination: design_moments(result.plate) for result in results}
    rows = list[tuple[int, SupportMoment]]()
    for axis, across in zip("xy", lines, strict=True):
        if across is None:
            continue
        sizes = dict[tuple[str, str], Array]()
        for name, moments in designs.items():
            for layer in (f"bottom_{axis}", f"top_{axis}"):
                means, counts = across.over(abs(getattr(moments, layer)))
                sizes[name, layer] = np.where(counts, means, 0.0)
        keys, table = [*sizes], np.array([*sizes.values()])
        for number, area in enumerate(areas):
            mine = np.flatnonzero((across.area == number) & (across.read > 0))
            if not len(mine):
                continue
            which, place = np.unravel_index(int(table[:, mine].argmax()), (len(keys), len(mine)))
            (name, layer), line = keys[which], int(mine[place])
            near = across.node[np.isin(across.first, mine) | np.isin(across.second, mine)]
            peaks = getattr(designs[name], layer)[near]
            peak = int(np.argmax(abs(peaks)))
            moment = float(table[which, line]) * (1.0 if layer.startswith("bottom") else -1.0)
            rows.append((number, SupportMoment(
                area.name, layer, float(across.length[line]), moment, place_of(across.middle, line), name,
                float(peaks[peak]), place_of(nodes, int(near[peak])),
            )))  # fmt: skip
    return [row for _, row in sorted(rows, key=lambda numbered: numbered[0])]


def support_areas(results: CombinationResult, steel: Reinforcement) -> tuple[SupportArea, ...]:
    """Return the areas of columns, of supports and piles with a diameter, and of ends and corners of walls.

    A support whose sides do not run along x and y counts as a rectangle of the same area, with the proportions of the
    rectangle around it along x and y (ACI 318-19 13.2.7.3 for circles).
    """
    rule, model = steel.averaging, results.model
    return tuple(
        SupportArea(name, center, sides, _widths(results, steel, rule, center, sides))
        for name, center, sides in _footprints(model)
    )


def has_support_areas(model: Model) -> bool:
    """Return whether a model has supports around which moments are averaged."""
    return next(_footprints(model), None) is not None


def _footprints(model: Model) -> Iterator[tuple[str, tuple[float, float], tuple[float, float]]]:
    """Yield names, centers and sides along x and y [m]."""
    for column in model.columns:
        x, y = column.extents
        same_area = sqrt(column.ring().area / (x * y))
        yield column.name, (column.x, column.y), (x * same_area, y * same_area)
    for number, support in enumerate(model.supports, start=1):
        if not isinstance(support, LineSupport) and support.diameter is not None:
            side = support.diameter * sqrt(np.pi) / 2
            yield support.name or Message("support {number}", number=number), (support.x, support.y), (side, side)
    for end in wall_ends(model.placed_walls, model.spans_of_walls):
        t = max(leg.thickness for leg in end.legs)
        yield end.name, _center(end, t), (t, t)


def _center(end: WallEnd, t: float) -> tuple[float, float]:
    """Return the center of the last part of a wall, as long as it is thick, or of a corner [m]."""
    x, y = end.place
    if end.kind == "corner":
        return x, y
    angle = end.legs[0].angle
    return x + t / 2 * cos(angle), y + t / 2 * sin(angle)


def _widths(
    results: CombinationResult,
    steel: Reinforcement,
    rule: Averaging,
    center: tuple[float, float],
    sides: tuple[float, float],
) -> tuple[float, float]:
    """Return over which width along x, and along y, a support's means are [m]."""
    if isinstance(rule.width, float):
        return rule.width, rule.width
    plate = results.plate
    node = int(np.argmin(((plate.nodes - center) ** 2).sum(axis=1)))
    h = float(results.elements.at_nodes(plate)[0][node])
    d = h - max(sum(steel.bottom_axes), sum(steel.top_axes)) / 2
    more = 2 * d if rule.width == "c + 2 d" else 3 * h
    return sides[0] + more, sides[1] + more


@made_once_by(lambda results, steel: (results.plate.nodes, results.model, steel))
def averaging_lines(results: CombinationResult, steel: Reinforcement) -> tuple[Lines | None, Lines | None]:
    """Return the lines over which moments are averaged for bars along x, and along y; None where there are none."""
    rule, plate = steel.averaging, results.plate
    areas = support_areas(results, steel) if rule.at_columns != "peak" else ()
    pieces = [piece for wall in results.model.placed_walls for piece in wall.pieces]
    walls = [(piece.thickness, edge) for piece in pieces for edge in piece.edges]
    if rule.at_walls == "peak":
        walls = []
    parts = _parts(plate.elements, len(plate.nodes))
    along_x, along_y = (
        _Builder(Mesh(plate.nodes, plate.elements), parts, axis).build(results.model, rule, areas, walls)
        for axis in (0, 1)
    )
    return along_x, along_y


def _parts(elements: Integers, n: int) -> Integers:
    """Return to which part of the plate each node (n,) belongs; joints and steps of the thickness part it."""
    from scipy import sparse

    first = np.repeat(elements[:, 0], elements.shape[1])
    joined = sparse.coo_array((np.ones(elements.size), (first, elements.ravel())), shape=(n, n))
    return np.asarray(sparse.csgraph.connected_components(joined, directed=False)[1], dtype=np.int64)


class _Asked(NamedTuple):
    """Lines that are asked for by one support, wall or strip, and by which nodes."""

    points: Array  # (s, 2, p, 2): samples from the middle to each side [m]
    near: Array  # (p,): distances of the samples from the middle [m]
    within: float  # how far from the middle a line may begin [m]
    width: float  # of a whole line [m]
    node: Integers  # (k,)
    first: Integers  # (k,): among these lines
    second: Integers
    share: Array
    of_strip: bool = False


@dataclass(frozen=True, slots=True)
class _Builder:
    """What makes the lines for bars along one axis."""

    mesh: Mesh
    part: Integers  # (n,) of nodes
    axis: int

    def build(
        self, model: Model, rule: Averaging, areas: Sequence[SupportArea], walls: list[tuple[float, Segment]]
    ) -> Lines | None:
        """Return the lines of supports, walls and strips; what comes first counts at a node."""
        nodes = self.mesh.nodes
        left = np.ones(len(nodes), dtype=bool)
        asked, of_area = list[_Asked](), list[int]()
        strips = [strip for strip in model.output.strips
                  if (rule.by == "strip" or strip.design == "beam") and along_axis(strip) == self.axis]  # fmt: skip
        groups: list[list[tuple[int, _Asked]]] = [
            [(-1, lines) for strip in strips for lines in [self._strip(strip.start, strip.end, strip.width, areas)]],
            [
                (number, lines)
                for number, area in enumerate(areas)
                for lines in [self._support(area) if rule.at_columns == "width" else self._faces(area)]
            ],
            [(-1, lines) for t, edge in walls for lines in [self._across(edge, FROM_AXIS[rule.at_walls] * t, t)]],
        ]
        for group in groups:
            taken = np.zeros(len(nodes), dtype=bool)
            for number, lines in group:
                free = left[lines.node]
                if free.any():
                    asked.append(lines._replace(
                        node=lines.node[free], first=lines.first[free], second=lines.second[free],
                        share=lines.share[free],
                    ))  # fmt: skip
                    of_area.append(number)
                    taken[lines.node[free]] = True
            left &= ~taken
        return self._read(asked, of_area) if asked else None

    def _support(self, area: SupportArea) -> _Asked:
        """Return the lines of a support: its faces, and on from there to where its means end."""
        a, b = self.axis, 1 - self.axis
        half, reach = area.sides[a] / 2, max(area.width[a], area.sides[a]) / 2
        beyond = np.linspace(half, reach, LINES + 1)
        places = area.center[a] + np.concatenate([-beyond[::-1], beyond])
        return self._lines(places, area.center[b], area.width[b], area.sides[b] / 2, LINES)

    def _strip(
        self, start: tuple[float, float], end: tuple[float, float], width: float, areas: Sequence[SupportArea]
    ) -> _Asked:
        """Return the lines across a strip; those at the faces of supports in it are among them."""
        a, b = self.axis, 1 - self.axis
        low, high = sorted((start[a], end[a]))
        places = np.linspace(low, high, 2 + int(PER_WIDTH * (high - low) / width))
        for area in areas:
            if abs(area.center[b] - start[b]) < width / 2:
                faces = area.center[a] + area.sides[a] / 2 * np.array([-1, 1])
                under = (places > faces[0]) & (places < faces[1])
                places = np.unique(np.concatenate([places[~under], faces.clip(low, high)]))
        return self._lines(places, start[b], width, width / 2, None)._replace(of_strip=True)

    def _lines(self, places: Array, middle: float, width: float, within: float, under: int | None) -> _Asked:
        """Return lines at places (s,) along the bars; between two, from one of them, lies the support itself."""
        a, b = self.axis, 1 - self.axis
        near = (np.arange(SAMPLES) + 0.5) / SAMPLES * width / 2
        points = np.empty((len(places), 2, SAMPLES, 2))
        points[..., a] = places[:, None, None]
        points[..., b] = middle + np.stack([-near, near])[None]
        along, across = self.mesh.nodes[:, a], self.mesh.nodes[:, b]
        small = SAME * max(width, float(np.ptp(places)))
        node = np.flatnonzero(
            (along >= places[0] - small) & (along <= places[-1] + small) & (abs(across - middle) <= width / 2 + small)
        )
        second = np.clip(np.searchsorted(places, along[node] - small), 1, len(places) - 1)
        first = second - 1
        apart = places[second] - places[first]
        share = np.clip(np.divide(along[node] - places[first], apart, out=np.zeros(len(node)), where=apart > 0), 0, 1)
        if under is not None:  # at each node under the support both faces count, each for itself
            below = np.flatnonzero(first == under)
            node = np.concatenate([node, node[below]])
            first, second = (np.concatenate([of, of[below]]) for of in (first, second))
            share[below] = 0.0
            share = np.concatenate([share, np.ones(len(below))])
        return _Asked(points, near, within, width, node, first, second, share)

    def _faces(self, area: SupportArea) -> _Asked:
        """Return both faces of a support beside each node in it."""
        a = self.axis
        offset = self.mesh.nodes - area.center
        node = np.flatnonzero((abs(offset) <= np.array(area.sides) / 2 * (1 + SAME)).all(axis=1))
        places = np.repeat(self.mesh.nodes[node][:, None], 2, axis=1)
        places[..., a] = area.center[a] + area.sides[a] / 2 * np.array([-1.0, 1.0])
        return _beside(node, places)

    def _across(self, edge: Segment, far: float, t: float) -> _Asked:
        """Return the places so far [m] on both sides of a wall's axis beside each node that lies under the wall."""
        x0, x1, y0, y1 = edge.bounds
        low, high = np.array([x0, y0]) - t, np.array([x1, y1]) + t
        close = np.flatnonzero(((self.mesh.nodes >= low) & (self.mesh.nodes <= high)).all(axis=1))
        close = close[edge.distance(self.mesh.nodes[close]) < far * (1 - SAME)]
        part = np.array([edge.part((float(x), float(y))) for x, y in self.mesh.nodes[close]])
        held = (part > 0) & (part < 1)
        close, part = close[held], part[held]
        left = edge.left(part) if len(part) else np.empty((0, 2))
        crossing = abs(left[:, self.axis]) >= ACROSS - SAME
        close, left, on_axis = close[crossing], left[crossing], edge.at(part[crossing])
        return _beside(close, np.stack([on_axis - far * left, on_axis + far * left], axis=1).reshape(-1, 2, 2))

    def _read(self, asked: list[_Asked], of_area: list[int]) -> Lines | None:
        """Return lines by what of them lies on the plate, in one piece and in the part of the plate of their nodes."""
        from scipy import sparse

        points = np.concatenate([lines.points.reshape(-1, 2) for lines in asked])
        element, place = locate(self.mesh, points, boxes=boxes_of(self.mesh))
        N = q9_values(place)
        part_of_element = self.part[self.mesh.elements[:, 0]]
        rows, columns, weights, inner = list[Any](), list[Any](), list[Any](), list[Any]()
        kept: dict[str, list[Any]] = {name: [] for name in Lines._fields[2:]}
        count = start = 0
        for lines, number in zip(asked, of_area, strict=True):
            shape = lines.points.shape[:3]
            stop = start + int(np.prod(shape))
            at, shapes = element[start:stop], N[start:stop]
            sampled, start = points[start:stop], stop
            for part in np.unique(self.part[lines.node]):
                on = ((at >= 0) & (part_of_element[at] == part)).reshape(shape)
                used = _in_one_piece(on, lines.near <= lines.within)
                number_used = used.sum(axis=(1, 2))
                line, *_ = np.nonzero(used)
                flat = np.flatnonzero(used.ravel())
                rows.append(np.repeat(count + line, 9))
                columns.append(self.mesh.elements[at[flat]].ravel())
                weights.append((shapes[flat] / number_used[line][:, None]).ravel())
                order = np.where(used, np.arange(shape[2]), shape[2])
                inmost = used & (order == order.min(axis=(1, 2), keepdims=True))
                of_inmost = inmost.ravel()[flat] / np.maximum(inmost.sum(axis=(1, 2)), 1)[line]
                inner.append((shapes[flat] * of_inmost[:, None]).ravel())
                mine = self.part[lines.node] == part
                whole = (number_used[lines.first] > 0) | (lines.share == 1)
                whole &= (number_used[lines.second] > 0) | (lines.share == 0)
                mine &= whole
                middle = np.zeros((shape[0], 2))
                np.add.at(middle, line, sampled[flat] / number_used[line][:, None])
                kept["middle"].append(middle)
                kept["read"].append(number_used)
                kept["length"].append(number_used / (shape[1] * shape[2]) * lines.width)
                kept["area"].append(np.full(shape[0], number))
                kept["of_strip"].append(np.full(shape[0], lines.of_strip))
                kept["node"].append(lines.node[mine])
                kept["first"].append(count + lines.first[mine])
                kept["second"].append(count + lines.second[mine])
                kept["share"].append(lines.share[mine])
                count += shape[0]
        places = np.concatenate(rows), np.concatenate(columns)
        means, middles = (
            sparse.coo_array((np.concatenate(values), places), shape=(count, len(self.mesh.nodes))).tocsr()
            for values in (weights, inner)
        )
        return Lines(means, middles, *(np.concatenate(values) for values in kept.values()))


def _beside(node: Integers, places: Array) -> _Asked:
    """Return lines that are single places (k, 2, 2) [m], two beside each node (k,)."""
    twice, numbers = np.repeat(node, 2), np.arange(2 * len(node))
    points = np.repeat(places.reshape(-1, 1, 1, 2), 2, axis=1)
    return _Asked(points, np.zeros(1), 0.0, 0.0, twice, numbers, numbers, np.zeros(len(numbers)))


def _in_one_piece(on: Flags, begins: Flags) -> Flags:
    """Return which samples (s, 2, p) of lines count: from the first one on the plate, near the middle, to the next gap.

    A side counts where it begins at its own middle, or where the other side does.
    """
    first = np.argmax(on, axis=2)
    started = np.take_along_axis(on, first[..., None], axis=2)[..., 0] & begins[first]
    after = np.arange(on.shape[2]) >= first[..., None]
    return np.asarray(np.logical_and.accumulate(on | ~after, axis=2) & after & started[..., None])
