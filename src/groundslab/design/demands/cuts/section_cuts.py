"""Section lines through a plate, design strips, and forces across their cuts: those of the plate, and of beams."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from operator import attrgetter

import numpy as np

from groundslab.arrays import Array, Flags, Integers, made_once_by
from groundslab.design.demands.cuts.line_traversal import ON_LINE, Pieces, interpolation, is_continuous, pieces
from groundslab.design.demands.design_moments import wood_armer
from groundslab.errors import InputError, Issue
from groundslab.fem.mesh import Mesh
from groundslab.geometry.plan import FLAT
from groundslab.messages import Message
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult


@dataclass(frozen=True, slots=True)
class SectionCut:
    """Nodal fields along a line: samples only where there is plate, in the order of the line.

    Samples of one `part` can be joined by a curve. A new part begins behind an opening or a notch, and where fields
    have two sides, as where the plate's thickness changes or a wall stands: there the same place stands twice.
    """

    s: Array  # (p,): distance from the line's start, along it [m]
    x: Array  # (p,) [m]
    y: Array  # (p,) [m]
    part: Integers  # (p,): from 0
    values: dict[str, Array]  # by the names of PLATE_FIELDS, (p,) each, SI units

    def parts(self) -> list[slice]:
        """Return the samples of each part."""
        first = np.searchsorted(self.part, np.arange(self.part[-1] + 2))
        return [slice(int(i), int(j)) for i, j in pairwise(first)]


@dataclass(frozen=True, slots=True)
class StripResult:
    """A design strip: at each station the forces on the part of the cut across it that lies on the plate.

    The normal n of a cut points along the strip: towards +x m_n = m_x and q_n = q_x. Together with supports, the loads
    and contact pressure ahead of the cut make up its forces: shear = int (load - p) dA, moment = int (p - load)
    lever dA, the lever being the distance from the cut, and torsion = int (p - load) e dA, e to the left of the axis.

    Design moments are those of Wood and Armer for reinforcement along the strip and at right angles to it, each the
    mean of the values at all points of the cut; at the bottom >= 0, at the top <= 0.
    """

    s: Array  # (c,): distance of the station from the strip's start [m]
    x: Array  # (c,): the station on the axis [m]
    y: Array  # (c,)
    length: Array  # (c,): of the cut, on the plate [m]
    moment: Array  # (c,): int m_n ds [N m], sagging positive
    shear: Array  # (c,): int q_n ds [N]
    torsion: Array  # (c,): int (m_nt - q_n e) ds about the axis, e to its left [N m]
    settlement: Array  # (c,): mean over the cut [m]
    mean_moment: Array  # (c,) [N m/m]
    mean_shear: Array  # (c,) [N/m]
    largest: Array  # (c,): the largest m_n on the cut [N m/m]
    least: Array  # (c,): the least m_n on the cut [N m/m]
    bottom: Array  # (c,): design moment along the strip [N m/m]
    top: Array  # (c,)
    bottom_across: Array  # (c,): design moment at right angles to the strip [N m/m]
    top_across: Array  # (c,)


def cut_along(plate: PlateResult, points: Array, spacing: float | None = None) -> SectionCut:
    """Return all nodal fields along a polyline (k, 2) [m], by the shape functions of the element that holds a sample.

    Samples stand at the polyline's corners, at the ends of each part, and in between every `spacing` [m], or without
    it at each side of an element and halfway between. A line along a border where fields have two sides takes values
    from either: move it by a small distance, such as a millionth of its length, to choose one.
    """
    ends = _legs(points)
    if spacing is not None and not spacing > 0:
        raise InputError([Issue("spacing", f"{spacing:g} m", "a length greater than zero")])
    mesh = Mesh(plate.nodes, plate.elements)
    line = _on_plate(mesh, ends, "points")
    goes_on = is_continuous(mesh, line)
    piece, s = _samples(line, goes_on, spacing)
    nodes, N = interpolation(mesh, line, piece, s)
    values = {name: np.einsum("pa,pa->p", N, getattr(plate, name)[nodes]) for name in PLATE_FIELDS}
    x, y = line.points(piece, s).T
    return SectionCut(s, x, y, (np.cumsum(~goes_on) - 1)[piece], values)


def strip(
    plate: PlateResult,
    start: tuple[float, float] | Array,
    end: tuple[float, float] | Array,
    width: float,
    count: int,
) -> StripResult:
    """Return the forces on `count` evenly spaced cuts of some width [m] across the axis of a design strip.

    The first cut is at the start, the last at the end; cuts that lie wholly off the plate are left out. The extremes
    of m_n are those at the elements' sides, halfway between, and at the Gauss points. Averaging the design moments
    (Wood 1968, Armer 1968) of all points is on the safe side of taking them from averaged moments.

    Gauss points between the element sides that a cut crosses make the integrals exact for the nodal fields on
    parallelograms. The fields are continuous but where the section changes and along line loads and line supports; for
    a cut along such a border, move it to one side by a small distance, such as a millionth of its length.

    The integrals are as good as the averaged nodal fields: against loads and contact pressure the error falls with
    the square of the element's size (tests/verification/test_cuts.py). Within an element of a line load, a point load
    or an edge where the ground pulls by a line force, shear is smeared.
    """
    issues = []
    if not width > 0:
        issues.append(Issue("width", f"{width:g} m", "a width greater than zero"))
    if count < 2:
        issues.append(Issue("count", f"{count}", "at least 2 stations"))
    if issues:
        raise InputError(issues)
    (origin, final), *_ = _legs(np.array([start, end]))
    s = np.linspace(0, np.linalg.norm(final - origin), count)
    axis = (final - origin) / s[-1]
    across = np.array([-axis[1], axis[0]])
    centers = origin + s[:, None] * axis
    rows, kept = [], []
    points = _Cut.of(plate, np.stack([centers - width / 2 * across, centers + width / 2 * across], axis=1))
    gauss_leg, edge_leg = (points.line.leg[piece] for piece in (points.gauss[0], points.edges[0]))
    m_n, m_t, m_nt, q_n = points.forces(points.gauss)
    at_edges, w = points.forces(points.edges)[0], points.settlement(points.gauss)
    e = points.gauss[1] - points.line.start[gauss_leg] - width / 2
    design = wood_armer(m_n, m_t, m_nt)
    for station in np.unique(gauss_leg):
        on = gauss_leg == station
        ds = points.ds[on]
        everywhere = np.concatenate([m_n[on], at_edges[edge_leg == station]])
        totals = [float(ds @ field[on]) for field in (m_n, q_n, m_nt - q_n * e)]
        means = [float(ds @ field[on]) / ds.sum() for field in (w, m_n, q_n)]
        wood = (design.bottom_x, design.top_x, design.bottom_y, design.top_y)
        designed = [float(ds @ field[on]) / ds.sum() for field in wood]
        rows.append([ds.sum(), *totals, *means, everywhere.max(), everywhere.min(), *designed])
        kept.append(station)
    x, y = centers[kept].T
    return StripResult(s[kept], x, y, *np.array(rows).T)


def moments_across(plate: PlateResult, ends: Array) -> tuple[Array, Array]:
    """Return int m_n ds and int m_nt ds [N m] over straight cuts (l, 2, 2) [m], where they lie on the plate, (l,) each.

    n is to the right of a cut.
    """
    cut = _Cut.of(plate, ends)
    m_n, _, m_nt, _ = cut.forces(cut.gauss)
    leg = cut.line.leg[cut.gauss[0]]
    bending, twist = np.zeros(len(ends)), np.zeros(len(ends))
    np.add.at(bending, leg, cut.ds * m_n)
    np.add.at(twist, leg, cut.ds * m_nt)
    return bending, twist


def length_across(plate: PlateResult, ends: Array) -> Array:
    """Return how much of straight cuts (l, 2, 2) [m] lies on the plate (l,) [m]."""
    line = pieces(Mesh(plate.nodes, plate.elements), ends)
    lengths = np.zeros(len(ends))
    np.add.at(lengths, line.leg, line.length)
    return lengths


@made_once_by(attrgetter("nodes", "elements"))
def _pieces_of(mesh: Mesh) -> dict[bytes, Pieces]:  # noqa: ARG001
    """Return the pieces of lines in a mesh, as combinations add them, by the ends of the lines' legs."""
    return {}


@dataclass(frozen=True, slots=True)
class _Cut:
    """The points at which straight cuts, one a leg, read the plate's fields."""

    plate: PlateResult
    mesh: Mesh
    line: Pieces
    gauss: tuple[Integers, Array]  # piece and s
    ds: Array  # the Gauss points' weights [m]
    edges: tuple[Integers, Array]  # piece and s of the pieces' ends and middles

    @classmethod
    def of(cls, plate: PlateResult, ends: Array) -> _Cut:
        """Return the points of cuts (l, 2, 2), at least one of which must cross the plate."""
        if not (np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) > 0).all():
            raise InputError([Issue("cut", "two ends at one place", "two different points")])
        mesh = Mesh(plate.nodes, plate.elements)
        line = _on_plate(mesh, ends, "cut")
        piece, s, ds = line.gauss()
        numbers = np.arange(len(line.low))
        edges = np.tile(numbers, 3), np.concatenate([line.low, line.high, (line.low + line.high) / 2])
        return cls(plate, mesh, line, (piece, s), ds, edges)

    def settlement(self, at: tuple[Integers, Array]) -> Array:
        """Return the settlement [m] at piece and s (k,)."""
        nodes, N = interpolation(self.mesh, self.line, *at)
        return np.asarray(np.einsum("pa,pa->p", N, self.plate.settlement[nodes]))

    def forces(self, at: tuple[Integers, Array]) -> tuple[Array, Array, Array, Array]:
        """Return m_n, m_t, m_nt [N m/m] and q_n [N/m] at piece and s (k,), n to the right of t, the way of the leg."""
        piece, s = at
        nodes, N = interpolation(self.mesh, self.line, piece, s)
        names = ("moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
        m_x, m_y, m_xy, q_x, q_y = (np.einsum("pa,pa->p", N, getattr(self.plate, name)[nodes]) for name in names)
        return rotate_to_cut(m_x, m_y, m_xy, q_x, q_y, self.line.along[self.line.leg[piece]])


def rotate_to_cut(
    m_x: Array, m_y: Array, m_xy: Array, q_x: Array, q_y: Array, t: Array
) -> tuple[Array, Array, Array, Array]:
    """Return m_n, m_t, m_nt and q_n (k,) on cuts along the unit vectors t (k, 2), n to the right of t.

    Moments turn as a symmetric tensor, shear forces as a vector (Timoshenko and Woinowsky-Krieger 1959).
    """
    t_x, t_y = t.T
    n_x, n_y = t_y, -t_x
    m_n = m_x * n_x**2 + m_y * n_y**2 + 2 * m_xy * n_x * n_y
    m_t = m_x * t_x**2 + m_y * t_y**2 + 2 * m_xy * t_x * t_y
    m_nt = m_x * n_x * t_x + m_y * n_y * t_y + m_xy * (n_x * t_y + n_y * t_x)
    return m_n, m_t, m_nt, q_x * n_x + q_y * n_y


def _legs(points: Array) -> Array:
    """Return the legs (k - 1, 2, 2) of a polyline; InputError unless it has two different points in a row or more."""
    points = np.asarray(points, dtype=float)
    if points.ndim != 2 or points.shape[1:] != (2,) or len(points) < 2 or not np.isfinite(points).all():
        legs = (
            Message("an array of shape {shape}", shape=points.shape)
            if np.isfinite(points).all()
            else "places that are not finite"
        )
        raise InputError([Issue("points", legs, "two or more places (x, y)")])
    ends = np.stack([points[:-1], points[1:]], axis=1)
    same = np.flatnonzero((ends[:, 0] == ends[:, 1]).all(axis=1))
    if len(same):
        where = [f"points[{i + 2}]" for i in same]
        raise InputError([Issue(place, "the same place as the point before", "another one") for place in where])
    return ends


def _on_plate(mesh: Mesh, ends: Array, where: str) -> Pieces:
    """Return the pieces of legs in the plate's elements; InputError if there are none."""
    mesh_pieces = _pieces_of(mesh)
    key = ends.tobytes()
    line = mesh_pieces[key] if key in mesh_pieces else mesh_pieces.setdefault(key, pieces(mesh, ends))
    if not len(line.low):
        off_plate = Message(
            "a line from {start:at (m)} to {end:at m} that does not meet the plate", start=ends[0, 0], end=ends[-1, 1]
        )
        raise InputError([Issue(where, off_plate, "a line that crosses the plate")])
    return line


def _samples(line: Pieces, goes_on: Flags, spacing: float | None) -> tuple[Integers, Array]:
    """Return piece and s (p,) of the samples of a section."""
    new_leg = np.diff(line.leg, prepend=-1) != 0
    starts_here, ends_here = ~goes_on | new_leg, np.append(~goes_on[1:] | new_leg[1:], True)
    near = ON_LINE * line.high[-1]
    piece, s = [], []
    for i, (low, high) in enumerate(zip(line.low, line.high, strict=True)):
        if spacing is None:
            inner = np.array([(low + high) / 2])
        else:
            # each multiple of the spacing belongs to one piece: low < s <= high
            inner = spacing * np.arange(np.floor(low / spacing) + 1, np.floor(high / spacing) + 1)
            inner = inner[(inner > low + near) | ~starts_here[i]]
            inner = inner[(inner < high - near) | ~ends_here[i]]
        last = [high] if spacing is None or ends_here[i] else []
        here = np.concatenate([[] if goes_on[i] else [low], inner, last])
        piece.append(np.full(len(here), i))
        s.append(here)
    return np.concatenate(piece), np.concatenate(s)


def carried_across(results: CombinationResult, starts: Array, ends: Array) -> Array:
    """Return moments [N m] and shear forces [N] of beams and walls with a height across cuts (k,), (k, 2).

    A cut goes from start to end (k, 2) [m], and the strip that it cuts to the left. A beam along t carries M t + T n
    there, n to its left, of which the part along the strip bends it; where its forces jump at the cut, the mean of both
    sides. Beams that end at a cut or run along it carry nothing across.
    """
    carried = np.zeros((len(starts), 2))
    chord = FLAT * max(results.model.sides)
    for beam, result in zip(results.model.members, results.beams, strict=True):
        axis = np.array(beam.to_shapely(chord).coords)
        steps = np.diff(axis, axis=0)
        lengths = np.linalg.norm(steps, axis=1)
        ways = np.concatenate([[0.0], np.cumsum(lengths)]) * (result.way[-1] / lengths.sum())
        for number, (start, end) in enumerate(zip(starts, ends, strict=True)):
            cut = end - start
            forth = np.array([-cut[1], cut[0]]) / np.linalg.norm(cut)  # the strip's direction
            side = (axis - start) @ forth
            for piece in np.flatnonzero((side[:-1] < 0) != (side[1:] < 0)):
                part = side[piece] / (side[piece] - side[piece + 1])
                place = axis[piece] + part * steps[piece]
                along = (place - start) @ cut / (cut @ cut)
                way = ways[piece] + part * (ways[piece + 1] - ways[piece])
                if not (0 <= along <= 1 and 0 < way < ways[-1]):
                    continue
                t = steps[piece] / lengths[piece]
                here = result.at(np.array([way, way]))  # where they jump, on both sides
                M, V, T = (float(force.mean()) for force in (here.moment, here.own_shear, here.torsion))
                onwards = np.sign(t @ forth)
                carried[number] += onwards * np.array([M * (t @ forth) + T * (np.array([-t[1], t[0]]) @ forth), V])
    return carried
