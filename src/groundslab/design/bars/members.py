"""What is designed as a beam: beams and ribs of concrete, and strips of the plate from edge to edge, as grade beams.

A strip has the section forces of the plate over its width, and the plate's section. Within the faces of a column its
moments are those at the faces, but where the case counts peaks. Where another strip crosses it, torsion counts up to
the other one's edge: beyond, it is the other one's bending.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Protocol

import numpy as np

from groundslab.arrays import Array, Flags, Integers, made_once, made_once_by
from groundslab.design.demands.beam_supports import Faces, faces_on
from groundslab.design.demands.cuts.section_cuts import StripResult, moments_across, strip
from groundslab.design.rules.design_code import TensionZone
from groundslab.design.rules.webs import Web
from groundslab.fem.mesh import Mesh, locate
from groundslab.geometry.plan import FLAT
from groundslab.model.design.laid_bars import bars_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.model.outputs import OutputStrip
from groundslab.model.structure.beams import LARGEST_BAR, Beam, GivenSection, RibSection
from groundslab.model.supports import LineSupport
from groundslab.results.records import BeamResult
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

#: So much of a piece's length beside its middle the plate's thickness is looked up.
BESIDE = 1e-2
#: Such a share of the way to the next place cuts across the flange move off the ends of a beam and places of jumps.
INSIDE = 1e-6
#: Places so close, relative to a beam's length, are one.
SAME = 1e-9
#: A strip is cut so many times over a length as long as the plate is thick, and at most so many times.
PER_THICKNESS, MOST_CUTS = 4, 1000


@dataclass(frozen=True, slots=True)
class Section:
    """A concrete section at k places along a beam, as the code needs it."""

    h: Array  # (k,): height [m]
    b: float  # of the web [m]
    compressed: tuple[float, float]  # width where the beam sags, where it hogs [m]
    flange: Array  # (k,): thickness of the flange [m]; infinite without one
    d: tuple[Array, Array]  # (k,) each: effective depth where it sags, where it hogs [m]
    diameter: float  # of its bars [m]

    def webs(self, V: Array, T: Array, *, released: bool) -> Web:
        """Return the webs at the places, with the shear forces V [N] and torsional moments T [N m] (k,) they carry."""
        d = np.minimum(*self.d)
        return Web(V, np.abs(T), self.b, self.h, d, float((self.h - d).max()), released)

    def tension(self, face: int) -> TensionZone:
        """Return the zone in tension before it cracks, at the bottom where it sags (face 0) or at the top (1)."""
        h, b, wide, width = self.h, self.b, max(self.compressed), self.compressed[1 - face]
        t = np.minimum(self.flange, h)
        A, web = wide * t + b * (h - t), b * (h - t)
        y = (wide * t**2 / 2 + web * (h + t) / 2) / A  # of the centroid from the flange's face
        inertia = (
            wide * t**3 / 12 + wide * t * (y - t / 2) ** 2 + web * (h - t) ** 2 / 12 + web * ((h + t) / 2 - y) ** 2
        )
        of_flange = width > b
        inside = np.minimum(t, y)
        mean = (wide * inside + b * (y - inside)) / y if of_flange else np.full(len(h), b)
        depth = y if of_flange else h - y
        return TensionZone(self.d[face], inertia / depth, mean, b, width, h, depth, self.flange, self.diameter)


class Member(Protocol):
    """What is designed as a beam."""

    @property
    def name(self) -> str:
        """Return its name."""

    @property
    def released(self) -> bool:
        """Return whether it is taken to resist no torsion."""

    @property
    def rib(self) -> bool:
        """Return whether it has a flange."""

    def forces(self, results: CombinationResult) -> BeamResult:
        """Return its section forces along it."""

    def section(self, results: CombinationResult, forces: BeamResult, steel: Reinforcement) -> Section:
        """Return its section at places along it."""

    def faces(self, model: Model, length: float) -> list[Faces]:
        """Return the faces of what bears on it, along its length [m]."""

    def twisted(self, model: Model, way: Array) -> Flags:
        """Return where along it (k,) [m] torsion is its own, not the bending of what crosses it."""


@made_once
def members_of(model: Model) -> tuple[Member, ...]:
    """Return the beams and ribs of concrete of a model, and its strips that are beams."""
    beams: list[Member] = [
        BeamMember(beam, number)
        for number, beam in enumerate(model.beams)
        if not isinstance(beam.section, GivenSection)
    ]
    return *beams, *(StripMember(output_strip) for output_strip in model.output.beams)


@dataclass(frozen=True)
class BeamMember:
    """A beam or rib of concrete."""

    beam: Beam
    number: int

    @property
    def name(self) -> str:
        """Return its name."""
        return self.beam.name

    @property
    def released(self) -> bool:
        """Return whether it is taken to resist no torsion."""
        return self.beam.torsion == "released"

    @property
    def rib(self) -> bool:
        """Return whether it has a flange."""
        return isinstance(self.beam.section, RibSection)

    def forces(self, results: CombinationResult) -> BeamResult:
        """Return it with M and V of its section: of a rib with what the slab carries over the flange's width."""
        forces, section = results.beams[self.number], self.beam.section
        if not isinstance(section, RibSection):
            return forces
        middle, left = across(forces, section.flange_width / 2)
        M, T = moments_across(results.plate, np.stack([middle - left, middle + left], axis=1))
        V = np.zeros(len(M))
        for run in _runs(forces):
            turn = _slope(np.unwrap(np.arctan2(left[run, 1], left[run, 0])), forces.way[run])
            V[run] = _slope(M[run], forces.way[run]) - turn * T[run]
        return replace(forces, moment=forces.moment + M, shear=forces.shear + V)

    def section(self, results: CombinationResult, forces: BeamResult, steel: Reinforcement) -> Section:
        """Return its section along it; of the plate on both sides the thinner one is its flange."""
        beam, section = self.beam, self.beam.section
        assert not isinstance(section, GivenSection)
        axes = beam.bar_axis or max(steel.bottom_axes), beam.bar_axis or max(steel.top_axes)
        b = section.width
        if not isinstance(section, RibSection):
            h = np.full(len(forces.way), section.height)
            return Section(h, b, (b, b), np.inf * h, (h - axes[0], h - axes[1]), beam.bar_diameter)
        t = thickness_along(results, forces)
        width = section.flange_width
        h = section.height + t
        wide = (width, b) if section.side == "below" else (b, width)
        return Section(h, b, wide, t, (h - axes[0], h - axes[1]), beam.bar_diameter)

    def faces(self, model: Model, length: float) -> list[Faces]:
        """Return the faces of columns, supports, walls and other beams, and its ends without any."""
        return faces_on(model, self.beam, length)

    def twisted(self, model: Model, way: Array) -> Flags:  # noqa: ARG002
        """Return that all along it torsion is its own."""
        return np.ones(len(way), dtype=bool)


@dataclass(frozen=True)
class StripMember:
    """A strip of the plate from edge to edge that is designed as a beam, along x or y."""

    strip: OutputStrip

    @property
    def name(self) -> str:
        """Return its name."""
        return self.strip.name

    @property
    def released(self) -> bool:
        """Return whether it is taken to resist no torsion."""
        return self.strip.torsion == "released"

    @property
    def rib(self) -> bool:
        """Return that it has no flange."""
        return False

    @property
    def axis(self) -> str:
        """Return the axis along which it runs."""
        return "x" if self.strip.start[1] == self.strip.end[1] else "y"

    @property
    def layers(self) -> tuple[str, str]:
        """Return the layers of bars along it, at the bottom and at the top."""
        return f"bottom_{self.axis}", f"top_{self.axis}"

    def forces(self, results: CombinationResult) -> BeamResult:
        """Return what the plate carries over its width; within the faces of columns the moments at these.

        A strip that is released from torsion has none.
        """
        f = strip_forces(results, self.strip)
        f = replace(f, torsion=0 * f.torsion) if self.released else f
        steel = results.model.reinforcement
        if steel is None or steel.averaging.at_columns == "peak":
            return f
        M = f.moment.copy()
        for face in self._columns(results.model):
            low, high = np.clip([face.low, face.high], f.way[0], f.way[-1])
            inside = (f.way > low) & (f.way < high)
            M[inside] = np.interp(f.way[inside], [low, high], np.interp([low, high], f.way, f.moment))
        return replace(f, moment=M)

    def section(self, results: CombinationResult, forces: BeamResult, steel: Reinforcement) -> Section:
        """Return the plate's section along it, as wide as it is where it is narrowest."""
        cuts = _cuts(results)[self.name]
        h, b = np.interp(forces.way, cuts.s - cuts.s[0], _thickness(results)[self.name]), float(cuts.length.min())
        axes = (getattr(steel, f"{face}_axes")["xy".index(self.axis)] for face in ("bottom", "top"))
        diameters = [bars.diameter for layer in self.layers for bars in bars_of(steel, layer)] if steel.laid else []
        below, above = axes
        return Section(h, b, (b, b), np.inf * h, (h - below, h - above), max(diameters, default=LARGEST_BAR))

    def faces(self, model: Model, length: float) -> list[Faces]:
        """Return the faces of columns, supports and walls across it, and its ends without any."""
        faces = self._columns(model)
        near = SAME * length
        faces += [Faces(end, end, direct=False) for end in (0.0, length)
                  if not any(face.low - near <= end <= face.high + near for face in faces)]  # fmt: skip
        return sorted(faces, key=lambda face: face.low)

    def twisted(self, model: Model, way: Array) -> Flags:
        """Return where along it (k,) [m] no other strip crosses it."""
        uncrossed = np.ones(len(way), dtype=bool)
        for other in model.output.beams:
            met = self.strip.area().intersection(other.area())
            if other is not self.strip and met.area > 0:
                low, high = self._ways(met)
                uncrossed &= (way <= low + SAME) | (way >= high - SAME)
        return uncrossed

    def nodes(self, nodes: Array) -> tuple[Integers, Array]:
        """Return which nodes (n, 2) [m] lie in it (k,), and how far along it they are (k,) [m]."""
        a = "xy".index(self.axis)
        start, end = self.strip.start, self.strip.end
        way = np.sign(end[a] - start[a]) * (nodes[:, a] - start[a])
        near = SAME * max(self.strip.width, abs(end[a] - start[a]))
        inside = (way >= -near) & (way <= abs(end[a] - start[a]) + near)
        inside &= np.abs(nodes[:, 1 - a] - start[1 - a]) <= self.strip.width / 2 + near
        return np.flatnonzero(inside), way[inside]

    def _columns(self, model: Model) -> list[Faces]:
        """Return the faces of columns and supports on it, and of walls across it; all of them press on it directly."""
        chord = FLAT * max(model.sides)
        area = self.strip.area()
        met = [shape.intersection(area) for shape in _bearing(model, chord)]
        ways = [self._ways(part) for part in met if not part.is_empty]
        # what lies along it is no place of its own
        return [Faces(low, high, direct=True) for low, high in ways if high - low <= self.strip.width]

    def _ways(self, shape: BaseGeometry) -> tuple[float, float]:
        """Return from where to where a shape lies along it [m]."""
        from shapely import get_coordinates

        start = np.array(self.strip.start)
        along = np.array(self.strip.end) - start
        ways = (get_coordinates(shape) - start) @ along / np.linalg.norm(along)
        return float(ways.min()), float(ways.max())


def _bearing(model: Model, chord: float) -> Iterator[BaseGeometry]:
    """Yield the plans of what bears on the plate or holds it."""
    from shapely import LineString, Point

    for column in model.columns:
        yield column.to_shapely(chord)
    for support in model.supports:
        if isinstance(support, LineSupport):
            yield LineString(support.points)
        else:
            yield Point(support.x, support.y).buffer(max((support.diameter or 0.0) / 2, chord))
    for wall in model.walls:
        yield wall.area(chord)


def member_forces(results: CombinationResult) -> tuple[BeamResult, ...]:
    """Return the section forces of beams and walls with a height, and of strips that are beams, along each."""
    return *results.beams, *(strip_forces(results, output_strip) for output_strip in results.model.output.beams)


def strip_forces(results: CombinationResult, asked: OutputStrip) -> BeamResult:
    """Return the section forces of the plate over the width of a strip that is a beam, as those of one."""
    f = _cuts(results)[asked.name]
    nothing = np.zeros(len(f.s))
    return BeamResult(
        asked.name, np.column_stack([f.x, f.y]), f.s - f.s[0], f.settlement, f.moment, f.shear, f.torsion,
        nothing, nothing, f.shear,
    )  # fmt: skip


@made_once
def _cuts(results: CombinationResult) -> dict[str, StripResult]:
    """Return the cuts across the strips that are beams, by their names."""
    t = min(plate.thickness for plate in results.model.every_plate)
    cuts = dict[str, StripResult]()
    for output_strip in results.model.output.beams:
        length = float(np.hypot(*np.subtract(output_strip.end, output_strip.start)))
        count = int(np.clip(PER_THICKNESS * length / t, output_strip.stations, MOST_CUTS)) + 1
        cuts[output_strip.name] = strip(results.plate, output_strip.start, output_strip.end, output_strip.width, count)
    return cuts


@made_once_by(lambda results: (results.plate.nodes, results.plate.elements))
def _thickness(results: CombinationResult) -> dict[str, Array]:
    """Return the thickness of the plate at the cuts (c,) [m] across the strips that are beams, by their names.

    Beside a step it is the lesser one.
    """
    from scipy.ndimage import minimum_filter1d

    return {
        output_strip.name: minimum_filter1d(
            thickness_along(results, strip_forces(results, output_strip)), 3, mode="nearest"
        )
        for output_strip in results.model.output.beams
    }


def thickness_along(results: CombinationResult, beam: BeamResult) -> Array:
    """Return the thickness of the plate along a beam (k,) [m], of both sides the less.

    Where it jumps, the first of the two places there belongs to what comes before.
    """
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    way = np.diff(beam.nodes, axis=0)
    length = np.linalg.norm(way, axis=1)
    between = np.flatnonzero(length > 0)
    middle = (beam.nodes[between] + beam.nodes[between + 1]) / 2
    beside = BESIDE * np.stack([-way[between, 1], way[between, 0]], axis=1)
    thinnest = np.full(len(length), np.inf)
    for places in (middle + beside, middle - beside):
        element = locate(mesh, places)[0]
        on_mesh = element >= 0
        own_t = np.where(on_mesh, results.elements.thickness[element], np.inf)
        thinnest[between] = np.minimum(thinnest[between], own_t)
    goes_on = np.append(length > 0, False)
    after, before = np.append(thinnest, np.inf), np.insert(thinnest, 0, np.inf)
    return np.where(goes_on, after, before)


def across(beam: BeamResult, distance: float) -> tuple[Array, Array]:
    """Return places along a beam (k, 2) [m], and vectors so long [m] to its left (k, 2).

    They are off the lines at which what the slab carries may jump.
    """
    middle, left = beam.nodes.copy(), np.zeros_like(beam.nodes)
    for run in _runs(beam):
        along = _slope(beam.nodes[run], beam.way[run])
        left[run] = distance * np.column_stack([-along[:, 1], along[:, 0]]) / np.linalg.norm(along, axis=1)[:, None]
        middle[run[[0, -1]]] += INSIDE * (middle[run[[1, -2]]] - middle[run[[0, -1]]])
    return middle, left


def _runs(beam: BeamResult) -> list[Integers]:
    """Return the places between which section forces are smooth."""
    return np.split(np.arange(len(beam.way)), np.flatnonzero(np.diff(beam.way) <= SAME * beam.way[-1]) + 1)


def _slope(values: Array, way: Array) -> Array:
    """Return the derivative of values (k,) or (k, 2) along k places."""
    slope: Array = np.gradient(values, way, axis=0, edge_order=2 if len(way) > 2 else 1)
    return slope
