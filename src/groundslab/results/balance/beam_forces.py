"""Section forces of beams along their axes, recovered from the Gauss points of their pieces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags, Integers, made_once_by
from groundslab.fem.mesh import select_along, sides_of
from groundslab.fem.parts.beams import POINTS, THETA, TO_ENDS, Beams, section_forces
from groundslab.fem.parts.spans import forces_within, settlements_within
from groundslab.fem.problem import Problem
from groundslab.fem.system import beam_unknowns, plate_settlement
from groundslab.geometry.nearest import nearest_distance
from groundslab.model.loads.acting import borders_of
from groundslab.model.model import Model
from groundslab.model.remarks.singular_places import kinks_of_loads
from groundslab.results.records import BeamResult
from groundslab.solvers.solution import Solution

#: The parts of a span over an opening after which section forces are told.
PARTS = np.linspace(0.0, 1.0, 9)
#: Places this close, relative to the plate's length, are one.
NEAR = 1e-8


@dataclass(frozen=True, slots=True)
class Stations:
    """Where along beams section forces are told: at the ends of their pieces, twice where they jump."""

    beam: Integers  # (k,): number
    node: Integers  # (k,): of the problem's mesh
    way: Array  # (k,) [m]: along the beam
    piece: Integers  # (k,): to which it belongs
    points: Integers  # (k, 4): Gauss points of pieces, numbered 2 piece + point, from which each takes its values
    weights: Array  # (k, 4)
    slopes: Array  # (k, 4) [1/m]: weights of the derivative along the beam
    of_piece: Integers  # (b, 2): those at its start and at its end
    place: Array  # (k, 2) [m]
    spans: Flags  # (k,): those along spans over openings, PARTS of each


def beam_results(model: Model, solution: Solution) -> tuple[BeamResult, ...]:
    """Return the section forces of each beam.

    They are most accurate at the Gauss points of a piece. Between two places where they or their slopes may jump (ends,
    kinks, other beams, supports, borders of loads and of zones) they are smooth: a parabola through the Gauss points of
    the two pieces about a place gives the values there, and its slope the shear force of the section.
    """
    if not model.members:
        return ()
    problem = solution.system.problem
    b = problem.beams
    stations, forces, (M, T, V, N) = _along(model, solution)
    w = plate_settlement(solution.system, solution.U)[stations.node]
    w[stations.spans] = _settlements_of_spans(solution, np.column_stack([M, T, V, N])[stations.spans])
    e = b.eccentricity[stations.piece]
    M += e * N
    whole = _shear_of_section(stations, b, forces)
    whole = np.where((b.deep | b.spans)[stations.piece], V, whole)
    beams = []
    for number, beam in enumerate(model.members):
        here = stations.beam == number
        arrays = (values[here] for values in (stations.place, stations.way, w, M, whole, T, N, e, V))
        beams.append(BeamResult(beam.name, *arrays))
    return tuple(beams)


def _shear_of_section(stations: Stations, b: Beams, forces: Array) -> Array:
    """Return dM_0/ds - T alpha,s (k,) [N] at stations, of M, T, V and N at the Gauss points of pieces (b, 2, 4).

    M_0 t + T n is what a beam carries along its direction t, n to the left of it; both turn along an arc.
    """
    M_0, T = forces[..., 0] + b.eccentricity[:, None] * forces[..., 3], forces[..., 1]
    (x, y), (x_1, y_1) = b.along[:, 0].T, b.along[:, 1].T
    turn = np.arctan2(x * y_1 - y * x_1, x * x_1 + y * y_1) / b.length
    slope, bent = M_0.ravel()[stations.points], (turn[:, None] * T).ravel()[stations.points]
    shear: Array = (stations.slopes * slope - stations.weights * bent).sum(axis=1)
    return shear


def _settlements_of_spans(solution: Solution, forces: Array) -> Array:
    """Return the settlements [m] at the stations of spans, whose M, T, V and N are (k, 4)."""
    problem = solution.system.problem
    b, xy = problem.beams, problem.mesh.nodes
    spans = b.spans
    if not spans.any():
        return np.zeros(0)
    u = beam_unknowns(problem, solution.U)[spans, 0]
    way = xy[b.sides[spans, 1]] - xy[b.sides[spans, 0]]
    t = way / np.linalg.norm(way, axis=1, keepdims=True)
    of_sections = u[:, THETA] * (t * b.along[spans, 0]).sum(axis=1)
    slope = np.where(b.deep[spans], of_sections, (u[:, 1:3] * t).sum(axis=1))
    start = np.column_stack([u[:, 0], slope])
    at_start = forces[:: len(PARTS)]
    return settlements_within(b, problem.loading.on_spans, start, at_start, PARTS).ravel()


def squared_errors(model: Model, solution: Solution) -> Array:
    """Return int (M* - M)^2 / EI of the pieces of beams, and the same of T, V and N, (b, 4) [N m].

    M is about the beams' own axes.
    What is recovered, M*, has the elements' own values at both Gauss points, and those at the stations: there is a
    parabola between, c (s^2 - 1/3) with s = -1 .. 1, of which the integral of the square is 4 c^2 / 45 of the length.
    """
    b = solution.system.problem.beams
    stations, forces, recovered = _along(model, solution)
    off = recovered.T[stations.of_piece] - np.einsum("ep,bpr->ber", TO_ENDS, forces)
    c = 1.5 * off.mean(axis=1)
    rigidity = np.where(b.rigidity > 0, b.rigidity, np.inf)
    squares: Array = 4 / 45 * c**2 * b.length[:, None] / rigidity
    squares[b.spans] = 0.0
    return squares


def _along(model: Model, solution: Solution) -> tuple[Stations, Array, Array]:
    """Return the stations of beams, and M, T, V and N at the Gauss points of pieces (b, 2, 4) and at stations (4, k).

    M is about the beams' own axes.
    """
    problem = solution.system.problem
    b = problem.beams
    stations = _stations(model, problem)
    forces = section_forces(b, problem.mesh.nodes, beam_unknowns(problem, solution.U))
    recovered = np.einsum("kp,kpr->rk", stations.weights, forces.reshape(-1, forces.shape[-1])[stations.points])
    if b.spans.any():
        recovered[:, stations.spans] += forces_within(b, problem.loading.on_spans, PARTS).reshape(-1, 4).T
    return stations, forces, recovered


@made_once_by(lambda model, problem: (problem.mesh.nodes, model.loads))
def _stations(model: Model, problem: Problem) -> Stations:
    """Return the stations of all beams of a problem, from one beam's start to its end after the other."""
    b = problem.beams
    first = np.flatnonzero(~_goes_on(model, problem))
    parts, at_start, count = [], np.zeros(len(b.sides), dtype=np.int64), 0
    for begin, end in zip(first, [*first[1:], len(b.sides)], strict=True):
        n = end - begin
        place = np.arange(n + 1)
        at_start[begin:end] = count + place[:-1]
        if b.spans[begin]:
            place = np.zeros(len(PARTS), dtype=np.int64)
        count += len(place)
        piece = begin + np.minimum(place, n - 1)
        node, way = b.sides[piece, 0], b.start[piece]
        node[-1], way[-1] = b.sides[end - 1, 1], b.start[end - 1] + b.length[end - 1]
        xy = problem.mesh.nodes[node]
        if b.spans[begin]:
            xy, way = xy[0] + PARTS[:, None] * (xy[-1] - xy[0]), way[0] + PARTS * b.length[begin]
        # the two pieces about the place, at ends the two nearest; a run may be one piece alone
        before = begin + np.clip(place - 1, 0, max(n - 2, 0))
        after = np.minimum(before + 1, end - 1)
        parts.append((b.number[piece], node, way, piece, np.column_stack([before, before, after, after]), xy))
    beam, node, way, piece, pieces, places = (np.concatenate(arrays) for arrays in zip(*parts, strict=True))
    at = (b.start + b.length / 2)[:, None] + b.length[:, None] / 2 * POINTS
    points = 2 * pieces + [0, 1, 0, 1]
    x = at.ravel()[points] - way[:, None]
    size = np.abs(x).max(axis=1, keepdims=True)
    x /= size
    alone = (pieces[:, :1] == pieces[:, 2:3]).astype(bool)
    A = np.stack([np.ones_like(x), x, np.where(alone, 0.0, x * x)], axis=2)
    of_piece = np.column_stack([at_start, at_start + np.where(b.spans, len(PARTS) - 1, 1)])
    fit = np.linalg.pinv(A)
    slopes = fit[:, 1] / size
    return Stations(beam, node, way, piece, points, fit[:, 0], slopes, of_piece, places, b.spans[piece])


def _goes_on(model: Model, problem: Problem) -> Flags:
    """Return which pieces of beams (b,) go on smoothly from the piece before: nothing meets the beam there."""
    b = problem.beams
    # across a joint the plates' parts of it may jump
    on_one_plate = np.append(False, b.sides[1:, 0] == b.sides[:-1, 1])
    same = on_one_plate & (np.diff(b.number, prepend=-1) == 0)
    beside_span = b.spans | np.append(False, b.spans[:-1])
    goes_on: Flags = b.smooth & same & ~beside_span & ~_meeting(model, problem)[b.sides[:, 0]]
    return goes_on


def _meeting(model: Model, problem: Problem) -> Flags:
    """Return at which nodes (n,) a beam meets another one, a force, a support, the end of a line load, or a border."""
    b, n = problem.beams, len(problem.mesh.nodes)
    points = [*kinks_of_loads(model), *(support.points[0] for support in model.supports if not support.edges)]
    meets = nearest_distance(problem.mesh.nodes, np.reshape(points, (-1, 2)), near := NEAR * problem.length) < near
    # more ends of pieces than those of one that goes on: another beam, or the same one once more
    meets |= np.bincount(b.sides[:, :2].ravel(), minlength=n) > 2
    borders = [edge for _, shape in model.acting for edge in borders_of(shape)]
    borders += [edge for support in model.supports for edge in support.edges]
    borders += [edge for plate in model.every_plate for zone in plate.zones for edge in zone.shape.ring().segments()]
    beside = np.zeros(n, dtype=bool)
    beside[b.sides[:, :2]] = True
    sides = sides_of(problem.mesh, problem.mesh.elements[problem.plate.elements])
    sides = select_along(problem.mesh, sides[beside[sides[:, :2]].any(axis=1)], borders)
    meets[sides[~np.isin(sides[:, 2], b.sides[:, 2])][:, :2]] = True
    return meets
